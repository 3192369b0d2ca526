//! A brute-force integrator that shares no code with the transports: each triangle by itself, or steps
//! along a ray over heights; directions on a spiral; formulas by vectors.

use eigenshade_generator::object::points::Point;
use eigenshade_model::parallel;
use eigenshade_model::vector::{cross, dot};
use eigenshade_testing::oracle::{ExplicitLight, ggx};
use std::f64::consts::{PI, TAU};

/// Roughness, reflectance at normal incidence and albedo of a GGX material; a matte one has 0
/// reflectance and no roughness.
#[derive(Clone, Copy)]
pub enum Glossy {
    Matte(f64),
    Ggx([f64; 3]),
}

/// Whether a ray from a point is blocked.
pub type Blocked<'a> = &'a (dyn Fn([f64; 3], [f64; 3]) -> bool + Sync);

/// The triangles that block light, one by one: T. Möller and B. Trumbore, 1997.
pub fn is_hit(triangles: &[[[f64; 3]; 3]], from: [f64; 3], along: [f64; 3]) -> bool {
    triangles.iter().any(|[a, b, c]| {
        let to = |p: &[f64; 3], q: &[f64; 3]| [0, 1, 2].map(|k: usize| p[k] - q[k]);
        let (u, v) = (to(b, a), to(c, a));
        let p = cross(along, v);
        let volume = dot(u, p);
        let t = [0, 1, 2].map(|k: usize| from[k] - a[k]);
        let first = dot(t, p) / volume;
        let q = cross(t, u);
        let second = dot(along, q) / volume;
        volume.abs() > 1e-12
            && first >= 0.0
            && second >= 0.0
            && first + second <= 1.0
            && dot(v, q) / volume > 1e-6
    })
}

/// Heights on a square grid, with two triangles in each cell, cut off beyond a radius.
pub struct Heights<'a> {
    pub side: usize,
    /// The distance between points; the middle of the grid is the origin.
    pub step: f64,
    pub radius: f64,
    pub highest: f64,
    pub heights: &'a [f64],
}

impl Heights<'_> {
    /// The height of the triangle at a point; none beyond the radius.
    fn at(&self, x: f64, y: f64) -> Option<f64> {
        if x.hypot(y) > self.radius {
            return None;
        }
        let place = |along: f64| along / self.step + (self.side - 1) as f64 / 2.0;
        let (x, y) = (place(x), place(y));
        let (i, j) = (x as usize, y as usize);
        let (u, v) = (x.fract(), y.fract());
        let height = |i: usize, j: usize| self.heights[j * self.side + i];
        let (from, to) = (height(i, j), height(i + 1, j + 1));
        Some(if u >= v {
            from + u * (height(i + 1, j) - from) + v * (to - height(i + 1, j))
        } else {
            from + v * (height(i, j + 1) - from) + u * (to - height(i, j + 1))
        })
    }

    /// Marches along a ray in steps of a tenth of a cell.
    pub fn is_hit(&self, from: [f64; 3], along: [f64; 3]) -> bool {
        let step = 0.1 * self.step / along[0].hypot(along[1]).max(0.05);
        for k in 1.. {
            let [x, y, z] = [0, 1, 2].map(|axis| from[axis] + f64::from(k) * step * along[axis]);
            match self.at(x, y) {
                _ if z > self.highest => return false,
                None => return false,
                Some(height) if height > z => return true,
                Some(_) => {}
            }
        }
        false
    }
}

/// Directions with the radiance from them times their solid angle.
pub struct Sky(Vec<([f64; 3], f64)>);

impl Sky {
    /// Of a light in harmonics; `start` turns the spiral.
    pub fn new(light: &[f64], count: usize, start: f64) -> Self {
        let light = ExplicitLight::new(light);
        let each = 4.0 * PI / count as f64;
        let directions = (0..count).map(|k| {
            let z = 1.0 - (2 * k + 1) as f64 / count as f64;
            let (sine, cosine) = (start + TAU * 0.618_033_988_75 * k as f64).sin_cos();
            let across = (1.0 - z * z).sqrt();
            let direction = [across * cosine, across * sine, z];
            (direction, each * light.radiance(direction))
        });
        Self(directions.collect())
    }

    /// The irradiances of pixels, each the mean of its points.
    pub fn irradiances(
        &self,
        pixels: &[&[Point]],
        material: Glossy,
        blocked: Blocked<'_>,
    ) -> Vec<f64> {
        parallel::map(pixels.len(), &(), |k| {
            let sum = pixels[k].iter().map(|point| self.irradiance(point, material, blocked));
            sum.sum::<f64>() / pixels[k].len() as f64
        })
    }

    fn irradiance(&self, point: &Point, material: Glossy, blocked: Blocked<'_>) -> f64 {
        let normal = point.normal;
        let other = if normal[0].abs() < 0.7 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
        let x = cross(normal, other);
        let length = dot(x, x).sqrt();
        let x = x.map(|along| along / length);
        let frame = [x, cross(normal, x), normal];
        let view = frame.map(|axis| axis[2]);
        let from = [0, 1, 2].map(|axis| point.position[axis] + 1e-5 * point.facet[axis]);
        let above = self.0.iter().filter(|(direction, _)| dot(normal, *direction) > 0.0);
        let free = above.filter(|(direction, _)| !blocked(from, *direction));
        free.map(|(direction, light)| {
            let local = frame.map(|axis| dot(axis, *direction));
            let value = match material {
                Glossy::Matte(albedo) => albedo / PI,
                Glossy::Ggx([roughness, f0, albedo]) => ggx(roughness, f0, albedo, local, view),
            };
            value * local[2] * light
        })
        .sum()
    }
}

/// The rms of differences in percent of white, the largest expected value.
pub fn percent(expected: &[f64], found: &[f64]) -> f64 {
    let white = expected.iter().copied().fold(0.0, f64::max);
    let square: f64 = expected.iter().zip(found).map(|(a, b)| (a - b) * (a - b)).sum();
    100.0 * (square / expected.len() as f64).sqrt() / white
}
