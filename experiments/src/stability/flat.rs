//! Objects that show few normals, and normals with very small weights.

use super::{Case, Figure};
use crate::tolerances;
use eigenshade_generator::object::geometry::WeightedNormals;
use eigenshade_generator::scene_file::Loaded;
use eigenshade_table::scene::{LightRotation, Normalise};
use eigenshade_testing::fixtures::{self, standard};
use eigenshade_testing::largest;
use eigenshade_testing::oracle::Numbers;
use eigenshade_testing::pictures::{Pictures, apart, eigenvalues, listed, table};
use nalgebra::DMatrix;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Error, relative to the peak, of pictures of normals whose weights span twelve decades, computed
/// by eigenvectors of squares: noise below 1e-8 of the largest singular value, over weights whose
/// roots are down to 1e-6.
const NAIVE_PICTURES: f64 = 1e-3;

pub const FLAT: Case = Case {
    name: "flat objects: one normal, normals on a line, a cylinder, all on the rim",
    naively: "M over few normals has a few eigenvalues and hundreds of roundings: its inverse root is NaN, with their \
              sizes far from orthonormal",
    here: "the singular values of the sphere's span over the normals, cut off; as many components as the pictures have",
    measure: flat,
};

pub const WEIGHTS: Case = Case {
    name: "normals whose weights span twelve decades",
    naively: "eigenvectors of squares: below 1e-8 of the largest singular value eigenimages are noise, and light normals \
              are off by a hundredth of the peak",
    here: "orthogonal factors of rows times the root of their weight, nothing squared",
    measure: weights,
};

const DEGREE: usize = 4;
const ORDER: usize = 4;

/// Twelve lights, as captured, on eight materials.
pub fn scene() -> Loaded {
    let mut numbers = Numbers(1604);
    let lights = fixtures::lights(DEGREE, 12, &mut numbers);
    let mut loaded = fixtures::scene(lights, fixtures::materials(ORDER, 8, &mut numbers));
    loaded.scene.light.rotation = LightRotation::None;
    loaded.scene.light.normalise = Normalise::None;
    loaded
}

fn one() -> WeightedNormals {
    listed([([0.6, 0.0, 0.8], 2.0)])
}

/// A half circle from rim to rim.
fn line() -> WeightedNormals {
    listed((-40..=40).map(|k| {
        let (sine, cosine) = (FRAC_PI_2 * f64::from(k) / 40.0).sin_cos();
        ([sine, 0.0, cosine.max(0.0)], 1.0)
    }))
}

/// A cylinder across the picture, weighted by projected area.
fn cylinder() -> WeightedNormals {
    listed((0..60).map(|k| {
        let (sine, cosine) = (FRAC_PI_2 * (f64::from(2 * k + 1) / 60.0 - 1.0)).sin_cos();
        ([0.0, sine, cosine], cosine)
    }))
}

fn rim() -> WeightedNormals {
    listed((0..64).map(|k| {
        let (y, x) = (TAU * f64::from(k) / 64.0).sin_cos();
        ([x, y, 0.0], 1.0)
    }))
}

fn flat() -> Vec<Figure> {
    let shapes = [
        ("components of one normal", one(), 1),
        ("of a line", line(), 18),
        ("of a cylinder", cylinder(), 18),
        ("of the rim", rim(), 9),
    ];
    let loaded = scene();
    let cutoff = loaded.scene.basis.rank_cutoff;
    let mut counts = Vec::new();
    let (mut negative, mut naive) = (f64::INFINITY, f64::INFINITY);
    let (mut values, mut errors, mut other) = (0.0f64, 0.0f64, 0);
    for (what, shape, expected) in shapes {
        let pictures = Pictures::new(&loaded, &shape);
        let (share, off) = root_of_gram(&pictures.modes(DEGREE, ORDER));
        (negative, naive) = (negative.min(share), naive.min(off));
        for loaded in [standard(loaded.clone()), loaded.clone()] {
            let table = table(&loaded, &shape);
            let of_pictures = pictures.eigenvalues(loaded.scene.basis.criterion, cutoff);
            let found = eigenvalues(&table);
            other += usize::from(found.len() != of_pictures.len());
            values = largest([values, apart(&found, &of_pictures)]);
            errors = largest([errors, largest(pictures.errors(&table))]);
            if table.count() > found.len() {
                counts.push(Figure::exactly(what, table.count(), expected));
            }
        }
    }
    let mut figures = vec![
        Figure::least("negative eigenvalues of M, share", negative, tolerances::NAIVE_NEGATIVE),
        Figure::least("|UᵀMU - I| with |λ|", naive, tolerances::NAIVE_ROOT),
    ];
    figures.extend(counts);
    figures.extend([
        Figure::exactly("objects with another number than their pictures", other, 0),
        Figure::most("eigenvalues, of the largest", values, tolerances::FLAT_EIGENVALUES),
        Figure::most("pictures, of the peak", errors, tolerances::FLAT_PICTURES),
    ]);
    figures
}

/// For M = AᵀA: the share of its eigenvalues that are negative, and the distance from the identity
/// of M^(-1/2) M M^(-1/2) computed from their absolute values.
fn root_of_gram(modes: &DMatrix<f64>) -> (f64, f64) {
    let gram = modes.tr_mul(modes);
    let count = gram.nrows();
    let eigen = gram.clone().symmetric_eigen();
    let negative = eigen.eigenvalues.iter().filter(|value| **value < 0.0).count();
    let roots = eigen.eigenvalues.map(|value| value.abs().sqrt().recip());
    let root =
        &eigen.eigenvectors * DMatrix::from_diagonal(&roots) * eigen.eigenvectors.transpose();
    let off = &root * gram * &root - DMatrix::identity(count, count);
    (negative as f64 / count as f64, largest(off.iter().copied()))
}

/// A spiral of 400 normals from the pole to the rim with decreasing weights.
fn spiral() -> WeightedNormals {
    listed((0..400).map(|k| {
        let z = (f64::from(k) + 0.5) / 400.0;
        let (y, x) = (2.399_963 * f64::from(k)).sin_cos();
        let radius = (1.0 - z * z).sqrt();
        ([radius * x, radius * y, z], 10f64.powf(-12.0 * f64::from(k) / 399.0))
    }))
}

fn weights() -> Vec<Figure> {
    let loaded = scene();
    let cutoff = loaded.scene.basis.rank_cutoff;
    let pictures = Pictures::new(&loaded, &spiral());
    let heaviest = largest(pictures.weights.iter().copied());
    let (mut values, mut seen, mut weighted, mut other) = (0.0f64, 0.0f64, 0.0f64, 0);
    for loaded in [loaded.clone(), standard(loaded.clone())] {
        let table = table(&loaded, &spiral());
        let of_pictures = pictures.eigenvalues(loaded.scene.basis.criterion, cutoff);
        let found = eigenvalues(&table);
        other += usize::from(found.len() != of_pictures.len());
        values = largest([values, apart(&found, &of_pictures)]);
        let errors = pictures.errors(&table);
        let by_weight = errors.iter().zip(&pictures.weights);
        weighted = largest(by_weight.map(|(e, w)| e * (w / heaviest).sqrt()).chain([weighted]));
        seen = largest([seen, largest(errors)]);
    }
    vec![
        Figure::least(
            "pictures by squares, of the peak",
            by_squares(&pictures, cutoff),
            NAIVE_PICTURES,
        ),
        Figure::exactly("bases of another number than their pictures", other, 0),
        Figure::most("eigenvalues, of the largest", values, tolerances::FLAT_EIGENVALUES),
        Figure::most(
            "pictures, times √weight, of the peak",
            weighted,
            tolerances::WEIGHTED_PICTURES,
        ),
        Figure::most("pictures of all normals, of the peak", seen, tolerances::LIGHTEST_NORMALS),
    ]
}

/// The worst error of pictures WWᵀI whose W are eigenvectors of the squares, divided by the roots
/// of their eigenvalues.
fn by_squares(pictures: &Pictures, cutoff: f64) -> f64 {
    let images = pictures.weighted();
    let eigen = images.tr_mul(&images).symmetric_eigen();
    let strongest = largest(eigen.eigenvalues.iter().copied());
    let kept: Vec<usize> = (0..eigen.eigenvalues.len())
        .filter(|&k| eigen.eigenvalues[k] > cutoff * cutoff * strongest)
        .collect();
    let eigenimages = DMatrix::from_fn(images.nrows(), kept.len(), |i, k| {
        let along = images.row(i).dot(&eigen.eigenvectors.column(kept[k]).transpose());
        along / eigen.eigenvalues[kept[k]].sqrt()
    });
    let off = &eigenimages * eigenimages.tr_mul(&images) - &images;
    let scale = (pictures.pairs.len() as f64).sqrt();
    let of_pair = |t: usize| {
        let peak = largest(pictures.pairs[t].2.iter().copied());
        let of = (0..images.nrows()).map(|k| off[(k, t)] * scale / pictures.weights[k].sqrt());
        largest(of) / peak
    };
    largest((0..images.ncols()).map(of_pair))
}
