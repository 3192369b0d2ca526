//! The record of a basis in integers. A number is a mantissa times 2 to its exponent.

use super::{Azimuth, Item, NONE, Word, item, record};
use zerocopy::{FromBytes, Immutable, KnownLayout};

record! {
    /// The arrays of a basis in integers. `q15::Basis::new` of the runtime checks
    /// that they are consistent.
    "eigenshade::q15::Parts" Parts OwnedParts
    sizes {
        /// Largest degree l of the light.
        degree: usize,
        /// Largest order o of the BRDF.
        order: usize,
        /// Number of components K.
        components: usize,
    }
    arrays {
        /// Slant profiles, in order of |m|.
        profiles: [Profile],
        /// For each |m|, where its profiles, rows of factors and terms are.
        azimuths: [Azimuth],
        /// Number of polynomial terms for each |m|.
        lengths: [u8],
        /// √(o+1) N_l^q C_lo^q of (11): for each l a row over the pairs (o, q). This and the next
        /// three arrays are empty in a basis that only holds transfers.
        polar: [S],
        /// An exponent for each number of `polar`.
        polar_exponents: [i8],
        /// Factors of UᵀM: for each profile and each l from |m| on, a row over the pairs.
        factors: [S],
        /// An exponent for each row of `factors`.
        factor_exponents: [i8],
        /// For each profile, its polynomial in t = 2z - 1, highest power first, times √2 if m is
        /// not 0.
        terms: [S],
    }
}

item! {
    /// A slant profile: its azimuth, the exponent of its terms, the components that use it, and its
    /// largest values.
    Profile {
        /// |m|.
        azimuth: u8,
        /// The exponent of the polynomial's terms.
        exponent: i8,
        /// The component of +m, or of 0; [`NONE`](Self::NONE) if there is none.
        plus: u16,
        /// The component of -m, or [`NONE`](Self::NONE).
        minus: u16,
        /// The largest absolute value of the profile in sixteenths, rounded up.
        size: u16,
        /// The largest term of the polynomial or intermediate step of Horner's rule in sixteenths,
        /// rounded up.
        step: u16,
    }
}

impl Profile {
    /// Marks a missing component.
    pub const NONE: u16 = NONE;

    /// The profile of `azimuth` |m|, used by component number `plus` with order +m (or 0) and by
    /// component number `minus` with order -m. Either may be [`NONE`](Self::NONE). `size` is its
    /// largest value, and `step` the largest term of its polynomial or intermediate step of
    /// Horner's rule, both in sixteenths.
    #[must_use]
    pub const fn new(
        azimuth: u8,
        exponent: i8,
        [plus, minus]: [u16; 2],
        [size, step]: [u16; 2],
    ) -> Self {
        Self { azimuth, exponent, plus, minus, size, step }
    }

    /// |m|.
    #[must_use]
    pub const fn azimuth(&self) -> usize {
        self.azimuth as usize
    }

    /// Whether a term with this mantissa, below 2^32, is at most the largest step.
    #[must_use]
    pub const fn states(&self, mantissa: u64) -> bool {
        let (by, step) = (self.exponent as i32 + 4, self.step as u64);
        match by {
            _ if mantissa == 0 => true,
            0..32 => mantissa << by <= step,
            -47..0 => mantissa <= step << -by,
            _ => by < 0 && step > 0,
        }
    }
}

/// A mantissa of 15 bits and a sign. The number is the mantissa times 2^exponent, where the
/// exponent belongs to the array that contains it.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, FromBytes, Immutable, KnownLayout,
)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(transparent)]
pub struct Q15(pub i16);

impl Q15 {
    /// Bits of a mantissa's magnitude.
    pub const BITS: u32 = 15;

    /// The mantissa as an integer.
    #[inline(always)]
    #[must_use]
    pub const fn get(self) -> i32 {
        self.0 as i32
    }

    /// The nearest mantissa, at most 2^15 - 1 in size.
    #[inline(always)]
    #[must_use]
    pub fn saturate(number: i32) -> Self {
        Self(number.clamp(-32_767, 32_767) as i16)
    }
}
