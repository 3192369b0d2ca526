//! The eigenbasis of one scene, as the runtime holds it.

use crate::error::{Error, What};
use crate::index::{layout, material, pair};

/// The arrays of a basis, as `eigenshade-table` writes them. [`Basis::new`]
/// checks that they fit together.
#[derive(Clone, Copy, Debug)]
pub struct Parts<'a, S> {
    /// Largest degree l of the light.
    pub degree: usize,
    /// Largest order o of the BRDF.
    pub order: usize,
    /// Number of components K.
    pub components: usize,
    /// Slant profiles, by |m|.
    pub profiles: &'a [ProfilePlace],
    /// How a transfer is laid out.
    pub passes: &'a [Pass],
    /// For each pass, profile and lane the number of its component, or one that
    /// the basis does not have.
    pub slots: &'a [u16],
    /// Number of polynomial terms for each |m|.
    pub lengths: &'a [u16],
    /// Which pairs each coefficient of the material couples.
    pub couplings: &'a [Coupling],
    /// √(o+1) N_l^q C_lo^q of (11): for each pair a row over l, `layout::groups`
    /// groups.
    pub polar: &'a [S],
    /// Factors of UᵀM: for each profile, each l from |m| on, a row of `layout::row`
    /// numbers, two profiles of an azimuth group by group beside each other.
    pub factors: &'a [S],
    /// For each profile its polynomial in t = 2z - 1, highest power first, times
    /// √2 where m is not 0.
    pub terms: &'a [S],
    /// The mean image's polynomial, or empty.
    pub mean: &'a [S],
    /// The mean image's coefficients, or empty.
    pub mean_coefficients: &'a [S],
    /// For each |m|, each (o, p, q), each l whether the mode is in; empty if all
    /// are.
    pub selection: &'a [bool],
}

/// A slant profile's azimuth, the components that it serves, and their rows in a
/// transfer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ProfilePlace {
    pub(crate) azimuth: u16,
    pub(crate) plus: Option<u16>,
    pub(crate) minus: Option<u16>,
    pub(crate) plus_row: Row,
    pub(crate) minus_row: Row,
}

impl ProfilePlace {
    /// The profile of `azimuth` |m| that serves component number `plus` with
    /// order +m (or 0) and `minus` with -m.
    #[must_use]
    pub const fn new(
        azimuth: u16,
        plus: Option<u16>,
        minus: Option<u16>,
        plus_row: Row,
        minus_row: Row,
    ) -> Self {
        Self { azimuth, plus, minus, plus_row, minus_row }
    }

    #[inline]
    pub(crate) const fn azimuth(self) -> usize {
        self.azimuth as usize
    }
}

/// Where the numbers of l = |m|, |m| + 1, ... of one component stand in a
/// transfer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    pub(crate) start: u32,
    pub(crate) step: u32,
}

impl Row {
    /// From `start` on, `step` apart.
    #[must_use]
    pub const fn new(start: u32, step: u32) -> Self {
        Self { start, step }
    }
}

/// The pairs that one coefficient b_op^q couples: polar integrals of (o, q) go into
/// the sum of (p, q), and the other way round.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Coupling {
    pub(crate) o: u16,
    pub(crate) p: u16,
}

impl Coupling {
    /// The places of (o, q) and of (p, q) among the pairs.
    #[must_use]
    pub const fn new(o: u16, p: u16) -> Self {
        Self { o, p }
    }
}

/// Part of a transfer: `LANES` orders m from `first` on, `profiles` of each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pass {
    pub(crate) first: i16,
    pub(crate) profiles: u16,
}

impl Pass {
    /// The orders from `first` on; at most [`layout::PASS`] profiles of each.
    #[must_use]
    pub const fn new(first: i16, profiles: u16) -> Self {
        Self { first, profiles }
    }

    /// Numbers of this pass in a transfer, or none if it does not fit the degree.
    const fn length(self, degree: usize) -> Option<usize> {
        let lowest = layout::lowest_degree(self.first as isize);
        let profiles = self.profiles as usize;
        if lowest > degree || profiles == 0 || profiles > layout::PASS {
            return None;
        }
        Some(layout::LANES * profiles * (degree + 1 - lowest))
    }
}

/// An eigenbasis: degree, order and number of components are values, the number
/// format is a type.
#[derive(Clone, Copy, Debug)]
pub struct Basis<'a, S> {
    pub(crate) parts: Parts<'a, S>,
    transfer: usize,
    scene: usize,
}

impl<'a, S> Basis<'a, S> {
    /// The basis of these parts.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] or [`Error::Profile`] if they contradict each other.
    pub const fn new(parts: Parts<'a, S>) -> Result<Self, Error> {
        let (mut factors, mut terms, mut scene) = (0, 0, 0);
        let (mut rest, mut before, mut run) = (parts.profiles, 0, 0);
        while let [place, tail @ ..] = rest {
            let azimuth = place.azimuth();
            if azimuth < before || !parts.serves(place) {
                return Err(Error::Profile);
            }
            // The first of every two profiles of an azimuth brings the place of both.
            run = if azimuth == before { run + 1 } else { 1 };
            if run % 2 == 1 {
                factors += layout::factors(parts.degree, parts.order, azimuth, 1);
            }
            terms += parts.length(azimuth);
            (rest, before) = (tail, azimuth);
        }
        let (mut transfer, mut slots) = (0, 0);
        let mut rest = parts.passes;
        while let [pass, tail @ ..] = rest {
            let Some(length) = pass.length(parts.degree) else {
                return Err(Error::Profile);
            };
            transfer += length;
            slots += layout::LANES * pass.profiles as usize;
            rest = tail;
        }
        let mut azimuth = 0;
        while azimuth <= parts.degree {
            scene += parts.length(azimuth) * if azimuth == 0 { 1 } else { 2 };
            azimuth += 1;
        }
        let group = layout::LANES * pair::count(parts.order);
        let selection = if parts.selection.is_empty() { 0 } else { parts.selection_length() };
        let mean = if parts.mean.is_empty() { 0 } else { parts.components };
        let mean_terms = if parts.mean.is_empty() { 0 } else { parts.length(0) };
        let checks = [
            Error::check(What::Slots, slots, parts.slots.len()),
            Error::check(What::Lengths, parts.degree + 1, parts.lengths.len()),
            Error::check(What::Polar, group * layout::groups(parts.degree), parts.polar.len()),
            Error::check(What::Factors, factors, parts.factors.len()),
            Error::check(What::Terms, terms, parts.terms.len()),
            Error::check(What::Mean, mean_terms, parts.mean.len()),
            Error::check(What::Mean, mean, parts.mean_coefficients.len()),
            Error::check(What::Selection, selection, parts.selection.len()),
        ];
        let mut rest = checks.as_slice();
        while let [check, tail @ ..] = rest {
            if let Err(error) = check {
                return Err(*error);
            }
            rest = tail;
        }
        Ok(Self { parts, transfer, scene })
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

    /// Numbers that a projection needs room for: the material's polar integrals,
    /// once along l and once along the pairs, and two coefficients of the light for
    /// each l.
    #[must_use]
    pub const fn workspace_len(&self) -> usize {
        (self.parts.degree + 1) * (layout::row(self.parts.order) + 2) + self.sums_len()
    }

    /// Numbers of the polar integrals along l, the pairs padded.
    pub(crate) const fn sums_len(&self) -> usize {
        layout::row(self.parts.order) * layout::LANES * layout::groups(self.parts.degree)
    }

    /// Numbers in a transfer.
    #[must_use]
    pub const fn transfer_len(&self) -> usize {
        self.transfer
    }

    /// Numbers in a collapsed scene.
    #[must_use]
    pub const fn scene_len(&self) -> usize {
        self.scene
    }
}

impl<S> Parts<'_, S> {
    /// Whether a place's azimuth and components exist.
    const fn serves(&self, place: &ProfilePlace) -> bool {
        let plus = match place.plus {
            Some(index) => (index as usize) < self.components,
            None => true,
        };
        let minus = match place.minus {
            Some(index) => (index as usize) < self.components && place.azimuth > 0,
            None => true,
        };
        place.azimuth() <= self.degree && plus && minus
    }

    /// Terms of the polynomials of an azimuth; 0 if it has none.
    pub(crate) const fn length(&self, azimuth: usize) -> usize {
        match self.lengths.split_at_checked(azimuth) {
            Some((_, [length, ..])) => *length as usize,
            _ => 0,
        }
    }

    /// Length of a selection.
    const fn selection_length(&self) -> usize {
        (self.degree + 1) * material::count(self.order) * (self.degree + 1)
    }
}
