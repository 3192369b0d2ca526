//! Any light on velvet.
#![no_std]
#![no_main]

programs::scene_f32!(programs::scenes::studio_velvet, 1);
