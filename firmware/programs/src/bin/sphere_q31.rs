//! A sphere as text, in Q31.
#![no_std]
#![no_main]

programs::sphere!(eigenshade::sphere::q31, programs::golden::q31, eigenshade::Q31);
