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

/// A part of a pixel with one normal.
pub struct Facing<'a> {
    /// The unit normal, z >= 0.
    pub normal: [f64; 3],
    /// Its share of the pixel.
    pub share: f64,
    /// Points of it, at least one, which take the rays in turns.
    pub places: Vec<Place>,
    /// For each BRDF that the pixel is drawn in, its shares of the materials.
    pub blends: &'a [Vec<f64>],
}

/// A part of a pixel, and the light or patch that it sees in each cell of rays.
struct Group<'a> {
    facing: &'a Facing<'a>,
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
    let share = |one: usize| move |other: usize| f64::from(u8::from(one == other));
    let count = materials.len();
    let blends: Vec<Vec<f64>> =
        (0..count).map(|one| (0..count).map(share(one)).collect()).collect();
    let albedos: Vec<f64> = materials.iter().map(Material::albedo).collect();
    let pixels: Vec<_> = pixels.iter().map(|points| facings(points, &blends)).collect();
    blended(&pixels, surroundings, (materials, &albedos), light, progress)
}

/// The same for pixels that blend the materials: for each blend a matrix. Each has an albedo for the
/// light that the surface reflects to the pixels.
#[must_use]
pub fn blended(
    pixels: &[Vec<Facing<'_>>],
    surroundings: Option<Surroundings<'_>>,
    (materials, albedos): (&[Material<'_>], &[f64]),
    light: Columns<'_>,
    progress: &impl Progress,
) -> Vec<Mat<f32>> {
    let cells = cells(FINE);
    let rays: Vec<[f64; 3]> = self::cells(RAYS).into_iter().map(|(ray, _)| ray).collect();
    let reflecting = surroundings.filter(|around| around.bounces > 0);
    let patches = reflecting.map(|around| {
        let patches = Patches::new(around.occluders, light.all);
        let radiance = |albedo: &f64| patches.radiance(*albedo, around.bounces);
        let radiances: Vec<Mat<f32>> = albedos.iter().map(radiance).collect();
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
        let mut weights = vec![none; albedos.len()];
        for (pixel, facings) in pixels.iter().enumerate() {
            for facing in facings {
                let mut columns: Vec<_> =
                    weights.iter_mut().map(|weights| weights.pixel(pixel)).collect();
                Group::new(facing, &rays, &look).add(materials, &open, &cells, &mut columns);
            }
        }
        let radiances = |blend: usize| patches.as_ref().map(|(_, all)| all[blend].as_ref());
        let product =
            |(blend, weights): (usize, &Weights)| weights.product(light, radiances(blend));
        weights.iter().enumerate().map(product).collect::<Vec<_>>()
    });
    (0..albedos.len())
        .map(|blend| {
            Mat::from_fn(pixels.len(), light.all.ncols(), |row, column| {
                found[row / BATCH][blend][(row % BATCH, column)]
            })
        })
        .collect()
}

/// Points of similar normals together.
fn facings<'a>(points: &[Point], blends: &'a [Vec<f64>]) -> Vec<Facing<'a>> {
    let mut groups: Vec<Vec<Point>> = Vec::new();
    for point in points {
        let near = |group: &&mut Vec<Point>| dot(group[0].normal, point.normal) > TOGETHER;
        match groups.iter_mut().find(near) {
            Some(group) => group.push(*point),
            None => groups.push(vec![*point]),
        }
    }
    let facing = |members: Vec<Point>| {
        let add = |sum: [f64; 3], point: &Point| [0, 1, 2].map(|k| sum[k] + point.normal[k]);
        let sum = members.iter().fold([0.0; 3], add);
        let length = dot(sum, sum).sqrt();
        Facing {
            normal: sum.map(|along| along / length),
            share: members.len() as f64 / points.len() as f64,
            places: members.iter().map(Place::from).collect(),
            blends,
        }
    };
    groups.into_iter().map(facing).collect()
}

impl<'a> Group<'a> {
    fn new(
        facing: &'a Facing<'a>,
        rays: &[[f64; 3]],
        look: &impl Fn(&Place, [f64; 3]) -> Sight,
    ) -> Self {
        let seen = |(cell, ray): (usize, &[f64; 3])| {
            let place = &facing.places[(cell % RAYS + 2 * (cell / RAYS)) % facing.places.len()];
            if dot(facing.normal, *ray) > -REACH { look(place, *ray) } else { Sight::Dark }
        };
        Self { facing, seen: rays.iter().enumerate().map(seen).collect() }
    }

    /// Adds f (n·w) dw of each direction to the weights of a pixel for each blend.
    fn add(
        &self,
        materials: &[Material<'_>],
        open: &Open<'_>,
        cells: &[([f64; 3], f64)],
        weights: &mut [PixelWeights<'_>],
    ) {
        let Facing { normal, share, blends, .. } = *self.facing;
        let reflected = normal[2].max(RIM);
        let seen = Seen::new(materials, reflected);
        let free = self.free(cells);
        let removed: Vec<f64> =
            open.materials.iter().map(|one| if one.is_some() { free } else { 0.0 }).collect();
        open.add(normal, share * free, blends, weights);
        let mut values = vec![0.0; materials.len()];
        for (cell, (direction, angle)) in cells.iter().enumerate() {
            let incident = dot(normal, *direction);
            if incident <= 0.0 {
                continue;
            }
            let at = Geometry { incident: incident.min(1.0), reflected, between: direction[2] };
            seen.values(at, &mut values);
            let sight = self.seen[ray_of(cell)];
            let is_seen = if sight == Sight::Light { 1.0 } else { 0.0 };
            let factor = share * incident * angle;
            for (weights, blend) in weights.iter_mut().zip(blends) {
                let (mut value, mut known) = (0.0, 0.0);
                for ((share, one), removed) in blend.iter().zip(&values).zip(&removed) {
                    value += share * one;
                    known += share * one * removed;
                }
                weights.harmonics[cell] += (factor * (value * is_seen - known)) as f32;
                if let Some(other) = weights.others.get_mut(cell) {
                    *other += (factor * value * is_seen) as f32;
                }
                if let Sight::Patch(number) = sight {
                    weights.patches[number as usize] += (factor * value) as f32;
                }
            }
        }
    }

    /// The share of the cells above the horizon that see the light, weighted with the cosine.
    fn free(&self, cells: &[([f64; 3], f64)]) -> f64 {
        let (mut free, mut all) = (0.0, 0.0);
        for (cell, (direction, angle)) in cells.iter().enumerate() {
            let weight = dot(self.facing.normal, *direction).max(0.0) * angle;
            all += weight;
            free += if self.seen[ray_of(cell)] == Sight::Light { weight } else { 0.0 };
        }
        free / all
    }
}
