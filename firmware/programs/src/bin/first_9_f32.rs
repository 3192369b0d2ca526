//! 9 components to 1e-1: a pixel and a new light.
#![no_std]
#![no_main]

programs::scene_f32!(programs::ladder::first_9, 1);
