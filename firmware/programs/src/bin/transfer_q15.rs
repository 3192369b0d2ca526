//! A new material, folded into the basis, K = 50, in Q15.
#![no_std]
#![no_main]

programs::transfer!(eigenshade::sphere::q15);
