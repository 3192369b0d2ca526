//! The shipped table: a pixel and a new light.
#![no_std]
#![no_main]

programs::scene_f32!(programs::ladder::shipped, 1);
