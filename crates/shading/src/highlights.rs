//! Small sources of the host as sources of the runtime.

use crate::shader::fault;
use eigenshade::mathematics::Libm;
use eigenshade::{Scalar, SourceSet};
use eigenshade_index::light;
use eigenshade_model::error::Result;
use eigenshade_model::screen::ScreenError;
use eigenshade_model::source::{Gloss, SetError, Source};

/// The largest degree of a light that sources are taken out of.
const DEGREE: usize = 32;

/// A source in a number format.
///
/// # Errors
///
/// If the runtime refuses it: see [`eigenshade::Source::new`].
pub fn source<S: Scalar>(source: &Source) -> Result<eigenshade::Source<S>> {
    let number = S::from_f64;
    let energy = source.energy.map(number);
    let (direction, major) = (source.direction.map(number), source.major.map(number));
    eigenshade::Source::new::<Libm>(direction, energy, major, number(source.minor)).map_err(fault)
}

/// A gloss in a number format.
///
/// # Errors
///
/// If a parameter is not in \[0, 1\].
pub fn gloss<S: Scalar>(gloss: &Gloss) -> Result<eigenshade::Gloss<S>> {
    let Gloss { roughness, reflectance, grazing, albedo } = *gloss;
    let [f0, f90, albedo] = [reflectance, grazing, albedo].map(|rgb| rgb.map(S::from_f64));
    let gloss = eigenshade::Gloss::new(S::from_f64(roughness), f0, albedo);
    gloss.and_then(|gloss| gloss.with_grazing(f90)).map_err(fault)
}

/// The errors of pictures with a set of sources of a material: see [`SourceSet::error`].
#[must_use]
pub fn set_errors(set: &SetError, gloss: &eigenshade::Gloss<f64>) -> ScreenError {
    let error = |of: fn(ScreenError) -> f64| SourceSet::new(&[], set.errors.map(of)).error(gloss);
    ScreenError {
        mean: error(|errors| errors.mean),
        p95: error(|errors| errors.p95),
        white: error(|errors| errors.white),
    }
}

/// The harmonics up to `degree` of a source of energy 1, rounded to a format.
///
/// # Errors
///
/// As [`source`], and if the degree exceeds 32.
pub fn harmonics<S: Scalar>(of: &Source, degree: usize) -> Result<Vec<S>> {
    let harmonics = self::source::<S>(of)?.harmonics::<Libm, { light::count(DEGREE) }>(degree);
    Ok(harmonics.map_err(fault)?.to_vec())
}

/// Takes sources out of the channels of a light of a degree.
///
/// # Errors
///
/// As [`harmonics`].
pub fn take_out(rgb: &mut [Vec<f64>; 3], degree: usize, sources: &[Source]) -> Result<()> {
    for source in sources {
        let harmonics = harmonics::<f64>(source, degree)?;
        for (channel, energy) in rgb.iter_mut().zip(source.energy) {
            channel.iter_mut().zip(&harmonics).for_each(|(to, y)| *to -= energy * y);
        }
    }
    Ok(())
}
