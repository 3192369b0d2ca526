//! 25 components to 3e-2, in Q15: a pixel and a new light.
#![no_std]
#![no_main]

programs::rung_q15!(programs::ladder::first_25::q15);
