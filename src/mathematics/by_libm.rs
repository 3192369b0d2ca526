//! Roots and angles by the crate `libm`.

use super::functions::Mathematics;
use crate::scalar::Scalar;

/// Roots and angles by the crate `libm`, in any format: right to the last bit or
/// nearly so, and what is taken where nothing else is asked for.
///
/// Its roots are loops over integers where the processor has no instruction for
/// them. Its f32 sines and cosines compute in f64, in software on a Cortex-M4F: those are
/// what [`SinglePrecision`](super::SinglePrecision) is for.
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
