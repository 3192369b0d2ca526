//! A pixel of a full scene, in Q15.
#![no_std]
#![no_main]

programs::shade!(programs::full::q15);
