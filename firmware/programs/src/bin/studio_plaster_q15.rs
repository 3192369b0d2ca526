//! Any light on plaster without highlights, in Q15.
#![no_std]
#![no_main]

programs::scene_q15!(programs::scenes::studio_plaster::q15, 1);
