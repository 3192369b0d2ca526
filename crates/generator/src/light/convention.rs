//! Converts lights between the conventions of the paper and of computer graphics.

use eigenshade_index::light;
use eigenshade_model::database::Lights;

/// Converts lights from the paper's convention to that of three.js, Filament and Ramamoorthi, or
/// back: the factor is exactly its own inverse.
///
/// The factor is [`light::graphics_sign`], at every degree. It does not change the axes: for a
/// frame other than x right, y up, z toward the camera, also apply a
/// [`Rotation`](eigenshade_model::rotation::Rotation).
#[must_use]
pub fn exchanged(lights: &Lights) -> Lights {
    let mut lights = lights.clone();
    for entry in &mut lights.entries {
        for channel in &mut entry.rgb {
            for (value, (_, m)) in channel.iter_mut().zip(light::indices(lights.degree)) {
                *value *= f64::from(light::graphics_sign(m));
            }
        }
    }
    lights
}
