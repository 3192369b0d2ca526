//! Wire files of each format and kind, and what they gave when they were made: they are read,
//! wherever they lie, and give the same.
#![allow(dead_code, reason = "each test takes what it needs")]

use eigenshade::wire::{Aligned, Fault, aligned};
use eigenshade::{Basis, Light, Material, Normal, Q15, q15};

pub const SPHERE: &Aligned<[u8]> = &Aligned(*include_bytes!("v4.sphere.f32.esw"));
pub const INTEGERS_15: &Aligned<[u8]> = &Aligned(*include_bytes!("v4.sphere.q15.esw"));
/// Of polynomials with more than 16 terms.
pub const LONG: &Aligned<[u8]> = &Aligned(*include_bytes!("v4.long.f32.esw"));
pub const ALL: [&[u8]; 3] = [&SPHERE.0, &INTEGERS_15.0, &LONG.0];

/// What `read` gives for these bytes at a multiple of four.
pub fn placed<T>(bytes: &[u8], read: impl FnOnce(&[u8]) -> T) -> T {
    read(aligned(bytes, &mut vec![0; bytes.len().div_ceil(4)]).expect("room"))
}

/// The last column of a CSV, of the rows that begin with `name`.
fn column(text: &str, name: &str) -> Vec<f32> {
    let rows = text.lines().filter(|line| line.starts_with(name));
    rows.map(|row| row.rsplit(',').next().expect("a field").parse().expect("a number")).collect()
}

/// The test's light, with nine coefficients, and its material, with five.
fn inputs() -> [Vec<f32>; 2] {
    [include_str!("light.csv"), include_str!("material.csv")].map(|text| column(text, "one,"))
}

/// Against d as it was when the files were made, of the largest.
fn assert_same(table: &str, found: &[f32], tolerance: f32) {
    let expected = column(include_str!("v4.csv"), &format!("{table},"));
    assert_eq!(found.len(), expected.len());
    let largest = expected.iter().fold(0.0f32, |most, d| most.max(d.abs()));
    for (found, expected) in found.iter().zip(&expected) {
        assert!((found - expected).abs() <= tolerance * largest, "{table}: {found}, {expected}");
    }
}

/// d of the test's light on its material, by projection and by a transfer, and some pixel.
fn floats(basis: &Basis<'_>) -> ([Vec<f32>; 2], f32) {
    let [light, material] = inputs();
    let light = Light::new(&light).expect("a light").truncated(basis.degree());
    let material = Material::new(&material).expect("a material").truncated(basis.order());
    let mut workspace = vec![0.0; basis.workspace_len()];
    let mut transfer = vec![0.0; basis.transfer_len()];
    let [mut projected, mut relit] = [(); 2].map(|()| vec![0.0; basis.components()]);
    basis.project_into(&light, &material, &mut workspace, &mut projected).expect("sizes");
    basis.transfer_into(&material, &mut workspace, &mut transfer).expect("sizes");
    basis.relight_into(&transfer, &light, &mut relit).expect("sizes");
    let scene = basis.collapse_into(&relit, vec![0.0; basis.scene_len()]).expect("sizes");
    let irradiance = scene.shade(Normal::new(0.6, 0.0, 0.8).expect("a normal"));
    ([projected, relit], irradiance)
}

/// The same in integers.
fn integers(basis: &q15::Basis<'_>) -> Vec<f32> {
    let [light, material] = inputs();
    let mut mantissas = vec![Q15(0); light.len()];
    let light = q15::Light::quantize(&light, &mut mantissas).expect("sizes");
    let (mut mantissas, mut exponents) = (vec![Q15(0); material.len()], [0; 3]);
    let material = q15::Material::quantize(&material, &mut mantissas, &mut exponents);
    let material = material.expect("sizes");
    let mut workspace = vec![0; basis.workspace_len()];
    let mut numbers = vec![Q15(0); basis.transfer_len()];
    let mut exponents = vec![0; basis.profiles()];
    let mut d = vec![0; basis.components()];
    basis.transfer_into(&material, &mut workspace, &mut numbers, &mut exponents).expect("sizes");
    let transfer = q15::Transfer::new(&numbers, &exponents);
    let exponent = basis.relight_into(&transfer, &light, &mut d).expect("sizes");
    // Exactly 2^exponent.
    let unit = f32::from_bits(((127 + exponent) << 23).cast_unsigned());
    d.into_iter().map(|d| d as f32 * unit).collect()
}

/// d from a wire file in f32, of the largest: 2^-24 times some twenty roundings.
const WIRE_F32: f32 = 1e-6;

/// d from a wire file in 15 bits, of the largest: a few roundings of 2^-15.
const WIRE_Q15: f32 = 2e-4;

#[test]
fn tables_are_read() {
    let basis = Basis::from_bytes(&SPHERE.0).expect("a wire file");
    floats(&basis).0.iter().for_each(|d| assert_same("sphere", d, WIRE_F32));
    let basis = q15::Basis::from_bytes(&INTEGERS_15.0).expect("a wire file");
    assert_same("sphere", &integers(&basis), WIRE_Q15);
}

/// The last number is an irradiance.
#[test]
fn long_polynomials_are_read() {
    let basis = Basis::from_bytes(&LONG.0).expect("a wire file");
    assert!(basis.parts().lengths.iter().any(|length| *length > 16));
    let ([_, mut found], irradiance) = floats(&basis);
    found.push(irradiance);
    assert_same("long", &found, WIRE_F32);
}

/// At every place but multiples of four, and put right.
#[test]
fn alignment_is_asked_for() {
    let mut places = vec![0_u32; SPHERE.0.len() / 4 + 1];
    for beyond in 1..4 {
        let bytes: Vec<u8> = [&vec![0; beyond], &SPHERE.0, &vec![0; 4 - beyond]].concat();
        let bytes = aligned(&bytes, &mut places).expect("room");
        let refused = Basis::from_bytes(&bytes[beyond..]).expect_err("not aligned");
        assert_eq!(refused, Fault::Alignment { beyond }.into());
        assert!(refused.to_string().contains("wire::aligned"));
        let file = &bytes[beyond..][..SPHERE.0.len()];
        assert!(placed(file, |bytes| Basis::from_bytes(bytes).is_ok()));
    }
}
