//! A scene or a table in f32: a pixel, a new light, and a turned light if the scene's light turns.
//! The material is transferred at start-up.
#![no_std]
#![no_main]

use board::{Passes, measure_named};
use core::hint::black_box;
use eigenshade::{Light, Rgb, Rotation};
use programs::inputs::floats as inputs;
use table::{COMPONENTS, LIGHT, ORDER};

programs::program!();

const MATERIAL: usize = eigenshade::index::material::count(ORDER);

fn main() {
    let material = inputs::numbers::<MATERIAL>();
    let Ok(transfer) = table::transfer(&inputs::material(&material)) else { board::exit(false) };
    let transfer = black_box(transfer);
    let numbers = inputs::numbers::<COMPONENTS>();
    let mut d = table::Coefficients::from(numbers);
    let mut scenes = [(); CHANNELS].map(|()| match table::collapse(&d) {
        Ok(scene) => scene,
        Err(_) => board::exit(false),
    });
    board::holds(size_of_val(&transfer) + size_of_val(&d) + size_of_val(&scenes));
    let lights = [[(); CHANNELS].map(|()| inputs::numbers::<LIGHT>())];
    measure_named("light", &lights, Passes(64), |lights| {
        lights.iter().zip(&mut scenes).try_for_each(|(light, scene)| {
            let light = Light::from_finite(light)?;
            table::relight_into(&transfer, &light, &mut d)?;
            table::collapse_into(&d, black_box(scene))
        })
    });
    let scenes = black_box(scenes);
    let terms = scenes.each_ref().map(|scene| match table::terms(scene) {
        Some(terms) => terms,
        None => board::exit(false),
    });
    if CHANNELS == 1 {
        let [terms, ..] = terms;
        measure_named("pixel", &inputs::normals(), Passes(64), |normal| {
            table::shade_terms(terms, *normal)
        });
    } else {
        measure_named("pixel", &inputs::normals(), Passes(64), |normal| {
            terms.map(|terms| table::shade_terms(terms, *normal))
        });
    }
    if TURNS {
        let rotation = Rotation::from_quaternion(black_box([0.1, 0.2, 0.3, 1.0]));
        let Ok(rotation) = rotation else { board::exit(false) };
        measure_named("turn", &lights, Passes(16), |lights| {
            let [first, ..] = lights;
            let channel = |place: usize| Light::from_finite(lights.get(place).unwrap_or(first));
            Rgb::new(channel(0)?, channel(1)?, channel(2)?).turned::<LIGHT>(&rotation)
        });
    }
}
