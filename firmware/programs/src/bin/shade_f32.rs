//! A pixel of a full scene.
#![no_std]
#![no_main]

use board::{Passes, holds, measure, program};
use core::hint::black_box;
use eigenshade::Normal;
use programs::full::{self, COMPONENTS, SCENE};
use programs::inputs;

program!(main);

fn main() {
    let coefficients = inputs::numbers::<COMPONENTS>();
    let Ok(scene) = full::collapse(&eigenshade::specialized::coefficients(coefficients, &[]))
    else {
        board::exit(false)
    };
    let scene = black_box(scene);
    holds(size_of_val(&scene));
    let Some(terms) = full::terms(&scene) else { board::exit(false) };
    measure(&inputs::normals(), Passes(64), |normal| pixel(terms, normal));
}

#[inline]
fn pixel(terms: &[f32; SCENE], normal: &Normal<f32>) -> f32 {
    full::shade_terms(terms, *normal)
}
