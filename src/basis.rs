//! The eigenbasis of one scene.

use crate::checked_slice::split_row;
use crate::error::{Argument, Error};
use crate::index::record::floats;
use crate::index::record::{ProfilePlace, Row};
use crate::index::{layout, pair};

/// The arrays of a basis: [`Basis::new`] checks that they are consistent.
pub type Parts<'a> = floats::Parts<'a, f32>;

/// Number of polynomials of an azimuth.
pub(crate) const fn signs(azimuth: usize) -> usize {
    if azimuth == 0 { 1 } else { 2 }
}

/// An eigenbasis. Degree, order and number of components are values.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Basis<'a> {
    pub(crate) parts: Parts<'a>,
    transfer: usize,
    scene: usize,
}

impl<'a> Basis<'a> {
    /// Creates a basis from its parts.
    ///
    /// Checks all lengths, and all positions from one part into another. An azimuth without a
    /// profile must have length 0. Neither the numbers themselves are checked, nor whether two
    /// profiles belong to the same component.
    ///
    /// # Errors
    ///
    /// [`Error::High`] beyond degree 12 or order 12; [`Error::Length`] or [`Error::Parts`] if the
    /// parts contradict each other. A polynomial has at most 40 terms.
    pub const fn new(parts: Parts<'a>) -> Result<Self, Error> {
        // These come first because they bound the counts below.
        if let Err(error) = Error::check_shape(parts.degree, parts.order) {
            return Err(error);
        }
        let degrees = parts.degree + 1;
        if let Err(error) = Error::check(Argument::Lengths, degrees, parts.lengths.len()) {
            return Err(error);
        }
        let [scene, terms, rows] = match (Self { parts, transfer: 0, scene: 0 }).lengths() {
            Ok(lengths) => lengths,
            Err(error) => return Err(error),
        };
        let (mut transfer, mut slots) = (0, 0);
        let mut passes = parts.passes;
        while let [pass, others @ ..] = passes {
            let Some(length) = pass.length(parts.degree) else { return Err(Error::Parts) };
            if pass.start as usize != transfer || pass.slots as usize != slots {
                return Err(Error::Parts);
            }
            (transfer, slots) = (usize::saturating_add(transfer, length), slots + pass.width());
            passes = others;
        }
        let basis = Self { parts, transfer, scene };
        // A basis that holds only transfers has neither polar integrals nor factors.
        let (polar, row) = if parts.polar.is_empty() && parts.factors.is_empty() {
            (0, 0)
        } else {
            (layout::LANES * pair::count(parts.order) * layout::groups(parts.degree), basis.row())
        };
        let checked = Error::first(&[
            Error::check(Argument::Slots, slots, parts.slots.len()),
            Error::check(Argument::Polar, polar, parts.polar.len()),
            Error::check(Argument::Factors, rows.saturating_mul(row), parts.factors.len()),
            Error::check(Argument::Terms, terms, parts.terms.len()),
        ]);
        if let Err(error) = checked {
            return Err(error);
        }
        if basis.has_rows() && basis.has_runs() { Ok(basis) } else { Err(Error::Parts) }
    }

    /// Checks the profiles and the positions of each azimuth. Returns the lengths of a scene, of the
    /// terms and, in rows, of the factors.
    const fn lengths(&self) -> Result<[usize; 3], Error> {
        let parts = &self.parts;
        let (mut first, mut served) = (0, 0);
        let [mut scene, mut terms, mut rows] = [0_usize; 3];
        let (mut azimuth, mut azimuths, mut rest) = (0, parts.azimuths, parts.profiles);
        while azimuth <= parts.degree {
            let mut profiles = 0;
            while let [profile, tail @ ..] = rest
                && profile.azimuth() == azimuth
            {
                if !self.serves(profile) {
                    return Err(Error::Parts);
                }
                served += profile.plus().is_some() as usize + profile.minus().is_some() as usize;
                (rest, profiles) = (tail, profiles + 1);
            }
            let [place, others @ ..] = azimuths else { return Err(Error::Parts) };
            if !place.is([first, profiles, scene, terms, rows]) {
                return Err(Error::Parts);
            }
            let found = self.length(azimuth);
            // The number of terms bounds the length of an azimuth with profiles.
            let expected = if profiles == 0 { 0 } else { layout::MAX_TERMS };
            if found > expected {
                let argument = Argument::Lengths;
                return Err(Error::Length { argument, expected, found });
            }
            first += profiles;
            scene += signs(azimuth) * found;
            terms = terms.saturating_add(profiles.saturating_mul(found));
            rows = rows.saturating_add(layout::rows(parts.degree, azimuth, profiles));
            (azimuths, azimuth) = (others, azimuth + 1);
        }
        if rest.is_empty() && azimuths.is_empty() && served == parts.components {
            Ok([scene, terms, rows])
        } else {
            Err(Error::Parts)
        }
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

    /// Whether this basis can project new materials. If not, it can only relight its own transfers.
    #[must_use]
    pub const fn projects(&self) -> bool {
        !self.parts.polar.is_empty()
    }

    /// Length of the workspace that a projection needs: the material's polar integrals, once along
    /// l and once along the pairs, and two coefficients of the light for each l.
    #[must_use]
    pub const fn workspace_len(&self) -> usize {
        (self.parts.degree + 1) * (self.row() + 2) + self.sums_len()
    }

    /// Length of the polar integrals along l, with padded pairs.
    pub(crate) const fn sums_len(&self) -> usize {
        self.row() * layout::LANES * layout::groups(self.parts.degree)
    }

    /// Length of a row over the pairs.
    pub(crate) const fn row(&self) -> usize {
        layout::row(self.parts.order)
    }

    /// Length of a transfer.
    #[must_use]
    pub const fn transfer_len(&self) -> usize {
        self.transfer
    }

    /// Number of azimuths |m| of a scene, including 0.
    #[must_use]
    pub const fn azimuths(&self) -> usize {
        self.parts.lengths.len()
    }

    /// Length of a collapsed scene.
    #[must_use]
    pub const fn scene_len(&self) -> usize {
        self.scene
    }

    /// Each profile, with the terms of its polynomial.
    #[inline]
    pub(crate) fn profiles(&self) -> impl Iterator<Item = (&'a ProfilePlace, &'a [f32])> {
        let mut terms = self.parts.terms;
        self.parts.profiles.iter().map(move |place| {
            let (of_profile, rest) = split_row(terms, self.length(place.azimuth()));
            terms = rest;
            (place, of_profile)
        })
    }

    /// Number of terms of an azimuth's polynomials.
    pub(crate) const fn length(&self, azimuth: usize) -> usize {
        match self.parts.lengths.split_at_checked(azimuth) {
            Some((_, [length, ..])) => *length as usize,
            _ => 0,
        }
    }

    /// Whether the azimuth and the components of a profile exist.
    const fn serves(&self, place: &ProfilePlace) -> bool {
        let plus = match place.plus() {
            Some(index) => (index as usize) < self.parts.components,
            None => true,
        };
        let minus = match place.minus() {
            Some(index) => (index as usize) < self.parts.components && place.azimuth() > 0,
            None => true,
        };
        place.azimuth() <= self.parts.degree && plus && minus
    }

    /// Whether the slots contain exactly the components, each where its profile has its row.
    const fn has_rows(&self) -> bool {
        let (mut rest, mut given) = (self.parts.slots, 0);
        while let [slot, tail @ ..] = rest {
            given += ((*slot as usize) < self.parts.components) as usize;
            rest = tail;
        }
        let mut rest = self.parts.profiles;
        while let [place, tail @ ..] = rest {
            let order = place.azimuth().cast_signed();
            let (plus, minus) = (place.plus_row, place.minus_row);
            let of_minus = if order == 0 {
                plus.start == minus.start && plus.step == minus.step
            } else {
                self.gives(minus, -order, place.minus())
            };
            if !of_minus || !self.gives(plus, order, place.plus()) {
                return false;
            }
            rest = tail;
        }
        given == self.parts.components
    }

    /// Whether a row belongs to this order and its slot holds this component.
    const fn gives(&self, row: Row, order: isize, component: Option<u16>) -> bool {
        let mut passes = self.parts.passes;
        while let [pass, others @ ..] = passes {
            passes = others;
            let (first, step) = (pass.first as isize, pass.width());
            // Skip the numbers between the pass's lowest degree and degree |m|.
            let skipped =
                step * (order.unsigned_abs().saturating_sub(layout::lowest_degree(first)));
            let Some(slot) = (row.start as usize).checked_sub(pass.start as usize + skipped) else {
                continue;
            };
            if layout::first_order(order) != first || slot >= step {
                continue;
            }
            let Some((_, of_pass)) = self.parts.slots.split_at_checked(pass.slots as usize) else {
                return false;
            };
            let Some((_, [found, ..])) = of_pass.split_at_checked(slot) else { return false };
            return row.step as usize == step
                && slot % layout::LANES == (order - first).unsigned_abs()
                && match component {
                    Some(component) => *found == component,
                    None => *found as usize >= self.parts.components,
                };
        }
        false
    }

    /// Whether the runs are the rows of the profiles, order by order.
    const fn has_runs(&self) -> bool {
        let (mut profile, mut of_azimuth, mut sign) = (0, 0, 1);
        let mut runs = self.parts.runs;
        while let [run, others @ ..] = runs {
            let Some((before, [first, ..])) = self.parts.profiles.split_at_checked(profile) else {
                return false;
            };
            if let [.., last] = before
                && last.azimuth != first.azimuth
            {
                of_azimuth = profile;
            }
            let order = sign * first.azimuth().cast_signed();
            let Row { start, step } = first.row(sign);
            let same = run.order as isize == order && run.first as usize == profile;
            let placed = run.start == start && run.step as u32 == step;
            if !same || !placed || !run.fits() {
                return false;
            }
            let mut count = 0;
            while count < run.profiles as usize {
                let Some((_, [next, ..])) = self.parts.profiles.split_at_checked(profile) else {
                    return false;
                };
                let row = next.row(sign);
                let beside = row.start == start + (layout::LANES * count) as u32;
                if next.azimuth != first.azimuth || !beside || row.step != step {
                    return false;
                }
                (profile, count) = (profile + 1, count + 1);
            }
            // The opposite order follows the last profile of an azimuth.
            let ends = match self.parts.profiles.split_at_checked(profile) {
                Some((_, [next, ..])) => next.azimuth != first.azimuth,
                _ => true,
            };
            if ends && first.azimuth > 0 {
                sign = -sign;
                profile = if sign < 0 { of_azimuth } else { profile };
            }
            runs = others;
        }
        profile == self.parts.profiles.len() && sign > 0
    }
}
