//! Small sources of the host as sources of the runtime.

use crate::shader::fault;
use eigenshade_model::error::Result;
use eigenshade_model::source::{Gloss, Source};
use eigenshade_table::light;

/// The largest degree of [`harmonics`].
const DEGREE: usize = 32;

/// A source of the runtime.
///
/// # Errors
///
/// If the runtime refuses it: see [`eigenshade::Source::new`].
pub fn source(source: &Source) -> Result<eigenshade::Source> {
    let number = |number: f64| number as f32;
    let energy = source.energy.map(number);
    let direction = source.direction.map(number);
    eigenshade::Source::new(direction, energy, number(source.spread)).map_err(fault)
}

/// A gloss of the runtime.
///
/// # Errors
///
/// If a parameter is not in \[0, 1\].
pub fn gloss(gloss: &Gloss) -> Result<eigenshade::Gloss> {
    let Gloss { roughness, reflectance, grazing, albedo } = *gloss;
    let [f0, f90, albedo] =
        [reflectance, grazing, albedo].map(|rgb| rgb.map(|number| number as f32));
    let gloss = eigenshade::Gloss::new(roughness as f32, f0, albedo);
    gloss.and_then(|gloss| gloss.with_grazing(f90)).map_err(fault)
}

/// The harmonics up to `degree` of a source of energy 1, by the runtime.
///
/// # Errors
///
/// As [`source`], and if the degree exceeds 32.
pub fn harmonics(of: &Source, degree: usize) -> Result<Vec<f32>> {
    let harmonics = source(of)?.harmonics::<{ light::count(DEGREE) }>(degree);
    Ok(harmonics.map_err(fault)?.to_vec())
}
