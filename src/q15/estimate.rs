//! The coefficients d of an image by a scalar product in fixed point, pixel by pixel as the pixels
//! arrive: d_i = I • U_i, (19).

use super::arithmetic::{
    BITS, Shift as _, TERM_BITS, argument, dot, halved, nearest_argument_times, product, saturated,
    sum,
};
use super::{Basis, Coefficients, Normal, Profile, Q15};
use crate::buffer::{Buffer, zeros};
use crate::checked_slice::split_row;
use crate::error::{Argument, Error};

/// An estimate that accumulates pixels: see [`Basis::estimate`].
#[derive(Clone, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Estimate<'a, const K: usize> {
    basis: Basis<'a>,
    sums: Buffer<i64, K>,
    weight: u64,
    /// Whether a sum has exceeded 64 bits.
    is_saturated: bool,
}

impl<'a> Basis<'a> {
    /// Starts an estimate of d from pixels.
    ///
    /// `K` must be at least [`components`](Self::components). The estimate keeps that many 64-bit
    /// numbers.
    ///
    /// # Errors
    ///
    /// [`Error::Capacity`] if `K` is too small.
    pub fn estimate<const K: usize>(&self) -> Result<Estimate<'a, K>, Error> {
        let sums = zeros::<i64, K>(Argument::Coefficients, self.components())?;
        Ok(Estimate { basis: *self, sums, weight: 0, is_saturated: false })
    }
}

impl<'a, const K: usize> Estimate<'a, K> {
    /// The estimate of a table with `K` components.
    #[doc(hidden)]
    #[must_use]
    pub fn of_table(basis: Basis<'a>) -> Self {
        Self { basis, sums: [0; K].into(), weight: 0, is_saturated: false }
    }

    /// Adds a pixel with its normal, the irradiance seen there and its weight. The irradiance is a
    /// mantissa, and all pixels share one exponent. The weight is the image area that the pixel
    /// represents: 1 if all pixels are alike, 0 for a pixel that does not count.
    ///
    /// The sums have room for 2^15 pixels of full weight and size, or 2^31 pixels of weight 1. With
    /// more, a sum may exceed 64 bits, and [`coefficients`](Self::coefficients) then reports an
    /// error.
    #[inline]
    pub fn add(&mut self, normal: Normal, irradiance: Q15, weight: u16) {
        let parts = self.basis.parts();
        let t = argument(normal.z);
        let mut terms = parts.terms;
        let (mut cosine, mut sine) = (1 << (BITS - 1), 0);
        let mut azimuth = 0;
        for profile in parts.profiles {
            while azimuth < usize::from(profile.azimuth) {
                (cosine, sine) = match azimuth {
                    0 => (halved(normal.x), halved(normal.y)),
                    _ => (
                        dot(cosine, normal.x, -sine, normal.y),
                        dot(cosine, normal.y, sine, normal.x),
                    ),
                };
                azimuth += 1;
            }
            let (of_profile, rest) = split_row(terms, self.basis.length(azimuth));
            terms = rest;
            let value = value(profile, of_profile, t);
            // Φ_-m = √2 sin(-mβ).
            for (index, around) in [(profile.plus, cosine), (profile.minus, -sine)] {
                if let Some(to) = self.sums.get_mut(usize::from(index)) {
                    let image = sum(product(value, around));
                    let addend = i64::from(irradiance.0) * i64::from(image) * i64::from(weight);
                    let (next, beyond) = to.overflowing_add(addend);
                    (*to, self.is_saturated) = (next, self.is_saturated | beyond);
                }
            }
        }
        self.weight = self.weight.saturating_add(weight.into());
    }

    /// Computes d, the weighted mean of I U_i over the pixels. `exponent` is the irradiances'
    /// exponent.
    ///
    /// The mean equals I • U_i to the extent that the weighted pixels are distributed like the
    /// normals of the basis: for a sphere, all pixels of its disc, seen from afar.
    ///
    /// Compared with the same mean in exact arithmetic, the error is below 5e-3 of the largest
    /// coefficient for the shipped table, whose weak components have polynomials no longer than
    /// pixels need.
    ///
    /// # Errors
    ///
    /// [`Error::Weight`] if the weights sum to zero, [`Error::Exponent`] if the exponent is beyond
    /// ±2^15, [`Error::Saturated`] if a sum exceeded 64 bits; smaller weights avoid this.
    pub fn coefficients(&self, exponent: i32) -> Result<Coefficients<K>, Error> {
        if exponent.unsigned_abs() > 1 << 15 {
            return Err(Error::Exponent);
        }
        if self.is_saturated {
            return Err(Error::Saturated { argument: Argument::Coefficients });
        }
        let mut mantissas = zeros::<i32, K>(Argument::Coefficients, self.sums.len())?;
        let profiles = self.basis.parts.profiles;
        let mut top = None;
        for profile in profiles {
            for index in [profile.plus, profile.minus].map(usize::from) {
                let Some(&sum) = self.sums.get(index) else { continue };
                if sum != 0 {
                    top = top.max(Some(sum.bits().cast_signed() + shifted(profile)));
                }
            }
        }
        let weight = i64::try_from(self.weight).unwrap_or(i64::MAX);
        // The largest sum gets 62 bits, and its shifted mean has at least 31 bits fewer.
        let common = top.unwrap_or(0) - 62;
        let by = (64 - self.weight.leading_zeros()).cast_signed() - 33;
        for profile in profiles {
            for index in [profile.plus, profile.minus].map(usize::from) {
                let (Some(sum), Some(mantissa)) = (self.sums.get(index), mantissas.get_mut(index))
                else {
                    continue;
                };
                let aligned = sum.shifted(shifted(profile) - common);
                let mean = aligned.checked_div(weight).ok_or(Error::Weight)?;
                *mantissa = saturated(mean.shifted(by));
            }
        }
        let exponent = exponent + common - by;
        Ok(Coefficients { mantissas, exponent })
    }
}

/// By how many bits the terms of a profile are too large for the steps of Horner's rule.
fn excess(profile: &Profile) -> i32 {
    let bits = i32::from(profile.step).bits().cast_signed() - 4 - i32::from(profile.exponent);
    (bits - TERM_BITS.cast_signed()).max(0)
}

/// The exponent of [`value`].
fn shifted(profile: &Profile) -> i32 {
    i32::from(profile.exponent) + excess(profile)
}

#[inline]
fn value(profile: &Profile, terms: &[Q15], t: i32) -> i32 {
    let by = -excess(profile);
    let term = |term: &Q15| term.get().shifted(by);
    // A forged table may state too small a step. This must not panic.
    terms.iter().fold(0, |sum, of| nearest_argument_times(sum, t).wrapping_add(term(of)))
}
