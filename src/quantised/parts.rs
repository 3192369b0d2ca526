//! The arrays that make up a fixed-point basis.

use crate::index::effect::Effects;
use zerocopy::{FromBytes, Immutable, KnownLayout};

/// The arrays of a basis in a fixed-point format, as `eigenshade-table` writes them. A number is a
/// mantissa times 2 to its exponent.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Parts<'a, Q> {
    /// Largest degree l of the light.
    pub degree: usize,
    /// Largest order o of the BRDF.
    pub order: usize,
    /// The effects that the basis covers. All coefficients must be factored.
    pub effects: Effects,
    /// Number of components K.
    pub components: usize,
    /// Slant profiles, in order of |m|.
    pub profiles: &'a [Profile],
    /// Number of polynomial terms for each |m|.
    pub lengths: &'a [u8],
    /// √(o+1) N_l^q C_lo^q of (11): for each l a row over the pairs (o, q). This and the next three
    /// arrays are empty in a basis that only holds transfers.
    pub polar: &'a [Q],
    /// An exponent for each number of `polar`.
    pub polar_exponents: &'a [i8],
    /// Factors of UᵀM: for each profile and each l from |m| on, a row over the pairs.
    pub factors: &'a [Q],
    /// An exponent for each row of `factors`.
    pub factor_exponents: &'a [i8],
    /// For each profile, its polynomial in t = 2z - 1, highest power first, times √2 if m is not 0.
    pub terms: &'a [Q],
}

/// A slant profile: its azimuth, the components that use it, the exponent of its terms, and its
/// largest values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, FromBytes, Immutable, KnownLayout)]
#[repr(C)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Profile {
    pub(crate) azimuth: u8,
    pub(crate) exponent: i8,
    pub(crate) plus: u16,
    pub(crate) minus: u16,
    pub(crate) size: u16,
    pub(crate) step: u16,
}

impl Profile {
    /// Marks a missing component.
    pub const NONE: u16 = u16::MAX;

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

    /// Whether a term with this mantissa, below 2^32, is at most the largest step.
    pub(crate) const fn states(&self, mantissa: u64) -> bool {
        let (by, step) = (self.exponent as i32 + 4, self.step as u64);
        match by {
            _ if mantissa == 0 => true,
            0..32 => mantissa << by <= step,
            -47..0 => mantissa <= step << -by,
            _ => by < 0 && step > 0,
        }
    }
}
