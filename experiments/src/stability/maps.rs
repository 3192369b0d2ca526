//! Maps with a sun, and maps of odd sizes.

use super::{Figure, least, most, tight};
use crate::tolerances;
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::light::projection;
use eigenshade_index::light;
use eigenshade_testing::fixtures::{self, named};
use eigenshade_testing::oracle::{ExplicitLight, Numbers};
use eigenshade_testing::relative_error;
use std::f64::consts::PI;

fn project(map: &EnvironmentMap, degree: usize) -> Vec<f64> {
    projection::project(map, degree)[0].clone()
}

/// The harmonics at a direction by the oracle's explicit sums. They are the coefficients of light
/// from that direction alone.
pub(super) fn harmonics(degree: usize, direction: [f64; 3]) -> Vec<f64> {
    let harmonic = |k: usize| {
        let mut unit = vec![0.0; light::count(degree)];
        unit[k] = 1.0;
        ExplicitLight::new(&unit).radiance(direction)
    };
    (0..light::count(degree)).map(harmonic).collect()
}

/// A texel of 1e6 and one of -1e3 in a map that is 1 elsewhere, against the closed form: the
/// projection of the constant map, and the texels' harmonics in their directions.
pub(super) fn sun() -> Vec<Figure> {
    const DEGREE: usize = 16;
    let (width, height) = (128, 64);
    let mut map =
        EnvironmentMap::new(width, height, vec![[1.0; 3]; width * height]).expect("a map");
    let mut expected = project(&map, DEGREE);
    for (row, column, value) in [(17, 100, 1e6f32), (40, 3, -1e3)] {
        map.texels[row * width + column] = [value; 3];
        let cosine = |edge: usize| (PI * edge as f64 / height as f64).cos();
        let solid_angle = 2.0 * PI / width as f64 * (cosine(row) - cosine(row + 1));
        let excess = (f64::from(value) - 1.0) * solid_angle;
        let harmonics = harmonics(DEGREE, map.direction(column, row));
        expected.iter_mut().zip(harmonics).for_each(|(sum, harmonic)| *sum += excess * harmonic);
    }
    let found = project(&map, DEGREE);
    let apart = relative_error(&found, &expected);
    // In a database with weak lights, all of its images are reproduced.
    let mut numbers = Numbers(31);
    let mut lights = fixtures::lights(DEGREE, 2, &mut numbers);
    lights.entries.push(named("sun", found));
    let loaded = fixtures::scene(lights, fixtures::materials(7, 5, &mut numbers));
    let error = fixtures::reconstruction_error(&loaded, &fixtures::table(&loaded));
    vec![
        tight("coefficients, of the largest", apart, tolerances::SUN),
        most("images under the map, of the peak", error, tolerances::ALL_COMPONENTS),
    ]
}

/// The mean of a map of two texels, and a sky that brightens with height, 1 + y, whose harmonics
/// are known.
pub(super) fn sizes() -> Vec<Figure> {
    let ambient = (4.0 * PI).sqrt();
    let small = EnvironmentMap::new(2, 1, vec![[1.0; 3], [3.0; 3]]).expect("a map");
    let of_small = project(&small, 4)[0] / (2.0 * ambient) - 1.0;
    let (width, height) = (8192, 4096);
    let row = |row: usize| {
        let y = (PI * (row as f64 + 0.5) / height as f64).cos();
        std::iter::repeat_n([(1.0 + y) as f32; 3], width)
    };
    let texels = (0..height).flat_map(row).collect();
    let found = project(&EnvironmentMap::new(width, height, texels).expect("a map"), 8);
    let mut expected = vec![0.0; light::count(8)];
    expected[light::position(0, 0)] = ambient;
    expected[light::position(1, -1)] = -(4.0 * PI / 3.0).sqrt();
    let naive = 2.0 * PI * PI / (4.0 * PI) - 1.0;
    vec![
        // A row from pole to pole, weighted with sin θ at its center, counts π/2 instead of 1.
        least("2 x 1, rows weighted with sin θ", naive, 0.5),
        most("2 x 1: the mean", of_small, tolerances::LIGHT_PROJECTION),
        most(
            "8192 x 4096, of the largest",
            relative_error(&found, &expected),
            tolerances::LARGE_MAP,
        ),
    ]
}
