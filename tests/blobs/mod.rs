//! Oracles of small sources, in f64: the blob that defines a source by quadrature, and the
//! microfacet formula in slopes.

use eigenshade::{Gloss, Source};
use eigenshade_model::source::{Gloss as GlossOfHost, Source as SourceOfHost};
use std::f64::consts::PI;

pub use eigenshade_testing::fixtures::disc;
pub use eigenshade_testing::vectors::{VIEW, Vector, at, cross, dot, scaled, sum, unit};

/// Two tangents at a direction that is not the view's negative: away from the view, and across.
pub fn tangents(direction: Vector) -> [Vector; 2] {
    let across = cross(VIEW, direction);
    let across = if dot(across, across) > 1e-24 { unit(across) } else { [0.0, 1.0, 0.0] };
    [cross(across, direction), across]
}

/// A source in f64.
#[derive(Clone, Copy, Debug)]
pub struct Blob {
    pub direction: Vector,
    pub spread: f64,
}

impl Blob {
    pub fn of_host(&self, energy: [f64; 3]) -> SourceOfHost {
        SourceOfHost { direction: self.direction, energy, spread: self.spread }
    }

    pub fn source(&self, energy: [f64; 3]) -> Source {
        let [direction, energy] = [self.direction, energy].map(|v| v.map(|x| x as f32));
        Source::new(direction, energy, self.spread as f32).expect("a small source")
    }

    /// Directions and weights that integrate the blob as it is defined, a heat kernel, by trapezoid
    /// sums of this spacing at most. A step of one standard deviation leaves 2 exp(-2 π²) = 5e-9,
    /// and the tails beyond six 2e-9.
    pub fn nodes(&self, spacing: f64) -> Vec<(Vector, f64)> {
        let [a, b] = tangents(self.direction);
        let node = |([u, v], weight): ([f64; 2], f64)| {
            let angle = u.hypot(v);
            let tangent = sum(scaled(a, u), v, b);
            let ratio = if angle > 0.0 { angle.sin() / angle } else { 1.0 };
            (sum(scaled(self.direction, angle.cos()), ratio, tangent), weight)
        };
        let mut nodes: Vec<_> = heat_kernel(self.spread, spacing).into_iter().map(node).collect();
        let total: f64 = nodes.iter().map(|(_, weight)| weight).sum();
        nodes.iter_mut().for_each(|(_, weight)| *weight /= total);
        nodes
    }
}

/// Points of a tangent plane, as angles, and weights of the heat kernel there: its harmonics summed
/// at each distance.
pub fn heat_kernel(spread: f64, spacing: f64) -> Vec<([f64; 2], f64)> {
    if spread == 0.0 {
        return vec![([0.0; 2], 1.0)];
    }
    let variance = spread * spread;
    let value = |cosine: f64| {
        let (mut before, mut now, mut sum) = (0.0, 1.0, 0.0);
        for l in 0..(9.0 / spread) as i32 + 8 {
            let degree = f64::from(l);
            sum += (2.0 * degree + 1.0) * (-0.5 * degree * (degree + 1.0) * variance).exp() * now;
            let next = ((2.0 * degree + 1.0) * cosine * now - degree * before) / (degree + 1.0);
            (before, now) = (now, next);
        }
        sum
    };
    let reach = (6.0 * spread).min(3.1);
    let step = spacing.min(spread);
    let count = (reach / step).ceil() as i32;
    let point = |[u, v]: [f64; 2]| {
        let angle = u.hypot(v);
        let ratio = if angle > 0.0 { angle.sin() / angle } else { 1.0 };
        (angle < reach).then(|| ([u, v], value(angle.cos()) * ratio))
    };
    grid(count, step).filter_map(point).collect()
}

/// The points of a square grid around 0.
fn grid(count: i32, step: f64) -> impl Iterator<Item = [f64; 2]> {
    let range = -count..=count;
    let pairs = range.clone().flat_map(move |i| range.clone().map(move |j| [i, j]));
    pairs.map(move |pair| pair.map(|k| f64::from(k) * step))
}

/// A material in f64, one channel.
#[derive(Clone, Copy, Debug)]
pub struct Glossy {
    pub roughness: f64,
    pub f0: f64,
    pub albedo: f64,
}

impl Glossy {
    pub fn alpha(&self) -> f64 {
        self.roughness * self.roughness
    }

    pub fn of_host(&self) -> GlossOfHost {
        let Self { roughness, f0, albedo } = *self;
        GlossOfHost { roughness, reflectance: [f0; 3], grazing: [1.0; 3], albedo: [albedo; 3] }
    }

    pub fn gloss(&self) -> Gloss {
        let [roughness, f0, albedo] = [self.roughness, self.f0, self.albedo].map(|x| x as f32);
        Gloss::new(roughness, [f0; 3], [albedo; 3]).expect("numbers from 0 to 1")
    }

    pub fn fresnel(&self, cosine: f64) -> f64 {
        self.f0 + (1.0 - self.f0) * (1.0 - cosine).powi(5)
    }

    /// Smith's term for the cosines of light and view.
    pub fn visibility(&self, light: f64, view: f64) -> f64 {
        let square = self.alpha().powi(2);
        let root = |cosine: f64| (square + (1.0 - square) * cosine * cosine).sqrt();
        0.5 / (light * root(view) + view * root(light))
    }

    /// BRDF times cosine for light from one direction at a normal.
    pub fn reflected(&self, light: Vector, normal: Vector) -> f64 {
        let [cosine, view] = [dot(light, normal), normal[2]];
        if cosine <= 0.0 {
            return 0.0;
        }
        let half = unit(sum(light, 1.0, VIEW));
        let square = self.alpha().powi(2);
        let facing = dot(half, normal);
        let divisor = facing * facing * (square - 1.0) + 1.0;
        let distribution = square / (PI * divisor * divisor);
        let fresnel = self.fresnel(dot(half, VIEW));
        let matte = (1.0 - fresnel) * self.albedo / PI;
        cosine * (matte + fresnel * distribution * self.visibility(cosine, view))
    }

    /// The lobe of a source of energy 1, with D from slopes about the half-way direction, no wider
    /// across the plane of source and view than a uniform one.
    pub fn lobe(&self, blob: &Blob, normal: Vector) -> f64 {
        let [cosine, view] = [dot(blob.direction, normal), normal[2]];
        if cosine <= 0.0 {
            return 0.0;
        }
        let half = unit(sum(blob.direction, 1.0, VIEW));
        let along_view = dot(half, VIEW);
        let square = self.alpha().powi(2);
        // The variances of the half-way direction, along the plane and across.
        let jacobian = [0.5, 0.5 / along_view];
        let wide = jacobian.map(|slope| (slope * blob.spread).powi(2));
        let blur = 2.0 + 1.0 / (1.0 + 0.5 * (wide[0] + wide[1]) / square);
        let [first, second] = wide.map(|wide| square + blur * wide);
        let second = second.min(1.0);
        let behind = (blob.spread / along_view).powi(2);
        let faded = 1.0 / (1.0 + 0.5 * behind * behind);
        // The tangents of the source's plane at the half-way direction.
        let across = tangents(blob.direction)[1];
        let along = cross(across, half);
        let facing = dot(half, normal);
        let [p, q] = [dot(along, normal) / facing, dot(across, normal) / facing];
        let quadratic = p * p / first + q * q / second;
        let distribution =
            1.0 / (PI * (first * second).sqrt() * facing.powi(4) * (1.0 + quadratic).powi(2));
        let fresnel = self.fresnel(along_view);
        let matte = (1.0 - fresnel) * self.albedo / PI;
        cosine * (matte + faded * fresnel * distribution * self.visibility(cosine, view))
    }
}

/// Normals around the half-way direction of a source, in steps of a part of the lobe.
pub fn around(blob: &Blob, step: f64, count: i32) -> Vec<Vector> {
    let half = unit(sum(blob.direction, 1.0, VIEW));
    let [a, b] = tangents(half);
    let normals = grid(count, step).map(|[u, v]| unit(sum(sum(half, u, a), v, b)));
    normals.filter(|normal| normal[2] >= 0.0).collect()
}

/// Blobs by angle from the view, from a point to the widest.
pub fn blobs(degrees: &[f64]) -> Vec<Blob> {
    let mut blobs = Vec::new();
    for (k, degrees) in degrees.iter().enumerate() {
        let direction = at(degrees.to_radians(), 0.4 + 1.3 * k as f64);
        blobs.extend([0.0, 0.02, 0.05, 0.2, 0.5].map(|spread| Blob { direction, spread }));
    }
    blobs
}

pub const ANGLES: [f64; 9] = [0.0, 0.01, 5.0, 40.0, 80.0, 90.0, 110.0, 150.0, 175.0];

/// Normals of the disc, around the highlight, and of the rim.
pub fn normals_for(blob: &Blob, width: f64) -> Vec<Vector> {
    let mut normals = disc(24);
    normals.extend(around(blob, 0.4 * width, 5));
    normals.extend(
        (0..24).map(|k| at(0.5 * PI, f64::from(k) * PI / 12.0)).map(|[x, y, _]| [x, y, 0.0]),
    );
    normals.push(VIEW);
    normals
}
