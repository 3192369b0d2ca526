//! Roots and angles from the crate `libm`.

use super::functions::Mathematics;
use crate::scalar::Scalar;

/// Roots and angles from the crate `libm`, in any float format. This is the default; results are
/// accurate to the last bit or nearly so.
///
/// Its roots are integer loops on processors without a root instruction. Its f32 sines and cosines
/// are computed in f64, which a Cortex-M4F does in software;
/// [`SinglePrecision`](super::SinglePrecision) avoids that.
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
