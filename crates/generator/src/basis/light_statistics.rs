//! First and second moments of a database's light under the rotations that a scene expects, stored
//! as factors: E{LLᵀ} = Σ_t v_t v_tᵀ.

use crate::basis::moments::{LightMoments, comparable};
use eigenshade_index::light;
use eigenshade_model::database::Lights;
use eigenshade_model::error::Result;
use eigenshade_model::rotation::Rotation;
use eigenshade_table::scene::{LightRotation, Normalize};
use faer::Mat;

/// Moments of the light.
#[derive(Clone, Debug, PartialEq)]
pub struct LightStatistics {
    /// E{L}.
    pub mean: Vec<f64>,
    /// v_t of E{LLᵀ}.
    pub second: Vec<Vec<f64>>,
    /// v_t of the covariance, E{LLᵀ} - E{L}E{L}ᵀ, computed from the deviations.
    pub centered: Vec<Vec<f64>>,
}

impl LightStatistics {
    /// The statistics of the lights' luminance, with weights that sum to 1.
    ///
    /// * `Any`: averaged over all rotations, (37)-(39).
    /// * `Vertical`: averaged over the rotations about y, the vertical axis of the camera's frame.
    ///   Products of two coefficients are trigonometric polynomials of the angle, of degree at most
    ///   2 `degree`, so 2 `degree` + 1 angles give exact averages.
    /// * `None`: as captured.
    ///
    /// # Errors
    ///
    /// The errors of [`LightMoments::new`].
    pub fn new(
        lights: &Lights,
        normalize: Normalize,
        rotation: LightRotation,
        weights: &[f64],
    ) -> Result<Self> {
        let degree = lights.degree;
        let angles = match rotation {
            LightRotation::Any => {
                let moments = LightMoments::weighted(lights, normalize, weights)?;
                return Ok(isotropic(degree, &moments));
            }
            LightRotation::None => 1,
            LightRotation::Vertical => 2 * degree + 1,
        };
        let mut samples = Vec::new();
        for (light, weight) in comparable(lights, normalize, weights)? {
            for k in 0..angles {
                let alpha = std::f64::consts::TAU * k as f64 / angles as f64;
                let turned = Rotation { alpha, beta: 0.0, gamma: 0.0 }.turn(degree, &light);
                samples.push((turned, weight / angles as f64));
            }
        }
        let mean: Vec<f64> = (0..light::count(degree))
            .map(|place| samples.iter().map(|(light, weight)| weight * light[place]).sum())
            .collect();
        let about = |center: Option<&[f64]>| -> Vec<Vec<f64>> {
            let scaled = |(light, weight): &(Vec<f64>, f64)| {
                let place = |(k, value): (usize, &f64)| {
                    weight.sqrt() * (value - center.map_or(0.0, |center| center[k]))
                };
                light.iter().enumerate().map(place).collect()
            };
            compressed(samples.iter().map(scaled).collect())
        };
        Ok(Self { second: about(None), centered: about(Some(&mean)), mean })
    }
}

fn isotropic(degree: usize, moments: &LightMoments) -> LightStatistics {
    let axis = |place: usize, length: f64| {
        let mut vector = vec![0.0; light::count(degree)];
        vector[place] = length;
        vector
    };
    let powers: Vec<f64> = light::indices(degree).map(|(l, _)| moments.power[l].sqrt()).collect();
    let all = |ambient: f64| -> Vec<Vec<f64>> {
        let lengths = std::iter::once(ambient).chain(powers.iter().skip(1).copied());
        lengths.enumerate().map(|(place, length)| axis(place, length)).collect()
    };
    LightStatistics {
        mean: axis(0, moments.ambient_mean),
        second: all(powers[0]),
        centered: all(moments.ambient_variance.sqrt()),
    }
}

/// The same Σ v vᵀ with at most as many vectors as each has entries, by an orthogonal
/// factorization: nothing is squared.
fn compressed(vectors: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let places = vectors.first().map_or(0, Vec::len);
    if vectors.len() <= places {
        return vectors;
    }
    let rows = Mat::from_fn(vectors.len(), places, |t, k| vectors[t][k]);
    let qr = rows.qr();
    let factor = qr.thin_R();
    (0..factor.nrows()).map(|t| (0..places).map(|k| factor[(t, k)]).collect()).collect()
}
