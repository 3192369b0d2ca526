//! Principal components of the images themselves: every light on every material, pixel by pixel.
//! The only code shared with the method for general objects is the direct sum.

use crate::fixtures::{Image, Projector, direct_images};
use crate::largest;
use eigenshade_generator::object::geometry::{Geometry, WeightedNormals};
use eigenshade_generator::scene_file::Loaded;
use eigenshade_model::irradiance;
use eigenshade_table::scene::Criterion;
use eigenshade_table::{Table, light, material};
use nalgebra::{DMatrix, DVector};

/// All images of a scene's database over a list of normals.
pub struct Pictures {
    pub normals: Vec<[f64; 3]>,
    /// The weights of the normals; they sum to 1.
    pub weights: Vec<f64>,
    /// The coefficients of a light and a material, and the irradiance at each normal.
    pub pairs: Vec<Image>,
}

impl Pictures {
    /// Computes the images by the direct sum, with lights as captured.
    pub fn new(loaded: &Loaded, listed: &WeightedNormals) -> Self {
        let pairs = direct_images(&loaded.lights, &loaded.materials, listed.normals());
        Self { normals: listed.normals().to_vec(), weights: listed.weights().to_vec(), pairs }
    }

    /// One column per image and one row per normal, multiplied by the root of the normal's weight
    /// and divided by the root of the number of images.
    pub fn weighted(&self) -> DMatrix<f64> {
        let scale = (self.pairs.len() as f64).sqrt();
        DMatrix::from_fn(self.normals.len(), self.pairs.len(), |k, t| {
            self.weights[k].sqrt() * self.pairs[t].2[k] / scale
        })
    }

    /// The eigenvalues above the rounding level of the images, descending. By the criterion, they
    /// belong to the deviations from each image's own mean or from the mean image.
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

    /// The largest |I| of all images.
    pub fn peak(&self) -> f64 {
        largest(self.pairs.iter().flat_map(|pair| pair.2.iter().copied()))
    }

    /// The error of a table's images at each normal: the worst of all pairs, each relative to its
    /// image's peak.
    pub fn errors(&self, table: &Table) -> Vec<f64> {
        let projector = Projector::new(table);
        let images = projector.0.eigenimages(&self.normals);
        let mut worst = vec![0.0; self.normals.len()];
        for (light, on, expected) in &self.pairs {
            let found = images.reconstruct(&projector.project(light, on));
            let peak = largest(expected.iter().copied());
            for (worst, (found, expected)) in worst.iter_mut().zip(found.iter().zip(expected)) {
                *worst = largest([*worst, (found - expected) / peak]);
            }
        }
        worst
    }

    /// √w times the value of each mode: one row per normal, one column per mode.
    pub fn modes(&self, degree: usize, order: usize) -> DMatrix<f64> {
        let modes = modes(degree, order);
        DMatrix::from_fn(self.normals.len(), modes.len(), |k, s| {
            let ([x, y, z], (l, m, o, p, q)) = (self.normals[k], modes[s]);
            let (alpha, beta) = (x.hypot(y).atan2(z), y.atan2(x));
            self.weights[k].sqrt() * irradiance::value(l, m, o, p, q, alpha, beta)
        })
    }
}

/// The modes (l, m, o, p, q), by light, then material.
pub fn modes(degree: usize, order: usize) -> Vec<(usize, isize, usize, usize, usize)> {
    light::indices(degree)
        .flat_map(|(l, m)| material::indices(order).map(move |(o, p, q)| (l, m, o, p, q)))
        .filter(|&(l, _, _, _, q)| q <= l)
        .collect()
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

/// The largest difference between two lists of eigenvalues, relative to the largest eigenvalue.
/// Missing values count as 0.
pub fn apart(found: &[f64], expected: &[f64]) -> f64 {
    let count = found.len().max(expected.len());
    let at = |values: &[f64], k: usize| values.get(k).copied().unwrap_or(0.0);
    let apart = largest((0..count).map(|k| at(found, k) - at(expected, k)));
    if apart == 0.0 { 0.0 } else { apart / at(expected, 0).max(at(found, 0)) }
}

/// The eigenvalues of a table, without the constant.
pub fn eigenvalues(table: &Table) -> Vec<f64> {
    table.spectrum.iter().filter_map(|(_, value)| *value).collect()
}
