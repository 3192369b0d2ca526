//! What holds of any input, read from any bytes: property tests and fuzz targets share it.
//!
//! Each function panics if it does not hold.
#![allow(
    dead_code,
    unused_imports,
    reason = "each test and each target takes the parts that it needs"
)]

mod drawing;
pub mod integer;
mod shading;
mod shadowed;
mod ways;

pub use ways::{project_reconstruct, public_interface};

use eigenshade::q15::{self, Transfer};
use eigenshade::truncation::Tolerance;
use eigenshade::wire::{WireError, aligned};
use eigenshade::{Basis, Light, Material, Normal, Q15};
use eigenshade_table::{light, material, wire};
use integer::Mantissa as _;
use shading::{collapse_sets, shade_coefficients, shade_floats, shade_integers, shade_transfer};

/// d in 15 bits, relative to what its addends could be: light, material, Ĉ, S, factors and T are
/// each rounded to 15 bits of the largest number of their row.
pub const ANY_D_Q15: f64 = 2e-5;

/// d has 30 bits of its largest component, and rounds twice.
pub const ANY_D_COMMON: f64 = 2e-9;

/// A bound against its parts, and what components are said to leave out against the sum of their
/// squares, of the bound: roundings of f32 of sums of some hundred squares.
pub const TRUNCATED_PARTS: f64 = 2e-6;

/// RRᵀ of any rotation in f32: sixteen roundings, and those of the sum itself.
pub const ORTHONORMAL_F32: f64 = 1.2e-6;

/// Any light on any material under any normals, any transfer, and any coefficients, in any format;
/// and any images within a tolerance.
pub const SHADING: [fn(&mut Reader<'_>); 5] =
    [shade_floats, shade_integers, shade_transfer, shade_coefficients, collapse_sets];

/// The first byte chooses one of [`SHADING`].
pub fn shade_any(bytes: &[u8]) {
    let mut input = Reader::new(bytes);
    SHADING[input.up_to(SHADING.len() - 1)](&mut input);
}

/// A packed object of any pixels, and its changed bytes.
pub fn packed_object(bytes: &[u8]) {
    drawing::packed(&mut Reader::new(bytes));
}

/// An object with shadows of any numbers, and its changed bytes.
pub fn shadowed_object(bytes: &[u8]) {
    shadowed::drawn(&mut Reader::new(bytes));
}

/// Bytes that are read one after the other.
pub struct Reader<'a>(&'a [u8]);

impl<'a> Reader<'a> {
    pub fn new(bytes: &'a [u8]) -> Self {
        Self(bytes)
    }

    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    pub fn bytes<const N: usize>(&mut self) -> [u8; N] {
        [(); N].map(|()| self.byte())
    }

    /// The next byte, or 0 at the end.
    pub fn byte(&mut self) -> u8 {
        self.0.split_off_first().copied().unwrap_or(0)
    }

    pub fn i32(&mut self) -> i32 {
        i32::from_le_bytes(self.bytes())
    }

    /// A number of at most this, or this.
    pub fn up_to(&mut self, most: usize) -> usize {
        usize::from(self.byte()) % (most + 1)
    }

    /// A whole number from -128 to 127.
    pub fn small(&mut self) -> f32 {
        self.byte().cast_signed().into()
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

/// These bytes as they are, and with length and checksum made right.
pub fn from_bytes(bytes: &[u8]) {
    let mut room = vec![0; bytes.len().div_ceil(wire::ALIGNMENT)];
    read(aligned(bytes, &mut room).expect("room for all"));
    if bytes.len() < wire::HEADER + wire::CHECKSUM || bytes.len() > 1 << 20 {
        return;
    }
    let mut sealed = bytes.to_vec();
    sealed[..wire::LABEL.len()].copy_from_slice(&wire::LABEL);
    let length = sealed.len() as u32;
    sealed[wire::place::LENGTH..][..4].copy_from_slice(&length.to_ne_bytes());
    let (file, sum) = sealed.split_at_mut(bytes.len() - wire::CHECKSUM);
    sum.copy_from_slice(&checksum(file).to_ne_bytes());
    read(aligned(&sealed, &mut room).expect("room for all"));
}

/// The error of each kind of basis that cannot be read from these bytes. Every other one is used.
pub fn read(bytes: &[u8]) -> [Option<WireError>; 2] {
    [
        Basis::from_bytes(bytes).map(|basis| floats(&basis)).err(),
        q15::Basis::from_bytes(bytes).map(|basis| integers(&basis)).err(),
    ]
}

/// More components than any table in `tests/wire_files` has. A basis with more is not estimated.
const COMPONENTS: usize = 256;

/// Everything can be done with a basis that was read.
pub fn floats(basis: &Basis<'_>) {
    let normal = Normal::new(0.6, 0.0, 0.8).expect("a normal");
    let estimate = basis.estimate::<COMPONENTS>();
    assert!(estimate.is_ok() || basis.components() > COMPONENTS);
    if let Ok(mut estimate) = estimate {
        estimate.add(normal, 1.0, 1.0);
        let _ = estimate.coefficients();
    }
    let ones = vec![1.0; light::count(basis.degree())];
    let light = Light::new(&ones).expect("a light");
    let ones = vec![1.0; material::count(basis.order())];
    let material = Material::new(&ones).expect("a material");
    let mut workspace = vec![0.0; basis.workspace_len()];
    let mut d = vec![1.0; basis.components()];
    let mut transfer = vec![1.0; basis.transfer_len()];
    // A basis of transfers alone takes in no material.
    let done = basis.project_into(&light, &material, &mut workspace, &mut d);
    assert!(done.is_ok() || !basis.projects());
    if done.is_ok() {
        basis.transfer_into(&material, &mut workspace, &mut transfer).expect("sizes");
    }
    basis.relight_into(&transfer, &light, &mut d).expect("sizes");
    basis.reconstruct(&d, normal).expect("as many as components");
    let scene = basis.collapse_into(&d, vec![0.0; basis.scene_len()]).expect("sizes");
    let _ = scene.shade(normal);
    let (mut lengths, buffer) = (vec![0; basis.azimuths()], vec![0.0; basis.scene_len()]);
    let tolerance = Tolerance::OfPeak(0.01);
    let within = basis.collapse_within(&d, tolerance, &mut lengths, buffer);
    let _ = within.expect("sizes").0.shade(normal);
}

/// See [`floats`].
pub fn integers(basis: &q15::Basis<'_>) {
    let numbers = |count: usize| -> Vec<Q15> {
        (0..count).map(|k| Q15(if k % 3 == 1 { i16::MIN } else { i16::MAX })).collect()
    };
    let (degree, order) = (basis.degree(), basis.order());
    let mantissas = numbers(light::count(degree));
    let light = q15::Light::new(0, &mantissas).expect("a light");
    let mut transfer = vec![Q15(1); basis.transfer_len()];
    let mut exponents = vec![0; basis.profiles()];
    if !basis.parts().polar.is_empty() {
        let (mantissas, of_orders) = (numbers(material::count(order)), vec![0; order + 1]);
        let material = q15::Material::new(&of_orders, &mantissas).expect("a material");
        let mut workspace = vec![0; basis.workspace_len()];
        basis
            .transfer_into(&material, &mut workspace, &mut transfer, &mut exponents)
            .expect("sizes");
    }
    let mut d = vec![0; basis.components()];
    let transfer = Transfer::new(&transfer, &exponents);
    let exponent = basis.relight_into(&transfer, &light, &mut d).expect("a transfer");
    let scene = basis.collapse_into(&d, exponent, vec![0; basis.scene_len()]).expect("sizes");
    for normal in [[0.6, 0.0, 0.8], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] {
        let normal = integer::normal(normal.map(Q15::rounded)).expect("a unit vector");
        // Of a forged table it may mean nothing.
        let _ = scene.shade(normal);
        if let Ok(mut estimate) = basis.estimate::<COMPONENTS>() {
            estimate.add(normal, Q15(1), 1);
            let _ = estimate.coefficients(0);
        }
    }
}

/// CRC-32 of ISO 3309, bit by bit.
fn checksum(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(u32::MAX, |sum, &byte| {
        (0..8).fold(sum ^ u32::from(byte), |sum, _| {
            (sum >> 1) ^ if sum & 1 == 1 { 0xedb8_8320 } else { 0 }
        })
    })
}
