//! An OpenEXR map.
#![cfg_attr(fuzzing, no_main)]

eigenshade_fuzz_readers::target!(exr);
