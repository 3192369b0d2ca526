//! Coefficients that are tiny or huge.

use super::images::coefficients;
use super::{Figure, exactly, tight};
use crate::tolerances;
use eigenshade::{Normal, Scalar, sphere};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_table::Table;
use eigenshade_testing::oracle::Numbers;
use eigenshade_testing::{fixtures, largest, relative_error};

/// 2^100 = 1.3e30.
const FAR: i32 = 100;

pub(super) fn double() -> Vec<Figure> {
    let found = Found::new::<f64>();
    vec![
        exactly("coefficients that differ in a bit", found.coefficients, 0),
        exactly("pixels that differ in a bit", found.pixels, 0),
        exactly("answers that are not finite", found.infinite, 0),
    ]
}

pub(super) fn single() -> Vec<Figure> {
    let found = Found::new::<f32>();
    vec![
        exactly("pixels that differ in a bit", found.pixels, 0),
        exactly("first 50 coefficients that differ in a bit", found.shipped, 0),
        tight("all coefficients, of the largest", found.apart, tolerances::SCALED_F32),
        exactly("answers that are not finite", found.infinite, 0),
        exactly("answers of 1e-60 that are not 0", found.not_zero, 0),
    ]
}

/// Compares the results for scaled inputs with the scaled results, bit for bit.
#[derive(Default)]
struct Found {
    coefficients: usize,
    /// For the coefficients of as many components as the shipped table has.
    shipped: usize,
    pixels: usize,
    /// The largest difference of two coefficients, relative to the largest coefficient.
    apart: f64,
    infinite: usize,
    not_zero: usize,
}

impl Found {
    fn new<S: Scalar + Into<f64>>() -> Self {
        let table = fixtures::table(&fixtures::shipped());
        let mut numbers = Numbers(41);
        let light = fixtures::lights(9, 1, &mut numbers).entries[0].luminance();
        let material = fixtures::materials(7, 1, &mut numbers).entries[0].luminance();
        let scaled = |values: &[f64], power: i32| -> Vec<f64> {
            values.iter().map(|value| value * 2f64.powi(power)).collect()
        };
        let plain = answers::<S>(&table, &light, &material);
        let mut all = Self::default();
        for (of_light, of_material) in
            [(FAR, 0), (-FAR, 0), (0, FAR), (0, -FAR), (FAR, -FAR), (-FAR, FAR), (-FAR, -FAR)]
        {
            let inputs = (scaled(&light, of_light), scaled(&material, of_material));
            let found = answers::<S>(&table, &inputs.0, &inputs.1);
            let count = |is: fn(&f64) -> bool| {
                found.iter().flatten().flatten().filter(|value| is(value)).count()
            };
            all.infinite += count(|value| !value.is_finite());
            // 1e-60 is zero in f32.
            if S::from_f64(2f64.powi(of_light + of_material)).into() == 0.0 {
                all.not_zero += count(|value| *value != 0.0);
                continue;
            }
            for ([d, pixels], [plain_d, plain_pixels]) in found.iter().zip(&plain) {
                let [d, pixels] = [d, pixels].map(|one| scaled(one, -of_light - of_material));
                all.coefficients += different(&d, plain_d);
                all.shipped += different(&d[..sphere::COMPONENTS], plain_d);
                all.pixels += different(&pixels, plain_pixels);
                all.apart = largest([all.apart, relative_error(&d, plain_d)]);
            }
        }
        all
    }
}

/// The number of values that differ in a bit.
fn different(a: &[f64], b: &[f64]) -> usize {
    a.iter().zip(b).filter(|(a, b)| a.to_bits() != b.to_bits()).count()
}

/// Coefficients by projection, then by transfer and new light, each with its pixels by collapsed
/// polynomials and component by component.
fn answers<S: Scalar + Into<f64>>(
    table: &Table,
    light: &[f64],
    material: &[f64],
) -> [[Vec<f64>; 2]; 2] {
    let owned = OwnedBasis::<S>::new(table);
    let basis = owned.basis().expect("a basis");
    coefficients(&basis, light, material).map(|d| {
        let scene = basis.collapse_into(&d, vec![S::ZERO; basis.scene_len()]).expect("sizes");
        let pixels = fixtures::normals(&fixtures::SLANTS, 5).into_iter().flat_map(|normal| {
            let [x, y, z] = normal.map(S::from_f64);
            let normal = Normal::new(x, y, z).expect("visible");
            let summed = basis.reconstruct(&d, normal).expect("all components");
            [scene.shade(normal), summed].map(Into::into)
        });
        let pixels = pixels.collect();
        [d.into_iter().map(Into::into).collect(), pixels]
    })
}
