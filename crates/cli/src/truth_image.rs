//! Images by the direct sum (15), in f64: what the rest is measured against.

use crate::parallel;
use eigenshade_generator::database::{Lights, Materials, Named};
use eigenshade_generator::truth::Truth;
use indicatif::ProgressBar;

/// The irradiance, r, g and b, of every light on every material at every normal:
/// by normal, within it by light, within it by material.
///
/// The normals are of unit length with z >= 0. The sum goes as far as the lights'
/// degree and the materials' order.
#[must_use]
pub fn images(
    lights: &Lights,
    materials: &Materials,
    normals: &[[f64; 3]],
    progress: &ProgressBar,
) -> Vec<Vec<[f64; 3]>> {
    let truth = Truth::new(lights.degree, materials.order);
    parallel::map(normals.len(), progress, |k| {
        let modes = truth.at(normals[k]);
        let scattered: Vec<_> = materials
            .entries
            .iter()
            .map(|material| {
                let channels = if material.is_grey() { 1 } else { 3 };
                let channels = material.rgb.iter().take(channels);
                channels.map(|channel| modes.scatter(channel)).collect::<Vec<_>>()
            })
            .collect();
        let of = |light: &Named, channel: usize, material: usize| {
            let scattered = &scattered[material];
            let scattered = &scattered[channel.min(scattered.len() - 1)];
            modes.irradiance(&light.rgb[channel], scattered)
        };
        let pairs = lights
            .entries
            .iter()
            .flat_map(|light| (0..materials.entries.len()).map(move |material| (light, material)));
        pairs.map(|(light, material)| [0, 1, 2].map(|c| of(light, c, material))).collect()
    })
}
