//! Light from all around on a Lambertian material.
#![no_std]
#![no_main]

programs::scene_f32!(programs::scenes::ambient_lambertian, 1);
