//! Light from all around on velvet, in Q15.
#![no_std]
#![no_main]

programs::scene_q15!(programs::scenes::ambient_velvet::q15, 1);
