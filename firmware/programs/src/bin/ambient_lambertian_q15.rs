//! Light from all around on a Lambertian material, in Q15.
#![no_std]
#![no_main]

programs::scene_q15!(programs::scenes::ambient_lambertian::q15, 1);
