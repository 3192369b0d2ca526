//! Tables that are not the library's. Modules `q15` have them in integers.
//!
//! A crate of its own, so that programs without these tables do not load its code to link.
#![no_std]

include!(concat!(env!("OUT_DIR"), "/tables.rs"));
