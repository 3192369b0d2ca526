//! A stereolithography mesh.
#![cfg_attr(fuzzing, no_main)]

eigenshade_fuzz_readers::target!(stl);
