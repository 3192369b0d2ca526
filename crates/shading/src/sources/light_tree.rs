//! Direct integration of irradiance, without harmonics, degree or order, about 100 times faster than
//! summing every texel of [`Texels`].
//!
//! Texels are integrated one by one where the BRDF changes fast: near the mirror direction, near the
//! horizon and near the direction opposite to the camera. Elsewhere they are integrated in blocks of
//! 8 x 8 up to 64 x 64. Within a block, the BRDF times the cosine is the polynomial through its
//! values at 4 x 4 Chebyshev nodes. What each node contributes is a sum over the block's texels,
//! computed once for all BRDFs and normals.

use crate::sources::sphere::Picture;
use crate::sources::texels::Texels;
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::material::brdf::{Brdf, Geometry, Surface};
use eigenshade_model::database::luminance;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::parallel::{self, Progress};
use eigenshade_model::vector::dot;
use std::f64::consts::{PI, TAU};

/// Texels along a side of the smallest block.
pub const BLOCK: usize = 8;
/// Largest number of block sizes, each twice the one before.
const LEVELS: usize = 4;
/// Nodes along a side of a block.
const NODES: usize = 4;
/// A block is used if its radius is at most this share of the distance over which the BRDF changes.
const FAR: f64 = 0.25;
/// A block is used if the horizon is farther from its center than this many radii.
const HIGH: f64 = 1.25;
/// Parts of a texel for each width of the features within it: see [`Texels::weight`].
const FINENESS: f64 = 1.0;
/// Directions below this z are nearly opposite to the camera: no visible normal mirrors them.
const OPPOSITE: f64 = -0.9999;

/// Environment maps of one size, for integration.
pub struct LightTree {
    texels: Texels,
    columns: usize,
    maps: usize,
    /// For each texel and channel the radiance of every map.
    radiance: Vec<f32>,
    /// From the smallest blocks up, in rows.
    levels: Vec<Level>,
}

struct Level {
    columns: usize,
    blocks: Vec<Block>,
}

struct Block {
    center: [f64; 3],
    /// The largest angle from the center, radians.
    radius: f64,
    nodes: [[f64; 3]; NODES * NODES],
    /// For each node and channel the radiance of every map, times solid angle.
    power: Vec<f32>,
}

/// Irradiances by channel and then by map.
type Sums = [Vec<f64>; 3];

/// A surface at one normal.
struct Query<'a> {
    brdf: &'a dyn Brdf,
    normal: [f64; 3],
}

impl LightTree {
    /// Prepares maps of equal size.
    ///
    /// # Errors
    ///
    /// As [`Texels::new`], or if a side is not a multiple of 8 texels.
    pub fn new(maps: &[EnvironmentMap]) -> Result<Self> {
        let texels = Texels::new(maps)?;
        let (columns, rows) = (maps[0].width, maps[0].height);
        if !columns.is_multiple_of(BLOCK) || !rows.is_multiple_of(BLOCK) {
            let what = format!("maps of {columns} x {rows} texels");
            return Err(Error::new(what, "give maps whose sides are multiples of 8"));
        }
        let of_texel = |texel: usize| {
            (0..3).flat_map(move |c| maps.iter().map(move |map| map.texels[texel][c]))
        };
        let radiance = (0..columns * rows).flat_map(of_texel).collect();
        let sizes = (0..LEVELS).map(|level| BLOCK << level);
        let fits = |size: &usize| columns.is_multiple_of(*size) && rows.is_multiple_of(*size);
        let levels = sizes.take_while(fits).map(|size| Level {
            columns: columns / size,
            blocks: (0..rows / size)
                .flat_map(|row| (0..columns / size).map(move |column| (column, row)))
                .map(|(column, row)| Block::new(maps, [column * size, row * size], size))
                .collect(),
        });
        let levels = levels.collect();
        Ok(Self { texels, columns, maps: maps.len(), radiance, levels })
    }

    /// The number of maps.
    pub fn maps(&self) -> usize {
        self.maps
    }

    /// The unit normal that mirrors the brightest texel of a map toward z.
    ///
    /// # Panics
    ///
    /// If `map` is out of range.
    pub fn mirror(&self, map: usize) -> [f64; 3] {
        let directions = self.texels.directions();
        let brightness = |texel: usize| {
            let radiance = |c| f64::from(self.radiance[(3 * texel + c) * self.maps + map]);
            luminance([0, 1, 2].map(radiance))
        };
        let brightest = (0..directions.len())
            .filter(|&texel| directions[texel][2] > OPPOSITE)
            .max_by(|&a, &b| brightness(a).total_cmp(&brightness(b)));
        let [x, y, z] = brightest.map_or([0.0, 0.0, 1.0], |texel| directions[texel]);
        let length = (2.0 + 2.0 * z).sqrt();
        [x / length, y / length, (z + 1.0) / length]
    }

    /// The irradiance of a BRDF at a unit normal with z > 0 by map.
    pub fn irradiance(&self, brdf: &dyn Brdf, normal: [f64; 3]) -> Vec<[f64; 3]> {
        let query = Query { brdf, normal };
        let mut sums = [0, 1, 2].map(|_| vec![0.0; self.maps]);
        if let Some((level, largest)) = self.levels.iter().enumerate().next_back() {
            (0..largest.blocks.len()).for_each(|k| self.add(level, k, &query, &mut sums));
        }
        (0..self.maps).map(|map| [0, 1, 2].map(|c: usize| sums[c][map])).collect()
    }

    /// The pictures of a surface at unit normals with z > 0, by map. Counts the normals.
    pub fn pictures(
        &self,
        surface: &Surface,
        normals: &[[f64; 3]],
        progress: &impl Progress,
    ) -> Vec<Picture> {
        let parts = surface.parts();
        let at = |k: usize| -> Vec<_> {
            parts.iter().map(|part| self.irradiance(part.brdf, normals[k])).collect()
        };
        let found = parallel::map(normals.len(), progress, at);
        let of_channel = |map: usize, c: usize| {
            let color = |of_parts: &Vec<Vec<[f64; 3]>>| {
                parts.iter().zip(of_parts).map(|(part, i)| part.shares[c] * i[map][c]).sum()
            };
            found.iter().map(color).collect()
        };
        (0..self.maps).map(|map| [0, 1, 2].map(|c| of_channel(map, c))).collect()
    }

    fn add(&self, level: usize, index: usize, query: &Query<'_>, sums: &mut Sums) {
        let Level { columns, blocks } = &self.levels[level];
        let block = &blocks[index];
        let elevation = dot(block.center, query.normal).clamp(-1.0, 1.0).asin();
        if elevation < -block.radius {
            return;
        }
        if elevation > HIGH * block.radius && block.radius < FAR * query.distance(block.center) {
            for (node, &direction) in block.nodes.iter().enumerate() {
                let at = query.geometry(direction);
                self.add_part(&block.power, node, query.brdf.value(at) * at.incident, sums);
            }
            return;
        }
        let (column, row) = (index % columns, index / columns);
        match level.checked_sub(1) {
            Some(below) => {
                for (i, j) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
                    let child = (2 * row + j) * 2 * columns + 2 * column + i;
                    self.add(below, child, query, sums);
                }
            }
            None => {
                for row in BLOCK * row..BLOCK * (row + 1) {
                    for column in BLOCK * column..BLOCK * (column + 1) {
                        let texel = row * self.columns + column;
                        let Query { brdf, normal } = *query;
                        let weight = self.texels.weight(brdf, FINENESS, texel, normal);
                        if weight != 0.0 {
                            self.add_part(&self.radiance, texel, weight, sums);
                        }
                    }
                }
            }
        }
    }

    /// Adds part number `part` of `parts`, times a weight.
    fn add_part(&self, parts: &[f32], part: usize, weight: f64, sums: &mut Sums) {
        let start = 3 * self.maps * part;
        let channels = parts[start..start + 3 * self.maps].chunks_exact(self.maps);
        for (sums, part) in sums.iter_mut().zip(channels) {
            for (sum, &part) in sums.iter_mut().zip(part) {
                *sum += weight * f64::from(part);
            }
        }
    }
}

impl Query<'_> {
    fn geometry(&self, direction: [f64; 3]) -> Geometry {
        let incident = dot(direction, self.normal).max(0.0);
        Geometry { incident, reflected: self.normal[2], between: direction[2] }
    }

    /// The distance over which the BRDF changes by its own size, radians.
    fn distance(&self, direction: [f64; 3]) -> f64 {
        let at = self.geometry(direction);
        let (_, sine) = at.half_squared();
        2.0 * at.difference_cosine() * sine.sqrt().max(self.brdf.width())
    }
}

impl Block {
    /// The block of `size` x `size` texels from this column and row on.
    fn new(maps: &[EnvironmentMap], [column, row]: [usize; 2], size: usize) -> Self {
        let (width, height) = (maps[0].width as f64, maps[0].height as f64);
        let middle = |start: usize| start as f64 + 0.5 * size as f64;
        let direction = |[u, v]: [f64; 2]| {
            let (sin_polar, cos_polar) = (PI * v / height).sin_cos();
            let (sin_t, cos_t) = (TAU * (u / width - 0.5)).sin_cos();
            [sin_t * sin_polar, cos_polar, -cos_t * sin_polar]
        };
        let center = direction([middle(column), middle(row)]);
        let side = |k: usize, steps: f64| k as f64 + steps * size as f64;
        let edge = (0..=8).flat_map(|k| {
            let along = f64::from(k) / 8.0;
            [[along, 0.0], [along, 1.0], [0.0, along], [1.0, along]]
        });
        let angle = |[a, b]: [f64; 2]| {
            let at = direction([side(column, a), side(row, b)]);
            dot(at, center).clamp(-1.0, 1.0).acos()
        };
        let radius = edge.map(angle).fold(0.0, f64::max);
        // Chebyshev nodes in units of the half side.
        let nodes: [f64; NODES] =
            std::array::from_fn(|k| (PI * (k as f64 + 0.5) / NODES as f64).cos());
        let place = |start: usize, node: f64| middle(start) + 0.5 * size as f64 * node;
        let of_node =
            |k: usize| direction([place(column, nodes[k % NODES]), place(row, nodes[k / NODES])]);
        // The polynomials that are 1 at one node and 0 at the others, at each texel's center.
        let shares: Vec<[f64; NODES]> = (0..size)
            .map(|texel| {
                let x = (2 * texel + 1) as f64 / size as f64 - 1.0;
                let share = |k: usize| -> f64 {
                    let others = nodes.iter().enumerate().filter(|&(j, _)| j != k);
                    others.map(|(_, &node)| (x - node) / (nodes[k] - node)).product()
                };
                std::array::from_fn(share)
            })
            .collect();
        let mut power = vec![0.0f64; NODES * NODES * 3 * maps.len()];
        for (j, i) in (0..size).flat_map(|j| (0..size).map(move |i| (j, i))) {
            let texel = (row + j) * maps[0].width + column + i;
            let solid_angle = maps[0].solid_angle(row + j);
            for (node, power) in power.chunks_exact_mut(3 * maps.len()).enumerate() {
                let share = solid_angle * shares[i][node % NODES] * shares[j][node / NODES];
                let radiance =
                    (0..3).flat_map(|c| maps.iter().map(move |map| map.texels[texel][c]));
                for (to, radiance) in power.iter_mut().zip(radiance) {
                    *to += share * f64::from(radiance);
                }
            }
        }
        let power = power.into_iter().map(|power| power as f32).collect();
        Self { center, radius, nodes: std::array::from_fn(of_node), power }
    }
}
