//! 50 components to 1e-2: a pixel and a new light.
#![no_std]
#![no_main]

programs::scene_f32!(programs::ladder::first_50, 1);
