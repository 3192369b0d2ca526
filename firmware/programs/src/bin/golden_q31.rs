//! The golden vectors, bit for bit, in Q31.
#![no_std]
#![no_main]

programs::golden!(eigenshade::sphere::q31, programs::golden::q31, eigenshade::Q31);
