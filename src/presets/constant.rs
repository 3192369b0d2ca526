//! Lights and materials in [`Q15`] as the compiler computes them: the same bits as the `quantize`
//! of [`q15::Light`](crate::q15::Light) and
//! [`q15::Material`](crate::q15::Material), which are not constant functions.

use crate::q15::Q15;
use crate::q15::{LEAST_TOP, decoded};

const BITS: i32 = 15;

/// The exponent and the mantissas of a light of degree 9.
pub(super) const fn light(from: &[f32]) -> (i32, [Q15; 100]) {
    let mut mantissas = [Q15(0); 100];
    let exponent = quantize(from, &mut mantissas, 0, 100);
    (exponent, mantissas)
}

/// The exponents and the mantissas of a material of order 7.
#[expect(clippy::indexing_slicing, reason = "a constant function has no iterators")]
pub(super) const fn material(from: &[f32]) -> ([i8; 8], [Q15; 40]) {
    let (mut exponents, mut mantissas) = ([0; 8], [Q15(0); 40]);
    let (mut start, mut o) = (0, 0);
    while o < exponents.len() {
        let end = crate::index::material::count(o);
        exponents[o] = quantize(from, &mut mantissas, start, end) as i8;
        (start, o) = (end, o + 1);
    }
    (exponents, mantissas)
}

/// Writes the mantissas from `start` to `end` and returns their exponent.
#[expect(clippy::indexing_slicing, reason = "a constant function has no iterators")]
const fn quantize(from: &[f32], to: &mut [Q15], start: usize, end: usize) -> i32 {
    let (mut top, mut i) = (LEAST_TOP, start);
    while i < end {
        let (size, exponent) = decoded(from[i]);
        let of_number = 32 - size.unsigned_abs().leading_zeros().cast_signed() + exponent;
        if size != 0 && of_number > top {
            top = of_number;
        }
        i += 1;
    }
    i = start;
    while i < end {
        // At least 9, as a size has 24 bits.
        let (size, exponent) = decoded(from[i]);
        let right = top - BITS - exponent;
        let rounded = if right > 31 { 0 } else { (size >> right) + ((size >> (right - 1)) & 1) };
        to[i] = Q15(if rounded > 32_767 {
            32_767
        } else if rounded < -32_767 {
            -32_767
        } else {
            rounded as i16
        });
        i += 1;
    }
    top - BITS
}
