//! Any light on velvet, in Q15.
#![no_std]
#![no_main]

programs::scene_q15!(programs::scenes::studio_velvet::q15, 1);
