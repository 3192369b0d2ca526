//! A new light on a fixed material, up to the scene, K = 50, in Q15.
#![no_std]
#![no_main]

programs::relight!(eigenshade::sphere::q15, collapse_into);
