//! The number formats of the floating-point code.

use crate::format::Format;
#[cfg(target_feature = "relaxed-simd")]
use crate::lanes;
use crate::turn::exchange;
use core::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

/// A floating-point format of the runtime: `f32` on devices, `f64` for comparison on the host.
///
/// Sealed: fixed-point formats have code of their own.
pub trait Scalar:
    Format
    + Add<Output = Self>
    + AddAssign
    + Sub<Output = Self>
    + SubAssign
    + Mul<Output = Self>
    + Neg<Output = Self>
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
    /// A step of Horner's rule at a block of arguments: each sum becomes term + sum t.
    #[doc(hidden)]
    #[inline(always)]
    fn horner<const N: usize>(term: Self, sums: &mut [Self; N], t: &[Self; N]) {
        for (sum, &t) in sums.iter_mut().zip(t) {
            *sum = term.add_product(*sum, t);
        }
    }
    /// [`horner`](Self::horner) for two polynomials. In one loop: compilers for x86 leave the numbers
    /// of two loops in memory, and take twice the instructions.
    #[doc(hidden)]
    #[inline(always)]
    fn horner_of_two<const N: usize>(
        [term, another]: [Self; 2],
        [sums, more]: [&mut [Self; N]; 2],
        t: &[Self; N],
    ) {
        for ((sum, more), &t) in sums.iter_mut().zip(more).zip(t) {
            *sum = term.add_product(*sum, t);
            *more = another.add_product(*more, t);
        }
    }
    /// A step of Horner's rule in w̄ = x - i y at a block of normals: the sum above becomes
    /// here + w̄ above. Real and imaginary parts.
    #[doc(hidden)]
    #[inline(always)]
    fn descend<const N: usize>(
        [real, imaginary]: [&mut [Self; N]; 2],
        [plus, minus]: [[Self; N]; 2],
        [x, y]: [&[Self; N]; 2],
    ) {
        let above = real.iter_mut().zip(imaginary);
        let here = plus.iter().zip(&minus).zip(x.iter().zip(y));
        for ((real, imaginary), ((&plus, &minus), (&x, &y))) in above.zip(here) {
            (*real, *imaginary) = (
                plus.add_product(*real, x).add_product(*imaginary, y),
                minus.add_product(*imaginary, x).add_product(-*real, y),
            );
        }
    }
    /// Whether the number is neither infinite nor NaN.
    fn is_finite(self) -> bool;
    /// 1/x. Per pixel only [`Highlights`](crate::Highlights) calls it.
    fn reciprocal(self) -> Self;
    /// The integer part of a number; 0 if the number is negative or NaN.
    fn to_whole(self) -> usize;
    /// Converts a small integer.
    fn from_whole(value: usize) -> Self;
    /// Rounds to the nearest number of this format.
    fn from_f64(value: f64) -> Self;
    /// Converts an `f32` exactly: this format contains every `f32`.
    fn from_f32(value: f32) -> Self;
    /// self / divisor. As `reciprocal`.
    #[doc(hidden)]
    fn over(self, divisor: Self) -> Self;
    /// √(x/2) for x > 0 by Newton's method, without branches, division or tables, so that loops
    /// over pixels can be vectorized. The half saves a product. Relative error: 8e-7 in f32, 5e-16
    /// in f64.
    #[doc(hidden)]
    fn root_of_half(self) -> Self;
    /// The square root, from `libm`.
    fn root_by_libm(self) -> Self;
    /// Sine and cosine of an angle in radians, from `libm`.
    fn sine_and_cosine_by_libm(self) -> (Self, Self);
}

macro_rules! scalar {
    (
        $float:ident, $exchange:path,
        |$value:ident| $nearest:expr,
        $inverse:path, $root:path, $sine_and_cosine:path,
        { $($steps:tt)* }
    ) => {
        impl Scalar for $float {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const EXCHANGE: &'static [Self] = &$exchange;
            $($steps)*
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
            #[inline(always)]
            fn over(self, divisor: Self) -> Self {
                self / divisor
            }
            #[inline(always)]
            fn root_of_half(self) -> Self {
                self * $inverse(self)
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
scalar!(
    f32,
    exchange::F32,
    |value| value as f32,
    inverse_root_of_single,
    libm::sqrtf,
    libm::sincosf,
    {
        // The steps with `fused`, a loop for each product.
        #[cfg(target_feature = "relaxed-simd")]
        #[inline(always)]
        fn horner<const N: usize>(term: f32, sums: &mut [f32; N], t: &[f32; N]) {
            *sums = lanes::fused([term; N], sums, t);
        }

        #[cfg(target_feature = "relaxed-simd")]
        #[inline(always)]
        fn horner_of_two<const N: usize>(
            [term, another]: [f32; 2],
            [sums, more]: [&mut [f32; N]; 2],
            t: &[f32; N],
        ) {
            Self::horner(term, sums, t);
            Self::horner(another, more, t);
        }

        #[cfg(target_feature = "relaxed-simd")]
        #[inline(always)]
        fn descend<const N: usize>(
            [real, imaginary]: [&mut [f32; N]; 2],
            [plus, minus]: [[f32; N]; 2],
            [x, y]: [&[f32; N]; 2],
        ) {
            let plus = lanes::fused(plus, real, x);
            let plus = lanes::fused(plus, imaginary, y);
            for number in &mut *real {
                *number = -*number;
            }
            let minus = lanes::fused(minus, imaginary, x);
            (*real, *imaginary) = (plus, lanes::fused(minus, real, y));
        }
    }
);
scalar!(f64, exchange::F64, |value| value, inverse_root_of_double, libm::sqrt, libm::sincos, {});

/// 1/√(2x). Each step multiplies by 3/2 - x y², with the constants for the smallest largest error:
/// 8.8e-4 after the first one, 5.8e-7 after the second.
#[inline(always)]
fn inverse_root_of_single(x: f32) -> f32 {
    let first = f32::from_bits(0x5ef7_6a26_u32.wrapping_sub(x.to_bits() >> 1));
    let second = first * (1.500_88 - x * first * first);
    second * (1.500_000_6 - x * second * second)
}

/// 1/√(2x) in four steps.
#[inline(always)]
fn inverse_root_of_double(x: f64) -> f64 {
    let mut inverse = f64::from_bits(0x5fde_eb50_c7b5_37a9_u64.wrapping_sub(x.to_bits() >> 1));
    for _ in 0..4 {
        inverse *= 1.5 - x * inverse * inverse;
    }
    inverse
}

#[cfg(test)]
mod tests {
    use super::Scalar;

    /// Every mantissa of two octaves, of which all others are copies.
    #[test]
    fn roots_of_halves() {
        let mut most = 0.0_f64;
        for bits in 1.0_f32.to_bits()..4.0_f32.to_bits() {
            let x = f32::from_bits(bits);
            let exact = libm::sqrt(0.5 * f64::from(x));
            most = most.max((f64::from(x.root_of_half()) / exact - 1.0).abs());
        }
        assert!(most <= 8e-7, "{most:e}");
        let mut most = 0.0_f64;
        for k in 1..100_000 {
            let x = f64::from(k) * 1e-4;
            most = most.max((x.root_of_half() / libm::sqrt(0.5 * x) - 1.0).abs());
        }
        assert!(most <= 5e-16, "{most:e}");
    }
}
