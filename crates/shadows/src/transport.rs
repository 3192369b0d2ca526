//! Transports of pixels: the irradiance as a linear function of the light, with shadows.
//!
//! The transport of a point with normal n is T_k = ∫ f(w, v) Y_k(w) (n·w) dw over the directions in
//! which the point sees the light, so that its irradiance under a light L is Σ_k T_k L_k. From the other
//! directions comes the radiance ρ E_k / π of the surface there ([`Patches`]), with the albedo ρ.

use crate::bounce::Patches;
use crate::directions::{FINE, RAYS, cells, ray_of};
use crate::material::{Material, Seen};
use crate::visibility::{Met, Occluders, Place};
use crate::weights::{Columns, Open, PixelWeights, Weights};
use eigenshade_generator::material::brdf::Geometry;
use eigenshade_generator::object::points::Point;
use eigenshade_model::parallel::{self, Progress};
use eigenshade_model::vector::dot;
use faer::Mat;

/// The cosine of the largest angle between normals that share a transport: 11 degrees.
const TOGETHER: f64 = 0.98;

/// The least cosine between a normal and the camera: BRDFs may diverge at the rim.
const RIM: f64 = 1e-3;

/// The sine of the largest angle between the middle of a cell of rays and a direction in it, at least.
const REACH: f64 = 0.05;

/// Pixels that are integrated together.
pub(crate) const BATCH: usize = 64;

/// Surfaces around pixels.
#[derive(Clone, Copy)]
pub struct Surroundings<'a> {
    /// The triangles that block light.
    pub occluders: &'a Occluders,
    /// How many times they reflect it; 0 if they are black.
    pub bounces: usize,
}

/// Points of one pixel of similar normals, and what they see.
struct Group {
    /// The mean of their normals.
    normal: [f64; 3],
    /// Their share of the pixel's points.
    share: f64,
    /// The light or patch that they see in each cell of rays.
    seen: Vec<Sight>,
}

#[derive(Clone, Copy, PartialEq)]
enum Sight {
    Light,
    Patch(u32),
    Dark,
}

/// The transports of pixels, each given by its points, on each of these materials: for each material
/// a matrix with a row for each pixel and a column for each column of `light`.
///
/// Without `surroundings` nothing is shadowed. The transport of a series to harmonics is Σ f (n·w) Y_k dw
/// over the cells that are seen, and the error of that sum over all cells times the share, weighted
/// with the cosine, of those that are seen: exact where all are.
#[must_use]
pub fn transports(
    pixels: &[&[Point]],
    surroundings: Option<Surroundings<'_>>,
    materials: &[Material<'_>],
    light: Columns<'_>,
    progress: &impl Progress,
) -> Vec<Mat<f32>> {
    let cells = cells(FINE);
    let rays: Vec<[f64; 3]> = self::cells(RAYS).into_iter().map(|(ray, _)| ray).collect();
    let reflecting = surroundings.filter(|around| around.bounces > 0);
    let patches = reflecting.map(|around| {
        let patches = Patches::new(around.occluders, light.all);
        let radiance =
            |material: &Material<'_>| patches.radiance(material.albedo(), around.bounces);
        let radiances: Vec<Mat<f32>> = materials.iter().map(radiance).collect();
        (patches, radiances)
    });
    let look = |from: &Place, ray: [f64; 3]| {
        let Some(Surroundings { occluders, .. }) = surroundings else { return Sight::Light };
        match (occluders.meets(from, ray), &patches) {
            (Met::Nothing, _) => Sight::Light,
            (Met::Front(place), Some((patches, _))) => {
                patches.at(&place).map_or(Sight::Dark, Sight::Patch)
            }
            (Met::Front(_) | Met::Back, _) => Sight::Dark,
        }
    };
    let open = Open::new(light.degree.unwrap_or(0), materials);
    let count = patches.as_ref().map_or(0, |(patches, _)| patches.count());
    let batches = pixels.len().div_ceil(BATCH);
    let found = parallel::map(batches, progress, |batch| {
        let pixels = &pixels[batch * BATCH..((batch + 1) * BATCH).min(pixels.len())];
        let none = Weights::new(light, count, pixels.len());
        let mut weights = vec![none; materials.len()];
        for (pixel, points) in pixels.iter().enumerate() {
            for group in groups(points, &rays, &look) {
                let mut columns: Vec<_> =
                    weights.iter_mut().map(|weights| weights.pixel(pixel)).collect();
                group.add(materials, &open, &cells, &mut columns);
            }
        }
        let radiances = |material: usize| patches.as_ref().map(|(_, all)| all[material].as_ref());
        let product =
            |(material, weights): (usize, &Weights)| weights.product(light, radiances(material));
        weights.iter().enumerate().map(product).collect::<Vec<_>>()
    });
    (0..materials.len())
        .map(|material| {
            Mat::from_fn(pixels.len(), light.all.ncols(), |row, column| {
                found[row / BATCH][material][(row % BATCH, column)]
            })
        })
        .collect()
}

fn groups(
    points: &[Point],
    rays: &[[f64; 3]],
    look: &impl Fn(&Place, [f64; 3]) -> Sight,
) -> Vec<Group> {
    let mut groups: Vec<Vec<Point>> = Vec::new();
    for point in points {
        let near = |group: &&mut Vec<Point>| dot(group[0].normal, point.normal) > TOGETHER;
        match groups.iter_mut().find(near) {
            Some(group) => group.push(*point),
            None => groups.push(vec![*point]),
        }
    }
    let group = |members: Vec<Point>| {
        let add = |sum: [f64; 3], point: &Point| [0, 1, 2].map(|k| sum[k] + point.normal[k]);
        let sum = members.iter().fold([0.0; 3], add);
        let length = dot(sum, sum).sqrt();
        let normal = sum.map(|along| along / length);
        // Members take the rays in turns.
        let seen = |(cell, ray): (usize, &[f64; 3])| {
            let point = &members[(cell % RAYS + 2 * (cell / RAYS)) % members.len()];
            if dot(normal, *ray) > -REACH { look(&point.into(), *ray) } else { Sight::Dark }
        };
        Group {
            normal,
            share: members.len() as f64 / points.len() as f64,
            seen: rays.iter().enumerate().map(seen).collect(),
        }
    };
    groups.into_iter().map(group).collect()
}

impl Group {
    /// Adds f (n·w) dw of each direction to the weights of a pixel for each material.
    fn add(
        &self,
        materials: &[Material<'_>],
        open: &Open<'_>,
        cells: &[([f64; 3], f64)],
        weights: &mut [PixelWeights<'_>],
    ) {
        let reflected = self.normal[2].max(RIM);
        let seen = Seen::new(materials, reflected);
        let free = self.free(cells);
        let removed: Vec<f64> =
            open.materials.iter().map(|one| if one.is_some() { free } else { 0.0 }).collect();
        open.add(self.normal, self.share * free, weights);
        let mut values = vec![0.0; materials.len()];
        for (cell, (direction, angle)) in cells.iter().enumerate() {
            let incident = dot(self.normal, *direction);
            if incident <= 0.0 {
                continue;
            }
            let at = Geometry { incident: incident.min(1.0), reflected, between: direction[2] };
            seen.values(at, &mut values);
            let sight = self.seen[ray_of(cell)];
            let is_seen = if sight == Sight::Light { 1.0 } else { 0.0 };
            for ((weights, value), removed) in weights.iter_mut().zip(&values).zip(&removed) {
                let weight = self.share * incident * angle * value;
                weights.harmonics[cell] += (weight * (is_seen - removed)) as f32;
                if let Some(other) = weights.others.get_mut(cell) {
                    *other += (weight * is_seen) as f32;
                }
                if let Sight::Patch(number) = sight {
                    weights.patches[number as usize] += weight as f32;
                }
            }
        }
    }

    /// The share of the cells above the horizon that see the light, weighted with the cosine.
    fn free(&self, cells: &[([f64; 3], f64)]) -> f64 {
        let (mut free, mut all) = (0.0, 0.0);
        for (cell, (direction, angle)) in cells.iter().enumerate() {
            let weight = dot(self.normal, *direction).max(0.0) * angle;
            all += weight;
            free += if self.seen[ray_of(cell)] == Sight::Light { weight } else { 0.0 };
        }
        free / all
    }
}
