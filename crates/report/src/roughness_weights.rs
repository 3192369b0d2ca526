//! The weights with which the images of five roughnesses are blended: see
//! `eigenshade_shading::textured`.

use eigenshade_model::database::Named;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::rotation::Rotation;
use eigenshade_model::shipped;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader, fault};
use eigenshade_shading::textured::{KNOTS, Weights, parts};
use eigenshade_table::{Table, light};
use faer::Mat;
use faer::linalg::solvers::Solve;

pub const COLUMNS: &str = "roughness,w1,w2,w3,w4,w5";

/// Roughnesses of the table, from 0.2 to 1.
pub const ROWS: usize = 33;

/// Normals of a picture.
const NORMALS: usize = 400;

/// Rotations of each light.
const ROTATIONS: usize = 6;

/// A metal's share of `metal`, and a dielectric's. Both have the whole of `rim`, and the second one
/// half a matte base.
const MATERIALS: [(f32, f32); 2] = [(0.9, 0.0), (0.04, 0.5 * 0.96)];

/// The roughness of a row.
pub fn roughness(row: usize) -> f32 {
    0.2 + 0.8 * row as f32 / (ROWS - 1) as f32
}

/// The pictures of a material under one light: without the matte part at each roughness, and the
/// mean peak with it.
pub struct Pictures {
    rows: Vec<Vec<f32>>,
    peaks: Vec<f32>,
}

/// The pictures of both materials under the shipped lights with an odd or an even number, rotated,
/// by all components of a table.
pub fn pictures(table: &Table, is_odd: bool) -> Result<Vec<Pictures>> {
    let owned = OwnedBasis::new(table)?;
    let mut shader = Shader::new(owned.basis().map_err(fault)?, table.count());
    let order = table.gram.order;
    let normals = OwnedNormals::new(&spiral());
    let parts = (0..ROWS).map(|row| parts(order, roughness(row))).collect::<Result<Vec<_>>>()?;
    let mut pictures = Vec::new();
    let lights = shipped::lights()?.truncated(table.gram.degree);
    let chosen =
        lights.entries.iter().enumerate().filter(|(number, _)| (number % 2 == 1) == is_odd);
    for (number, Named { rgb: [_, green, _], .. }) in chosen {
        for turn in 0..ROTATIONS {
            let light = turned(lights.degree, green, number * ROTATIONS + turn);
            let matte = shader.polynomial(&light, &parts[0][0], &normals)?;
            let mut images = Vec::with_capacity(ROWS);
            for [_, rim, metal] in &parts {
                let rim = shader.polynomial(&light, rim, &normals)?;
                images.push((rim, shader.polynomial(&light, metal, &normals)?));
            }
            for (of_metal, of_matte) in MATERIALS {
                let mix = |(rim, metal): &(Vec<f32>, Vec<f32>)| -> Vec<f32> {
                    rim.iter().zip(metal).map(|(rim, metal)| rim + of_metal * metal).collect()
                };
                let rows: Vec<Vec<f32>> = images.iter().map(mix).collect();
                let peak = |row: &Vec<f32>| {
                    let whole =
                        row.iter().zip(&matte).map(|(gloss, matte)| gloss + of_matte * matte);
                    whole.fold(0.0, |most: f32, value| most.max(value.abs()))
                };
                let peaks = rows.iter().map(peak).collect();
                pictures.push(Pictures { rows, peaks });
            }
        }
    }
    Ok(pictures)
}

fn spiral() -> Vec<[f64; 3]> {
    let normal = |k: usize| {
        let square = (k as f64 + 0.5) / NORMALS as f64;
        let (sine, cosine) = (k as f64 * std::f64::consts::PI * (3.0 - 5_f64.sqrt())).sin_cos();
        [square.sqrt() * cosine, square.sqrt() * sine, (1.0 - square).sqrt()]
    };
    (0..NORMALS).map(normal).collect()
}

/// The light after rotation number `k` of a sequence that covers all rotations, in a unit in which
/// its mean is 1.
fn turned(degree: usize, coefficients: &[f64], k: usize) -> Vec<f64> {
    let part = |step: f64| (0.5 + step * k as f64).fract();
    let rotation = Rotation {
        alpha: (1.0 - 2.0 * part(0.671_043_6)).acos(),
        beta: std::f64::consts::TAU * part(0.819_172_5),
        gamma: std::f64::consts::TAU * part(0.549_700_5),
    };
    let mean = coefficients[0];
    let mut turned = rotation.turn(degree, coefficients);
    turned.truncate(light::count(degree));
    turned.iter_mut().for_each(|coefficient| *coefficient /= mean);
    turned
}

/// The weights that leave the least squares over pictures.
pub fn fitted(pictures: &[Pictures]) -> Vec<[f64; 5]> {
    // The sums of the products of the pictures of two roughnesses.
    let mut products = Mat::<f64>::zeros(ROWS, ROWS);
    for Pictures { rows, peaks } in pictures {
        let scale = f64::from(peaks.iter().sum::<f32>() / ROWS as f32).powi(-2);
        for (i, one) in rows.iter().enumerate() {
            for (j, other) in rows.iter().enumerate().take(i + 1) {
                let sum: f64 =
                    one.iter().zip(other).map(|(a, b)| f64::from(*a) * f64::from(*b)).sum();
                products[(i, j)] += scale * sum;
                if i != j {
                    products[(j, i)] += scale * sum;
                }
            }
        }
    }
    let rows = KNOTS.map(|knot| ((knot - 0.2) / 0.8 * (ROWS - 1) as f32).round() as usize);
    let matrix = Mat::from_fn(5, 5, |i, j| products[(rows[i], rows[j])]);
    let right = Mat::from_fn(5, ROWS, |i, row| products[(rows[i], row)]);
    let solved = matrix.partial_piv_lu().solve(&right);
    (0..ROWS).map(|row| [0, 1, 2, 3, 4].map(|k| solved[(k, row)])).collect()
}

/// The rms error of each blended picture over its own peak, at one roughness.
pub fn errors(pictures: &[Pictures], weights: &Weights, row: usize) -> Vec<f64> {
    let knots = KNOTS.map(|knot| ((knot - 0.2) / 0.8 * (ROWS - 1) as f32).round() as usize);
    let weights = weights.at(roughness(row));
    let error = |Pictures { rows, peaks }: &Pictures| {
        let square: f32 = (0..NORMALS)
            .map(|n| {
                let sum: f32 = knots.iter().zip(weights).map(|(k, w)| w * rows[*k][n]).sum();
                (sum - rows[row][n]).powi(2)
            })
            .sum();
        f64::from((square / NORMALS as f32).sqrt() / peaks[row])
    };
    pictures.iter().map(error).collect()
}

/// The rows of the CSV.
pub fn rows() -> Result<Vec<Vec<String>>> {
    let table = eigenshade_table::decode(shipped::PBR)
        .map_err(|error| Error::new(error.to_string(), "make tables/pbr.bin again"))?;
    let weights = fitted(&pictures(&table, false)?);
    let row = |(row, weights): (usize, &[f64; 5])| {
        // Without -0.
        let digits = |weight: &f64| format!("{:.6}", weight + 0.0).replace("-0.000000", "0.000000");
        let first = format!("{:.3}", roughness(row));
        std::iter::once(first).chain(weights.iter().map(digits)).collect()
    };
    Ok(weights.iter().enumerate().map(row).collect())
}
