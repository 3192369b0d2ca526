//! The highlights of small sources in f64, and what their light loses: the reference for the
//! runtime's `Highlights` and `Source`, whose pages define both.

use crate::source::{Gloss, Source};
use crate::special::spherical_harmonic;
use crate::vector::{dot, plus, times, unit};
use eigenshade_table::light;
use std::f64::consts::{FRAC_1_PI, TAU};

/// The least cosine of half the angle between a source and the view.
const LEAST_COSINE: f64 = 1.0 / 32.0;

/// How far the sum along a blob's major axis reaches, in standard deviations.
const REACH: f64 = 5.0;

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
    /// A_11, A_12 and A_22 of the slopes along these tangents.
    slopes: [f64; 3],
    /// E F, faded.
    specular: [f64; 3],
    /// E (1 - F) albedo / π.
    matte: [f64; 3],
}

impl Highlights {
    /// The reflections of these sources.
    #[must_use]
    pub fn new(gloss: &Gloss, sources: &[Source]) -> Self {
        let lobes = sources.iter().map(|source| Lobe::new(gloss, &normalized(source))).collect();
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
        let [x, y, z] = source.direction;
        let radius = x.hypot(y);
        let [ex, ey] = if radius > 1e-15 { [x / radius, y / radius] } else { [1.0, 0.0] };
        // Half the angle between source and view.
        let (sine, cosine) = (0.5 * radius.atan2(z)).sin_cos();
        let cosine = cosine.max(LEAST_COSINE);
        let across = [-ey, ex, 0.0];
        let frame = [[sine * ex, sine * ey, cosine], [cosine * ex, cosine * ey, -sine], across];

        // C, the blob's covariance at s, along the plane of source and view and across.
        let [a, b] = [[z * ex, z * ey, -radius], across].map(|axis| dot(source.major, axis));
        let long = a * a + b * b;
        let ratio = if long > 0.0 { source.minor.powi(2) / long } else { 1.0 };
        let [c11, c12, c22] = [a * a + ratio * b * b, a * b * (1.0 - ratio), b * b + ratio * a * a];

        // A = α² I + κ J C Jᵀ with J = diag(1/2, 1/(2 cos θ_d)).
        let square = gloss.alpha().powi(2);
        let far = c22 / cosine.powi(2);
        let [w11, w12, w22] = [c11, c12 / cosine, far].map(|element| 0.25 * element);
        let kappa = 2.0 + square / (square + 0.5 * (w11 + w22));
        let [a11, a12, a22] = [square + kappa * w11, kappa * w12, square + kappa * w22];
        let [a12, a22] = if a22 > 1.0 { [a12 / a22, 1.0] } else { [a12, a22] };

        let fade = 1.0 / (1.0 + 0.5 * far * far);
        let fresnel = (1.0 - cosine).powi(5);
        let reflected =
            |c: usize| gloss.reflectance[c] + (gloss.grazing[c] - gloss.reflectance[c]) * fresnel;
        let specular = |c: usize| source.energy[c] * reflected(c) * fade;
        let matte =
            |c: usize| source.energy[c] * (1.0 - reflected(c)) * gloss.albedo[c] * FRAC_1_PI;
        Self {
            direction: source.direction,
            frame,
            slopes: [a11, a12, a22],
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
        let [a11, a12, a22] = self.slopes;
        let determinant = a11 * a22 - a12 * a12;
        let form = h * h + (a22 * u * u - 2.0 * a12 * u * v + a11 * v * v) / determinant;
        let distribution = FRAC_1_PI / (determinant.sqrt() * form * form);
        let channel =
            |c: usize| cosine * (self.specular[c] * distribution * visibility + self.matte[c]);
        [0, 1, 2].map(channel)
    }
}

/// The harmonics up to `degree` of a source of energy 1.
///
/// The heat kernel of variance minor² damps degree l by exp(-l (l + 1) minor² / 2). The convolution
/// along the major axis is a trapezoid sum to five standard deviations, which leaves 4e-6.
#[must_use]
pub fn harmonics(source: &Source, degree: usize) -> Vec<f64> {
    let Source { direction, major, minor, .. } = normalized(source);
    let mut sum = spherical_harmonic::all(degree, direction);
    let (long, short) = (dot(major, major), minor * minor);
    let mut total = 1.0;
    if long - short > 1e-6 * long {
        let width = (long - short).sqrt();
        let axis = unit(major);
        let nodes = (REACH * (REACH + width * degree as f64) / TAU).floor() + 1.0;
        for j in 1..=nodes as usize {
            let x = REACH * j as f64 / nodes;
            let weight = (-0.5 * x * x).exp();
            total += 2.0 * weight;
            for angle in [x * width, -x * width] {
                let node = plus(times(angle.cos(), direction), times(angle.sin(), axis));
                let values = spherical_harmonic::all(degree, node);
                sum.iter_mut().zip(values).for_each(|(sum, value)| *sum += weight * value);
            }
        }
    }
    for ((l, _), value) in light::indices(degree).zip(&mut sum) {
        *value *= (-0.5 * short * (l * (l + 1)) as f64).exp() / total;
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

/// The source with a direction of length 1 and a major axis perpendicular to it that is not shorter
/// than the minor one: files have rounded numbers.
fn normalized(source: &Source) -> Source {
    let direction = unit(source.direction);
    let along = dot(source.major, direction);
    let major = plus(source.major, times(-along, direction));
    let minor = source.minor.min(dot(major, major).sqrt());
    Source { direction, major, minor, ..*source }
}
