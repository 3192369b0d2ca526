//! Roots and angles for setup, with an implementation that the user chooses.
//!
//! Shading a pixel calls none of these functions; scaling a normal to length 1 takes one root.
//!
//! | type | formats | root, relative error | sine and cosine, error | also links |
//! |---|---|---|---|---|
//! | [`Libm`] | f32, f64 | last bit | last bit | f64 for f32 angles |
//! | [`SinglePrecision`] | f32 | 2e-7 | 1e-7 to 1,000 rad | nothing |
//! | [`Tabled`] | f32 | 1.1e-7 | 8e-8 to 1,000 rad | 388 bytes of tables |
//! | `Micromath` | f32 | 6.1 %, its reciprocal 3.5 % | 1.1e-3 to 10 rad | nothing |
//!
//! Most microcontrollers compute f64 in software. `Micromath` needs the feature `micromath`.

mod steps;
mod tabled;

pub use tabled::Tabled;

use crate::scalar::Scalar;
#[cfg(feature = "micromath")]
use micromath::F32Ext;

/// Roots and angles in the number format `S`.
///
/// The trait has functions, not methods. An implementation is a type without values, chosen at the
/// call, as in `Normal::with_mathematics::<SinglePrecision>(x, y, z)`.
pub trait Mathematics<S> {
    /// √x, for x >= 0.
    fn square_root(x: S) -> S;
    /// 1/√x, for x > 0.
    fn inverse_root(x: S) -> S;
    /// (sin a, cos a) of an angle a in radians.
    fn sine_and_cosine(angle: S) -> (S, S);
}

/// Roots and angles from the crate `libm`, in any float format. This is the default; results are
/// accurate to the last bit or nearly so.
///
/// Its roots are integer loops on processors without a root instruction. Its f32 sines and cosines
/// are computed in f64, which a Cortex-M4F does in software;
/// [`SinglePrecision`] avoids that.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Libm;

impl<S: Scalar> Mathematics<S> for Libm {
    #[inline]
    fn square_root(x: S) -> S {
        x.root_by_libm()
    }
    #[inline]
    fn inverse_root(x: S) -> S {
        x.root_by_libm().reciprocal()
    }
    #[inline]
    fn sine_and_cosine(angle: S) -> (S, S) {
        angle.sine_and_cosine_by_libm()
    }
}

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
        steps::square_root(x, Self::inverse_root(x))
    }

    /// Newton's method, starting from half the exponent.
    #[inline]
    fn inverse_root(x: f32) -> f32 {
        let first = f32::from_bits(0x5f37_5a86_u32.wrapping_sub(x.to_bits() >> 1));
        steps::inverse_root::<3>(x, first)
    }

    #[inline]
    fn sine_and_cosine(angle: f32) -> (f32, f32) {
        let (number, rest) = steps::nearest::<1>(angle);
        let square = rest * rest;
        let polynomial = |terms: [f32; 3]| terms.iter().fold(0.0, |sum, term| sum * square + term);
        let sine = rest + rest * (square * polynomial(SINE));
        let cosine = 1.0 - (0.5 * square - square * square * polynomial(COSINE));
        steps::turned(number, (sine, cosine))
    }
}

/// Roots and angles from the crate `micromath`: a handful of instructions each, with low accuracy.
///
/// Roots are off by up to 6.1 %, their reciprocals by up to 3.5 %, so a normal scaled by one is
/// too long or too short by as much. Sines and cosines are off by up to 1.1e-3 within 10 rad.
#[cfg(feature = "micromath")]
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Micromath;

#[cfg(feature = "micromath")]
impl Mathematics<f32> for Micromath {
    #[inline]
    fn square_root(x: f32) -> f32 {
        F32Ext::sqrt(x)
    }
    #[inline]
    fn inverse_root(x: f32) -> f32 {
        x.invsqrt()
    }
    #[inline]
    fn sine_and_cosine(angle: f32) -> (f32, f32) {
        (F32Ext::sin(angle), F32Ext::cos(angle))
    }
}
