//! First and second moments of light and material, (34)-(41), kept as factors.
//!
//! V_c of (36) is the product of the light's and the material's second moments.
//! Its factor, V_c = Σ_t v_t v_tᵀ, has one vector v_t for each degree l of the
//! light and each material: √E{(L_l^m)²} b_j / √n. So nothing is squared, and no
//! root of a matrix is taken.

use crate::database::{Lights, Materials};
use crate::error::{Error, Result};
use eigenshade_index::light;
use eigenshade_table::scene::{Criterion, Normalise};

/// What is known of the light, averaged over all rotations.
#[derive(Clone, Debug, PartialEq)]
pub struct LightMoments {
    /// E{L_0^0}, (39); all other means are zero.
    pub ambient_mean: f64,
    /// E{(L_0^0)²} - E{L_0^0}², from the deviations themselves: the difference of
    /// the two leaves 1e-8 of L_0^0 where all are equal.
    pub ambient_variance: f64,
    /// E{(L_l^m)²} for each l, (38): the same for all m.
    pub power: Vec<f64>,
}

impl LightMoments {
    /// The moments of the lights' luminance.
    ///
    /// # Errors
    ///
    /// No lights; or, where they are to be normalised, one whose L_0^0 is not
    /// positive.
    pub fn new(lights: &Lights, normalise: Normalise) -> Result<Self> {
        if lights.entries.is_empty() {
            return Err(Error::new("no lights", "give a light database with at least one light"));
        }
        let count = lights.entries.len() as f64;
        let mut ambients = Vec::new();
        let mut power = vec![0.0; lights.degree + 1];
        for entry in &lights.entries {
            let coefficients = entry.luminance();
            let scale = exposure(&entry.name, coefficients[0], normalise)?;
            ambients.push(scale * coefficients[0]);
            for ((l, _), value) in light::indices(lights.degree).zip(&coefficients) {
                power[l] += (scale * value).powi(2) / (count * (2 * l + 1) as f64);
            }
        }
        let ambient_mean = ambients.iter().sum::<f64>() / count;
        let squares = ambients.iter().map(|ambient| (ambient - ambient_mean).powi(2));
        let ambient_variance = squares.sum::<f64>() / count;
        Ok(Self { ambient_mean, ambient_variance, power })
    }
}

/// The factor that makes one light comparable to the others.
///
/// # Errors
///
/// A light whose luminance L_0^0 is not positive cannot be normalised.
pub fn exposure(name: &str, ambient: f64, normalise: Normalise) -> Result<f64> {
    match normalise {
        Normalise::None => Ok(1.0),
        Normalise::UnitAmbient if ambient > 0.0 => Ok(ambient.recip()),
        Normalise::UnitAmbient => Err(Error::new(
            format!("light `{name}` has mean radiance {ambient}: it cannot be scaled to 1"),
            "leave it out, or set normalise = \"none\" in the scene",
        )),
    }
}

/// One vector v_t of the factor of V_c or Σ_c: degree l of the light, and the
/// material's coefficients times the light's deviation.
#[derive(Clone, Debug, PartialEq)]
pub struct Deviation {
    /// The degree l to which it belongs.
    pub degree: usize,
    /// Coefficients in the order of [`eigenshade_index::material`].
    pub material: Vec<f64>,
}

/// The factor of V_c ([`Criterion::ImageCentered`]) or of Σ_c, (34)
/// ([`Criterion::Standard`]), for the modes of one azimuth.
#[must_use]
pub fn deviations(
    light: &LightMoments,
    materials: &Materials,
    criterion: Criterion,
    azimuth: usize,
) -> Vec<Deviation> {
    let vectors: Vec<Vec<f64>> =
        materials.entries.iter().map(crate::database::Named::luminance).collect();
    let root = (vectors.len() as f64).sqrt();
    let mean = mean(&vectors);
    let mut deviations = Vec::new();
    for (degree, &power) in light.power.iter().enumerate().skip(azimuth) {
        // Only L_0^0 has a mean to be subtracted.
        let (centre, spread) = if degree == 0 && criterion == Criterion::Standard {
            (light.ambient_mean, light.ambient_variance.sqrt())
        } else {
            (0.0, power.sqrt())
        };
        for vector in &vectors {
            if spread > 0.0 {
                let material = vector.iter().map(|b| spread * b / root).collect();
                deviations.push(Deviation { degree, material });
            }
            if centre != 0.0 {
                let material =
                    vector.iter().zip(&mean).map(|(b, mean)| centre * (b - mean) / root).collect();
                deviations.push(Deviation { degree, material });
            }
        }
    }
    deviations
}

/// E{b_op^q}, (41), of the materials' luminance.
#[must_use]
pub fn material_mean(materials: &Materials) -> Vec<f64> {
    mean(&materials.entries.iter().map(crate::database::Named::luminance).collect::<Vec<_>>())
}

fn mean(vectors: &[Vec<f64>]) -> Vec<f64> {
    let mut mean = vec![0.0; vectors.first().map_or(0, Vec::len)];
    for vector in vectors {
        for (mean, value) in mean.iter_mut().zip(vector) {
            *mean += value / vectors.len() as f64;
        }
    }
    mean
}
