//! A pixel of a Lambertian scene, in Q31.
#![no_std]
#![no_main]

programs::shade!(programs::lambertian::q31, nine_terms);
