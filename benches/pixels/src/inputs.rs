//! What is shaded: the shipped lights on the shipped materials, and normals.

use crate::place::Placed;
use csv::{ReaderBuilder, StringRecord};
use eigenshade::{Light, Material, NineTerms, sphere};
use eigenshade_index::{light, material};
use std::path::Path;

/// Name of the nine-term formula in docs/performance.md.
pub const NINE: &str = "nine-term formula";

/// It, of any coefficients.
pub const NINE_TERMS: NineTerms<f32> =
    NineTerms::new([0.9, 0.2, -0.1, 0.5, 0.05, 0.02, -0.03, 0.01, 0.07]);

/// Room for irradiances, apart from the normals.
pub fn irradiances() -> Placed {
    Placed::zeros(PIXELS, 3)
}

/// Few enough that normals and irradiances stay in the second cache.
pub const PIXELS: usize = 16_384;
const DEGREE: usize = 9;
const ORDER: usize = 7;

/// Many normals over the visible hemisphere.
pub fn normals() -> [Placed; 3] {
    let normal = |k: usize| {
        let z = (k as f64 + 0.5) / PIXELS as f64;
        let (sine, tilt) = ((1.0 - z * z).sqrt(), 2.399_963 * k as f64);
        [sine * tilt.cos(), sine * tilt.sin(), z].map(|value| value as f32)
    };
    std::array::from_fn(|axis| {
        let mut placed = Placed::zeros(PIXELS, axis);
        for (k, number) in placed.all_mut().iter_mut().enumerate() {
            *number = normal(k)[axis];
        }
        placed
    })
}

/// Luminances of the shipped lights.
pub fn lights() -> Vec<Vec<f32>> {
    entries("lights.csv", light::count(DEGREE), |row| {
        let [r, g, b] = [3, 4, 5].map(|column| number(row, column));
        let [l, m] = [1, 2].map(|column| number(row, column) as isize);
        let place = (l <= DEGREE as isize).then(|| light::position(l.unsigned_abs(), m))?;
        Some((place, 0.2126 * r + 0.7152 * g + 0.0722 * b))
    })
}

/// The shipped materials, which are grey.
pub fn materials() -> Vec<Vec<f32>> {
    entries("materials.csv", material::count(ORDER), |row| {
        let [o, p, q] = [1, 2, 3].map(|column| number(row, column) as usize);
        Some((material::position(o, p, q), number(row, 4)))
    })
}

/// Entries of a file by name: each row's place and number.
fn entries(
    file: &str,
    count: usize,
    place: impl Fn(&StringRecord) -> Option<(usize, f64)>,
) -> Vec<Vec<f32>> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tables/inputs").join(file);
    let reader = ReaderBuilder::new().comment(Some(b'#')).from_path(&path);
    let mut found: Vec<(String, Vec<f32>)> = Vec::new();
    for row in reader.expect("the shipped inputs").records() {
        let row = row.expect("a row");
        if found.last().is_none_or(|(name, _)| *name != row[0]) {
            found.push((row[0].to_owned(), vec![0.0; count]));
        }
        if let (Some((place, value)), Some((_, values))) = (place(&row), found.last_mut()) {
            values[place] = value as f32;
        }
    }
    found.into_iter().map(|(_, values)| values).collect()
}

fn number(row: &StringRecord, column: usize) -> f64 {
    row[column].parse().expect("a number")
}

/// d of a light on a material.
pub fn coefficients(light: &[f32], material: &[f32]) -> Vec<f32> {
    let order = (0..).find(|&order| material::count(order) >= material.len()).expect("an order");
    let light = Light::new(light.len().isqrt() - 1, light).expect("a light");
    let material = Material::new(order, material).expect("a material");
    sphere::project(&light, &material).expect("it fits").to_vec()
}

/// d of each light on each material.
pub fn database() -> Vec<Vec<f32>> {
    let (lights, materials) = (lights(), materials());
    let pairs = lights.iter().flat_map(|light| materials.iter().map(move |of| (light, of)));
    pairs.map(|(light, material)| coefficients(light, material)).collect()
}
