//! Environment maps of every file type to coefficients: closed forms, the sum
//! texel by texel, the shipped maps, and every fault of a file.

use crate::tolerances;

mod cubes;
mod files;
mod pictures;
mod radiance;
mod refusals;
mod stated;

use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::light::projection::{named_maps, project};
use eigenshade_model::inputs::coefficient_csv::{read_lights, write_lights};
use eigenshade_model::inputs::coefficient_text::{LIGHT_DIGITS, rounded};
use eigenshade_model::special::spherical_harmonic;
use eigenshade_table::light;
use files::{Type, held, map_of, through};
use std::f64::consts::PI;
use tolerances::LIGHT_PROJECTION;

const MAPS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tables/inputs/maps");
const LIGHTS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tables/inputs/lights.csv");

/// Midpoint rule of a smooth map, of its largest coefficient: this times (degree / height)².
const MAP_DEGREE_SQUARED: f64 = 0.1;

/// Midpoint rule of a cosine lobe at height 128, of its largest coefficient: the kink at its rim.
const MAP_KINK: f64 = 2e-4;

/// Files with 8 bits a mantissa: half of what is cut off, 1/256, is added on reading.
const MAP_RGBE: f64 = 4e-3;

/// Files of half floats: 11 bits, each texel rounded to nearest.
const MAP_HALF: f64 = 5e-4;

/// Files of 32-bit floats: 24 bits, each texel rounded to nearest.
const MAP_FLOAT: f64 = 6e-8;

/// Σ radiance x Y x solid angle over all texels, one by one.
fn direct(map: &EnvironmentMap, degree: usize) -> [Vec<f64>; 3] {
    let mut sums = [0, 1, 2].map(|_| vec![0.0; light::count(degree)]);
    for row in 0..map.height {
        for column in 0..map.width {
            let harmonics = spherical_harmonic::all(degree, map.direction(column, row));
            let texel = map.texels[row * map.width + column];
            for (sums, value) in sums.iter_mut().zip(texel) {
                let weight = f64::from(value) * map.solid_angle(row);
                for (sum, harmonic) in sums.iter_mut().zip(&harmonics) {
                    *sum += weight * harmonic;
                }
            }
        }
    }
    sums
}

/// Asserts that the coefficients differ by no more than `tolerance` of the
/// largest expected one, channel by channel.
#[track_caller]
fn assert_near(found: &[Vec<f64>; 3], expected: &[Vec<f64>; 3], tolerance: f64) {
    for (found, expected) in found.iter().zip(expected) {
        assert_eq!(found.len(), expected.len());
        let scale = eigenshade_testing::largest(expected.iter().copied());
        for (k, (found, expected)) in found.iter().zip(expected).enumerate() {
            let error = (found - expected).abs() / scale;
            assert!(error <= tolerance, "coefficient {k}: {found} for {expected}, {error:e}");
        }
    }
}

/// What the file type itself may change, relative to the largest texel.
fn rounding(file_type: Type) -> f64 {
    match file_type {
        Type::Hdr => MAP_RGBE,
        Type::ExrHalf | Type::ExrLayer => MAP_HALF,
        _ => MAP_FLOAT,
    }
}

#[test]
fn the_separable_sum_is_the_direct_one() {
    // An even, an odd and a single width; no symmetry, and negative texels.
    for (width, height) in [(48, 24), (31, 17), (1, 3), (2, 1), (3, 2)] {
        let mut state = 1_u32;
        let texels = (0..width * height)
            .map(|_| {
                [0, 1, 2].map(|_| {
                    state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                    (state >> 8) as f32 / 16_777_216.0 - 0.3
                })
            })
            .collect();
        let map = EnvironmentMap::new(width, height, texels).unwrap();
        assert_near(&project(&map, 32), &direct(&map, 32), LIGHT_PROJECTION);
        assert_near(&project(&map, 0), &direct(&map, 0), LIGHT_PROJECTION);
    }
}

#[test]
fn solid_angles_fill_the_sphere() {
    for (width, height) in [(512, 256), (7, 3), (1, 1)] {
        let map = EnvironmentMap::new(width, height, vec![[1.0; 3]; width * height]).unwrap();
        let sphere: f64 = (0..height).map(|row| width as f64 * map.solid_angle(row)).sum();
        assert!((sphere - 4.0 * PI).abs() < LIGHT_PROJECTION);
        let [total, ..] = map.negative_integral().total;
        assert!((total - 4.0 * PI).abs() < 4.0 * PI * LIGHT_PROJECTION);
    }
}

#[test]
fn a_constant_map_has_one_coefficient() {
    let (degree, height) = (9, 64);
    let color = [2.0, 0.5, 0.25];
    for file_type in Type::ALL {
        let constant = map_of(height, |_| color);
        let map = through(file_type, &constant);
        let [r, g, b] = held(file_type, &constant).texels[0];
        let color = if file_type == Type::PfmGray { [r; 3] } else { [r, g, b] };
        let expected = color.map(|c| {
            let mut expected = vec![0.0; light::count(degree)];
            expected[0] = f64::from(c) * (4.0 * PI).sqrt();
            expected
        });
        let midpoint = MAP_DEGREE_SQUARED * (degree as f64 / height as f64).powi(2);
        assert_near(&project(&map, degree), &expected, midpoint + rounding(file_type));
    }
}

#[test]
fn a_cosine_lobe_has_the_known_coefficients() {
    // Of max(0, n.w): A_l Y_l^m(n), with A_0 = π, A_1 = 2π/3, and else 0 for odd l,
    // 2π (-1)^(l/2-1) / ((l+2)(l-1)) l! / (2^l (l/2)!²) for even.
    let (degree, height) = (8, 128);
    let factor = |l: usize| match l {
        0 => PI,
        1 => 2.0 * PI / 3.0,
        _ if l % 2 == 1 => 0.0,
        _ => {
            let binomial =
                (1..=l / 2).fold(1.0, |product, k| product * (l / 2 + k) as f64 / (4 * k) as f64);
            let sign = if l.is_multiple_of(4) { -1.0 } else { 1.0 };
            2.0 * PI * sign * binomial / ((l + 2) * (l - 1)) as f64
        }
    };
    for axis in [[0.0, 0.0, 1.0], [0.6, 0.0, -0.8], [0.48, 0.6, 0.64], [0.0, -1.0, 0.0]] {
        let harmonics = spherical_harmonic::all(degree, axis);
        let expected: Vec<f64> = light::indices(degree)
            .zip(harmonics)
            .map(|((l, _), harmonic)| factor(l) * harmonic)
            .collect();
        let expected = [expected.clone(), expected.clone(), expected];
        let lobe = map_of(height, |[x, y, z]| {
            [(axis[0] * x + axis[1] * y + axis[2] * z).max(0.0) as f32; 3]
        });
        for file_type in Type::ALL {
            let map = through(file_type, &lobe);
            assert_near(&project(&map, degree), &expected, MAP_KINK + rounding(file_type));
        }
    }
}

#[test]
fn one_harmonic_has_one_coefficient() {
    let (degree, height) = (6, 128);
    // Left out: the type that knows no negative texel.
    for file_type in Type::ALL.into_iter().filter(|&file_type| file_type != Type::Hdr) {
        for (place, (l, _)) in light::indices(degree).enumerate() {
            if file_type != Type::ExrFloat && l > 2 {
                continue;
            }
            let map = through(
                file_type,
                &map_of(height, |direction| {
                    [spherical_harmonic::all(degree, direction)[place] as f32; 3]
                }),
            );
            let mut expected = vec![0.0; light::count(degree)];
            expected[place] = 1.0;
            let expected = [expected.clone(), expected.clone(), expected];
            let midpoint = MAP_DEGREE_SQUARED * (degree as f64 / height as f64).powi(2);
            assert_near(&project(&map, degree), &expected, midpoint + rounding(file_type));
        }
    }
}

#[test]
fn one_texel_is_a_point_of_light() {
    let degree = 32;
    for (column, row) in [(0, 0), (7, 3), (63, 31), (32, 16), (40, 31)] {
        // What every file type can hold.
        let mut map = map_of(32, |_| [0.0; 3]);
        map.texels[row * map.width + column] = [4.0, 1.0, 0.5];
        let harmonics = spherical_harmonic::all(degree, map.direction(column, row));
        for file_type in Type::ALL {
            let [r, g, b] = held(file_type, &map).texels[row * map.width + column];
            let color = if file_type == Type::PfmGray { [r; 3] } else { [r, g, b] };
            let expected = color
                .map(f64::from)
                .map(|value| harmonics.iter().map(|y| value * map.solid_angle(row) * y).collect());
            let found = project(&through(file_type, &map), degree);
            assert_near(&found, &expected, LIGHT_PROJECTION);
        }
    }
}

#[test]
fn texels_keep_their_places() {
    // Odd and even heights; every file type can hold quarters.
    for height in [1, 2, 3, 7] {
        let mut map = map_of(height, |_| [0.0; 3]);
        for (k, texel) in map.texels.iter_mut().enumerate() {
            *texel = [0.25 * (k + 1) as f32; 3];
        }
        for file_type in Type::ALL {
            assert_eq!(through(file_type, &map), held(file_type, &map), "{file_type:?}");
        }
    }
}

/// Texels of another size have the same radiance over every direction: exactly where they are
/// parts of the old ones, and the same integral otherwise.
#[test]
fn maps_in_blocks_have_the_same_light() {
    let texels = |count: usize| (0..count).map(|k| [(k * 7 % 11) as f32, 1.0, 0.5]).collect();
    let map = EnvironmentMap::new(10, 5, texels(50)).unwrap();
    let blocks = map.clone().in_blocks(8);
    assert_eq!((blocks.width, blocks.height), (16, 8));
    let integral = |map: &EnvironmentMap| direct(map, 0).map(|sum| sum[0]);
    for (a, b) in integral(&map).into_iter().zip(integral(&blocks)) {
        assert!((a / b - 1.0).abs() < 1e-6, "{a} {b}");
    }
    let halved = EnvironmentMap::new(4, 2, texels(8)).unwrap().in_blocks(4);
    let of_rows: Vec<f32> = halved.texels.iter().map(|texel| texel[0]).collect();
    assert_eq!(
        of_rows,
        [0.0, 7.0, 3.0, 10.0, 0.0, 7.0, 3.0, 10.0, 6.0, 2.0, 9.0, 5.0, 6.0, 2.0, 9.0, 5.0]
    );
    let whole = EnvironmentMap::new(16, 8, texels(128)).unwrap();
    assert_eq!(whole.clone().in_blocks(8), whole);
}

#[test]
fn the_map_is_seen_from_the_camera() {
    let map = map_of(64, |_| [0.0; 3]);
    let near = |column: usize, row: usize, expected: [f64; 3]| {
        let found = map.direction(column, row);
        let distance: f64 = found.iter().zip(expected).map(|(a, b)| (a - b).powi(2)).sum();
        // Half a texel off, across.
        assert!(distance.sqrt() < PI / 64.0, "{found:?} for {expected:?}");
    };
    near(64, 32, [0.0, 0.0, -1.0]);
    near(0, 32, [0.0, 0.0, 1.0]);
    near(127, 31, [0.0, 0.0, 1.0]);
    near(96, 32, [1.0, 0.0, 0.0]);
    near(32, 32, [-1.0, 0.0, 0.0]);
    near(5, 0, [0.0, 1.0, 0.0]);
    near(5, 63, [0.0, -1.0, 0.0]);
}

#[test]
fn every_map_decodes_and_keeps_its_negative_texels() {
    let maps = named_maps(&[MAPS]).unwrap();
    assert_eq!(maps.len(), 18);
    for (name, path) in maps {
        let map = EnvironmentMap::from_path(path).unwrap();
        assert_eq!((map.width, map.height), (512, 256));
        let (mut total, mut negative) = ([0.0; 3], [0.0; 3]);
        for (k, texel) in map.texels.iter().enumerate() {
            let row = (k / map.width) as f64;
            let (top, bottom) = (PI * row / 256.0, PI * (row + 1.0) / 256.0);
            let solid_angle = 2.0 * PI / 512.0 * (top.cos() - bottom.cos());
            for channel in 0..3 {
                let value = f64::from(texel[channel]) * solid_angle;
                total[channel] += value;
                negative[channel] += value.min(0.0);
            }
        }
        let integrals = map.negative_integral();
        for channel in 0..3 {
            assert!(negative[channel] < 0.0);
            let error = |a: f64, b: f64| (a - b).abs() / total[channel];
            assert!(error(integrals.total[channel], total[channel]) < LIGHT_PROJECTION);
            assert!(error(integrals.negative[channel], negative[channel]) < LIGHT_PROJECTION);
            let ambient = project(&map, 0)[channel][0] * (4.0 * PI).sqrt();
            assert!(error(ambient, total[channel]) < LIGHT_PROJECTION);
        }
        println!(
            "{name}: integral {:.4?}, negative {:.4?}, share {:.2} %",
            integrals.total,
            integrals.negative,
            100.0 * integrals.negative_share()
        );
    }
}

#[test]
fn the_shipped_lights_are_those_of_the_maps() {
    let shipped = read_lights(LIGHTS, None).unwrap();
    assert_eq!((shipped.degree, shipped.entries.len()), (32, 26));
    let degree = 9;
    let shipped = shipped.truncated(degree);
    for (name, path) in named_maps(&[MAPS]).unwrap() {
        let rgb = project(&EnvironmentMap::from_path(path).unwrap(), degree);
        let entry = shipped.entries.iter().find(|entry| entry.name == name).unwrap();
        for (shipped, made) in entry.rgb.iter().flatten().zip(rgb.iter().flatten()) {
            // Half a unit of the last digit, and what another libm may do.
            let rounding = 5e-9 * made.abs() + LIGHT_PROJECTION * rgb[1][0];
            assert!((shipped - made).abs() <= rounding, "{name}: {shipped} for {made}");
        }
    }
    let again = rounded(&shipped, LIGHT_DIGITS);
    assert_eq!(again, shipped);
    let mut text = Vec::new();
    write_lights(&again, &mut text).unwrap();
    assert!(text.starts_with(b"name,l,m,r,g,b\n"));
}
