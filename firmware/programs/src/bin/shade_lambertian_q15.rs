//! A pixel of a Lambertian scene, in Q15.
#![no_std]
#![no_main]

programs::shade!(programs::lambertian::q15, nine_terms);
