//! Any light on a Lambertian material, to 1e-2.
#![no_std]
#![no_main]

programs::scene_f32!(programs::scenes::park_lambertian, 1);
