//! A fixed-point basis, whose shape and bounds were checked.

use super::Q15;
use crate::basis::signs;
use crate::error::{Argument, Error};
use crate::index::record::integers;
pub use crate::index::record::integers::Profile;
use crate::index::{layout, pair};
use crate::known_table::tail;

/// The arrays of a basis: [`Basis::new`] checks that they are consistent.
pub type Parts<'a> = integers::Parts<'a, Q15>;

/// An eigenbasis in fixed point.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Basis<'a> {
    pub(crate) parts: Parts<'a>,
}

impl Basis<'_> {
    /// Checks all lengths, and all positions by which one part refers to another.
    const fn fits(&self) -> Result<(), Error> {
        if let Err(error) = Error::check_shape(self.parts.degree, self.parts.order) {
            return Err(error);
        }
        let degrees = self.parts.degree.saturating_add(1);
        if let Err(error) = Error::check(Argument::Lengths, degrees, self.parts.lengths.len()) {
            return Err(error);
        }
        // Each profile needs a weight for +m and one for -m.
        if 2 * self.parts.profiles.len() > layout::MAX_WEIGHTS {
            return Err(Error::Bound);
        }
        let pairs = pair::count(self.parts.order);
        let (mut rows, mut terms, mut served, mut before) = (0, 0, 0, 0);
        let mut rest = self.parts.profiles;
        while let [profile, tail @ ..] = rest {
            let azimuth = profile.azimuth();
            let of_minus = profile.minus != Profile::NONE;
            if azimuth < before || azimuth > self.parts.degree || (azimuth == 0 && of_minus) {
                return Err(Error::Parts);
            }
            let orders = [profile.plus, profile.minus];
            let mut orders = orders.as_slice();
            while let [component, others @ ..] = orders {
                if *component != Profile::NONE {
                    let of_others = profile.plus == profile.minus || served_by(tail, *component);
                    if *component as usize >= self.parts.components || of_others {
                        return Err(Error::Parts);
                    }
                    served += 1;
                }
                orders = others;
            }
            rows = usize::saturating_add(rows, degrees - azimuth);
            terms = usize::saturating_add(terms, self.length(azimuth));
            (rest, before) = (tail, azimuth);
        }
        if served != self.parts.components {
            return Err(Error::Parts);
        }
        let (mut azimuth, mut azimuths, mut rest) = (0, self.parts.azimuths, self.parts.profiles);
        let [mut first, mut scene, mut of_terms, mut of_rows] = [0; 4];
        while azimuth <= self.parts.degree {
            let (mut profiles, length) = (0, self.length(azimuth));
            while let [profile, tail @ ..] = rest
                && profile.azimuth() == azimuth
            {
                (rest, profiles) = (tail, profiles + 1);
            }
            let [place, others @ ..] = azimuths else { return Err(Error::Parts) };
            if !place.is([first, profiles, scene, of_terms, of_rows]) {
                return Err(Error::Parts);
            }
            // The number of terms bounds the length of an azimuth with profiles.
            if profiles == 0
                && let Err(error) = Error::check(Argument::Lengths, 0, length)
            {
                return Err(error);
            }
            first += profiles;
            scene += signs(azimuth) * length;
            of_terms += profiles * length;
            of_rows += profiles * (degrees - azimuth);
            (azimuths, azimuth) = (others, azimuth + 1);
        }
        if !azimuths.is_empty() {
            return Err(Error::Parts);
        }
        let holds_transfers = self.parts.polar.is_empty() && self.parts.factors.is_empty();
        let (degrees, rows) = if holds_transfers { (0, 0) } else { (degrees, rows) };
        let polar = pairs.saturating_mul(degrees);
        Error::first(&[
            Error::check(Argument::Polar, polar, self.parts.polar.len()),
            Error::check(Argument::Polar, polar, self.parts.polar_exponents.len()),
            Error::check(Argument::Factors, pairs.saturating_mul(rows), self.parts.factors.len()),
            Error::check(Argument::Factors, rows, self.parts.factor_exponents.len()),
            Error::check(Argument::Terms, terms, self.parts.terms.len()),
        ])
    }
}

/// Whether one of these profiles belongs to this component.
const fn served_by(mut profiles: &[Profile], component: u16) -> bool {
    while let [profile, others @ ..] = profiles {
        if profile.plus == component || profile.minus == component {
            return true;
        }
        profiles = others;
    }
    false
}

impl<'a> Basis<'a> {
    /// The basis of these parts.
    ///
    /// Checks all lengths, all positions by which one part refers to another, that no sum over a
    /// row of factors can overflow its accumulator, and that no term of a profile is larger than
    /// the step that the profile states. Hence no sum of weighted terms can overflow its
    /// accumulator either.
    ///
    /// # Errors
    ///
    /// [`Error::High`] beyond degree 12 or order 12; [`Error::Length`] or [`Error::Parts`] if the
    /// parts are inconsistent; [`Error::Bound`] if a row of factors sums to 2^16 or more, if a term
    /// is larger than the largest step that its profile states, or if there are more than 511
    /// profiles.
    pub const fn new(parts: Parts<'a>) -> Result<Self, Error> {
        let basis = Self { parts };
        if let Err(error) = basis.fits() {
            return Err(error);
        }
        let pairs = pair::count(parts.order);
        let mut rest = parts.factors;
        while let Some((row, tail)) = rest.split_at_checked(pairs) {
            if !Self::bounds(row) {
                return Err(Error::Bound);
            }
            if tail.is_empty() {
                break;
            }
            rest = tail;
        }
        let (mut terms, mut profiles) = (parts.terms, parts.profiles);
        while let [profile, others @ ..] = profiles {
            let length = basis.length(profile.azimuth());
            let Some((row, tail)) = terms.split_at_checked(length) else { break };
            if !profile.states(Self::largest(row)) {
                return Err(Error::Bound);
            }
            (terms, profiles) = (tail, others);
        }
        Ok(basis)
    }

    const fn largest(row: &[Q15]) -> u64 {
        let (mut largest, mut numbers) = (0, row);
        while let [Q15(number), others @ ..] = numbers {
            let size = number.unsigned_abs() as u64;
            largest = if size > largest { size } else { largest };
            numbers = others;
        }
        largest
    }

    /// Whether the absolute values of a row sum to less than 2^16.
    pub(crate) const fn bounds(row: &[Q15]) -> bool {
        let (mut sum, mut numbers) = (0_u64, row);
        while let [Q15(number), others @ ..] = numbers {
            sum += number.unsigned_abs() as u64;
            numbers = others;
        }
        sum >> (Q15::BITS + 1) == 0
    }

    /// The parts of this basis.
    #[must_use]
    pub const fn parts(&self) -> &Parts<'a> {
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

    /// Workspace length of `transfer`, in numbers: S and one row, both with exponents.
    #[must_use]
    pub const fn workspace_len(&self) -> usize {
        pair::count(self.parts.order).saturating_add(3).saturating_mul(self.parts.degree + 1)
    }

    /// Length of a transfer: for each profile, one number for each l from |m| on.
    #[must_use]
    pub const fn transfer_len(&self) -> usize {
        let (mut sum, mut rest) = (0, self.parts.profiles);
        while let [profile, tail @ ..] = rest {
            let degrees = self.parts.degree + 1 - profile.azimuth();
            sum = usize::saturating_add(sum, degrees);
            rest = tail;
        }
        sum
    }

    /// The profiles of an azimuth.
    pub(crate) const fn profiles_of(&self, azimuth: usize) -> &'a [Profile] {
        let Some((_, [place, ..])) = self.parts.azimuths.split_at_checked(azimuth) else {
            return &[];
        };
        let profiles = tail(self.parts.profiles, place.first as usize);
        match profiles.split_at_checked(place.profiles as usize) {
            Some((profiles, _)) => profiles,
            None => profiles,
        }
    }

    /// Number of terms of an azimuth's polynomials.
    pub(crate) const fn length(&self, azimuth: usize) -> usize {
        match self.parts.lengths.split_at_checked(azimuth) {
            Some((_, [length, ..])) => *length as usize,
            _ => 0,
        }
    }

    /// Number of profiles.
    #[must_use]
    pub const fn profiles(&self) -> usize {
        self.parts.profiles.len()
    }

    /// Length of a collapsed scene.
    #[inline]
    #[must_use]
    pub const fn scene_len(&self) -> usize {
        let (mut sum, mut azimuth) = (0, 0);
        while azimuth <= self.parts.degree {
            sum += self.length(azimuth) * if azimuth == 0 { 1 } else { 2 };
            azimuth += 1;
        }
        sum
    }
}
