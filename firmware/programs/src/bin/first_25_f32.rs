//! 25 components to 3e-2: a pixel and a new light.
#![no_std]
#![no_main]

programs::scene_f32!(programs::ladder::first_25, 1);
