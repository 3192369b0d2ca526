//! The coefficients of images to scenes within 1 % of the peak, K = 50: of lights and materials
//! that grow darker with their degree, as real ones do.
#![no_std]
#![no_main]

use board::{Passes, holds, measure, program};
use core::hint::black_box;
use eigenshade::Tolerance;
use eigenshade::sphere::{self, BASIS, Coefficients, DEGREE, SCENE};
use programs::inputs;

program!(main);

fn main() {
    let (light, material) = (inputs::numbers::<100>(), inputs::numbers::<40>());
    let images = [1, 2, 3, 4].map(|faster| image(&light, &material, faster));
    let (mut lengths, mut scene) = ([0; DEGREE + 1], [0.0; SCENE]);
    holds(size_of_val(&images[0]) + size_of_val(&lengths) + size_of_val(&scene));
    measure(&images, Passes(64), |d| {
        let (scene, lengths) = (black_box(&mut scene[..]), black_box(&mut lengths));
        BASIS.collapse_within(d, Tolerance::OfPeak(1e-2), lengths, scene).map(|(_, told)| told)
    });
}

/// That of numbers that are the smaller the later they are.
fn image(light: &[f32; 100], material: &[f32; 40], faster: usize) -> Coefficients {
    let (mut light, mut material) = (*light, *material);
    light.iter_mut().zip(0..).for_each(|(value, k)| *value /= (1 + k * faster) as f32);
    material.iter_mut().zip(0..).for_each(|(value, k)| *value /= (1 + k * faster) as f32);
    let (light, material) = (inputs::light(&light), inputs::material(&material));
    sphere::project(&light, &material).unwrap_or_else(|_| board::exit(false))
}
