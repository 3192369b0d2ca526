//! Principal components of the pictures themselves: every light on every material, pixel
//! by pixel. Of the general way this shares the direct sum at most.

use crate::largest;
use crate::projector::Projector;
use eigenshade_generator::object::geometry::{Geometry, WeightedNormals};
use eigenshade_generator::scene_file::Loaded;
use eigenshade_index::{light, material};
use eigenshade_model::irradiance;
use eigenshade_model::truth::Truth;
use eigenshade_table::Table;
use eigenshade_table::scene::Criterion;
use nalgebra::{DMatrix, DVector};

/// Every picture that a scene's database makes of a list of normals.
pub struct Pictures {
    pub normals: Vec<[f64; 3]>,
    /// They sum to 1.
    pub weights: Vec<f64>,
    /// A light's and a material's coefficients, and the irradiance of each normal.
    pub pairs: Vec<(Vec<f64>, Vec<f64>, Vec<f64>)>,
}

impl Pictures {
    /// By the direct sum, lights as they come.
    pub fn new(loaded: &Loaded, listed: &WeightedNormals) -> Self {
        let truth = Truth::new(loaded.lights.degree, loaded.materials.order);
        let modes: Vec<_> = listed.normals().iter().map(|normal| truth.at(*normal)).collect();
        let mut pairs = Vec::new();
        for on in &loaded.materials.entries {
            let on = on.luminance();
            let scattered: Vec<_> = modes.iter().map(|modes| modes.scatter(&on)).collect();
            for light in &loaded.lights.entries {
                let light = light.luminance();
                let seen = modes.iter().zip(&scattered).map(|(at, of)| at.irradiance(&light, of));
                let seen = seen.collect();
                pairs.push((light, on.clone(), seen));
            }
        }
        Self { normals: listed.normals().to_vec(), weights: listed.weights().to_vec(), pairs }
    }

    /// A column a picture, a row a normal times the root of its weight; over the root of
    /// the number of pictures.
    pub fn weighted(&self) -> DMatrix<f64> {
        let scale = (self.pairs.len() as f64).sqrt();
        DMatrix::from_fn(self.normals.len(), self.pairs.len(), |k, t| {
            self.weights[k].sqrt() * self.pairs[t].2[k] / scale
        })
    }

    /// The eigenvalues above the rounding of the pictures, falling: of what differs from
    /// the mean in each image, or from the mean image.
    pub fn eigenvalues(&self, criterion: Criterion, cutoff: f64) -> Vec<f64> {
        let mut pictures = self.weighted();
        let whole = pictures.norm();
        match criterion {
            Criterion::ImageCentered => {
                let roots = self.weights.iter().map(|weight| weight.sqrt());
                let constant = DVector::from_iterator(self.normals.len(), roots);
                let along = pictures.tr_mul(&constant);
                pictures -= &constant * along.transpose();
            }
            Criterion::Standard => {
                let mean = pictures.column_mean();
                pictures.column_iter_mut().for_each(|mut column| column -= &mean);
            }
        }
        let mut values: Vec<f64> = pictures.singular_values().iter().copied().collect();
        values.sort_by(|a, b| b.total_cmp(a));
        let weakest = (1e-14 * whole).max(cutoff * values[0]);
        values.into_iter().filter(|value| *value > weakest).map(|value| value * value).collect()
    }

    /// The largest |I| of all pictures.
    pub fn peak(&self) -> f64 {
        largest(self.pairs.iter().flat_map(|pair| pair.2.iter().copied()))
    }

    /// How far a table's pictures of each normal are off, the worst of all pairs, each of
    /// its peak.
    pub fn errors(&self, table: &Table) -> Vec<f64> {
        let projector = Projector::new(table);
        let mut worst = vec![0.0; self.normals.len()];
        for (light, on, expected) in &self.pairs {
            let found = projector.shade(&projector.project(light, on), &self.normals);
            let peak = largest(expected.iter().copied());
            for (worst, (found, expected)) in worst.iter_mut().zip(found.iter().zip(expected)) {
                *worst = largest([*worst, (found - expected) / peak]);
            }
        }
        worst
    }

    /// √w times each mode's value: a row a normal, a column a mode.
    pub fn modes(&self, degree: usize, order: usize) -> DMatrix<f64> {
        let modes: Vec<_> = light::indices(degree)
            .flat_map(|(l, m)| material::indices(order).map(move |(o, p, q)| (l, m, o, p, q)))
            .filter(|&(l, _, _, _, q)| q <= l)
            .collect();
        DMatrix::from_fn(self.normals.len(), modes.len(), |k, s| {
            let ([x, y, z], (l, m, o, p, q)) = (self.normals[k], modes[s]);
            let (alpha, beta) = (x.hypot(y).atan2(z), y.atan2(x));
            self.weights[k].sqrt() * irradiance::value(l, m, o, p, q, alpha, beta)
        })
    }
}

/// Normals of any length with weights of any scale.
pub fn listed(pairs: impl IntoIterator<Item = ([f64; 3], f64)>) -> WeightedNormals {
    WeightedNormals::new(pairs).expect("normals")
}

/// The table of a scene over these normals.
pub fn table(loaded: &Loaded, listed: &WeightedNormals) -> Table {
    let of_object = Loaded { geometry: Geometry::Listed(listed.clone()), ..loaded.clone() };
    of_object.build().expect("a table")
}

/// The largest difference of two lists of eigenvalues, of the largest; those that one
/// list has not count as 0.
pub fn apart(found: &[f64], expected: &[f64]) -> f64 {
    let count = found.len().max(expected.len());
    let at = |values: &[f64], k: usize| values.get(k).copied().unwrap_or(0.0);
    let apart = largest((0..count).map(|k| at(found, k) - at(expected, k)));
    if apart == 0.0 { 0.0 } else { apart / at(expected, 0).max(at(found, 0)) }
}

/// A table's eigenvalues, without the constant.
pub fn eigenvalues(table: &Table) -> Vec<f64> {
    table.spectrum.iter().filter_map(|(_, value)| *value).collect()
}
