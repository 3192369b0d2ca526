//! What holds of any input, read from any bytes: property tests and fuzz targets share it.
//!
//! Each function panics if it does not hold.
#![allow(
    dead_code,
    unused_imports,
    reason = "each test and each target takes the parts that it needs"
)]

pub mod integer;
mod shading;
mod tables;
mod ways;

pub use shading::{
    collapse_sets, shade_coefficients, shade_floats, shade_integers, shade_transfer,
};
pub use tables::from_bytes;
pub use ways::{every_way, reconstruct};

use eigenshade::{Q15, Q31};

/// d in 15 bits, relative to what its addends could be: light, material, Ĉ, S, factors and T are
/// each rounded to 15 bits of the largest number of their row.
pub const ANY_D_Q15: f64 = 2e-5;

/// See [`ANY_D_Q15`], with 16 bits more.
pub const ANY_D_Q31: f64 = 3e-10;

/// d has 30 bits of its largest component, and rounds twice.
pub const ANY_D_COMMON: f64 = 2e-9;

/// A bound against its parts, and what components are said to leave out against the sum of their
/// squares, of the bound: roundings of f32 of sums of some hundred squares.
pub const TRUNCATED_PARTS: f64 = 2e-6;

/// RRᵀ of any rotation in f32: sixteen roundings, and those of the sum itself.
pub const ORTHONORMAL_F32: f64 = 1.2e-6;

/// Any light on any material under any normals, or any transfer, or any coefficients,
/// in any format; or any images within a tolerance.
pub fn shade_any(bytes: &[u8]) {
    let mut input = Reader::new(bytes);
    match input.byte() % 8 {
        0 => shade_floats(&mut input),
        1 => shade_integers::<Q15>(&mut input),
        2 => shade_integers::<Q31>(&mut input),
        3 => shade_transfer::<Q15>(&mut input),
        4 => shade_transfer::<Q31>(&mut input),
        5 => shade_coefficients::<Q15>(&mut input),
        6 => shade_coefficients::<Q31>(&mut input),
        _ => collapse_sets(&mut input),
    }
}

/// Any numbers into look-ups, baking, rotation, windows, truncation and estimates.
pub fn public_interface(bytes: &[u8]) {
    every_way(&mut Reader::new(bytes));
}

/// Any light and material of moderate size: every format's d and image against f64.
pub fn project_reconstruct(bytes: &[u8]) {
    reconstruct(&mut Reader::new(bytes));
}

/// Bytes that are read one after the other.
pub struct Reader<'a> {
    rest: &'a [u8],
}

impl<'a> Reader<'a> {
    pub fn new(bytes: &'a [u8]) -> Self {
        Self { rest: bytes }
    }

    /// Whether anything is left.
    pub fn is_empty(&self) -> bool {
        self.rest.is_empty()
    }

    pub fn bytes<const N: usize>(&mut self) -> [u8; N] {
        let (now, rest) = self.rest.split_at(N.min(self.rest.len()));
        self.rest = rest;
        let mut bytes = [0; N];
        bytes[..now.len()].copy_from_slice(now);
        bytes
    }

    pub fn byte(&mut self) -> u8 {
        let [byte] = self.bytes();
        byte
    }

    pub fn i32(&mut self) -> i32 {
        i32::from_le_bytes(self.bytes())
    }

    /// A number of at most this, or this.
    pub fn up_to(&mut self, most: usize) -> usize {
        usize::from(self.byte()) % (most + 1)
    }

    /// A number of moderate size: 15 bits, times a power of two from 2^-40 to 2^7.
    pub fn moderate(&mut self) -> f32 {
        let [low, high, exponent] = self.bytes();
        let mantissa = f32::from(i16::from_le_bytes([low, high]));
        mantissa * 2f32.powi(i32::from(exponent) % 48 - 55)
    }

    /// A number of moderate size, or any.
    pub fn float(&mut self, is_moderate: bool) -> f32 {
        if is_moderate { self.moderate() } else { f32::from_le_bytes(self.bytes()) }
    }

    /// So many of them.
    pub fn floats(&mut self, count: usize, is_moderate: bool) -> Vec<f32> {
        (0..count).map(|_| self.float(is_moderate)).collect()
    }
}
