//! 9 components to 1e-1, in Q15: a pixel and a new light.
#![no_std]
#![no_main]

programs::rung_q15!(programs::ladder::first_9::q15);
