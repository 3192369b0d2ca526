//! A new light on a fixed material, up to the scene, K = 50, in Q31.
#![no_std]
#![no_main]

programs::relight!(eigenshade::sphere::q31, collapse_into);
