//! Any light on leather, in color, in Q15.
#![no_std]
#![no_main]

programs::scene_q15!(programs::scenes::sun_leather::q15, 3);
