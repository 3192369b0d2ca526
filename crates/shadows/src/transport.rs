//! Transports of pixels: the irradiance as a linear function of the light, with shadows.
//!
//! The transport of a point with normal n is T_k = ∫ f(w, v) V(w) (n·w) Y_k(w) dw, where V is 1 in
//! directions that the point sees, so that its irradiance under a light L is Σ_k T_k L_k.

use crate::directions::{FINE, RAYS, cells, ray_of};
use crate::material::Material;
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
const BATCH: usize = 64;

/// Points of one pixel of similar normals, and what they see.
struct Group {
    normal: [f64; 3],
    count: f32,
    /// How many of the points see each cell of rays.
    seen: Vec<f32>,
}

/// The transports of pixels, each given by its points, on each of these materials: for each material
/// a matrix with a row for each pixel and a column for each column of `light`, whose rows are the
/// directions of [`directions`].
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
        let of_material = |material: &Material<'_>| {
            let mut weights = Mat::<f32>::zeros(cells.len(), pixels.len());
            for (pixel, groups) in groups.iter().enumerate() {
                let column = weights.col_as_slice_mut(pixel);
                groups.iter().for_each(|group| group.add(material, &cells, column));
            }
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
        materials.iter().map(of_material).collect::<Vec<_>>()
    });
    (0..materials.len())
        .map(|material| {
            Mat::from_fn(pixels.len(), light.ncols(), |row, column| {
                found[row / BATCH][material][(row % BATCH, column)]
            })
        })
        .collect()
}

/// The directions over which [`transports`] integrates, with solid angles.
#[must_use]
pub fn directions() -> Vec<([f64; 3], f64)> {
    cells(FINE)
}

fn groups(points: &[Point], occluders: Option<&Occluders>) -> Vec<Group> {
    let mut groups: Vec<(Vec<[f64; 3]>, Group)> = Vec::new();
    for point in points {
        let seen: Vec<f32> = match occluders {
            Some(occluders) => occluders.seen(point).into_iter().map(f32::from).collect(),
            None => vec![1.0; RAYS * RAYS],
        };
        let found = groups.iter_mut().find(|(normals, _)| dot(normals[0], point.normal) > TOGETHER);
        match found {
            Some((normals, group)) => {
                normals.push(point.normal);
                group.count += 1.0;
                group.seen.iter_mut().zip(seen).for_each(|(sum, one)| *sum += one);
            }
            None => {
                let group = Group { normal: point.normal, count: 1.0, seen };
                groups.push((vec![point.normal], group));
            }
        }
    }
    let all = points.len() as f32;
    groups
        .into_iter()
        .map(|(normals, mut group)| {
            let sum =
                normals.iter().fold([0.0; 3], |sum, normal| [0, 1, 2].map(|k| sum[k] + normal[k]));
            let length = dot(sum, sum).sqrt();
            group.normal = sum.map(|along| along / length);
            group.seen.iter_mut().for_each(|seen| *seen /= all);
            group
        })
        .collect()
}

impl Group {
    /// Adds f V (n·w) dw of each direction.
    fn add(&self, material: &Material<'_>, cells: &[([f64; 3], f64)], weights: &mut [f32]) {
        let reflected = self.normal[2].max(RIM);
        let material = material.seen(reflected);
        for (cell, ((direction, angle), weight)) in cells.iter().zip(weights).enumerate() {
            let seen = self.seen[ray_of(cell)];
            if seen == 0.0 {
                continue;
            }
            let incident = dot(self.normal, *direction);
            if incident <= 0.0 {
                continue;
            }
            let at = Geometry { incident: incident.min(1.0), reflected, between: direction[2] };
            *weight += seen * (material.value(at) * incident * angle) as f32;
        }
    }
}
