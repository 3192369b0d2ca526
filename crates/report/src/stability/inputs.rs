//! Difficult inputs: maps with a sun and of odd sizes, normals of 8 bits and behind the rim, a sun,
//! and a light that rings. Images of the shipped table are compared with its sums in f64.

use super::{Figure, exactly, least, most, tight};
use crate::numbers::median;
use crate::tolerances;
use eigenshade::screen::NegativePolicy;
use eigenshade::truncation::Tolerance;
use eigenshade::{Normal, Normals, q15};
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::light::projection;
use eigenshade_model::database::Named;
use eigenshade_model::evaluation::Evaluator;
use eigenshade_model::shipped;
use eigenshade_shading::integer_shader::IntegerShader;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader};
use eigenshade_table::{Table, decode, light};
use eigenshade_testing::fixtures::{self, captured, disc, named};
use eigenshade_testing::images::vectors;
use eigenshade_testing::oracle::{ExplicitLight, Numbers};
use eigenshade_testing::{largest, largest_difference, relative_error};
use std::f64::consts::PI;

fn project(map: &EnvironmentMap, degree: usize) -> Vec<f64> {
    projection::project(map, degree)[0].clone()
}

/// The coefficients of light from one direction: its harmonics by the oracle's explicit sums.
fn harmonics(degree: usize, direction: [f64; 3]) -> Vec<f64> {
    let harmonic = |k: usize| {
        let mut unit = vec![0.0; light::count(degree)];
        unit[k] = 1.0;
        ExplicitLight::new(&unit).radiance(direction)
    };
    (0..light::count(degree)).map(harmonic).collect()
}

/// A texel of 1e6 and one of -1e3 in a map that is 1 elsewhere, against the closed form: the
/// projection of the constant map, and the texels' harmonics in their directions.
pub(super) fn sun_in_a_map() -> Vec<Figure> {
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

/// The mean of a map of two texels, and the sky 1 + y, whose harmonics are known.
pub(super) fn map_sizes() -> Vec<Figure> {
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
    let off = relative_error(&found, &expected);
    let naive = 2.0 * PI * PI / (4.0 * PI) - 1.0;
    vec![
        // A row from pole to pole, weighted with sin θ at its center, counts π/2 instead of 1.
        least("2 x 1, rows weighted with sin θ", naive, 0.5),
        most("2 x 1: the mean", of_small, tolerances::LIGHT_PROJECTION),
        most("8192 x 4096, of the largest", off, tolerances::LARGE_MAP),
    ]
}

/// The shipped materials, every `step`-th.
fn materials(step: usize) -> Vec<Vec<f64>> {
    let materials = shipped::materials().expect("the shipped materials").truncated(7);
    materials.entries.iter().step_by(step).map(Named::luminance).collect()
}

fn table() -> Table {
    decode(shipped::TABLE).expect("the shipped table")
}

/// The image of the shipped table in f64, component by component.
fn reference(light: &[f64], material: &[f64], normals: &[[f64; 3]]) -> Vec<f64> {
    let evaluator = Evaluator::new(table());
    let d = evaluator.project(light, material).expect("a table that projects");
    evaluator.eigenimages(normals).reconstruct(&d)
}

fn floats(values: Vec<f32>) -> Vec<f64> {
    values.into_iter().map(f64::from).collect()
}

/// Directions of any length in Q15.
fn in_integers(directions: &[[f64; 3]]) -> Vec<q15::Normal> {
    let along = |direction: &[f64; 3]| {
        let [x, y, z] = direction.map(|c| (c * f64::from(i32::MAX)) as i32);
        q15::Normal::new(x, y, z).expect("a direction")
    };
    directions.iter().map(along).collect()
}

/// Shaded at decoded 8-bit normals, as they are or scaled to length 1.
pub(super) fn eight_bits() -> Vec<Figure> {
    let normals = disc(64);
    let decode = |c: f64| f64::from(2 * ((c + 1.0) * 127.5).round() as i32 - 255) / 255.0;
    let decoded: Vec<[f64; 3]> = normals.iter().map(|normal| normal.map(decode)).collect();
    let component = |axis: usize| decoded.iter().map(|v| v[axis] as f32).collect::<Vec<f32>>();
    let [mut x, mut y, mut z] = [0, 1, 2].map(component);
    Normals::normalized(&mut x, &mut y, &mut z).expect("visible");
    let scaled = x.iter().zip(&y).zip(&z).map(|((&x, &y), &z)| [x, y, z].map(f64::from));
    let scaled = OwnedNormals::new(&scaled.collect::<Vec<_>>());
    let (as_they_are, in_q15) = (OwnedNormals::new(&decoded), in_integers(&decoded));
    let owned = OwnedBasis::new(&table()).expect("a table for f32");
    let mut f32 = Shader::new(owned.basis().expect("a basis"), usize::MAX);
    let mut q15 = IntegerShader::new(&table(), usize::MAX).expect("a table for Q15");
    let mut errors = [const { Vec::new() }; 3];
    let mut pixel = 0.0;
    for light in captured(9).entries.iter().step_by(3).map(Named::luminance) {
        for material in materials(5) {
            let expected = reference(&light, &material, &normals);
            let peak = largest(expected.iter().copied());
            let (light, material) = (light.as_slice(), material.as_slice());
            let [naive, ours] = [&as_they_are, &scaled]
                .map(|normals| floats(f32.polynomial(light, material, normals).expect("it fits")));
            let of_q15 = q15.polynomial(light, material, &in_q15).expect("it fits");
            pixel = largest([pixel, largest_difference(&ours, &expected) / peak]);
            for (errors, found) in errors.iter_mut().zip([naive, ours, of_q15]) {
                let squares = found.iter().zip(&expected).map(|(a, b)| (a - b).powi(2));
                errors.push((squares.sum::<f64>() / normals.len() as f64).sqrt() / peak);
            }
        }
    }
    let worst = |errors: &[f64]| largest(errors.iter().copied());
    let [of_median, of_worst, of_pixel] = tolerances::EIGHT_BITS;
    let [naive, ours, q15] = errors;
    vec![
        least("not scaled: rms of the peak, worst", worst(&naive), 2.5e-3),
        most("scaled: rms of the peak, median", median(&ours), of_median),
        most("scaled: rms of the peak, worst", worst(&ours), of_worst),
        most("scaled: worst pixel, of the peak", pixel, of_pixel),
        most("scaled, Q15: rms of the peak, median", median(&q15), of_median),
        most("scaled, Q15: rms of the peak, worst", worst(&q15), of_worst),
    ]
}

/// Normals with z = -0.01 and -0.1, by the longer polynomials of a table of degree 12.
pub(super) fn behind() -> Vec<Figure> {
    let owned =
        OwnedBasis::new(&decode(shipped::PBR).expect("the table")).expect("a table for f32");
    let mut shader = Shader::new(owned.basis().expect("a basis"), usize::MAX);
    let light = captured(9).entries[5].luminance();
    let (mut naive, mut ours, mut of_integers) = ([0.0f64; 2], 0.0, 0);
    for material in materials(7) {
        shader.project(&light, &material).expect("coefficients");
        let scene = shader.scene().expect("room");
        let seen = |normal: [f64; 3]| {
            let [x, y, z] = normal.map(|c| [c as f32]);
            let normals = Normals::from_unit(&x, &y, &z).expect("one length");
            let as_it_is = normals.iter().next().expect("one normal");
            let moved = Normal::new(x[0], y[0], z[0]).expect("moved to the rim");
            [as_it_is, moved].map(|normal| f64::from(scene.shade(normal)))
        };
        for turn in 0..16 {
            let (sine, cosine) = (PI * f64::from(turn) / 8.0).sin_cos();
            let at_rim = [cosine, sine, 0.0];
            let [rim, _] = seen(at_rim);
            for (z, naive) in [-0.01, -0.1].into_iter().zip(&mut naive) {
                let root = (1.0f64 - z * z).sqrt();
                let normal = [cosine * root, sine * root, z];
                let [as_it_is, moved] = seen(normal);
                *naive = naive.max((as_it_is / rim).abs());
                ours = largest([ours, moved / rim - 1.0]);
                let [a, b] = [at_rim, normal].map(|one| in_integers(&[one])[0].components());
                of_integers = (0..3).map(|k| a[k].0.abs_diff(b[k].0)).fold(of_integers, u16::max);
            }
        }
    }
    vec![
        least("z = -0.01 as it is, relative to the rim", naive[0], 1.01),
        least("z = -0.1 as it is, relative to the rim", naive[1], 1.5),
        // An image's slope times an f32 rounding.
        most("moved to the rim, relative error", ours, 5e-6),
        most("in Q15, units of a component", of_integers.into(), 1.0),
    ]
}

/// The images of a light on materials by each method, in the order of the page. For each material
/// also the reference and the bound of the scene within 1e-2 of the peak.
fn every_method(
    light: &[f64],
    normals: &[[f64; 3]],
) -> impl Iterator<Item = ([Vec<f64>; 5], Vec<f64>, f64)> {
    let owned = OwnedBasis::new(&table()).expect("a table for f32");
    let mut q15 = IntegerShader::new(&table(), usize::MAX).expect("a table for Q15");
    let rounded = OwnedNormals::new(normals);
    let (each, in_q15) = (rounded.each().expect("visible normals"), in_integers(normals));
    materials(3).into_iter().map(move |material| {
        let expected = reference(light, &material, normals);
        let mut f32 = Shader::new(owned.basis().expect("a basis"), usize::MAX);
        let material = material.as_slice();
        let all = f32.polynomial(light, material, &rounded).expect("it fits");
        let baked = f32.baked(light, material, &each, 64).expect("a map");
        let map = f32.scene().expect("room").bake_integers_into(64, vec![0; 64 * 64]);
        let map = map.expect("numbers that fit");
        let pixel = |&normal| f64::from(map.bilinear(q15::MapPoint::of(normal)));
        let of_map = in_q15.iter().map(|normal| pixel(normal) * 2f64.powi(map.exponent()));
        let within = f32.within(&[(light, material)], &rounded, Tolerance::OfPeak(1e-2));
        let (within, truncation) = within.expect("a tolerance").remove(0);
        let of_q15 = q15.polynomial(light, material, &in_q15).expect("it fits");
        let images = [floats(all), of_q15, floats(within), floats(baked), of_map.collect()];
        (images, expected, truncation.bound.into())
    })
}

/// A texel of a map of 64 x 32 with radiance 1e6, in a sky of radiance 1, on shipped materials.
pub(super) fn sun() -> Vec<Figure> {
    let (normals, weights): (Vec<_>, Vec<_>) = vectors().into_iter().unzip();
    let mut worst = [0.0; 5];
    for direction in [[0.6, 0.0, 0.8], [-0.48, 0.6, 0.64], [0.0, 0.96, -0.28]] {
        let mut light = harmonics(9, direction);
        light.iter_mut().for_each(|value| *value *= 1e6 * 9.6e-3);
        light[0] += (4.0 * PI).sqrt();
        for (images, expected, bound) in every_method(&light, &normals) {
            let peak = largest(expected.iter().copied());
            let scales = [peak, peak, bound, peak, peak];
            for ((worst, found), scale) in worst.iter_mut().zip(images).zip(scales) {
                let squares = found.iter().zip(&expected).map(|(a, b)| (a - b).powi(2));
                let mean: f64 = squares.zip(&weights).map(|(square, weight)| square * weight).sum();
                *worst = largest([*worst, mean.sqrt() / scale]);
            }
        }
    }
    let [of_f32, of_q15, of_bound, of_baked, of_map] = worst;
    vec![
        // As for any light.
        most("f32, rms of the peak", of_f32, 1e-6),
        // The worst pair has 68 dB.
        most("Q15, rms of the peak", of_q15, 4e-4),
        // Images are some thousand times the error, so that rounding may exceed the bound.
        most("within 1e-2: rms, of the reported bound", of_bound, 1.0001),
        // Twice the worst error of the shipped lights.
        most("baked, 64 x 64, rms of the peak", of_baked, 1e-3),
        most("baked in integers, rms of the peak", of_map, 1e-3),
    ]
}

/// Lobes below zero of a light from one direction, to degree 9.
pub(super) fn delta() -> Vec<Figure> {
    let normals = disc(64);
    let light = harmonics(9, [0.6, 0.0, 0.8]);
    let (mut deepest, mut apart, mut left) = (0.0f64, [0.0; 5], 0);
    for (images, expected, _) in every_method(&light, &normals) {
        let peak = largest(expected.iter().copied());
        let below = expected.iter().copied().fold(f64::INFINITY, f64::min);
        deepest = deepest.max(-below / peak);
        for (apart, mut found) in apart.iter_mut().zip(images) {
            let mantissa = |value: &f64| (value / peak * f64::from(i16::MAX)) as i32;
            let mut mantissas: Vec<i32> = found.iter().map(mantissa).collect();
            let lowest = NegativePolicy::Clamped.apply(&mut found).expect("pixels");
            *apart = largest([*apart, (lowest - below) / peak]);
            left += found.iter().filter(|&&value| value < 0.0).count();
            let lowest = NegativePolicy::Clamped.apply(&mut mantissas).expect("pixels");
            assert_eq!(lowest < 0, mantissas.contains(&0), "a value below zero became zero");
            left += mantissas.iter().filter(|&&value| value < 0).count();
        }
    }
    let mut figures = vec![least("least value, below zero, of the peak", deepest, 5e-2)];
    let methods = ["f32", "Q15", "a scene within 1e-2", "a map of 64 x 64", "a map of integers"];
    for ((method, apart), bound) in methods.into_iter().zip(apart).zip(tolerances::DELTA) {
        figures.push(most(format!("its error by {method}, of the peak"), apart, bound));
    }
    figures.push(exactly("values below zero that clamping left", left, 0));
    figures
}
