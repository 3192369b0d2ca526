//! The runtime's expected results in every format, for the golden file.
//!
//! Integer rows are the runtime's own results: machines compare bits. Float rows are results in
//! f64, rounded: machines compare to a tolerance.

pub mod record;

use self::record::{Golden, Row};
use crate::fixtures::{Projector, captured, measured};
use crate::images::single;
use eigenshade::q15::{Basis, Light, Material, Normal, Transfer};
use eigenshade::{Error, Q15, sphere};
use eigenshade_model::shipped;

/// d and irradiances in f32 against those in f64, relative to the largest number of their array:
/// about forty significant roundings of 6e-8, in any order, fused or not.
pub const GOLDEN_F32: f32 = 2e-6;

/// Light, material and channel of each test pair, with the channel's index.
pub const PAIRS: [([&str; 3], usize); 6] = [
    (["esplanade", "ptfe-633nm", "r"], 0),
    (["park", "07-velvet", "g"], 1),
    (["blender-courtyard", "15-aluminum-foil", "b"], 2),
    (["studio", "34-slate-b", "r"], 0),
    (["sky", "13-artificial-grass", "g"], 1),
    (["night", "05-leather", "b"], 2),
];

const DEGREE: usize = sphere::DEGREE;
const ORDER: usize = sphere::ORDER;

/// Normals at the pole, on the rim, at corners of the cube, next to the pole and the rim, and some
/// in between.
fn normals() -> Vec<[f64; 3]> {
    let (half, third) = (0.5f64.sqrt(), (1.0f64 / 3.0).sqrt());
    let mut normals = vec![[0.0, 0.0, 1.0]];
    for (x, y) in [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)] {
        normals.push([x, y, 0.0]);
        normals.push([half * (x - y), half * (x + y), 0.0]);
        normals.push([third * (x - y), third * (x + y), third]);
    }
    for z in [0.999_999_5f64, 1e-3, 0.15, 0.35, 0.55, 0.75, 0.9] {
        let (sine, tilt) = ((1.0 - z * z).sqrt(), 2.399_963 * (1.0 + 10.0 * z));
        normals.push([sine * tilt.cos(), sine * tilt.sin(), z]);
    }
    normals
}

/// The mantissas of all normals. The last normal has the format's smallest mantissa.
fn mantissas_of_normals() -> Vec<Q15> {
    let rounded =
        |component: f64| Q15((32_768.0 * component).round().clamp(-32_767.0, 32_767.0) as i16);
    let mut numbers: Vec<Q15> = normals().into_iter().flatten().map(rounded).collect();
    numbers.extend([i16::MIN, 0, 0].map(Q15));
    numbers
}

/// The coefficients of a pair's light and material.
fn input([light, material, _]: [&str; 3], channel: usize) -> [Vec<f32>; 2] {
    let lights = captured(DEGREE).entries;
    [(lights, light), (measured(ORDER).entries, material)].map(|(entries, name)| {
        let entry = entries.into_iter().find(|entry| entry.name == name).expect("a shipped name");
        single(entry.rgb[channel].clone())
    })
}

/// d with its exponent, and the irradiances with their exponent.
pub type Answer = [(Vec<i32>, i32); 2];

/// Computes irradiances from mantissas with the methods of a basis.
///
/// # Errors
///
/// As the runtime's functions.
pub fn answer(
    basis: &Basis<'_>,
    light: &Light<'_>,
    material: &Material<'_>,
    normals: &[Normal],
) -> Result<Answer, Error> {
    let mut workspace = vec![0; basis.workspace_len()];
    let mut numbers = vec![Q15(0); basis.transfer_len()];
    let mut exponents = vec![0; basis.profiles()];
    basis.transfer_into(material, &mut workspace, &mut numbers, &mut exponents)?;
    let mut d = vec![0; basis.components()];
    let exponent = basis.relight_into(&Transfer::new(&numbers, &exponents), light, &mut d)?;
    let scene = basis.collapse_into(&d, exponent, vec![0; basis.scene_len()])?;
    let irradiances = normals.iter().map(|&normal| scene.shade(normal)).collect();
    Ok([(d, exponent), (irradiances, scene.exponent())])
}

/// The CRC-32 of all results of a format: for each pair d, its exponent, the irradiances and their
/// exponent, as little-endian 32-bit integers.
pub fn checksum<'a>(answers: impl IntoIterator<Item = &'a Answer>) -> u32 {
    let mut hasher = crc32fast::Hasher::new();
    for (numbers, exponent) in answers.into_iter().flatten() {
        for number in numbers.iter().chain([exponent]) {
            hasher.update(&number.to_le_bytes());
        }
    }
    hasher.finalize()
}

/// Adds the rows of the integers.
fn integer_rows(rows: &mut Vec<Row>) {
    let integers = |numbers: &[Q15]| numbers.iter().map(|number| number.get().into()).collect();
    let numbers = mantissas_of_normals();
    let mantissas: Vec<i64> = integers(&numbers);
    rows.push(Row::new("q15", [""; 3], "normals", &[-15], &mantissas));
    let normals: Vec<Normal> = numbers
        .as_chunks::<3>()
        .0
        .iter()
        .map(|&[x, y, z]| Normal::from_unit(x, y, z).expect("a visible normal"))
        .collect();
    let mut answers = Vec::new();
    for (pair, channel) in PAIRS {
        let [light, material] = input(pair, channel);
        let mut of_light = vec![Q15(0); light.len()];
        let light = Light::quantize(&light, &mut of_light).expect("a light");
        let mut of_material = vec![Q15(0); material.len()];
        let mut exponents = [0; ORDER + 1];
        let material = Material::quantize(&material, &mut of_material, &mut exponents);
        let material = material.expect("a material");
        let answer =
            answer(&sphere::q15::BASIS, &light, &material, &normals).expect("they fit the basis");
        let exponent_of_light = light.exponent();
        let mut row = |array: &str, exponents: &[i32], numbers: &[i64]| {
            rows.push(Row::new("q15", pair, array, exponents, numbers));
        };
        row("light", &[exponent_of_light], &integers(&of_light));
        row("material", &exponents.map(i32::from), &integers(&of_material));
        for (array, (numbers, exponent)) in ["d", "irradiance"].into_iter().zip(&answer) {
            let numbers: Vec<i64> = numbers.iter().map(|&number| number.into()).collect();
            row(array, &[*exponent], &numbers);
        }
        answers.push(answer);
    }
    rows.push(Row::new("q15", [""; 3], "crc32", &[], &[checksum(&answers)]));
}

fn float_rows(rows: &mut Vec<Row>) {
    let wide = |numbers: &[f32]| numbers.iter().map(|&value| value.into()).collect::<Vec<f64>>();
    let table = eigenshade_table::decode(shipped::TABLE).expect("the shipped table");
    let projector = Projector::new(&table);
    let normals = single(normals().into_flattened());
    rows.push(Row::new("f32", [""; 3], "normals", &[], &normals));
    let components = wide(&normals);
    let (normals, _) = components.as_chunks::<3>();
    for (pair, channel) in PAIRS {
        let [light, material] = input(pair, channel);
        let d = projector.project(&wide(&light), &wide(&material));
        let irradiances = single(projector.shade(&d, normals));
        for (array, numbers) in [
            ("light", light),
            ("material", material),
            ("d", single(d)),
            ("irradiance", irradiances),
        ] {
            rows.push(Row::new("f32", pair, array, &[], &numbers));
        }
    }
    rows.push(Row::new("f32", [""; 3], "tolerance", &[], &[GOLDEN_F32]));
}

/// All rows of the golden file.
pub fn golden() -> Golden {
    let mut rows = Vec::new();
    float_rows(&mut rows);
    integer_rows(&mut rows);
    Golden { rows }
}
