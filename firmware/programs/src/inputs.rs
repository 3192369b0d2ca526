//! Inputs of the measured operations. What they are does not change the counts: no
//! operation branches on its numbers.

use core::hint::black_box;
use eigenshade::{Light, Material, Normal};

/// 16 visible normals.
#[must_use]
pub fn normals() -> [Normal<f32>; 16] {
    let step = black_box(0.4);
    let along = |k: usize| {
        let (x, y) = ((k % 4) as f32 * step - 0.6, (k / 4) as f32 * step - 0.6);
        Normal::new(x, y, 0.7).ok()
    };
    let facing = Normal::new(0.0, 0.0, 1.0).ok();
    // Each is a normal: none is as short as zero or points away.
    core::array::from_fn(|k| along(k).or(facing)).map(|normal| match normal {
        Some(normal) => normal,
        None => board::exit(false),
    })
}

/// Numbers of both signs between -1 and 1, always the same.
#[must_use]
pub fn numbers<const N: usize>() -> [f32; N] {
    // Not to be computed by the compiler: the program would hold all of them.
    let mut state = black_box(1_u32);
    core::array::from_fn(|_| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f32::from((state >> 16) as u16 as i16) / 32768.0
    })
}

/// A light of these coefficients.
#[must_use]
pub fn light(coefficients: &[f32]) -> Light<'_, f32> {
    Light::new(coefficients).unwrap_or_else(|_| board::exit(false))
}

/// A material of these coefficients.
#[must_use]
pub fn material(coefficients: &[f32]) -> Material<'_, f32> {
    Material::new(coefficients).unwrap_or_else(|_| board::exit(false))
}
