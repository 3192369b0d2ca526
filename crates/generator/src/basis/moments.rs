//! First and second moments of light and material, (34)-(41), kept as factors.
//!
//! V_c of (36) is the product of the light's and the material's second moments. Its factorization
//! V_c = Σ_t v_t v_tᵀ has one vector v_t for each degree l of the light and each material:
//! √E{(L_l^m)²} b_j / √n. So nothing is squared, and no matrix square root is needed.

use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::error::{Error, Result};
use eigenshade_table::light;
use eigenshade_table::scene::{Criterion, Normalize};

/// Moments of the light, averaged over all rotations.
#[derive(Clone, Debug, PartialEq)]
pub struct LightMoments {
    /// E{L_0^0}, (39); all other means are zero.
    pub ambient_mean: f64,
    /// E{(L_0^0)²} - E{L_0^0}², computed from the deviations: subtracting the two moments would
    /// leave 1e-8 of L_0^0 when all values are equal.
    pub ambient_variance: f64,
    /// E{(L_l^m)²} for each l, (38); it does not depend on m.
    pub power: Vec<f64>,
}

impl LightMoments {
    /// The moments of the lights' luminance, with equal weights.
    ///
    /// # Errors
    ///
    /// If there are no lights, or if lights are to be normalized and the L_0^0 of one is not
    /// positive.
    pub fn new(lights: &Lights, normalize: Normalize) -> Result<Self> {
        Self::weighted(lights, normalize, &equal(lights.entries.len()))
    }

    /// The moments of the lights' luminance with the given weights, which sum to 1.
    ///
    /// # Errors
    ///
    /// The errors of [`new`](Self::new). Lights of weight 0 are ignored.
    pub fn weighted(lights: &Lights, normalize: Normalize, weights: &[f64]) -> Result<Self> {
        let mut ambients = Vec::new();
        let mut power = vec![0.0; lights.degree + 1];
        for (light, weight) in comparable(lights, normalize, weights)? {
            ambients.push((light[0], weight));
            for ((l, _), value) in light::indices(lights.degree).zip(&light) {
                power[l] += weight * value.powi(2) / (2 * l + 1) as f64;
            }
        }
        let ambient_mean = ambients.iter().map(|(ambient, weight)| weight * ambient).sum::<f64>();
        let squares =
            ambients.iter().map(|(ambient, weight)| weight * (ambient - ambient_mean).powi(2));
        let ambient_variance = squares.sum::<f64>();
        Ok(Self { ambient_mean, ambient_variance, power })
    }
}

/// `count` equal weights.
#[must_use]
pub fn equal(count: usize) -> Vec<f64> {
    vec![1.0 / count as f64; count]
}

/// The lights' luminance with comparable exposures, and their weights. Lights of weight 0 are left
/// out.
///
/// # Errors
///
/// The errors of [`LightMoments::new`].
pub fn comparable(
    lights: &Lights,
    normalize: Normalize,
    weights: &[f64],
) -> Result<Vec<(Vec<f64>, f64)>> {
    if lights.entries.is_empty() {
        return Err(Error::new("no lights", "give a light database with at least one light"));
    }
    let weighted = lights.entries.iter().zip(weights).filter(|(_, weight)| **weight > 0.0);
    weighted
        .map(|(entry, weight)| {
            let mut light = entry.luminance();
            let scale = exposure(&entry.name, light[0], normalize)?;
            light.iter_mut().for_each(|value| *value *= scale);
            Ok((light, *weight))
        })
        .collect()
}

/// Moments of the materials.
#[derive(Clone, Debug, PartialEq)]
pub struct MaterialMoments {
    /// Luminance coefficients b of each material.
    pub vectors: Vec<Vec<f64>>,
    /// Weights of the materials, which sum to 1.
    pub weights: Vec<f64>,
    /// E{b_op^q}, (41).
    pub mean: Vec<f64>,
}

impl MaterialMoments {
    /// The moments of the materials' luminance, with equal weights.
    #[must_use]
    pub fn new(materials: &Materials) -> Self {
        Self::weighted(materials, equal(materials.entries.len()))
    }

    /// The moments of the materials' luminance with the given weights, which sum to 1.
    #[must_use]
    pub fn weighted(materials: &Materials, weights: Vec<f64>) -> Self {
        let vectors: Vec<Vec<f64>> =
            materials.entries.iter().map(eigenshade_model::database::Named::luminance).collect();
        let mut mean = vec![0.0; vectors.first().map_or(0, Vec::len)];
        for (vector, weight) in vectors.iter().zip(&weights) {
            for (mean, value) in mean.iter_mut().zip(vector) {
                *mean += weight * value;
            }
        }
        Self { vectors, weights, mean }
    }

    /// Each material's coefficients and the square root of its weight.
    pub fn rooted(&self) -> impl Iterator<Item = (&Vec<f64>, f64)> {
        self.vectors.iter().zip(self.weights.iter().map(|weight| weight.sqrt()))
    }
}

/// The factor that makes one light comparable to the others.
///
/// # Errors
///
/// If the light is to be normalized and its luminance L_0^0 is not positive.
pub fn exposure(name: &str, ambient: f64, normalize: Normalize) -> Result<f64> {
    match normalize {
        Normalize::None => Ok(1.0),
        Normalize::UnitAmbient if ambient > 0.0 => Ok(ambient.recip()),
        Normalize::UnitAmbient => Err(Error::new(
            format!("light `{name}` has mean radiance {ambient}: it cannot be scaled to 1"),
            "leave it out, or set normalize = \"none\" in the scene",
        )),
    }
}

/// One vector v_t of the factor of V_c or Σ_c: a degree l of the light, and the material's
/// coefficients times the light's deviation.
#[derive(Clone, Debug, PartialEq)]
pub struct Deviation {
    /// The degree l of the light.
    pub degree: usize,
    /// Coefficients in the order of [`eigenshade_table::material`].
    pub material: Vec<f64>,
}

/// The factor of V_c ([`Criterion::ImageCentered`]) or of Σ_c, (34) ([`Criterion::Standard`]), for
/// the modes of one azimuth.
#[must_use]
pub fn deviations(
    light: &LightMoments,
    materials: &MaterialMoments,
    criterion: Criterion,
    azimuth: usize,
) -> Vec<Deviation> {
    let mut deviations = Vec::new();
    for (degree, &power) in light.power.iter().enumerate().skip(azimuth) {
        // Only L_0^0 has a nonzero mean to subtract.
        let (center, spread) = if degree == 0 && criterion == Criterion::Standard {
            (light.ambient_mean, light.ambient_variance.sqrt())
        } else {
            (0.0, power.sqrt())
        };
        for (vector, root) in materials.rooted() {
            if spread > 0.0 {
                let material = vector.iter().map(|b| root * spread * b).collect();
                deviations.push(Deviation { degree, material });
            }
            if center != 0.0 {
                let pairs = vector.iter().zip(&materials.mean);
                let material = pairs.map(|(b, mean)| root * center * (b - mean)).collect();
                deviations.push(Deviation { degree, material });
            }
        }
    }
    deviations
}
