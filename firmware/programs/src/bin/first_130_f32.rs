//! 130 components to 1e-3: a pixel and a new light.
#![no_std]
#![no_main]

programs::scene_f32!(programs::ladder::first_130, 1);
