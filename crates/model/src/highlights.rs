//! The highlights of small sources in f64, and what their light loses: the reference for the
//! runtime's `Highlights` and `Source`, whose pages define both.

use crate::source::{Gloss, Source};
use crate::special::spherical_harmonic;
use crate::vector::{dot, unit};
use eigenshade_table::light;
use std::f64::consts::FRAC_1_PI;

/// The least cosine of half the angle between a source and the view.
const LEAST_COSINE: f64 = 1.0 / 32.0;

/// The reflections of sources by one material.
#[derive(Clone, Debug, PartialEq)]
pub struct Highlights {
    /// α².
    square: f64,
    lobes: Vec<Lobe>,
}

/// The reflection of one source.
#[derive(Clone, Debug, PartialEq)]
struct Lobe {
    direction: [f64; 3],
    /// h, and the tangents there: along the plane of source and view, and across.
    frame: [[f64; 3]; 3],
    /// The diagonal of A, along these tangents.
    slopes: [f64; 2],
    /// E F, faded.
    specular: [f64; 3],
    /// E (1 - F) albedo / π.
    matte: [f64; 3],
}

impl Highlights {
    /// The reflections of these sources.
    #[must_use]
    pub fn new(gloss: &Gloss, sources: &[Source]) -> Self {
        let lobes = sources.iter().map(|source| Lobe::new(gloss, source)).collect();
        Self { square: gloss.alpha().powi(2), lobes }
    }

    /// The irradiance of a unit normal by the sources alone, by channel.
    #[must_use]
    pub fn irradiance(&self, normal: [f64; 3]) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for lobe in &self.lobes {
            let lit = lobe.irradiance(self.square, normal);
            sum.iter_mut().zip(lit).for_each(|(sum, value)| *sum += value);
        }
        sum
    }
}

impl Lobe {
    fn new(gloss: &Gloss, source: &Source) -> Self {
        // Files have rounded numbers.
        let direction = unit(source.direction);
        let [x, y, z] = direction;
        let radius = x.hypot(y);
        let [ex, ey] = if radius > 1e-15 { [x / radius, y / radius] } else { [1.0, 0.0] };
        // Half the angle between source and view.
        let (sine, cosine) = (0.5 * radius.atan2(z)).sin_cos();
        let cosine = cosine.max(LEAST_COSINE);
        let across = [-ey, ex, 0.0];
        let frame = [[sine * ex, sine * ey, cosine], [cosine * ex, cosine * ey, -sine], across];

        // A = α² I + κ σ² J² with J = diag(1/2, 1/(2 cos θ_d)).
        let square = gloss.alpha().powi(2);
        let wide = source.spread.powi(2);
        let far = wide / cosine.powi(2);
        let kappa = 2.0 + square / (square + 0.125 * (wide + far));
        let slopes = [wide, far].map(|blob| square + 0.25 * kappa * blob);
        let slopes = [slopes[0], slopes[1].min(1.0)];

        let fade = 1.0 / (1.0 + 0.5 * far * far);
        let fresnel = (1.0 - cosine).powi(5);
        let reflected =
            |c: usize| gloss.reflectance[c] + (gloss.grazing[c] - gloss.reflectance[c]) * fresnel;
        let specular = |c: usize| source.energy[c] * reflected(c) * fade;
        let matte =
            |c: usize| source.energy[c] * (1.0 - reflected(c)) * gloss.albedo[c] * FRAC_1_PI;
        Self {
            direction,
            frame,
            slopes,
            specular: [0, 1, 2].map(specular),
            matte: [0, 1, 2].map(matte),
        }
    }

    /// E (F D V n·s + (1 - F) albedo / π n·s), and 0 where n·s <= 0.
    fn irradiance(&self, square: f64, normal: [f64; 3]) -> [f64; 3] {
        let cosine = dot(self.direction, normal);
        if cosine <= 1e-12 {
            return [0.0; 3];
        }
        let view = normal[2].max(0.0);
        let root = |cosine: f64| (square + (1.0 - square) * cosine * cosine).sqrt();
        let visibility = 0.5 / (cosine * root(view) + view * root(cosine));
        // nᵀ Q n = (n·h)² + wᵀ A⁻¹ w with the components w of n along the tangents.
        let [h, u, v] = self.frame.map(|axis| dot(axis, normal));
        let [along, across] = self.slopes;
        let form = h * h + u * u / along + v * v / across;
        let distribution = FRAC_1_PI / ((along * across).sqrt() * form * form);
        let channel =
            |c: usize| cosine * (self.specular[c] * distribution * visibility + self.matte[c]);
        [0, 1, 2].map(channel)
    }
}

/// The harmonics up to `degree` of a source of energy 1.
///
/// The heat kernel of variance spread² damps degree l by exp(-l (l + 1) spread² / 2).
#[must_use]
pub fn harmonics(source: &Source, degree: usize) -> Vec<f64> {
    let mut sum = spherical_harmonic::all(degree, unit(source.direction));
    let square = source.spread.powi(2);
    for ((l, _), value) in light::indices(degree).zip(&mut sum) {
        *value *= (-0.5 * square * (l * (l + 1)) as f64).exp();
    }
    sum
}

/// Takes sources out of the channels of a light of a degree: L' = L - Σ E_k Y(blob_k).
pub fn take_out(rgb: &mut [Vec<f64>; 3], degree: usize, sources: &[Source]) {
    for source in sources {
        let harmonics = harmonics(source, degree);
        for (channel, energy) in rgb.iter_mut().zip(source.energy) {
            channel.iter_mut().zip(&harmonics).for_each(|(to, y)| *to -= energy * y);
        }
    }
}
