//! Normals of a sphere at which polished materials show the lamps of environment maps.
//!
//! Equal areas of a sphere's picture mirror equal solid angles, so evenly spaced normals meet a
//! small lamp by chance. Here more normals are drawn, which mirror blocks of texels in proportion
//! to the square of their luminance: of one texel for the sharpest lobes, and of more for wider
//! ones. Each normal weighs the inverse of the density of all normals where it is (the balance
//! heuristic: E. Veach and L. Guibas, "Optimally Combining Sampling Techniques for Monte Carlo
//! Rendering", SIGGRAPH 1995).

use crate::sources::sphere::Sphere;
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_model::database::luminance;
use eigenshade_model::sphere_rings::{Ring, rings};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Texels along a side of the blocks.
const SIZES: [usize; 3] = [1, 4, 16];
/// Normals drawn for the blocks of one size of one map, times the square of the spacing.
const DRAWN: f64 = 0.09;
/// Steps of a sequence that fills a square evenly: 1 / p and 1 / p² with p³ = p + 1.
const STEPS: [f64; 2] = [0.754_877_666_246_693, 0.569_840_290_998_053];

/// The normals of [`rings`] of this spacing in radians, the normals drawn for the maps, and others
/// that have no weight.
pub fn sphere(maps: &[EnvironmentMap], spacing: f64, others: &[[f64; 3]]) -> Sphere {
    let fits = |map: &EnvironmentMap, size: usize| {
        map.width.is_multiple_of(size) && map.height.is_multiple_of(size)
    };
    let of_map = |map| {
        let sizes = SIZES.into_iter().filter(move |&size| fits(map, size));
        sizes.map(move |size| Blocks::new(map, size))
    };
    let all: Vec<Blocks> = maps.iter().flat_map(of_map).collect();
    let drawn = (DRAWN / (spacing * spacing)).ceil();
    let mut normals = rings(spacing);
    let even = normals.len();
    for (number, blocks) in all.iter().enumerate() {
        for k in 0..drawn as usize {
            let place = number as f64 * drawn + k as f64 + 1.0;
            let direction =
                blocks.direction((k as f64 + 0.5) / drawn, STEPS.map(|s| (s * place).fract()));
            let [x, y, z] = half_way(direction);
            let slant = z.clamp(0.0, 1.0).acos();
            let ring = (slant / FRAC_PI_2 * even as f64) as usize;
            let weight = normals[ring.min(even - 1)].weight;
            normals.push(Ring { slant, tilts: vec![y.atan2(x)], weight });
        }
    }
    normals.extend(others.iter().map(|&[x, y, z]| {
        let slant = z.clamp(0.0, 1.0).acos();
        Ring { slant, tilts: vec![y.atan2(x)], weight: 0.0 }
    }));
    let mut sphere = Sphere::new(normals);
    for (&[x, y, z], weight) in sphere.normals.iter().zip(&mut sphere.weights) {
        let mirrored = [2.0 * x * z, 2.0 * y * z, 2.0 * z * z - 1.0];
        let density: f64 = all.iter().map(|blocks| drawn * blocks.density(mirrored)).sum();
        *weight = (weight.recip() + density).recip();
    }
    let sum: f64 = sphere.weights.iter().sum();
    sphere.weights.iter_mut().for_each(|weight| *weight /= sum);
    sphere
}

/// The normal that mirrors a direction toward the camera.
fn half_way([x, y, z]: [f64; 3]) -> [f64; 3] {
    let length = (2.0 + 2.0 * z).max(0.0).sqrt();
    if length > 0.0 { [x / length, y / length, (z + 1.0) / length] } else { [1.0, 0.0, 0.0] }
}

/// A map in blocks.
struct Blocks {
    columns: usize,
    rows: usize,
    /// The share of the normals that mirror this block or one before it.
    cumulative: Vec<f64>,
    /// The density of mirrored directions, relative to evenly spaced ones.
    densities: Vec<f64>,
}

impl Blocks {
    fn new(map: &EnvironmentMap, size: usize) -> Self {
        let (columns, rows) = (map.width / size, map.height / size);
        let mut blocks = vec![[0.0; 2]; columns * rows];
        for (texel, &rgb) in map.texels.iter().enumerate() {
            let (column, row) = (texel % map.width, texel / map.width);
            let [power, solid_angle] = &mut blocks[row / size * columns + column / size];
            *power += luminance(rgb.map(f64::from)).max(0.0) * map.solid_angle(row);
            *solid_angle += map.solid_angle(row);
        }
        let squares = blocks.iter().map(|[power, solid_angle]| power * power / solid_angle);
        let sum: f64 = squares.clone().sum();
        // A black map has no lamps.
        let shares: Vec<f64> =
            squares.map(|square| if sum > 0.0 { square / sum } else { 0.0 }).collect();
        let add = |before: &mut f64, share: &f64| {
            *before += share;
            Some(*before)
        };
        let densities = shares.iter().zip(&blocks);
        Self {
            columns,
            rows,
            cumulative: shares.iter().scan(0.0, add).collect(),
            densities: densities.map(|(share, [_, of])| share / (of / (4.0 * PI))).collect(),
        }
    }

    /// A direction in the block at this share of them all, and at this place in the block.
    fn direction(&self, share: f64, [along, down]: [f64; 2]) -> [f64; 3] {
        let block = self.cumulative.partition_point(|&before| before < share);
        let block = block.min(self.cumulative.len() - 1);
        let (column, row) = (block % self.columns, block / self.columns);
        let height = |row: usize| (PI * row as f64 / self.rows as f64).cos();
        let height = height(row) + down * (height(row + 1) - height(row));
        let across = (1.0 - height * height).max(0.0).sqrt();
        let turn = TAU * ((column as f64 + along) / self.columns as f64 - 0.5);
        [turn.sin() * across, height, -turn.cos() * across]
    }

    fn density(&self, direction: [f64; 3]) -> f64 {
        self.densities[texel_of(direction, self.columns, self.rows)]
    }
}

/// The texel in which a direction is, in a map of this size.
pub(crate) fn texel_of([x, y, z]: [f64; 3], width: usize, height: usize) -> usize {
    let column = (x.atan2(-z) / TAU + 0.5) * width as f64;
    let row = y.clamp(-1.0, 1.0).acos() / PI * height as f64;
    (row as usize).min(height - 1) * width + (column as usize).min(width - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A lamp of one texel on a dark sky: the weighted share of the normals that mirror it is its
    /// share of all directions, and there are many.
    #[test]
    fn lamps_are_mirrored_and_weigh_their_solid_angle() {
        let (width, height) = (64, 32);
        let mut texels = vec![[0.01; 3]; width * height];
        let (column, row) = (40, 20);
        texels[row * width + column] = [1e4; 3];
        let map = EnvironmentMap { width, height, texels };
        let share = map.solid_angle(row) / (4.0 * PI);
        let lamp = Blocks::new(&map, 1);
        let sphere = sphere(std::slice::from_ref(&map), 0.08, &[[0.0, 0.0, 1.0]]);
        let mirrors = |&[x, y, z]: &[f64; 3]| {
            lamp.density([2.0 * x * z, 2.0 * y * z, 2.0 * z * z - 1.0]) > 1.0
        };
        let at_lamp = sphere.normals.iter().zip(&sphere.weights).filter(|(n, _)| mirrors(n));
        let (count, weight) = at_lamp.fold((0, 0.0), |(n, sum), (_, weight)| (n + 1, sum + weight));
        assert!(count > 10, "{count}");
        assert!((weight / share - 1.0).abs() < 0.1, "{weight} {share}");
        assert!((sphere.weights.iter().sum::<f64>() - 1.0).abs() < 1e-12);
        // Means of smooth functions stay those of the disc.
        let mean: f64 = sphere.normals.iter().zip(&sphere.weights).map(|(n, w)| n[2] * w).sum();
        assert!((mean - 2.0 / 3.0).abs() < 0.01, "{mean}");
    }
}
