//! Light to degree 2 on a Lambertian material.
#![no_std]
#![no_main]

programs::scene_f32!(programs::scenes::sky_lambertian, 1);
