//! Roots and angles by the crate `libm`.

use super::Mathematics;
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

/// What `libm` has under a name for each format.
pub trait ByLibm: Sized {
    fn root_by_libm(self) -> Self;
    fn sine_and_cosine_by_libm(self) -> (Self, Self);
}

impl ByLibm for f32 {
    #[inline]
    fn root_by_libm(self) -> Self {
        libm::sqrtf(self)
    }
    #[inline]
    fn sine_and_cosine_by_libm(self) -> (Self, Self) {
        libm::sincosf(self)
    }
}

impl ByLibm for f64 {
    #[inline]
    fn root_by_libm(self) -> Self {
        libm::sqrt(self)
    }
    #[inline]
    fn sine_and_cosine_by_libm(self) -> (Self, Self) {
        libm::sincos(self)
    }
}
