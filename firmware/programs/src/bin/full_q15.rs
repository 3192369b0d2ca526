//! 130 components to 2e-4, in Q15: a pixel and a new light.
#![no_std]
#![no_main]

programs::rung_q15!(programs::full::q15);
