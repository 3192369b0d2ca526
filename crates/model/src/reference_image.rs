//! Images by the direct sum (15), in f64: the reference for all other methods.

use crate::database::{Lights, Materials};
use crate::parallel::{self, Progress};
use crate::reference::{DirectSum, light_products, material_products};
use eigenshade_table::effect::Effects;

/// The irradiance, r, g and b, of every light on every material at every normal: one list per
/// normal, sorted by light, then material.
///
/// The normals have unit length and z >= 0. The sum uses the full degree of the lights and the full
/// order of the materials.
#[must_use]
pub fn images(
    lights: &Lights,
    materials: &Materials,
    normals: &[[f64; 3]],
    progress: &impl Progress,
) -> Vec<Vec<[f64; 3]>> {
    images_of_effects(lights, materials, Effects::ALL, normals, progress)
}

/// Like [`images`], restricted to some effects.
#[must_use]
pub fn images_of_effects(
    lights: &Lights,
    materials: &Materials,
    wanted: Effects,
    normals: &[[f64; 3]],
    progress: &impl Progress,
) -> Vec<Vec<[f64; 3]>> {
    let reference = DirectSum::new(lights.degree, materials.order);
    let lit: Vec<[Vec<Vec<f64>>; 3]> = lights
        .entries
        .iter()
        .map(|light| [0, 1, 2].map(|c| light_products(lights.degree, &light.rgb[c], wanted)))
        .collect();
    parallel::map(normals.len(), progress, |k| {
        let modes = reference.at(normals[k]);
        let scattered: Vec<_> = materials
            .entries
            .iter()
            .map(|material| {
                let channels = if material.is_gray() { 1 } else { 3 };
                let channels = material.rgb.iter().take(channels);
                let of_effects = |channel| material_products(materials.order, channel, wanted);
                let scatter = |one: Vec<Vec<f64>>| -> Vec<_> {
                    one.iter().map(|material| modes.scatter(material)).collect()
                };
                channels.map(|one| scatter(of_effects(one))).collect::<Vec<_>>()
            })
            .collect();
        let of = |light: &[Vec<Vec<f64>>; 3], channel: usize, material: usize| -> f64 {
            let scattered = &scattered[material];
            let scattered = &scattered[channel.min(scattered.len() - 1)];
            let products = light[channel].iter().zip(scattered);
            products.map(|(light, scattered)| modes.irradiance(light, scattered)).sum()
        };
        let pairs = lit
            .iter()
            .flat_map(|light| (0..materials.entries.len()).map(move |material| (light, material)));
        pairs.map(|(light, material)| [0, 1, 2].map(|c| of(light, c, material))).collect()
    })
}
