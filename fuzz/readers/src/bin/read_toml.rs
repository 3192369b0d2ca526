//! A scene or a list of materials.
#![cfg_attr(fuzzing, no_main)]

eigenshade_fuzz_readers::target!(toml);
