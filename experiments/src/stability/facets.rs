//! Degenerate facets.

use super::flat;
use super::{Case, Figure};
use crate::tolerances;
use eigenshade_generator::object::mesh;
use eigenshade_testing::fixtures::ROOT;
use eigenshade_testing::largest;
use eigenshade_testing::pictures::{Pictures, apart, eigenvalues, listed, table};
use std::path::Path;

/// Facets of `degenerate.obj` whose cross product has no length: those with two equal corners, and
/// those on a line of two digits.
const NAIVE_FACETS: f64 = 5.0;

pub const DEGENERATE: Case = Case {
    name: "a mesh with degenerate triangles",
    naively: "a normal of length 0 divided by it, NaN in every sum; a direction of rounding where edges are nearly parallel",
    here: "edges scaled first; facets without area, or whose direction is rounding, are left out, as are those that face \
           away",
    measure,
};

/// The visible facets of `data/degenerate.obj`, from the planes in which they lie.
const SEEN: [([f64; 3], f64); 6] = [
    ([0.0, -2.0, 1.0], 1.0),
    ([2.0, 0.0, 1.0], 1.0),
    ([0.0, 2.0, 1.0], 1.0),
    ([-2.0, 0.0, 1.0], 1.0),
    ([-0.25, 0.5, 1.0], 0.5),
    ([-0.25, 0.5, 1.0], 0.5),
];

fn measure() -> Vec<Figure> {
    let path = format!("{ROOT}/experiments/data/degenerate.obj");
    let found = listed(mesh::read(Path::new(&path)).expect("a mesh"));
    let expected = listed(SEEN);
    let pairs = found.normals().iter().zip(expected.normals());
    let normals = largest(pairs.flat_map(|(a, b)| (0..3).map(|i| a[i] - b[i])));
    let pairs = found.weights().iter().zip(expected.weights());
    let weights = largest(pairs.map(|(a, b)| a - b));
    let loaded = flat::scene();
    let table = table(&loaded, &found);
    let pictures = Pictures::new(&loaded, &expected);
    let basis = &loaded.scene.basis;
    let of_pictures = pictures.eigenvalues(basis.criterion, basis.rank_cutoff);
    let values = apart(&eigenvalues(&table), &of_pictures);
    let text = std::fs::read_to_string(path).expect("a mesh");
    vec![
        Figure::least("normals by dividing by their length: NaN", naive(&text), NAIVE_FACETS),
        Figure::exactly("facets seen", found.normals().len(), SEEN.len()),
        Figure::most("their normals", normals, tolerances::FACETS),
        Figure::most("their weights", weights, tolerances::FACETS),
        Figure::exactly("components, of five normals", table.count(), 5),
        Figure::most("eigenvalues, of the largest", values, tolerances::FLAT_EIGENVALUES),
        Figure::most(
            "pictures, of the peak",
            largest(pictures.errors(&table)),
            tolerances::FLAT_PICTURES,
        ),
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
