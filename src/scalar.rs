//! The number formats of the floating-point code.

use crate::turn::exchange;
use core::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

/// A floating-point format of the runtime: `f32` on devices, `f64` for comparison on the host.
///
/// Sealed: fixed-point formats have code of their own.
pub trait Scalar:
    sealed::Sealed
    + Copy
    + PartialOrd
    + core::fmt::Debug
    + Default
    + Add<Output = Self>
    + AddAssign
    + Sub<Output = Self>
    + SubAssign
    + Mul<Output = Self>
    + Neg<Output = Self>
    + 'static
{
    /// 0.
    const ZERO: Self;
    /// 1.
    const ONE: Self;
    /// The matrices that turning takes: see `turn/exchange.rs`.
    #[doc(hidden)]
    const EXCHANGE: &'static [Self];
    /// self + a b. With the feature `std` on a target with the target feature `fma`, it
    /// rounds once, otherwise twice.
    fn add_product(self, a: Self, b: Self) -> Self;
    /// Whether the number is neither infinite nor NaN.
    fn is_finite(self) -> bool;
    /// 1/x. Never called per pixel.
    fn reciprocal(self) -> Self;
    /// The integer part of a number; 0 if the number is negative or NaN.
    fn to_whole(self) -> usize;
    /// Converts a small integer.
    fn from_whole(value: usize) -> Self;
    /// Rounds to the nearest number of this format.
    fn from_f64(value: f64) -> Self;
    /// Converts an `f32` exactly: this format contains every `f32`.
    fn from_f32(value: f32) -> Self;
    /// The square root, from `libm`.
    fn root_by_libm(self) -> Self;
    /// Sine and cosine of an angle in radians, from `libm`.
    fn sine_and_cosine_by_libm(self) -> (Self, Self);
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

macro_rules! scalar {
    (
        $float:ident, $exchange:path,
        |$value:ident| $nearest:expr, $root:path, $sine_and_cosine:path
    ) => {
        impl Scalar for $float {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const EXCHANGE: &'static [Self] = &$exchange;
            #[cfg(all(feature = "std", target_feature = "fma"))]
            #[inline(always)]
            fn add_product(self, a: Self, b: Self) -> Self {
                a.mul_add(b, self)
            }
            #[cfg(not(all(feature = "std", target_feature = "fma")))]
            #[inline(always)]
            fn add_product(self, a: Self, b: Self) -> Self {
                self + a * b
            }
            #[inline]
            fn is_finite(self) -> bool {
                self.is_finite()
            }
            #[inline]
            fn reciprocal(self) -> Self {
                1.0 / self
            }
            #[inline]
            fn to_whole(self) -> usize {
                self as usize
            }
            #[inline]
            fn from_whole(value: usize) -> Self {
                value as Self
            }
            #[inline]
            fn from_f64($value: f64) -> Self {
                $nearest
            }
            #[inline(always)]
            fn from_f32(value: f32) -> Self {
                value.into()
            }
            #[inline]
            fn root_by_libm(self) -> Self {
                $root(self)
            }
            #[inline]
            fn sine_and_cosine_by_libm(self) -> (Self, Self) {
                $sine_and_cosine(self)
            }
        }
    };
}
scalar!(f32, exchange::F32, |value| value as f32, libm::sqrtf, libm::sincosf);
scalar!(f64, exchange::F64, |value| value, libm::sqrt, libm::sincos);
