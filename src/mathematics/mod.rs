//! Roots and angles for setup, with an implementation that the user chooses.
//!
//! Shading a pixel calls none of these functions; scaling a normal to length 1 takes one root.
//!
//! | type | formats | root, relative error | sine and cosine, error | also links |
//! |---|---|---|---|---|
//! | [`Libm`] | f32, f64 | last bit | last bit | f64 for f32 angles |
//! | [`SinglePrecision`] | f32 | 2e-7 | 1e-7 to 1,000 rad | nothing |
//! | `Micromath` | f32 | 6.1 %, its reciprocal 3.5 % | 1.1e-3 to 10 rad | nothing |
//!
//! Most microcontrollers compute f64 in software. `Micromath` needs the feature `micromath`.

mod single_precision;

pub use single_precision::SinglePrecision;

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
