//! Transports of pixels: the irradiance as a linear function of the light, with shadows.
//!
//! The transport of a point with normal n is T_k = ∫ f(w, v) V(w) (n·w) Y_k(w) dw, where V is 1 in
//! directions that the point sees, so that its irradiance under a light L is Σ_k T_k L_k.

use crate::directions::{FINE, RAYS, cells, ray_of};
use crate::material::{Material, Seen};
use crate::visibility::Occluders;
use eigenshade_generator::material::brdf::Geometry;
use eigenshade_generator::object::points::Point;
use eigenshade_model::parallel::{self, Progress};
use eigenshade_model::vector::dot;
use faer::{Mat, MatRef, Par};

/// The cosine of the largest angle between normals that share a transport: 11 degrees.
const TOGETHER: f64 = 0.98;

/// The least cosine between a normal and the camera: BRDFs may diverge at the rim.
const RIM: f64 = 1e-3;

/// Pixels that are integrated together.
pub(crate) const BATCH: usize = 64;

/// Points of one pixel of similar normals, and what they see.
struct Group {
    /// The mean of their normals.
    normal: [f64; 3],
    /// Their share of the pixel's points.
    share: f64,
    /// Whether they see each cell of rays.
    seen: Vec<bool>,
}

/// The transports of pixels, each given by its points, on each of these materials: for each material
/// a matrix with a row for each pixel and a column for each column of `light`, whose rows are the
/// [`FINE`] cells.
///
/// Without `occluders` nothing is shadowed.
#[must_use]
pub fn transports(
    pixels: &[&[Point]],
    occluders: Option<&Occluders>,
    materials: &[Material<'_>],
    light: MatRef<'_, f32>,
    progress: &impl Progress,
) -> Vec<Mat<f32>> {
    let cells = cells(FINE);
    let batches = pixels.len().div_ceil(BATCH);
    let found = parallel::map(batches, progress, |batch| {
        let pixels = &pixels[batch * BATCH..((batch + 1) * BATCH).min(pixels.len())];
        let groups: Vec<Vec<Group>> =
            pixels.iter().map(|points| groups(points, occluders)).collect();
        let mut weights = vec![Mat::<f32>::zeros(cells.len(), pixels.len()); materials.len()];
        for (pixel, groups) in groups.iter().enumerate() {
            let mut columns: Vec<&mut [f32]> =
                weights.iter_mut().map(|weights| weights.col_as_slice_mut(pixel)).collect();
            groups.iter().for_each(|group| group.add(materials, &cells, &mut columns));
        }
        let product = |weights: Mat<f32>| {
            let mut product = Mat::<f32>::zeros(pixels.len(), light.ncols());
            faer::linalg::matmul::matmul(
                &mut product,
                faer::Accum::Replace,
                weights.transpose(),
                light,
                1.0,
                Par::Seq,
            );
            product
        };
        weights.into_iter().map(product).collect::<Vec<_>>()
    });
    (0..materials.len())
        .map(|material| {
            Mat::from_fn(pixels.len(), light.ncols(), |row, column| {
                found[row / BATCH][material][(row % BATCH, column)]
            })
        })
        .collect()
}

fn groups(points: &[Point], occluders: Option<&Occluders>) -> Vec<Group> {
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
        Group {
            normal: sum.map(|along| along / length),
            share: members.len() as f64 / points.len() as f64,
            seen: match occluders {
                Some(occluders) => occluders.seen(&members),
                None => vec![true; RAYS * RAYS],
            },
        }
    };
    groups.into_iter().map(group).collect()
}

impl Group {
    /// Adds f (n·w) dw of each direction that is seen, for each material.
    fn add(
        &self,
        materials: &[Material<'_>],
        cells: &[([f64; 3], f64)],
        columns: &mut [&mut [f32]],
    ) {
        let reflected = self.normal[2].max(RIM);
        let seen = Seen::new(materials, reflected);
        let mut values = vec![0.0; materials.len()];
        for (cell, (direction, angle)) in cells.iter().enumerate() {
            let incident = dot(self.normal, *direction);
            if incident <= 0.0 || !self.seen[ray_of(cell)] {
                continue;
            }
            let at = Geometry { incident: incident.min(1.0), reflected, between: direction[2] };
            seen.values(at, &mut values);
            let weight = self.share * incident * angle;
            for (column, value) in columns.iter_mut().zip(&values) {
                column[cell] += (weight * value) as f32;
            }
        }
    }
}
