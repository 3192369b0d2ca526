//! A sphere as text, in Q15.
#![no_std]
#![no_main]

programs::sphere!(eigenshade::sphere::q15, programs::golden::q15, eigenshade::Q15);
