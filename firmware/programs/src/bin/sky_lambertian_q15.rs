//! Light to degree 2 on a Lambertian material, in Q15.
#![no_std]
#![no_main]

programs::scene_q15!(programs::scenes::sky_lambertian::q15, 1, nine_terms);
