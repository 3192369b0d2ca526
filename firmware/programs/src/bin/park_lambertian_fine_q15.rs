//! Any light on a Lambertian material, to 1e-3, in Q15.
#![no_std]
#![no_main]

programs::scene_q15!(programs::scenes::park_lambertian_fine::q15, 1);
