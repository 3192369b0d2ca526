//! A scene in Q15: a pixel, and a new light on its material, which was transferred when the program
//! was compiled.
#![no_std]
#![no_main]

use board::{Passes, measure_named};
use core::hint::black_box;
use programs::inputs::integers as inputs;
use table::{Coefficients, DEGREE, MATERIAL, Scene};

programs::program!();

const LIGHT: usize = eigenshade::index::light::count(DEGREE);

fn main() {
    let mut d = Coefficients::default();
    let mut scenes = [(); CHANNELS].map(|()| Scene::default());
    board::holds(size_of_val(&d) + size_of_val(&scenes));
    let lights = [[(); CHANNELS].map(|()| inputs::mantissas::<LIGHT>())];
    measure_named("light", &lights, Passes(64), |lights| {
        lights.iter().zip(&mut scenes).try_for_each(|(light, scene)| {
            let light = inputs::light(light);
            table::relight_into(&MATERIAL, &light, &mut d)?;
            table::collapse_into(&d, black_box(scene))
        })
    });
    let scenes = black_box(scenes);
    let normals = inputs::normals();
    // At degree 2, a pixel is the nine-term formula.
    if DEGREE == 2 {
        let formulas = scenes.each_ref().map(|scene| match scene.nine_terms() {
            Some(formula) => formula,
            None => board::exit(false),
        });
        measure_named("pixel", &normals, Passes(256), |normal| {
            formulas.each_ref().map(|formula| formula.shade(*normal))
        });
    } else {
        measure_named("pixel", &normals, Passes(256), |normal| {
            scenes.each_ref().map(|scene| table::shade(scene, *normal))
        });
    }
}
