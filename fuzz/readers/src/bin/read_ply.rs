//! A polygon file.
#![cfg_attr(fuzzing, no_main)]

eigenshade_fuzz_readers::target!(ply);
