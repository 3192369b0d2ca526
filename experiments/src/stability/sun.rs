//! Maps with a sun, and maps of odd sizes.

use super::{Case, Figure};
use crate::tolerances;
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::light::projection;
use eigenshade_index::light;
use eigenshade_model::database::Lights;
use eigenshade_testing::fixtures::{self, named};
use eigenshade_testing::largest;
use eigenshade_testing::oracle::Numbers;
use std::f64::consts::PI;

/// Error of weighting a row from pole to pole with sin θ at its center: π/2 instead of 1, 57 % too
/// much.
const NAIVE_ROWS: f64 = 0.5;

pub const TEXEL: Case = Case {
    name: "a sun: one texel 1e6 times the rest, and a negative one",
    naively: "f32 sums lose the sky beside the sun; clamping negative texels changes the integral",
    here: "f64 sums by rows; texels are kept as they are; the ringing of a finite degree stays visible",
    measure: texel,
};

pub const SIZES: Case = Case {
    name: "maps of 2 x 1 and of 8192 x 4096",
    naively: "rows weighed with sin θ: 57 % too much at one row; 33 million terms in one running sum",
    here: "exact solid angles; rows first, then columns",
    measure: sizes,
};

const DEGREE: usize = 16;

fn project(map: &EnvironmentMap, degree: usize) -> Vec<f64> {
    projection::project(map, degree)[0].clone()
}

/// Compares with the closed form: the sky's ambient term, and the sun's harmonics in its direction,
/// by the oracle's explicit sums.
fn texel() -> Vec<Figure> {
    let (width, height) = (128, 64);
    let mut map =
        EnvironmentMap::new(width, height, vec![[1.0; 3]; width * height]).expect("a map");
    let suns = [(17, 100, 1e6f32), (40, 3, -1e3)];
    for (row, column, value) in suns {
        map.texels[row * width + column] = [value; 3];
    }
    let found = project(&map, DEGREE);
    let mut expected = constant_map(&map, DEGREE);
    for (row, column, value) in suns {
        let solid_angle = 2.0 * PI / width as f64
            * ((PI * row as f64 / height as f64).cos()
                - (PI * (row + 1) as f64 / height as f64).cos());
        let [x, y, z] = map.direction(column, row);
        for (place, (l, m)) in light::indices(DEGREE).enumerate() {
            let mut unit = vec![0.0; light::count(DEGREE)];
            unit[light::position(l, m)] = 1.0;
            let harmonic =
                eigenshade_testing::oracle::ExplicitLight::new(&unit).radiance([x, y, z]);
            expected[place] += (f64::from(value) - 1.0) * solid_angle * harmonic;
        }
    }
    let scale = largest(expected.iter().copied());
    let apart = largest(found.iter().zip(&expected).map(|(a, b)| a - b)) / scale;
    // In a database with weak lights, all of its images are reproduced.
    let mut numbers = Numbers(31);
    let mut lights = fixtures::lights(DEGREE, 2, &mut numbers);
    lights.entries.push(named("sun", found));
    let loaded = fixtures::scene(
        Lights { degree: DEGREE, entries: lights.entries },
        fixtures::materials(7, 5, &mut numbers),
    );
    let error = fixtures::reconstruction_error(&loaded, &fixtures::table(&loaded));
    vec![
        Figure::most("coefficients, of the largest", apart, tolerances::SUN),
        Figure::most("images under it, of the peak", error, tolerances::ALL_COMPONENTS),
    ]
}

/// The projection of a map that is 1 everywhere, including the texel centers: its ambient term is
/// exact, and the others come from the map's own quadrature.
fn constant_map(map: &EnvironmentMap, degree: usize) -> Vec<f64> {
    let ones = EnvironmentMap { texels: vec![[1.0; 3]; map.texels.len()], ..map.clone() };
    project(&ones, degree)
}

fn sizes() -> Vec<Figure> {
    let ambient = (4.0 * PI).sqrt();
    let small = EnvironmentMap::new(2, 1, vec![[1.0; 3], [3.0; 3]]).expect("a map");
    let of_small = (project(&small, 4)[0] / (2.0 * ambient) - 1.0).abs();
    // A sky that brightens with height, 1 + y, whose harmonics are known.
    let (width, height) = (8192, 4096);
    let texels = (0..height)
        .flat_map(|row| {
            let y = (PI * (row as f64 + 0.5) / height as f64).cos();
            std::iter::repeat_n([(1.0 + y) as f32; 3], width)
        })
        .collect();
    let found = project(&EnvironmentMap::new(width, height, texels).expect("a map"), 8);
    let mut expected = vec![0.0; light::count(8)];
    expected[light::position(0, 0)] = ambient;
    expected[light::position(1, -1)] = -(4.0 * PI / 3.0).sqrt();
    let of_large = largest(found.iter().zip(&expected).map(|(a, b)| a - b)) / ambient;
    let naive = 2.0 * PI * PI * 1.0 / (4.0 * PI) - 1.0;
    vec![
        Figure::least("2 x 1 weighed with sin θ", naive, NAIVE_ROWS),
        Figure::most("2 x 1: the mean", of_small, tolerances::LIGHT_PROJECTION),
        Figure::most("8192 x 4096, of the largest", of_large, tolerances::LARGE_MAP),
    ]
}
