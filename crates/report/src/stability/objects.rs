//! Objects that show few normals, normals with very small weights, and degenerate facets.

use super::{Figure, GramRoot, exactly, least, left_vectors, most, tight};
use crate::accuracy_cost::times::hemisphere;
use crate::tolerances;
use eigenshade_generator::object::geometry::WeightedNormals;
use eigenshade_generator::object::mesh;
use eigenshade_generator::scene_file::Loaded;
use eigenshade_table::scene::{LightRotation, Normalize};
use eigenshade_testing::fixtures::{self, ROOT, standard};
use eigenshade_testing::oracle::Numbers;
use eigenshade_testing::pictures::{Pictures, apart, eigenvalues, listed, table};
use eigenshade_testing::{largest, largest_difference};
use nalgebra::Vector3;
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

/// Tables of an object, compared with the principal components of its pictures.
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
    /// The number of components by the last criterion.
    components: usize,
}

impl Compared {
    fn new(scenes: &[Loaded], shape: &WeightedNormals, pictures: &Pictures) -> Self {
        let heaviest = largest(pictures.weights.iter().copied());
        let mut all = Self::default();
        for loaded in scenes {
            let (basis, table) = (&loaded.scene.basis, table(loaded, shape));
            let of_pictures = pictures.eigenvalues(basis.criterion, basis.rank_cutoff);
            let found = eigenvalues(&table);
            all.other += usize::from(found.len() != of_pictures.len());
            all.values = largest([all.values, apart(&found, &of_pictures)]);
            for (error, weight) in pictures.errors(&table).iter().zip(&pictures.weights) {
                all.errors = largest([all.errors, *error]);
                all.weighted = largest([all.weighted, error * (weight / heaviest).sqrt()]);
            }
            all.components = table.count();
        }
        all
    }
}

/// The scene by the standard criterion, then by that of centered images.
fn both(loaded: &Loaded) -> [Loaded; 2] {
    [standard(loaded.clone()), loaded.clone()]
}

/// Normals at the given sine and cosine, and weights.
fn arc(angles: impl Iterator<Item = f64>, at: fn(f64, f64) -> ([f64; 3], f64)) -> WeightedNormals {
    listed(angles.map(f64::sin_cos).map(|(sine, cosine)| at(sine, cosine)))
}

/// One normal, normals on a line, a cylinder, and normals on the rim, by both criteria.
pub(super) fn flat() -> Vec<Figure> {
    let across =
        |steps: i32| (-steps..=steps).map(move |k| FRAC_PI_2 * f64::from(k) / f64::from(steps));
    let strips = (0..60).map(|k| FRAC_PI_2 * (f64::from(2 * k + 1) / 60.0 - 1.0));
    let around = (0..64).map(|k| TAU * f64::from(k) / 64.0);
    let shapes = [
        ("components of one normal", listed([([0.6, 0.0, 0.8], 2.0)]), 1),
        // A half circle from rim to rim.
        ("components of a line", arc(across(40), |s, c| ([s, 0.0, c.max(0.0)], 1.0)), 18),
        // Across the picture, weighted by projected area.
        ("components of a cylinder", arc(strips, |s, c| ([0.0, s, c], c)), 18),
        ("components of the rim", arc(around, |s, c| ([c, s, 0.0], 1.0)), 9),
    ];
    let loaded = scene();
    let mut counts = Vec::new();
    let (mut negative, mut naive) = (f64::INFINITY, f64::INFINITY);
    let (mut other, mut values, mut errors) = (0, 0.0, 0.0);
    for (what, shape, expected) in shapes {
        let pictures = Pictures::new(&loaded, &shape);
        let root = GramRoot::new(&pictures.modes(DEGREE, ORDER));
        negative = negative.min(root.negative[0] as f64 / root.negative[1] as f64);
        naive = naive.min(root.off);
        let found = Compared::new(&both(&loaded), &shape, &pictures);
        other += found.other;
        values = largest([values, found.values]);
        errors = largest([errors, found.errors]);
        counts.push(exactly(what, found.components, expected));
    }
    let first = [
        least("share of M's eigenvalues that are negative", negative, tolerances::NAIVE_NEGATIVE),
        least("|UᵀMU - I| with the eigenvalues' sizes", naive, tolerances::NAIVE_ROOT),
    ];
    let last = [
        exactly("bases with another number of components than their pictures", other, 0),
        most("eigenvalues, of the largest", values, tolerances::FLAT_EIGENVALUES),
        tight("pictures, of the peak", errors, tolerances::FLAT_PICTURES),
    ];
    first.into_iter().chain(counts).chain(last).collect()
}

/// A spiral of 400 normals from the rim to the pole with weights that span twelve decades.
pub(super) fn weights() -> Vec<Figure> {
    let weight = |k: i32| 10f64.powf(-12.0 * f64::from(k) / 399.0);
    let spiral = listed(hemisphere(400).into_iter().zip((0..400).map(weight)));
    let loaded = scene();
    let pictures = Pictures::new(&loaded, &spiral);
    let squares = by_squares(&pictures, loaded.scene.basis.rank_cutoff);
    let found = Compared::new(&both(&loaded), &spiral, &pictures);
    vec![
        // Noise of 1e-8 of the largest singular value, over weights with roots down to 1e-6.
        least("pictures by squares, of the peak", squares, 1e-3),
        exactly("bases with another number of components than their pictures", found.other, 0),
        most("eigenvalues, of the largest", found.values, tolerances::FLAT_EIGENVALUES),
        tight("pictures times √weight, of the peak", found.weighted, tolerances::WEIGHTED_PICTURES),
        most("pictures of all normals, of the peak", found.errors, tolerances::LIGHTEST_NORMALS),
    ]
}

/// The worst error of pictures WWᵀI whose W are from squares.
fn by_squares(pictures: &Pictures, cutoff: f64) -> f64 {
    let images = pictures.weighted();
    let (vectors, values) = left_vectors(&images);
    let kept = values.iter().take_while(|value| **value > cutoff * cutoff * values[0]).count();
    let strongest = vectors.columns(0, kept);
    let off = strongest * strongest.tr_mul(&images) - &images;
    let scale = (pictures.pairs.len() as f64).sqrt();
    largest(off.column_iter().zip(&pictures.pairs).map(|(off, (_, _, image))| {
        let of = off.iter().zip(&pictures.weights).map(|(off, weight)| off * scale / weight.sqrt());
        largest(of) / largest(image.iter().copied())
    }))
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
    let path = format!("{ROOT}/crates/report/data/degenerate.obj");
    let found = listed(mesh::read(Path::new(&path)).expect("a mesh"));
    let expected = listed(SEEN);
    let [a, b] = [&found, &expected].map(|one| one.normals().as_flattened());
    let normals = largest_difference(a, b);
    let weights = largest_difference(found.weights(), expected.weights());
    let loaded = scene();
    let pictures = Pictures::new(&loaded, &expected);
    let compared = Compared::new(&[loaded], &found, &pictures);
    let text = std::fs::read_to_string(path).expect("a mesh");
    vec![
        // Two with equal corners, and three on a line of two digits.
        least("normals divided by their length: NaN", naive(&text), 5.0),
        exactly("facets seen", found.normals().len(), SEEN.len()),
        tight("their normals", normals, tolerances::FACETS),
        most("their weights", weights, tolerances::FACETS),
        exactly("components, of five normals", compared.components, 5),
        most("eigenvalues, of the largest", compared.values, tolerances::FLAT_EIGENVALUES),
        most("pictures, of the peak", compared.errors, tolerances::FLAT_PICTURES),
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
    let has_no_normal = |facet: &&[f64; 3]| {
        let [a, b, c] = facet.map(|index| Vector3::from(corners[index as usize - 1]));
        (b - a).cross(&(c - a)).normalize().z.is_nan()
    };
    rows("f ").iter().filter(has_no_normal).count() as f64
}
