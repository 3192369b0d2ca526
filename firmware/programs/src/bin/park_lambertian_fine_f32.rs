//! Any light on a Lambertian material, to 1e-3.
#![no_std]
#![no_main]

programs::scene_f32!(programs::scenes::park_lambertian_fine, 1);
