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

impl Glossy {
    /// The BRDF between two directions above a surface whose normal is z.
    fn value(self, light: [f64; 3], view: [f64; 3]) -> f64 {
        match self {
            Self::Matte(albedo) => albedo / PI,
            Self::Ggx([roughness, f0, albedo]) => ggx(roughness, f0, albedo, light, view),
        }
    }

    /// The share of uniform light that is reflected, by sums over pairs of directions.
    pub fn albedo(self, count: usize) -> f64 {
        let sky = Sky::of(count, 0.0, |_| 1.0);
        let views = Sky::of(count, 0.3, |_| 1.0);
        let mut sum = 0.0;
        for (view, each) in views.0.iter().filter(|(view, _)| view[2] > 0.0) {
            for (light, angle) in sky.0.iter().filter(|(light, _)| light[2] > 0.0) {
                sum += self.value(*light, *view) * light[2] * view[2] * angle * each;
            }
        }
        sum / PI
    }
}

/// Whether a ray from a point is blocked.
pub type Blocked<'a> = &'a (dyn Fn([f64; 3], [f64; 3]) -> bool + Sync);

/// A triangle by its corners.
pub type Triangle = [[f64; 3]; 3];

/// How far a ray goes to a triangle: T. Möller and B. Trumbore, 1997.
fn distance([a, b, c]: &Triangle, from: [f64; 3], along: [f64; 3]) -> Option<f64> {
    let to = |p: &[f64; 3], q: &[f64; 3]| [0, 1, 2].map(|k: usize| p[k] - q[k]);
    let (u, v) = (to(b, a), to(c, a));
    let p = cross(along, v);
    let volume = dot(u, p);
    let t = [0, 1, 2].map(|k: usize| from[k] - a[k]);
    let first = dot(t, p) / volume;
    let q = cross(t, u);
    let second = dot(along, q) / volume;
    let is_inside = volume.abs() > 1e-12 && first >= 0.0 && second >= 0.0 && first + second <= 1.0;
    let distance = dot(v, q) / volume;
    (is_inside && distance > 1e-6).then_some(distance)
}

/// Whether triangles block a ray.
pub fn is_hit(triangles: &[Triangle], from: [f64; 3], along: [f64; 3]) -> bool {
    triangles.iter().any(|triangle| distance(triangle, from, along).is_some())
}

/// The nearest point of triangles along a ray, and the normal there.
pub fn hit(
    triangles: &[Triangle],
    from: [f64; 3],
    along: [f64; 3],
) -> Option<([f64; 3], [f64; 3])> {
    let all = triangles.iter().filter_map(|one| Some((distance(one, from, along)?, one)));
    let (far, [a, b, c]) = all.min_by(|a, b| a.0.total_cmp(&b.0))?;
    let normal =
        cross([0, 1, 2].map(|k: usize| b[k] - a[k]), [0, 1, 2].map(|k: usize| c[k] - a[k]));
    let length = dot(normal, normal).sqrt();
    Some(([0, 1, 2].map(|k| from[k] + far * along[k]), normal.map(|x| x / length)))
}

/// Heights on a square grid, with two triangles in each cell, cut off beyond a radius.
pub struct Heights {
    side: usize,
    /// The distance between points; the middle of the grid is the origin.
    step: f64,
    radius: f64,
    heights: Vec<f64>,
    /// The highest of each block of cells, and of all.
    highest: Vec<f64>,
    top: f64,
}

/// Cells along each side of a block.
const BLOCK: usize = 12;

impl Heights {
    pub fn new(side: usize, step: f64, radius: f64, heights: Vec<f64>) -> Self {
        let blocks = side.div_ceil(BLOCK);
        let mut highest = vec![f64::NEG_INFINITY; blocks * blocks];
        for (place, height) in heights.iter().enumerate() {
            let [row, column] = [place / side, place % side];
            // Points on an edge are of both blocks.
            for j in [row.saturating_sub(1) / BLOCK, row / BLOCK] {
                for i in [column.saturating_sub(1) / BLOCK, column / BLOCK] {
                    let block = &mut highest[j * blocks + i];
                    *block = block.max(*height);
                }
            }
        }
        let top = heights.iter().copied().fold(0.0, f64::max);
        Self { side, step, radius, heights, highest, top }
    }

    /// A coordinate in cells.
    fn place(&self, along: f64) -> f64 {
        along / self.step + (self.side - 1) as f64 / 2.0
    }

    /// The height of the triangle at a point.
    fn at(&self, x: f64, y: f64) -> f64 {
        let (x, y) = (self.place(x), self.place(y));
        let (i, j) = (x as usize, y as usize);
        let (u, v) = (x.fract(), y.fract());
        let height = |i: usize, j: usize| self.heights[j * self.side + i];
        let (from, to) = (height(i, j), height(i + 1, j + 1));
        if u >= v {
            from + u * (height(i + 1, j) - from) + v * (to - height(i + 1, j))
        } else {
            from + v * (height(i, j + 1) - from) + u * (to - height(i, j + 1))
        }
    }

    /// Marches along a ray in steps of a tenth of a cell, and leaps over blocks below it.
    pub fn is_hit(&self, from: [f64; 3], along: [f64; 3]) -> bool {
        let step = 0.1 * self.step / along[0].hypot(along[1]).max(0.05);
        let at =
            |k: u32| [0, 1, 2].map(|axis: usize| from[axis] + f64::from(k) * step * along[axis]);
        let mut k = 1;
        loop {
            let [x, y, z] = at(k);
            if z > self.top || x.hypot(y) > self.radius {
                return false;
            }
            // The last step within the block, at most.
            let within = [(x, along[0]), (y, along[1])].map(|(place, along)| {
                let block = self.place(place) / BLOCK as f64;
                let edge = if along > 0.0 { block.floor() + 1.0 } else { block.floor() };
                (edge - block) * BLOCK as f64 * self.step / (along * step)
            });
            let most = within[0].min(within[1]).clamp(0.0, 1e6) as u32;
            let [.., low] = at(k + most);
            let [i, j] = [x, y].map(|along| self.place(along) as usize / BLOCK);
            if z.min(low) > self.highest[j * self.side.div_ceil(BLOCK) + i] {
                k += most.max(1);
            } else if self.at(x, y) > z {
                return true;
            } else {
                k += 1;
            }
        }
    }
}

/// The radiance that comes to a point along a direction.
pub type Radiance<'a> = &'a (dyn Fn([f64; 3], [f64; 3]) -> f64 + Sync);

/// Directions with the radiance from them times their solid angle.
pub struct Sky(pub Vec<([f64; 3], f64)>);

impl Sky {
    /// Of a light in harmonics; `start` turns the spiral.
    pub fn new(light: &[f64], count: usize, start: f64) -> Self {
        let light = ExplicitLight::new(light);
        Self::of(count, start, |direction| light.radiance(direction))
    }

    /// Of a radiance.
    pub fn of(count: usize, start: f64, radiance: impl Fn([f64; 3]) -> f64) -> Self {
        let each = 4.0 * PI / count as f64;
        let directions = (0..count).map(|k| {
            let z = 1.0 - (2 * k + 1) as f64 / count as f64;
            let (sine, cosine) = (start + TAU * 0.618_033_988_75 * k as f64).sin_cos();
            let across = (1.0 - z * z).sqrt();
            let direction = [across * cosine, across * sine, z];
            (direction, each * radiance(direction))
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
        self.reflected(pixels, material, &|from, along| f64::from(!blocked(from, along)))
    }

    /// The same where a point receives this times the radiance of the sky.
    pub fn reflected(
        &self,
        pixels: &[&[Point]],
        material: Glossy,
        factor: Radiance<'_>,
    ) -> Vec<f64> {
        parallel::map(pixels.len(), &(), |k| {
            let sum = pixels[k].iter().map(|point| self.irradiance(point, material, factor));
            sum.sum::<f64>() / pixels[k].len() as f64
        })
    }

    /// The irradiance of a matte point.
    pub fn matte(&self, place: [f64; 3], normal: [f64; 3], blocked: Blocked<'_>) -> f64 {
        let from = [0, 1, 2].map(|axis| place[axis] + 1e-5 * normal[axis]);
        let above = self.0.iter().filter(|(direction, _)| dot(normal, *direction) > 0.0);
        let free = above.filter(|(direction, _)| !blocked(from, *direction));
        free.map(|(direction, light)| dot(normal, *direction) * light).sum()
    }

    fn irradiance(&self, point: &Point, material: Glossy, factor: Radiance<'_>) -> f64 {
        let normal = point.normal;
        let other = if normal[0].abs() < 0.7 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
        let x = cross(normal, other);
        let length = dot(x, x).sqrt();
        let x = x.map(|along| along / length);
        let frame = [x, cross(normal, x), normal];
        let view = frame.map(|axis| axis[2]);
        let from = [0, 1, 2].map(|axis| point.position[axis] + 1e-5 * point.facet[axis]);
        let above = self.0.iter().filter(|(direction, _)| dot(normal, *direction) > 0.0);
        above
            .map(|(direction, light)| {
                let local = frame.map(|axis| dot(axis, *direction));
                factor(from, *direction) * material.value(local, view) * local[2] * light
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
