//! The number formats: floats, and integers with a separate scale.

pub use crate::index::record::{Q15, Q31};
use crate::turn::exchange;
use core::fmt::Debug;
use core::ops::{Add, AddAssign, BitOr, Mul, Neg, Sub};

/// A number format of the runtime: `f32`, `f64`, [`Q15`] or [`Q31`].
///
/// This trait is sealed. Floating-point code is generic over [`Scalar`](crate::Scalar), integer
/// code over [`FixedPoint`].
pub trait Format:
    sealed::Sealed + Copy + Debug + Default + PartialEq + PartialOrd + 'static
{
    /// The format of a sum of products.
    type Wide: Copy;
    /// The name of the format on a command line.
    const NAME: &'static str;
}

impl Format for f32 {
    type Wide = Self;
    const NAME: &'static str = "f32";
}

impl Format for f64 {
    type Wide = Self;
    const NAME: &'static str = "f64";
}

impl Format for Q15 {
    type Wide = i32;
    const NAME: &'static str = "q15";
}

impl Format for Q31 {
    type Wide = i64;
    const NAME: &'static str = "q31";
}

pub(crate) mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
    impl Sealed for super::Q15 {}
    impl Sealed for super::Q31 {}
    impl Sealed for i32 {}
    impl Sealed for i64 {}
}

/// An integer format.
pub trait FixedPoint: Format<Wide: Wide> {
    /// Bits of a mantissa's magnitude.
    const BITS: u32;
    /// The matrices that turning takes: see `turn/exchange.rs`.
    #[doc(hidden)]
    const EXCHANGE: &'static [Self];
    /// Number of bits by which a scene's weights are finer than its terms.
    const WEIGHT_BITS: u32;
    /// Number of bits by which a sum of weighted numbers is finer than a scene's terms.
    const SUM_SHIFT: u32;
    /// Bits of the magnitude at each step of a pixel's polynomials, and of its irradiance.
    const TERM_BITS: u32;
    /// Number of bits by which `seen` shifts its product down.
    const SEEN_SHIFT: u32;
    /// The product of two complex numbers of magnitude 1 and thereabouts, in fractions of 2^30.
    #[doc(hidden)]
    fn rotated(a: [i32; 2], b: [i32; 2]) -> [i32; 2];
    /// The mantissa of the low bits of a number.
    fn truncated(number: i32) -> Self;
    /// The mantissa as a factor of a [`Wide`] product.
    fn widen(self) -> Self::Wide;
    /// The nearest mantissa, saturated at the largest one.
    fn saturate(number: Self::Wide) -> Self;
    /// This mantissa / √2, rounded.
    fn over_root_two(self) -> Self;
    /// `weight` times this mantissa, rounded, [`SUM_SHIFT`](Self::SUM_SHIFT) bits finer than a
    /// term; modulo 2^32.
    fn weigh(self, weight: i32) -> i32;
    /// floor(sum t), where t is `argument` as a fraction of 2^(BITS - 1).
    /// Domain: |sum| < 2^[`TERM_BITS`](Self::TERM_BITS), |t| <= 1.
    fn argument_times(sum: i32, argument: i32) -> i32;
    /// The same as `argument_times`, rounded to the nearest integer.
    fn nearest_argument_times(sum: i32, argument: i32) -> i32;
    /// The product of an irradiance and the value of an eigenimage, shifted down by
    /// [`SEEN_SHIFT`](Self::SEEN_SHIFT) bits and rounded.
    fn seen(irradiance: Self, image: i32) -> i64;
    /// This mantissa as a fraction of 2^(BITS - 1).
    fn halved(self) -> i32;
    /// a x + b y, rounded, where a and b are fractions of 2^(BITS - 1). Domain: a² + b² at most 2,
    /// x² + y² at most 1.001, which a [`Normal`](crate::quantized::Normal) satisfies.
    fn dot(a: i32, x: Self, b: i32, y: Self) -> i32;
    /// `value` times `fraction`, a fraction of 2^(BITS - 1).
    fn product(value: i32, fraction: i32) -> Self::Wide;
    /// `value` on the scale of a `product`.
    fn of_value(value: i32) -> Self::Wide;
    /// Rounds a sum of `product`s. Intermediate sums may wrap if the final one fits.
    fn sum(sum: Self::Wide) -> i32;
    /// `value` times this mantissa, modulo 2^32 or 2^64.
    fn times(self, value: i32) -> Self::Wide;
    /// floor(sum / 2^BITS): the integer part of a sum of products with mantissas. Domain: it fits.
    fn whole(sum: Self::Wide) -> i32;
    /// 2z - 1 as a fraction of 2^(BITS - 1). Domain: z >= 0.
    fn argument(z: Self) -> i32;
}

/// A sum of products of an integer format.
pub trait Wide:
    sealed::Sealed
    + Copy
    + Debug
    + Default
    + Ord
    + Add<Output = Self>
    + AddAssign
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
    + BitOr<Output = Self>
{
    /// Bits of the largest magnitude.
    const SIZE: u32;
    /// self + other, modulo 2^(SIZE + 1).
    fn wrapping_plus(self, other: Self) -> Self;
    /// -self, modulo 2^(SIZE + 1).
    fn wrapping_minus(self) -> Self;
    /// Converts an `i32`.
    fn of(number: i32) -> Self;
    /// Number of bits of |self|: the smallest n with |self| < 2^n.
    fn bits(self) -> u32;
    /// The integer nearest to self 2^`by`. Domain: it fits.
    fn shifted(self, by: i32) -> Self;
    /// floor(self 2^`by`). Domain: it fits.
    fn floor_shr(self, by: i32) -> Self;
    /// The integer nearest to self / 2^(`by` + 1). Domain: `by` >= 0, |self| < 2^SIZE - 1.
    fn round_shr(self, by: i32) -> Self;
    /// The nearest `i32`.
    fn saturated(self) -> i32;
}

macro_rules! wide {
    ($wide:ident, $size:literal, |$number:ident| $saturated:expr) => {
        impl Wide for $wide {
            const SIZE: u32 = $size;
            #[inline(always)]
            fn wrapping_plus(self, other: Self) -> Self {
                self.wrapping_add(other)
            }
            #[inline(always)]
            fn wrapping_minus(self) -> Self {
                self.wrapping_neg()
            }
            #[inline(always)]
            fn of(number: i32) -> Self {
                number.into()
            }
            #[inline]
            fn bits(self) -> u32 {
                Self::SIZE + 1 - self.unsigned_abs().leading_zeros()
            }
            #[inline]
            fn shifted(self, by: i32) -> Self {
                match by {
                    0.. => {
                        let fits = self == 0 || self.bits().cast_signed() + by <= $size;
                        debug_assert!(fits, "out of domain");
                        self << by.min($size)
                    }
                    _ if by >= -$size => (self >> -by) + ((self >> (-by - 1)) & 1),
                    _ => 0,
                }
            }
            #[inline(always)]
            fn floor_shr(self, by: i32) -> Self {
                if by >= 0 { self << by.min($size) } else { self >> (-by).min($size) }
            }
            #[inline(always)]
            fn round_shr(self, by: i32) -> Self {
                debug_assert!(by >= 0, "out of domain");
                // A shift by all bits gives 0 or -1, both of which round to 0.
                ((self >> by.cast_unsigned().min($size)) + 1) >> 1
            }
            #[inline]
            fn saturated(self) -> i32 {
                let $number = self;
                $saturated
            }
        }
    };
}
wide!(i32, 31, |number| number);
wide!(i64, 63, |number| number.clamp((-i32::MAX).into(), i32::MAX.into()) as i32);

impl FixedPoint for Q15 {
    const BITS: u32 = 15;
    const EXCHANGE: &'static [Self] = &exchange::Q15_ELEMENTS;
    const WEIGHT_BITS: u32 = 14;
    const SUM_SHIFT: u32 = 14;
    const TERM_BITS: u32 = 17;
    const SEEN_SHIFT: u32 = 0;
    /// From halves of 15 bits, without the low product: small processors have no longer products.
    #[inline(always)]
    fn rotated([c, s]: [i32; 2], [cosine, sine]: [i32; 2]) -> [i32; 2] {
        let halves = |number: i32| [number >> 15, number & 0x7fff];
        let ([c, c_low], [s, s_low]) = (halves(c), halves(s));
        let ([cosine, cosine_low], [sine, sine_low]) = (halves(cosine), halves(sine));
        let low = |a: i32, b: i32| a.wrapping_add(b) >> 15;
        [
            c * cosine - s * sine
                + low(c * cosine_low, -(s * sine_low))
                + low(c_low * cosine, -(s_low * sine)),
            s * cosine
                + c * sine
                + low(s * cosine_low, c * sine_low)
                + low(s_low * cosine, c_low * sine),
        ]
    }
    #[inline(always)]
    fn truncated(number: i32) -> Self {
        Self(number as i16)
    }
    #[inline(always)]
    fn widen(self) -> i32 {
        i32::from(self.0)
    }
    #[inline(always)]
    fn saturate(number: i32) -> Self {
        Self(number.clamp(-32_767, 32_767) as i16)
    }
    #[inline]
    fn over_root_two(self) -> Self {
        Self::saturate((self.widen() * 23_170 + (1 << 14)) >> 15)
    }
    #[inline(always)]
    fn weigh(self, weight: i32) -> i32 {
        weight.wrapping_mul(self.widen())
    }
    #[inline(always)]
    fn argument_times(sum: i32, argument: i32) -> i32 {
        sum.wrapping_mul(argument) >> 14
    }
    #[inline(always)]
    fn nearest_argument_times(sum: i32, argument: i32) -> i32 {
        sum.wrapping_mul(argument).wrapping_add(1 << 13) >> 14
    }
    #[inline(always)]
    fn seen(irradiance: Self, image: i32) -> i64 {
        i64::from(irradiance.0) * i64::from(image)
    }
    #[inline(always)]
    fn halved(self) -> i32 {
        (self.widen() + 1) >> 1
    }
    #[inline(always)]
    fn dot(a: i32, x: Self, b: i32, y: Self) -> i32 {
        (a * x.widen() + b * y.widen() + (1 << 14)) >> 15
    }
    #[inline(always)]
    fn product(value: i32, fraction: i32) -> i32 {
        value.wrapping_mul(fraction)
    }
    #[inline(always)]
    fn of_value(value: i32) -> i32 {
        value << 14
    }
    #[inline(always)]
    fn sum(sum: i32) -> i32 {
        ((sum >> 13) + 1) >> 1
    }
    #[inline(always)]
    fn times(self, value: i32) -> i32 {
        value.wrapping_mul(self.widen())
    }
    #[inline(always)]
    fn whole(sum: i32) -> i32 {
        sum >> 15
    }
    #[inline(always)]
    fn argument(z: Self) -> i32 {
        z.widen() - (1 << 14)
    }
}

impl FixedPoint for Q31 {
    const BITS: u32 = 31;
    const EXCHANGE: &'static [Self] = &exchange::Q31_ELEMENTS;
    const WEIGHT_BITS: u32 = 30;
    const SUM_SHIFT: u32 = 1;
    const TERM_BITS: u32 = 30;
    const SEEN_SHIFT: u32 = 30;
    fn rotated([c, s]: [i32; 2], b: [i32; 2]) -> [i32; 2] {
        const ONE: i32 = 1 << 30;
        let [cosine, sine] = b.map(i64::from);
        let [c, s] = [c, s].map(i64::from);
        [c * cosine - s * sine, s * cosine + c * sine]
            .map(|sum| (((sum + (1 << 29)) >> 30) as i32).clamp(-ONE, ONE))
    }
    #[inline(always)]
    fn truncated(number: i32) -> Self {
        Self(number)
    }
    #[inline(always)]
    fn widen(self) -> i64 {
        i64::from(self.0)
    }
    #[inline(always)]
    fn saturate(number: i64) -> Self {
        Self(number.saturated())
    }
    #[inline]
    fn over_root_two(self) -> Self {
        Self::saturate((self.widen() * 1_518_500_250 + (1 << 30)) >> 31)
    }
    #[inline(always)]
    fn weigh(self, weight: i32) -> i32 {
        ((i64::from(weight) * self.widen() + (1 << 28)) >> 29) as i32
    }
    #[inline(always)]
    fn argument_times(sum: i32, argument: i32) -> i32 {
        ((i64::from(sum) * i64::from(argument)) >> 30) as i32
    }
    #[inline(always)]
    fn nearest_argument_times(sum: i32, argument: i32) -> i32 {
        ((i64::from(sum) * i64::from(argument) + (1 << 29)) >> 30) as i32
    }
    #[inline(always)]
    fn seen(irradiance: Self, image: i32) -> i64 {
        (irradiance.widen() * i64::from(image) + (1 << 29)) >> 30
    }
    #[inline(always)]
    fn halved(self) -> i32 {
        ((self.widen() + 1) >> 1) as i32
    }
    #[inline(always)]
    fn dot(a: i32, x: Self, b: i32, y: Self) -> i32 {
        ((i64::from(a) * x.widen() + i64::from(b) * y.widen() + (1 << 30)) >> 31) as i32
    }
    #[inline(always)]
    fn product(value: i32, fraction: i32) -> i64 {
        i64::from(value) * i64::from(fraction)
    }
    #[inline(always)]
    fn of_value(value: i32) -> i64 {
        i64::from(value) << 30
    }
    #[inline(always)]
    fn sum(sum: i64) -> i32 {
        (((sum >> 29) + 1) >> 1) as i32
    }
    #[inline(always)]
    fn times(self, value: i32) -> i64 {
        i64::from(value) * self.widen()
    }
    #[inline(always)]
    fn whole(sum: i64) -> i32 {
        (sum >> 31) as i32
    }
    #[inline(always)]
    fn argument(z: Self) -> i32 {
        z.0 - (1 << 30)
    }
}
