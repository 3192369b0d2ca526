//! A formula of a density.
#![cfg_attr(fuzzing, no_main)]

eigenshade_fuzz_readers::target!(formula);
