//! Light from all around on velvet.
#![no_std]
#![no_main]

programs::scene_f32!(programs::scenes::ambient_velvet, 1);
