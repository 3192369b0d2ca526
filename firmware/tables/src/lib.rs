//! Tables that are not the library's. Modules `q15` and `q31` have the integer formats.
//!
//! A crate of its own: programs that use none of them link faster without.
#![no_std]

include!(concat!(env!("OUT_DIR"), "/tables.rs"));
