//! Roots and angles entirely in f32.

use super::functions::Mathematics;
use super::{newton, quarters};

/// Roots and angles entirely in f32, without f64, division or tables.
///
/// Roots and their reciprocals have a relative error within 2e-7 if x is a normal number. Sines and
/// cosines are within 1e-7 for angles to 1,000 rad.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SinglePrecision;

/// Polynomials in x², highest term first, that equal (sin x - x) / x³ and (cos x - 1 + x²/2) / x⁴
/// at three Chebyshev nodes of [0, (π/4)²].
const SINE: [f32; 3] = [-1.958_789e-4, 8.332_748e-3, -1.666_666_7e-1];
const COSINE: [f32; 3] = [2.454_794_2e-5, -1.388_830_3e-3, 4.166_666_5e-2];

impl Mathematics<f32> for SinglePrecision {
    #[inline]
    fn square_root(x: f32) -> f32 {
        newton::square_root(x, Self::inverse_root(x))
    }

    /// Newton's method, starting from half the exponent.
    #[inline]
    fn inverse_root(x: f32) -> f32 {
        let first = f32::from_bits(0x5f37_5a86_u32.wrapping_sub(x.to_bits() >> 1));
        newton::inverse_root::<3>(x, first)
    }

    #[inline]
    fn sine_and_cosine(angle: f32) -> (f32, f32) {
        let (number, rest) = quarters::nearest::<1>(angle);
        let square = rest * rest;
        let polynomial = |terms: [f32; 3]| terms.iter().fold(0.0, |sum, term| sum * square + term);
        let sine = rest + rest * (square * polynomial(SINE));
        let cosine = 1.0 - (0.5 * square - square * square * polynomial(COSINE));
        quarters::turned(number, (sine, cosine))
    }
}
