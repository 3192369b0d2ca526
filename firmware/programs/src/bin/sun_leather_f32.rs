//! Any light on leather.
#![no_std]
#![no_main]

programs::scene_f32!(programs::scenes::sun_leather, 1);
