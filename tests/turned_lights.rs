//! Light turned on the device: against the harmonics at turned directions, against the generator's
//! Wigner functions, and back again.

use crate::oracle;
use eigenshade::{Argument, Error, Light, Rgb, Rotation};
use eigenshade_testing::images::single;
use eigenshade_testing::{largest, largest_difference, relative_error};
use oracle::{ExplicitLight, Numbers};
use std::f64::consts::PI;

/// A light of degree 9 turned in f32, of its largest coefficient: nine steps of a recurrence, and
/// sums of 19 products.
const TURNED_F32: f64 = 2e-6;

/// Its radiance in the turned direction, which is rounded: a slope of up to nine times the radiance.
const TURNED_RADIANCE: f64 = 1e-5;

/// A light turned by an angle whose cosine and sine are off length 1 by 1 %: nine times 5/16 of the
/// cube of 2 %.
const SCALED_ANGLE: f64 = 4e-5;

/// A light turned and turned back, of its largest coefficient.
const TURNED_BACK_F32: f64 = 1e-6;

/// A quarter turn brings an axis to the next, not to its negative or the third.
const QUARTER_TURN: f32 = 0.999;

/// A light of white noise.
fn noise(degree: usize, numbers: &mut Numbers) -> Vec<f64> {
    (0..(degree + 1) * (degree + 1)).map(|_| numbers.next()).collect()
}

fn turned(light: &[f32], rotation: &Rotation) -> Vec<f32> {
    let light = Light::new(light).expect("coefficients");
    light.turned::<289>(rotation).expect("room").to_vec()
}

fn wide(values: &[f32]) -> Vec<f64> {
    values.iter().map(|&value| value.into()).collect()
}

fn of_angles([a, b, c]: [f32; 3]) -> Rotation {
    Rotation::from_euler(a, b, c).expect("a rotation")
}

/// Angles in general, and those at which Euler angles are not unique.
fn angles() -> Vec<[f64; 3]> {
    let mut numbers = Numbers(11);
    let mut angles: Vec<_> = (0..200).map(|_| [0; 3].map(|_| PI * numbers.next())).collect();
    let special = [0.0, 1e-9, 1e-7, 1e-3, 0.14, 0.5 * PI, PI - 1e-6, PI - 1e-9, PI];
    angles.extend(special.iter().flat_map(|&a| [[0.3, a, -0.7], [a, 0.0, a], [0.0, -a, 0.0]]));
    angles
}

/// L'(Rω) = L(ω), the harmonics by their explicit sums.
#[test]
fn turned_light_comes_from_turned_directions() {
    let mut numbers = Numbers(5);
    let light = single(noise(9, &mut numbers));
    let before = ExplicitLight::new(&wide(&light));
    let directions: Vec<_> = (0..40)
        .map(|k| {
            let [x, y, z] = numbers.normal();
            [x, y, if k % 2 == 0 { z } else { -z }]
        })
        .collect();
    for [a, b, c] in angles().into_iter().step_by(5) {
        let rotation = of_angles([a, b, c].map(|angle| angle as f32));
        let after = ExplicitLight::new(&wide(&turned(&light, &rotation)));
        for &direction in &directions {
            let turned = rotation.turn_direction(direction.map(|x| x as f32));
            let seen = after.radiance(turned.map(f64::from));
            let expected = before.radiance(direction);
            assert!((seen - expected).abs() <= TURNED_RADIANCE, "{seen} {expected}");
        }
    }
}

/// The generator has them from Wigner's d by another recurrence.
#[test]
fn turned_light_is_the_generators() {
    let mut numbers = Numbers(6);
    for degree in [0, 1, 9, 12, 16] {
        let light = noise(degree, &mut numbers);
        let mut worst = 0.0f64;
        for angles in angles() {
            let single_angles = angles.map(|angle| angle as f32);
            let [a, b, c] = single_angles.map(f64::from);
            let of_generator = eigenshade_model::rotation::Rotation { alpha: b, beta: a, gamma: c };
            let expected = of_generator.turn(degree, &light);
            let scale = largest(light.iter().copied());
            let rotation = of_angles(single_angles);
            let found = wide(&turned(&single(light.clone()), &rotation));
            worst = worst.max(largest_difference(&found, &expected) / scale);
        }
        println!("degree {degree}: {worst:e}");
        assert!(worst <= TURNED_F32, "{degree}: {worst:e}");
    }
}

/// Turned and turned back in f32, by quaternions and by angles.
#[test]
fn turning_back_is_exact() {
    let mut numbers = Numbers(7);
    let mut worst = [0.0f64; 4];
    for round in 0..2_000 {
        let degree = 1 + round % 9;
        let light = single(noise(degree, &mut numbers));
        let quaternion = [0; 4].map(|_| numbers.next() as f32);
        let [x, y, z, w] = quaternion;
        let [a, b, c] = [x, y, z].map(|x| 3.2 * x);
        let of_quaternion = |quaternion| Rotation::from_quaternion(quaternion).expect("a rotation");
        let (first, second) = (of_quaternion(quaternion), of_angles([a, b, c]));
        let pairs = [
            (first, first.inverse()),
            (first, of_quaternion([x, y, z, -w])),
            (second, second.inverse()),
            (second, of_angles([-c, -b, -a])),
        ];
        for ((rotation, inverse), worst) in pairs.into_iter().zip(&mut worst) {
            let there = turned(&light, &rotation);
            let back = turned(&there, &inverse);
            *worst = worst.max(relative_error(&wide(&back), &wide(&light)));
        }
    }
    println!("back: {worst:?}");
    assert!(worst.iter().all(|&worst| worst <= TURNED_BACK_F32), "{worst:?}");
}

/// The energy of a degree of a light turned in f32, relative: roundings of 25 coefficients, and
/// the square of those of a rotation.
const TURNED_ENERGY: f64 = 1e-6;

/// A rotation changes the energy of no degree.
#[test]
fn degrees_keep_their_energy() {
    let mut numbers = Numbers(12);
    let energy = |light: &[f32], l: usize| -> f64 {
        light[l * l..(l + 1) * (l + 1)].iter().map(|&x| f64::from(x).powi(2)).sum()
    };
    let light = single(noise(12, &mut numbers));
    let mut worst = 0.0f64;
    for angles in angles() {
        let turned = turned(&light, &of_angles(angles.map(|angle| angle as f32)));
        let changes = (0..=12).map(|l| energy(&turned, l) / energy(&light, l) - 1.0);
        worst = worst.max(largest(changes));
    }
    println!("energy: {worst:e}");
    assert!(worst <= TURNED_ENERGY, "{worst:e}");
}

/// All channels at once are each channel by itself, of other degrees too.
#[test]
fn color_turns_as_each_channel() {
    let mut numbers = Numbers(13);
    let channels = [9, 3, 12].map(|degree| single(noise(degree, &mut numbers)));
    let lights = channels.each_ref().map(|channel| Light::new(channel).expect("a light"));
    let rotation = Rotation::from_quaternion([0.3, -0.5, 0.2, 0.1]).expect("a rotation");
    let turned = Rgb::from(lights).turned::<169>(&rotation).expect("room");
    for (turned, light) in <[_; 3]>::from(turned).into_iter().zip(lights) {
        assert_eq!(turned, light.turned::<169>(&rotation).expect("room"));
    }
    // The view axis too, in buffers of every length.
    let angle = [0.6f32, -0.8];
    let [light, ..] = lights;
    let found = light.turned_about_view::<100>(angle).expect("room");
    assert_eq!(found.as_slice(), light.turned_about_view::<120>(angle).expect("room").as_slice());
    let mut few = [0.0; 81];
    let error = light.turn_about_view_into(angle, &mut few);
    assert_eq!(error, Err(Error::Length { argument: Argument::Light, expected: 100, found: 81 }));
}

/// Cosines and sines of few digits neither brighten nor dim a light, and others are refused.
#[test]
fn cosines_and_sines_are_scaled() {
    let mut numbers = Numbers(21);
    let coefficients = single(noise(9, &mut numbers));
    let light = Light::new(&coefficients).expect("a light");
    let (sine, cosine) = 2.2_f32.sin_cos();
    let exact = light.turned_about_view::<100>([cosine, sine]).expect("an angle");
    for length in [0.9901, 0.996, 1.004, 1.0099] {
        let found = light.turned_about_view::<100>([length * cosine, length * sine]);
        let apart = largest_difference(&wide(&found.expect("nearly an angle")), &wide(&exact));
        let worst = apart / largest(wide(&coefficients));
        assert!(worst <= SCALED_ANGLE, "{length}: {worst:e}");
    }
    for length in [0.0, 0.98, 1.02, -7.0, f32::NAN, f32::INFINITY] {
        let refused = light.turned_about_view::<100>([length * cosine, length * sine]);
        assert_eq!(refused.err(), Some(Error::Rotation), "{length}");
        let in_loops = light.turned_about_view::<120>([length * cosine, length * sine]);
        assert_eq!(in_loops.err(), Some(Error::Rotation), "{length}");
    }
}

/// Half turns are their own inverses, and turns by nothing change nothing.
#[test]
fn half_turns_and_none() {
    let mut numbers = Numbers(8);
    for degree in 0..=9 {
        let light = single(noise(degree, &mut numbers));
        let [x, y, z] = numbers.normal().map(|x| x as f32);
        let half = Rotation::from_quaternion([x, y, z, 0.0]).expect("a rotation");
        for rotation in [half, Rotation::NONE] {
            let back = turned(&turned(&light, &rotation), &rotation);
            assert!(largest_difference(&wide(&back), &wide(&light)) <= TURNED_BACK_F32);
        }
        assert_eq!(turned(&light, &Rotation::NONE), light);
    }
}

/// Elements of a matrix in f32: roundings of angles up to π and of a few products.
const ONE_ROTATION: f64 = 1e-6;

/// One rotation by a quaternion, by angles, by its matrix; one after another.
#[test]
fn rotations_are_one_however_given() {
    let apart = |a: Rotation, b: Rotation| {
        let (a, b) = (a.matrix(), b.matrix());
        largest(a.as_flattened().iter().zip(b.as_flattened()).map(|(a, b)| f64::from(a - b)))
    };
    let of_angles = |a, b, c| Rotation::from_euler(a, b, c).expect("a rotation");
    for wide in angles() {
        let [a, b, c] = wide.map(|angle| angle as f32);
        let rotation = of_angles(a, b, c);
        // Products of quaternions about z, y and z.
        let (sb, cb) = (0.5 * b).sin_cos();
        let (sum, difference) = (0.5 * (a + c), 0.5 * (c - a));
        let quaternion =
            [sb * difference.sin(), sb * difference.cos(), cb * sum.sin(), cb * sum.cos()];
        let of_quaternion =
            Rotation::from_quaternion(quaternion.map(|x| -3.0 * x)).expect("a rotation");
        assert!(apart(rotation, of_quaternion) <= ONE_ROTATION);
        let of_matrix = Rotation::from_matrix(rotation.matrix()).expect("a rotation");
        assert_eq!(rotation, of_matrix);
        let none = rotation.after(rotation.inverse());
        assert!(apart(none, Rotation::NONE) <= ONE_ROTATION);
        let product = of_angles(a, 0.0, 0.0).after(of_angles(0.0, b, 0.0));
        let product = product.after(of_angles(c, 0.0, 0.0));
        assert!(apart(rotation, product) <= ONE_ROTATION);
        // The generator's angles are these.
        let [beta, alpha, gamma] = wide;
        let matrix = eigenshade_model::rotation::Rotation { alpha, beta, gamma }.matrix();
        let matrix = matrix.map(|row| row.map(|element| element as f32));
        let of_generator = Rotation::from_matrix(matrix).expect("a rotation");
        assert!(apart(rotation, of_generator) <= ONE_ROTATION);
    }
    // Rz(π/2) brings x to y, Ry(π/2) brings z to x.
    let quarter = of_angles(0.5 * PI as f32, 0.0, 0.0);
    assert!(quarter.turn_direction([1.0, 0.0, 0.0])[1] > QUARTER_TURN);
    let quarter = of_angles(0.0, 0.5 * PI as f32, 0.0);
    assert!(quarter.turn_direction([0.0, 0.0, 1.0])[0] > QUARTER_TURN);
}

#[test]
fn what_is_no_rotation_is_an_error() {
    let no = Err(Error::Rotation);
    assert_eq!(Rotation::from_quaternion([0.0f32; 4]), no);
    assert_eq!(Rotation::from_quaternion([f32::MAX, 0.0, 0.0, 0.0]), no);
    assert_eq!(Rotation::from_quaternion([f32::NAN, 0.0, 0.0, 1.0]), no);
    assert_eq!(Rotation::from_euler(0.0, f32::INFINITY, 0.0), no);
    let mirrored = [[1.0f32, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]];
    assert_eq!(Rotation::from_matrix(mirrored), no);
    assert_eq!(Rotation::from_matrix([[2.0f32, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 2.0]]), no);
    assert_eq!(Rotation::from_matrix([[f32::NAN; 3]; 3]), no);
    // Too long, and too short: every product is below what it should be.
    for scale in [1.01f32, 0.99] {
        let scaled = Rotation::NONE.matrix().map(|row| row.map(|element: f32| scale * element));
        assert_eq!(Rotation::from_matrix(scaled), no, "{scale}");
    }
    let light = [0.5f32; 16];
    let light = Light::new(&light).expect("16 coefficients");
    assert!(light.turned::<16>(&Rotation::NONE).is_ok());
    assert!(matches!(light.turned::<15>(&Rotation::NONE), Err(Error::Capacity { .. })));
    let numbers = [0.5f32; 324];
    let light = Light::new(&numbers).expect("324 coefficients");
    let error = Error::Beyond { argument: Argument::Light, most: 16, found: 17 };
    assert_eq!(light.turned::<324>(&Rotation::NONE), Err(error));
    let light = Light::new(&numbers[..196]).expect("196 coefficients");
    let error = Error::Beyond { argument: Argument::Light, most: 12, found: 13 };
    assert_eq!(light.turned_about_view::<196>([1.0, 0.0]), Err(error));
    assert_eq!(light.turned_about_view::<200>([1.0, 0.0]), Err(error));
    assert_eq!(light.turn_about_view_into([1.0, 0.0], &mut [0.0; 196]), Err(error));
}

/// Of every length a rotation or an error: the reciprocal of a small square was finite and twice
/// of it was not.
#[test]
fn quaternions_of_any_length_are_rotations_or_errors() {
    let no = Err(Error::Rotation);
    assert_eq!(Rotation::from_quaternion([0.0f32, 0.0, 0.0, 7e-20]), no);
    assert_eq!(Rotation::from_quaternion([0.0f32, 0.0, 0.0, 1.1e-19]), Ok(Rotation::NONE));
    let mut refused = 0;
    for step in 0..3_000u16 {
        let length = 2f64.powf(f64::from(step) / 10.0 - 150.0) as f32;
        let rotation = Rotation::from_quaternion([1.0, -2.0, 0.5, 3.0].map(|x| x * length));
        let Ok(rotation) = rotation else {
            refused += 1;
            continue;
        };
        let product = rotation.after(rotation.inverse()).matrix();
        for (row, found) in product.iter().enumerate() {
            for (column, &found) in found.iter().enumerate() {
                let expected = f32::from(u8::from(row == column));
                assert!((found - expected).abs() <= 2e-6, "{length:e}: {product:?}");
            }
        }
    }
    // The square is a normal number of f32 from 2^-126 to 2^128: 127 of 300 octaves of lengths.
    assert!((1_725..1_735).contains(&refused), "{refused}");
}
