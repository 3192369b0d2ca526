//! An eigenbasis in integers, its shape and its bounds checked.

use super::Parts;
use crate::error::{Error, What};
use crate::format::{Q15, Q31};
use crate::index::pair;

/// An eigenbasis in an integer format.
#[derive(Clone, Copy, Debug)]
pub struct Basis<'a, Q> {
    pub(crate) parts: Parts<'a, Q>,
}

impl<'a, Q> Parts<'a, Q> {
    /// Checks all lengths, and all places that one part has in another.
    const fn fits(&self) -> Result<(), Error> {
        let degrees = self.degree.saturating_add(1);
        if let Err(error) = Error::check(What::Lengths, degrees, self.lengths.len()) {
            return Err(error);
        }
        let pairs = pair::count(self.order);
        let (mut rows, mut terms, mut served, mut before) = (0, 0, 0, 0);
        let mut rest = self.profiles;
        while let [profile, tail @ ..] = rest {
            let azimuth = profile.azimuth as usize;
            let of_minus = profile.minus != super::Profile::NONE;
            if azimuth < before || azimuth > self.degree || (azimuth == 0 && of_minus) {
                return Err(Error::Profile);
            }
            let orders = [profile.plus, profile.minus];
            let mut orders = orders.as_slice();
            while let [component, others @ ..] = orders {
                if *component != super::Profile::NONE {
                    if *component as usize >= self.components {
                        return Err(Error::Profile);
                    }
                    served += 1;
                }
                orders = others;
            }
            rows += degrees - azimuth;
            terms += self.length(azimuth);
            (rest, before) = (tail, azimuth);
        }
        if served != self.components {
            return Err(Error::Profile);
        }
        let folded = self.polar.is_empty() && self.factors.is_empty();
        let (polar, rows) = if folded { (0, 0) } else { (degrees * pairs, rows) };
        let checks = [
            Error::check(What::Polar, polar, self.polar.len()),
            Error::check(What::Polar, polar, self.polar_exponents.len()),
            Error::check(What::Factors, rows * pairs, self.factors.len()),
            Error::check(What::Factors, rows, self.factor_exponents.len()),
            Error::check(What::Terms, terms, self.terms.len()),
        ];
        let mut rest = checks.as_slice();
        while let [check, tail @ ..] = rest {
            if let Err(error) = check {
                return Err(*error);
            }
            rest = tail;
        }
        Ok(())
    }

    /// Terms of the polynomials of an azimuth; 0 if it has none.
    pub(crate) const fn length(&self, azimuth: usize) -> usize {
        match self.lengths.split_at_checked(azimuth) {
            Some((_, [length, ..])) => *length as usize,
            _ => 0,
        }
    }
}

macro_rules! bounded {
    ($format:ident, $bits:literal) => {
        impl<'a> Basis<'a, $format> {
            /// The basis of these parts.
            ///
            /// Checked are all lengths, all places that one part has in another, and that
            /// no sum over a row of factors can leave its accumulator.
            ///
            /// # Errors
            ///
            /// [`Error::Length`] or [`Error::Profile`] if the parts contradict each
            /// other, [`Error::Bound`] if a row of factors sums to 2^(BITS + 1) or more.
            pub const fn new(parts: Parts<'a, $format>) -> Result<Self, Error> {
                if let Err(error) = parts.fits() {
                    return Err(error);
                }
                let pairs = pair::count(parts.order);
                let mut rest = parts.factors;
                while let Some((row, tail)) = rest.split_at_checked(pairs) {
                    let (mut sum, mut numbers) = (0_u64, row);
                    while let [$format(number), others @ ..] = numbers {
                        sum += number.unsigned_abs() as u64;
                        numbers = others;
                    }
                    if sum >> ($bits + 1) != 0 {
                        return Err(Error::Bound);
                    }
                    if tail.is_empty() {
                        break;
                    }
                    rest = tail;
                }
                Ok(Self { parts })
            }
        }
    };
}
bounded!(Q15, 15);
bounded!(Q31, 31);

impl<'a, Q> Basis<'a, Q> {
    /// What it was made of.
    #[must_use]
    pub const fn parts(&self) -> &Parts<'a, Q> {
        &self.parts
    }

    /// Largest degree l of the light.
    #[must_use]
    pub const fn degree(&self) -> usize {
        self.parts.degree
    }

    /// Largest order o of the BRDF.
    #[must_use]
    pub const fn order(&self) -> usize {
        self.parts.order
    }

    /// Number of components K.
    #[must_use]
    pub const fn components(&self) -> usize {
        self.parts.components
    }

    /// Wide numbers that folding needs room for: S, its exponents, and one row
    /// with exponents.
    #[must_use]
    pub const fn workspace_len(&self) -> usize {
        (self.parts.degree + 1) * (pair::count(self.parts.order) + 3)
    }

    /// Numbers in a transfer: for each profile one for each l from |m| on.
    #[must_use]
    pub const fn transfer_len(&self) -> usize {
        let (mut sum, mut rest) = (0, self.parts.profiles);
        while let [profile, tail @ ..] = rest {
            sum += self.parts.degree + 1 - profile.azimuth as usize;
            rest = tail;
        }
        sum
    }

    /// Number of profiles.
    #[must_use]
    pub const fn profiles(&self) -> usize {
        self.parts.profiles.len()
    }

    /// Numbers in a collapsed scene.
    #[must_use]
    pub const fn scene_len(&self) -> usize {
        let (mut sum, mut azimuth) = (0, 0);
        while azimuth <= self.parts.degree {
            sum += self.parts.length(azimuth) * if azimuth == 0 { 1 } else { 2 };
            azimuth += 1;
        }
        sum
    }
}
