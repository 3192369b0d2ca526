//! The golden vectors, bit for bit, in Q15.
#![no_std]
#![no_main]

programs::golden!(eigenshade::sphere::q15, programs::golden::q15, eigenshade::Q15);
