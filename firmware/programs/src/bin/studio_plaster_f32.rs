//! Any light on plaster without highlights.
#![no_std]
#![no_main]

programs::scene_f32!(programs::scenes::studio_plaster, 1);
