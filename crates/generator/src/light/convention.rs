//! Lights between the paper's convention and that of graphics.

use eigenshade_index::light;
use eigenshade_model::database::Lights;

/// The same lights, from the paper's convention to the one of three.js,
/// Filament and Ramamoorthi, or from that to the paper's: the factor is its own
/// inverse, exactly.
///
/// It is [`light::graphics_sign`], in every degree. What the axes mean is
/// another matter: a frame that is not x right, y up, z toward the camera takes
/// a [`Rotation`](eigenshade_model::rotation::Rotation) as well.
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
