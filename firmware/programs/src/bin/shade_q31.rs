//! A pixel of a full scene, in Q31.
#![no_std]
#![no_main]

programs::shade!(programs::full::q31);
