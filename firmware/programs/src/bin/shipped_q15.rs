//! The shipped table, in Q15: a pixel and a new light.
#![no_std]
#![no_main]

programs::rung_q15!(programs::ladder::shipped::q15);
