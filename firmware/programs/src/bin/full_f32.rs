//! 130 components to 2e-4: a pixel and a new light.
#![no_std]
#![no_main]

programs::scene_f32!(programs::full, 1);
