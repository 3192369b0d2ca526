//! Objects that show few normals, normals with very small weights, and degenerate facets.

use super::{Figure, exactly, least, most};
use crate::tolerances;
use eigenshade_generator::object::geometry::WeightedNormals;
use eigenshade_generator::object::mesh;
use eigenshade_generator::scene_file::Loaded;
use eigenshade_table::Table;
use eigenshade_table::scene::{LightRotation, Normalize};
use eigenshade_testing::fixtures::{self, ROOT, standard};
use eigenshade_testing::largest;
use eigenshade_testing::oracle::Numbers;
use eigenshade_testing::pictures::{Pictures, apart, eigenvalues, listed, table};
use nalgebra::DMatrix;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::path::Path;

const DEGREE: usize = 4;
const ORDER: usize = 4;

/// Twelve lights, as captured, on eight materials.
fn scene() -> Loaded {
    let mut numbers = Numbers(1604);
    let lights = fixtures::lights(DEGREE, 12, &mut numbers);
    let mut loaded = fixtures::scene(lights, fixtures::materials(ORDER, 8, &mut numbers));
    loaded.scene.light.rotation = LightRotation::None;
    loaded.scene.light.normalize = Normalize::None;
    loaded
}

/// Tables of objects, compared with the principal components of their pictures.
#[derive(Default)]
struct Compared {
    /// Tables with another number of eigenvalues.
    other: usize,
    /// The largest difference of eigenvalues.
    values: f64,
    /// The largest error of a picture, of its peak.
    errors: f64,
    /// The same, times the root of the normal's weight relative to the heaviest.
    weighted: f64,
}

impl Compared {
    fn add(&mut self, loaded: &Loaded, table: &Table, pictures: &Pictures) {
        let basis = &loaded.scene.basis;
        let of_pictures = pictures.eigenvalues(basis.criterion, basis.rank_cutoff);
        let found = eigenvalues(table);
        self.other += usize::from(found.len() != of_pictures.len());
        self.values = largest([self.values, apart(&found, &of_pictures)]);
        let errors = pictures.errors(table);
        let heaviest = largest(pictures.weights.iter().copied());
        let by_weight = errors.iter().zip(&pictures.weights);
        let weighted = by_weight.map(|(e, w)| e * (w / heaviest).sqrt());
        self.weighted = largest(weighted.chain([self.weighted]));
        self.errors = largest(errors.into_iter().chain([self.errors]));
    }
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

/// One normal, normals on a line, a cylinder, and normals on the rim, by both criteria.
pub(super) fn flat() -> Vec<Figure> {
    let shapes = [
        ("components of one normal", one(), 1),
        ("components of a line", line(), 18),
        ("components of a cylinder", cylinder(), 18),
        ("components of the rim", rim(), 9),
    ];
    let loaded = scene();
    let mut counts = Vec::new();
    let (mut negative, mut naive) = (f64::INFINITY, f64::INFINITY);
    let mut all = Compared::default();
    for (what, shape, expected) in shapes {
        let pictures = Pictures::new(&loaded, &shape);
        let (share, off) = root_of_gram(&pictures.modes(DEGREE, ORDER));
        (negative, naive) = (negative.min(share), naive.min(off));
        for loaded in [standard(loaded.clone()), loaded.clone()] {
            let table = table(&loaded, &shape);
            all.add(&loaded, &table, &pictures);
            if table.count() > eigenvalues(&table).len() {
                counts.push(exactly(what, table.count(), expected));
            }
        }
    }
    let Compared { other, values, errors, .. } = all;
    let mut figures = vec![
        least("share of M's eigenvalues that are negative", negative, tolerances::NAIVE_NEGATIVE),
        least("|UᵀMU - I| with the eigenvalues' sizes", naive, tolerances::NAIVE_ROOT),
    ];
    figures.extend(counts);
    figures.extend([
        exactly("bases with another number of components than their pictures", other, 0),
        most("eigenvalues, of the largest", values, tolerances::FLAT_EIGENVALUES),
        most("pictures, of the peak", errors, tolerances::FLAT_PICTURES),
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

/// Normals whose weights span twelve decades.
pub(super) fn weights() -> Vec<Figure> {
    let loaded = scene();
    let pictures = Pictures::new(&loaded, &spiral());
    let squares = by_squares(&pictures, loaded.scene.basis.rank_cutoff);
    let mut all = Compared::default();
    for loaded in [loaded.clone(), standard(loaded)] {
        all.add(&loaded, &table(&loaded, &spiral()), &pictures);
    }
    let Compared { other, values, errors, weighted } = all;
    vec![
        // Noise below 1e-8 of the largest singular value, over weights whose roots are down to
        // 1e-6.
        least("pictures by squares, of the peak", squares, 1e-3),
        exactly("bases with another number of components than their pictures", other, 0),
        most("eigenvalues, of the largest", values, tolerances::FLAT_EIGENVALUES),
        most("pictures times √weight, of the peak", weighted, tolerances::WEIGHTED_PICTURES),
        most("pictures of all normals, of the peak", errors, tolerances::LIGHTEST_NORMALS),
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

/// The visible facets of `data/degenerate.obj`, from the planes in which they lie.
const SEEN: [([f64; 3], f64); 6] = [
    ([0.0, -2.0, 1.0], 1.0),
    ([2.0, 0.0, 1.0], 1.0),
    ([0.0, 2.0, 1.0], 1.0),
    ([-2.0, 0.0, 1.0], 1.0),
    ([-0.25, 0.5, 1.0], 0.5),
    ([-0.25, 0.5, 1.0], 0.5),
];

/// `data/degenerate.obj`, against the planes of its facets.
pub(super) fn degenerate() -> Vec<Figure> {
    let path = format!("{ROOT}/experiments/data/degenerate.obj");
    let found = listed(mesh::read(Path::new(&path)).expect("a mesh"));
    let expected = listed(SEEN);
    let pairs = found.normals().iter().zip(expected.normals());
    let normals = largest(pairs.flat_map(|(a, b)| (0..3).map(|i| a[i] - b[i])));
    let pairs = found.weights().iter().zip(expected.weights());
    let weights = largest(pairs.map(|(a, b)| a - b));
    let loaded = scene();
    let table = table(&loaded, &found);
    let mut all = Compared::default();
    all.add(&loaded, &table, &Pictures::new(&loaded, &expected));
    let text = std::fs::read_to_string(path).expect("a mesh");
    vec![
        // Two with equal corners, and three on a line of two digits.
        least("normals divided by their length: NaN", naive(&text), 5.0),
        exactly("facets seen", found.normals().len(), SEEN.len()),
        most("their normals", normals, tolerances::FACETS),
        most("their weights", weights, tolerances::FACETS),
        exactly("components, of five normals", table.count(), 5),
        most("eigenvalues, of the largest", all.values, tolerances::FLAT_EIGENVALUES),
        most("pictures, of the peak", all.errors, tolerances::FLAT_PICTURES),
    ]
}

/// The number of facets, in a text of `v` and `f` lines, whose normalized cross product is NaN.
fn naive(text: &str) -> f64 {
    let rows = |kind: &str| -> Vec<[f64; 3]> {
        let row = |line: &str| {
            let numbers: Vec<f64> = line.split(' ').map(|x| x.parse().expect("a number")).collect();
            numbers.try_into().expect("three numbers")
        };
        text.lines().filter_map(|line| line.strip_prefix(kind)).map(row).collect()
    };
    let corners = rows("v ");
    let normal = |facet: &[f64; 3]| {
        let [a, b, c] = facet.map(|index| corners[index as usize - 1]);
        let edge = |to: [f64; 3]| [to[0] - a[0], to[1] - a[1], to[2] - a[2]];
        let (u, v) = (edge(b), edge(c));
        let cross =
            [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        cross[2] / cross.iter().map(|x| x * x).sum::<f64>().sqrt()
    };
    rows("f ").iter().filter(|facet| normal(facet).is_nan()).count() as f64
}
