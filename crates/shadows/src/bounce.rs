//! Light between parts of a surface, as a matte one reflects it.
//!
//! Facets are divided into patches: the parts in a cell of a grid that face the same side of a cube. The
//! irradiance of a patch is E = ∫ V (n·w) L dw, and that by other patches: E_i = E_i0 + Σ_j F_ij ρ E_j,
//! where F_ij is the share of the hemisphere of i, weighted with the cosine, that j covers, and ρ the
//! albedo. A patch has the radiance ρ E / π in all directions (C. M. Goral, K. E. Torrance, D. P.
//! Greenberg, B. Battaile, "Modeling the interaction of light between diffuse surfaces", 1984).

use crate::directions::{FINE, cells};
use crate::visibility::{Met, Occluders, Place, double};
use eigenshade_model::parallel;
use eigenshade_model::vector::{cross, dot};
use faer::{Mat, MatRef, Par};
use obvhs::triangle::Triangle;
use std::collections::HashMap;
use std::f64::consts::PI;

/// The most patches.
const MOST: usize = 4096;

/// Points of the surface that find the patches.
const SAMPLES: usize = 1 << 16;

/// The most points of a patch; its rays start from them in turns.
const STARTS: usize = 16;

/// The least side of a cell, in the unit of the surface.
const LEAST: f64 = 1e-6;

/// Rays of a patch along each side of the map of directions.
const RAYS: usize = 32;

/// Patches that are integrated together.
const BATCH: usize = 64;

/// A cell of the grid, and the axis that is nearest to the normal, with its sign.
type Key = ([i32; 3], u8);

/// The patches of a surface under light in some columns.
pub struct Patches {
    /// The side of a cell.
    side: f64,
    numbers: HashMap<Key, u32>,
    /// A point of each.
    places: Vec<Place>,
    /// E_0, with a row for each column of the light and a column for each patch.
    direct: Mat<f32>,
    /// For each patch i, each j with F_ij.
    factors: Vec<Vec<(u32, f32)>>,
}

impl Patches {
    /// At most 4,096 patches, each with 1,024 rays, whose light is the mean of `light` around them. The
    /// rows of `light` are the [`FINE`] cells. Memory: four bytes for each patch and column, and
    /// eight for each pair of patches that see each other.
    #[must_use]
    pub fn new(occluders: &Occluders, light: MatRef<'_, f32>) -> Self {
        let (samples, area) = samples(&occluders.triangles);
        let (side, numbers, members) = divided(&samples, area);
        let places = members.iter().map(|members| members[members.len() / 2]).collect();
        let direct = Mat::zeros(light.ncols(), members.len());
        let mut patches = Self { side, numbers, places, direct, factors: Vec::new() };
        let (cells, light) = (cells(RAYS), coarse(light));
        let found = parallel::map(members.len().div_ceil(BATCH), &(), |batch| {
            let members = &members[batch * BATCH..((batch + 1) * BATCH).min(members.len())];
            let mut weights = Mat::<f32>::zeros(cells.len(), members.len());
            let factors: Vec<_> = (members.iter().enumerate())
                .map(|(k, starts)| {
                    patches.integrate(starts, occluders, &cells, weights.col_as_slice_mut(k))
                })
                .collect();
            let mut direct = Mat::<f32>::zeros(light.ncols(), members.len());
            let light = light.transpose();
            faer::linalg::matmul::matmul(
                &mut direct,
                faer::Accum::Replace,
                light,
                &weights,
                1.0,
                Par::Seq,
            );
            (direct, factors)
        });
        for (batch, (direct, factors)) in found.into_iter().enumerate() {
            let columns = patches.direct.as_mut().subcols_mut(batch * BATCH, factors.len());
            { columns }.copy_from(&direct);
            patches.factors.extend(factors);
        }
        patches
    }

    /// The number of patches.
    #[must_use]
    pub fn count(&self) -> usize {
        self.places.len()
    }

    /// The patch of a point: of its cell, or the most alike of those around.
    #[must_use]
    pub fn at(&self, place: &Place) -> Option<u32> {
        let (cell, axis) = key(place, self.side);
        if let Some(number) = self.numbers.get(&(cell, axis)) {
            return Some(*number);
        }
        let around = (0..27).map(|k| [k % 3, k / 3 % 3, k / 9]);
        let keys = around.flat_map(|step| {
            (0..6).map(move |axis| ([0, 1, 2].map(|k: usize| cell[k] + step[k] - 1), axis))
        });
        let likeness = |number: &u32| {
            let other = self.places[*number as usize];
            let apart = [0, 1, 2].map(|k: usize| other.position[k] - place.position[k]);
            dot(other.facet, place.facet) - dot(apart, apart).sqrt() / self.side
        };
        keys.filter_map(|key| self.numbers.get(&key).copied())
            .max_by(|a, b| likeness(a).total_cmp(&likeness(b)))
    }

    /// ρ E / π of each patch after this many reflections by others, in the shape of E_0.
    #[must_use]
    pub fn radiance(&self, albedo: f64, bounces: usize) -> Mat<f32> {
        let mut all = self.direct.clone();
        for _ in 1..bounces {
            let columns = parallel::map(self.factors.len(), &(), |patch| {
                let mut sum = self.direct.col_as_slice(patch).to_vec();
                for (other, factor) in &self.factors[patch] {
                    let factor = factor * albedo as f32;
                    let other = all.col_as_slice(*other as usize);
                    sum.iter_mut().zip(other).for_each(|(sum, one)| *sum += factor * one);
                }
                sum
            });
            for (patch, column) in columns.into_iter().enumerate() {
                all.col_as_slice_mut(patch).copy_from_slice(&column);
            }
        }
        all * faer::Scale((albedo / PI) as f32)
    }

    /// Sets V (n·w) dw in each cell of the rays of a patch. Returns its F_ij.
    fn integrate(
        &self,
        starts: &[Place],
        occluders: &Occluders,
        cells: &[([f64; 3], f64)],
        weights: &mut [f32],
    ) -> Vec<(u32, f32)> {
        let (mut factors, mut all) = (HashMap::<u32, f64>::new(), 0.0);
        for (cell, (ray, angle)) in cells.iter().enumerate() {
            let from = starts[(cell % RAYS + 2 * (cell / RAYS)) % starts.len()];
            let cosine = dot(from.facet, *ray);
            if cosine <= 0.0 {
                continue;
            }
            let weight = cosine * angle;
            all += weight;
            match occluders.meets(&from, *ray) {
                Met::Nothing => weights[cell] = weight as f32,
                Met::Front(place) => {
                    if let Some(number) = self.at(&place) {
                        *factors.entry(number).or_default() += weight;
                    }
                }
                Met::Back => {}
            }
        }
        // The cosines sum to π, but for the size of the cells.
        weights.iter_mut().for_each(|weight| *weight *= (PI / all) as f32);
        let mut factors: Vec<(u32, f32)> =
            factors.into_iter().map(|(number, weight)| (number, (weight / all) as f32)).collect();
        factors.sort_unstable_by_key(|(number, _)| *number);
        factors
    }
}

/// Points of the surface, each of the same area, and the area of all.
fn samples(triangles: &[Triangle]) -> (Vec<Place>, f64) {
    let corners = |triangle: &Triangle| [triangle.v0, triangle.v1, triangle.v2].map(double);
    let area = |triangle: &Triangle| {
        let [a, b, c] = corners(triangle);
        let edge = |to: [f64; 3]| [0, 1, 2].map(|k: usize| to[k] - a[k]);
        let product = cross(edge(b), edge(c));
        0.5 * dot(product, product).sqrt()
    };
    let areas: Vec<f64> = triangles.iter().map(area).collect();
    let total = areas.iter().sum::<f64>();
    let each = total / SAMPLES as f64;
    let (mut samples, mut sum) = (Vec::with_capacity(SAMPLES), 0.0);
    for (triangle, area) in triangles.iter().zip(areas) {
        sum += area;
        while sum > (samples.len() as f64 + 0.5) * each && samples.len() < SAMPLES {
            // M. Roberts' sequence in the square.
            let k = samples.len() as f64;
            let [u, v] = [0.754_877_666_246_692_8, 0.569_840_290_998_053_2];
            let [u, v] = [(k * u).fract(), (k * v).fract()];
            let [u, v] = if u + v > 1.0 { [1.0 - u, 1.0 - v] } else { [u, v] };
            let [a, b, c] = corners(triangle);
            samples.push(Place {
                position: [0, 1, 2].map(|k: usize| a[k] + u * (b[k] - a[k]) + v * (c[k] - a[k])),
                facet: double(triangle.compute_normal()),
            });
        }
    }
    (samples, total)
}

/// The smallest cells that have at most [`MOST`] patches; their numbers, and points of each.
fn divided(samples: &[Place], area: f64) -> (f64, HashMap<Key, u32>, Vec<Vec<Place>>) {
    let mut side = (area / MOST as f64).sqrt().max(LEAST);
    loop {
        let mut numbers = HashMap::new();
        let mut members: Vec<Vec<Place>> = Vec::new();
        for place in samples {
            let number = *numbers.entry(key(place, side)).or_insert(members.len() as u32) as usize;
            if number == members.len() {
                members.push(Vec::new());
            }
            members[number].push(*place);
        }
        if members.len() <= MOST {
            for members in &mut members {
                let step = members.len().div_ceil(STARTS);
                *members = members.iter().copied().step_by(step).collect();
            }
            return (side, numbers, members);
        }
        side *= 1.1;
    }
}

fn key(place: &Place, side: f64) -> Key {
    // The origin is no place of a corner, where rounding would decide.
    let cell = place.position.map(|along| ((along + 0.123_456_7) / side).floor() as i32);
    let axes = [0, 1, 2].map(|axis: usize| (place.facet[axis].abs(), axis));
    let (_, axis) = axes.into_iter().max_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or_default();
    (cell, 2 * axis as u8 + u8::from(place.facet[axis] > 0.0))
}

/// The means of light in the cells of the rays of a patch.
fn coarse(light: MatRef<'_, f32>) -> Mat<f32> {
    const EACH: usize = FINE / RAYS;
    let angles: Vec<f64> = cells(FINE).into_iter().map(|(_, angle)| angle).collect();
    Mat::from_fn(RAYS * RAYS, light.ncols(), |cell, column| {
        let first = cell / RAYS * EACH * FINE + cell % RAYS * EACH;
        let within = (0..EACH * EACH).map(|k| first + k / EACH * FINE + k % EACH);
        let (mut sum, mut all) = (0.0, 0.0);
        for fine in within {
            sum += angles[fine] * f64::from(light[(fine, column)]);
            all += angles[fine];
        }
        (sum / all) as f32
    })
}
