//! Any light on leather, in color, turning.
#![no_std]
#![no_main]

programs::scene_f32!(programs::scenes::sun_leather, 3, turns);
