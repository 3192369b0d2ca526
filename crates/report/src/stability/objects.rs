//! Degenerate facets of a mesh.

use super::{Figure, exactly, least, most, tight};
use crate::tolerances;
use eigenshade_generator::object::mesh;
use eigenshade_generator::object::surface::View;
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_testing::fixtures::ROOT;
use eigenshade_testing::largest_difference;
use nalgebra::Vector3;

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
    let text = std::fs::read_to_string(&path).expect("a mesh");
    let view = View { is_flat: true, ..View::default() };
    let surface = mesh::surface(&InputFile::from(path), &view).expect("a mesh");
    let facets = surface.facets.iter().filter(|facet| facet.projected_area > 0.0);
    let (found, areas): (Vec<_>, Vec<_>) =
        facets.map(|facet| (facet.normal, facet.projected_area)).unzip();
    let (expected, planes): (Vec<_>, Vec<_>) = SEEN.into_iter().unzip();
    let expected: Vec<[f64; 3]> =
        expected.into_iter().map(|normal| Vector3::from(normal).normalize().into()).collect();
    let shares = |areas: &[f64]| -> Vec<f64> {
        let sum: f64 = areas.iter().sum();
        areas.iter().map(|area| area / sum).collect()
    };
    let normals = largest_difference(found.as_flattened(), expected.as_flattened());
    vec![
        // Two with equal corners, and three on a line of two digits.
        least("normals divided by their length: NaN", naive(&text), 5.0),
        exactly("facets seen", found.len(), SEEN.len()),
        tight("their normals", normals, tolerances::FACETS),
        most(
            "their areas",
            largest_difference(&shares(&areas), &shares(&planes)),
            tolerances::FACETS,
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
    let has_no_normal = |facet: &&[f64; 3]| {
        let [a, b, c] = facet.map(|index| Vector3::from(corners[index as usize - 1]));
        (b - a).cross(&(c - a)).normalize().z.is_nan()
    };
    rows("f ").iter().filter(has_no_normal).count() as f64
}
