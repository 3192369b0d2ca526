//! The coefficients of an image to its scene, K = 50, in Q15.
#![no_std]
#![no_main]

programs::collapse!(eigenshade::sphere::q15);
