//! A pixel of a Lambertian scene.
#![no_std]
#![no_main]

use board::{Passes, holds, measure, program};
use core::hint::black_box;
use eigenshade::{NineTerms, Normal};
use programs::inputs;
use programs::lambertian::{self, COMPONENTS};

program!(main);

fn main() {
    let coefficients = inputs::numbers::<COMPONENTS>();
    let Ok(scene) = lambertian::collapse(&eigenshade::specialized::coefficients(coefficients, &[]))
    else {
        board::exit(false)
    };
    let scene = black_box(scene);
    holds(size_of_val(&scene));
    let Some(terms) = lambertian::terms(&scene) else { board::exit(false) };
    measure(&inputs::normals(), Passes(64), |normal| pixel(terms, normal));
}

#[inline]
fn pixel(terms: NineTerms<f32>, normal: &Normal<f32>) -> f32 {
    lambertian::shade_terms(terms, *normal)
}
