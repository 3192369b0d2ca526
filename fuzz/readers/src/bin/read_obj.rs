//! A Wavefront mesh.
#![cfg_attr(fuzzing, no_main)]

eigenshade_fuzz_readers::target!(obj);
