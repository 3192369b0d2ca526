//! A new light on a fixed material, K = 50, in Q15.
#![no_std]
#![no_main]

programs::relight!(eigenshade::sphere::q15);
