//! The eigenbasis of one scene.

use crate::error::{Argument, Error};
use crate::index::effect::Effects;
use crate::index::record::floats;
use crate::index::record::{Coupling, ProfilePlace, Row};
use crate::index::{layout, material, pair};
use crate::invariant::split_row;

/// The arrays of a basis: [`Basis::new`] checks that they are consistent.
pub type Parts<'a> = floats::Parts<'a, f32>;

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
    /// This checks all lengths, and all indices from one part into another. An azimuth without a
    /// profile must have length 0. The numbers themselves are not checked, nor that no two profiles
    /// serve the same component.
    ///
    /// # Errors
    ///
    /// [`Error::High`] beyond degree 12 or order 12, or [`Error::Length`], [`Error::Coupling`],
    /// [`Error::Profile`] or [`Error::Pass`] if the parts contradict each other. A polynomial has at
    /// most 40 terms.
    pub const fn new(parts: Parts<'a>) -> Result<Self, Error> {
        // These come first because they bound the counts below.
        if let Err(error) = Error::check_shape(parts.degree, parts.order) {
            return Err(error);
        }
        let basis = Self { parts, transfer: 0, scene: 0 };
        let parts = &basis.parts;
        let (degrees, factored) = (parts.degree.saturating_add(1), basis.factored_order());
        let couplings = material::count(factored);
        if let Err(error) = Error::check(Argument::Lengths, degrees, parts.lengths.len()) {
            return Err(error);
        }
        if let Err(error) = Error::check(Argument::Couplings, couplings, parts.couplings.len()) {
            return Err(error);
        }
        if !basis.couples() {
            return Err(Error::Coupling);
        }
        let (mut served, mut zonal) = (0, 0);
        let (mut factors, mut terms, mut scene) = (0, 0, 0);
        let (mut rest, mut before, mut run) = (parts.profiles, 0, 0);
        while let [place, tail @ ..] = rest {
            let azimuth = place.azimuth();
            if azimuth < before || !basis.serves(place) {
                return Err(Error::Profile);
            }
            // Factors are stored for two profiles of an azimuth at a time: the first of the two
            // adds the length of both.
            run = if azimuth == before { run + 1 } else { 1 };
            if run % 2 == 1 {
                let more = layout::factors(parts.degree, factored, azimuth, 1);
                factors = usize::saturating_add(factors, more);
            }
            terms = usize::saturating_add(terms, basis.length(azimuth));
            zonal += (azimuth == 0) as usize;
            served += place.plus().is_some() as usize + place.minus().is_some() as usize;
            (rest, before) = (tail, azimuth);
        }
        let (mut transfer, mut slots) = (0, 0);
        let mut rest = parts.passes;
        while let [pass, tail @ ..] = rest {
            let Some(length) = pass.length(parts.degree) else {
                return Err(Error::Pass);
            };
            transfer = usize::saturating_add(transfer, length);
            slots += pass.slots();
            rest = tail;
        }
        let (mut azimuth, mut rest) = (0, parts.profiles);
        while azimuth <= parts.degree {
            let (signs, mut has_terms) =
                if azimuth == 0 { (1, !parts.mean.is_empty()) } else { (2, false) };
            while let [place, tail @ ..] = rest
                && place.azimuth() == azimuth
            {
                (rest, has_terms) = (tail, true);
            }
            // An azimuth with terms needs no check, since its terms bound its length.
            if !has_terms
                && let Err(error) = Error::check(Argument::Lengths, 0, basis.length(azimuth))
            {
                return Err(error);
            }
            let found = basis.length(azimuth);
            if found > layout::MAX_TERMS {
                let (argument, expected) = (Argument::Lengths, layout::MAX_TERMS);
                return Err(Error::Length { argument, expected, found });
            }
            scene = usize::saturating_add(scene, signs * found);
            azimuth += 1;
        }
        let group = layout::LANES * pair::count(factored);
        // A basis that holds only transfers has neither polar integrals nor factors.
        let holds_transfers = parts.polar.is_empty() && parts.factors.is_empty();
        let polar = if holds_transfers { 0 } else { group * layout::groups(parts.degree) };
        let factors = if holds_transfers { 0 } else { factors };
        let unfactored = if holds_transfers { 0 } else { basis.unfactored_count() };
        let selection = if parts.selection.is_empty() { 0 } else { basis.selection_length() };
        let mean = if parts.mean.is_empty() { 0 } else { parts.components };
        let mean_terms = if parts.mean.is_empty() { 0 } else { basis.length(0) };
        let checked = Error::first(&[
            Error::check(Argument::Slots, slots, parts.slots.len()),
            Error::check(Argument::Polar, polar, parts.polar.len()),
            Error::check(Argument::Factors, factors, parts.factors.len()),
            Error::check(Argument::Ambient, zonal * unfactored, parts.ambient.len()),
            Error::check(Argument::Terms, terms, parts.terms.len()),
            Error::check(Argument::Mean, mean_terms, parts.mean.len()),
            Error::check(Argument::Mean, mean, parts.mean_coefficients.len()),
            Error::check(Argument::Selection, selection, parts.selection.len()),
        ]);
        if let Err(error) = checked {
            return Err(error);
        }
        if served != parts.components {
            return Err(Error::Profile);
        }
        if !basis.places() {
            return Err(Error::Pass);
        }
        Ok(Self { transfer, scene, ..basis })
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

    /// The effects that this basis covers.
    #[must_use]
    pub const fn effects(&self) -> Effects {
        self.parts.effects
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

    /// Length of the workspace that a projection needs. It holds the material's polar integrals,
    /// once along l and once along the pairs, and two coefficients of the light for each l.
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
        layout::row(self.factored_order())
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

    /// The largest order o of the factors: the order of the basis unless effects are left out.
    pub(crate) const fn factored_order(&self) -> usize {
        self.parts.effects.factored_order(self.parts.order)
    }

    pub(crate) const fn unfactored_count(&self) -> usize {
        self.parts.effects.unfactored_count(self.parts.order)
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

    /// Whether the couplings match the order of the basis, coefficient by coefficient.
    const fn couples(&self) -> bool {
        let (mut o, mut p, mut q) = (0, 0, 0);
        let mut rest = self.parts.couplings;
        while let [coupling, tail @ ..] = rest {
            let none = coupling.o == Coupling::NONE.o && coupling.p == Coupling::NONE.p;
            let same = coupling.o as usize == pair::position(o, q)
                && coupling.p as usize == pair::position(p, q);
            let fits = if self.parts.effects.factored(o) { same } else { none };
            if !fits {
                return false;
            }
            (o, p, q) = match (q < p, p < o) {
                (true, _) => (o, p, q + 2),
                (false, true) => (o, p + 2, o % 2),
                (false, false) => (o + 1, (o + 1) % 2, (o + 1) % 2),
            };
            rest = tail;
        }
        true
    }

    /// Whether the slots contain exactly the components, each where its profile has its row.
    const fn places(&self) -> bool {
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
        let (mut passes, mut slots, mut start) =
            (self.parts.passes, self.parts.slots, row.start as usize);
        while let [pass, tail @ ..] = passes {
            let (Some(length), Some((of_pass, others))) =
                (pass.length(self.parts.degree), slots.split_at_checked(pass.slots()))
            else {
                return false;
            };
            if start >= length {
                (passes, slots, start) = (tail, others, start - length);
                continue;
            }
            let (first, step) = (pass.first as isize, pass.slots());
            if layout::first_order(order) != first || row.step as usize != step {
                return false;
            }
            // Skip the numbers between the pass's lowest degree and degree |m|.
            let skipped = step * (order.unsigned_abs() - layout::lowest_degree(first));
            let Some(slot) = start.checked_sub(skipped) else { return false };
            let in_lane = slot % layout::LANES == (order - first).unsigned_abs();
            let Some((_, [found, ..])) = of_pass.split_at_checked(slot) else { return false };
            return in_lane
                && match component {
                    Some(component) => *found == component,
                    None => *found as usize >= self.parts.components,
                };
        }
        false
    }

    const fn selection_length(&self) -> usize {
        let degrees = self.parts.degree + 1;
        degrees.saturating_mul(degrees).saturating_mul(material::count(self.parts.order))
    }
}
