//! The arrays that make up a basis.

use crate::error::{Argument, Error};
use crate::index::effect::Effects;
use crate::index::layout;
use zerocopy::{FromBytes, Immutable, KnownLayout};

/// The arrays of a basis, as `eigenshade-table` writes them. [`Basis::new`](crate::Basis::new)
/// checks that they are consistent.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Parts<'a, S> {
    /// Largest degree l of the light.
    pub degree: usize,
    /// Largest order o of the BRDF.
    pub order: usize,
    /// The effects that the basis covers.
    pub effects: Effects,
    /// Number of components K.
    pub components: usize,
    /// Slant profiles, in order of |m|.
    pub profiles: &'a [ProfilePlace],
    /// The layout of a transfer.
    pub passes: &'a [Pass],
    /// For each pass, profile and lane, the number of its component, or a number that the basis
    /// does not have.
    pub slots: &'a [u16],
    /// Number of polynomial terms for each |m|.
    pub lengths: &'a [u16],
    /// The pairs that each coefficient of the material couples, in the order of
    /// [`index::material`](crate::index::material), up to the largest order that the effects
    /// factor. Coefficients that are not factored have [`Coupling::NONE`].
    pub couplings: &'a [Coupling],
    /// √(o+1) N_l^q C_lo^q of (11): for each pair a row over l, padded to `layout::groups` groups.
    /// Both this and `factors` are empty in a basis that only holds transfers.
    pub polar: &'a [S],
    /// Factors of UᵀM: for each profile and each l from |m| on, a row of `layout::row` numbers. The
    /// profiles of an azimuth are taken in twos, whose rows alternate group by group; if their
    /// number is odd, the last profile is paired with zeros.
    pub factors: &'a [S],
    /// For each profile of m = 0, a row of UᵀM over the coefficients that are
    /// [not factored](crate::index::effect::Effects::unfactored); empty if all are.
    pub ambient: &'a [S],
    /// For each profile, its polynomial in t = 2z - 1, highest term first, times √2 if m is not 0.
    /// If its azimuth has a [recurrence](layout::Recurrence), the terms refer to the polynomials of
    /// that recurrence; otherwise they have the form of their length, [`layout::Form::of`].
    pub terms: &'a [S],
    /// Recurrences of the last azimuths (see [`layout::recurrences`]), or empty.
    pub recurrences: &'a [layout::Recurrence],
    /// The mean image's polynomial, or empty.
    pub mean: &'a [S],
    /// The mean image's coefficients, or empty.
    pub mean_coefficients: &'a [S],
    /// For each |m|, each (o, p, q) and each l, whether the mode is selected; empty if all modes
    /// are.
    pub selection: &'a [bool],
}

/// A slant profile: its azimuth, the components that use it, and their rows in a transfer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, FromBytes, Immutable, KnownLayout)]
#[repr(C)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ProfilePlace {
    pub(crate) azimuth: u16,
    plus: u16,
    minus: u16,
    pub(crate) plus_row: Row,
    pub(crate) minus_row: Row,
}

/// Marks a missing component.
const NONE: u16 = u16::MAX;

/// The number of a component, or [`NONE`].
const fn number(component: Option<u16>) -> u16 {
    match component {
        Some(component) => component,
        None => NONE,
    }
}

/// The component with this number.
const fn component(number: u16) -> Option<u16> {
    match number {
        NONE => None,
        component => Some(component),
    }
}

impl ProfilePlace {
    /// The profile of `azimuth` |m|, used by component number `plus` with order +m (or 0) and by
    /// component number `minus` with order -m. Component number 65,535 means none.
    #[must_use]
    pub const fn new(
        azimuth: u16,
        plus: Option<u16>,
        minus: Option<u16>,
        plus_row: Row,
        minus_row: Row,
    ) -> Self {
        Self { azimuth, plus: number(plus), minus: number(minus), plus_row, minus_row }
    }

    #[inline]
    pub(crate) const fn plus(self) -> Option<u16> {
        component(self.plus)
    }

    #[inline]
    pub(crate) const fn minus(self) -> Option<u16> {
        component(self.minus)
    }

    /// The row of the component of this sign.
    pub(crate) const fn row(self, sign: isize) -> Row {
        if sign < 0 { self.minus_row } else { self.plus_row }
    }

    /// The number of the component of this sign, or one that no basis has.
    pub(crate) const fn component(self, sign: isize) -> u16 {
        if sign < 0 { self.minus } else { self.plus }
    }

    #[inline]
    pub(crate) const fn azimuth(self) -> usize {
        self.azimuth as usize
    }
}

/// The positions in a transfer of one component's numbers for l = |m|, |m| + 1, ...
#[derive(Clone, Copy, Debug, PartialEq, Eq, FromBytes, Immutable, KnownLayout)]
#[repr(C)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Row {
    pub(crate) start: u32,
    pub(crate) step: u32,
}

impl Row {
    /// The row whose numbers begin at `start` and are `step` apart.
    #[must_use]
    pub const fn new(start: u32, step: u32) -> Self {
        Self { start, step }
    }
}

/// The pairs that one coefficient b_op^q couples: polar integrals of (o, q) are added to the sum of
/// (p, q), and vice versa.
#[derive(Clone, Copy, Debug, PartialEq, Eq, FromBytes, Immutable, KnownLayout)]
#[repr(C)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Coupling {
    pub(crate) o: u16,
    pub(crate) p: u16,
}

impl Coupling {
    /// The coupling of a coefficient that the effects of the basis do not factor.
    pub const NONE: Self = Self { o: u16::MAX, p: u16::MAX };

    /// The coupling of the pairs (o, q) and (p, q), given by their positions among the pairs.
    #[must_use]
    pub const fn new(o: u16, p: u16) -> Self {
        Self { o, p }
    }
}

/// Part of a transfer: `LANES` orders m beginning with `first`, with `profiles` profiles each.
#[derive(Clone, Copy, Debug, PartialEq, Eq, FromBytes, Immutable, KnownLayout)]
#[repr(C)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Pass {
    pub(crate) first: i16,
    pub(crate) profiles: u16,
}

impl Pass {
    /// The pass of the orders from `first` on. `first` is a multiple of [`layout::LANES`], and
    /// there are at most [`layout::PASS`] profiles for each order.
    #[must_use]
    pub const fn new(first: i16, profiles: u16) -> Self {
        Self { first, profiles }
    }

    /// Number of slots, which is the number of entries for one degree.
    pub(crate) const fn slots(self) -> usize {
        layout::LANES * self.profiles as usize
    }

    /// Numbers of this pass in a transfer, or `None` if it does not fit the layout or the degree.
    pub(crate) const fn length(self, degree: usize) -> Option<usize> {
        let first = self.first as isize;
        let lowest = layout::lowest_degree(first);
        let aligned = first == layout::first_order(first);
        let profiles = self.profiles as usize;
        if !aligned || lowest > degree || profiles == 0 || profiles > layout::PASS {
            return None;
        }
        Some(self.slots() * (degree + 1 - lowest))
    }
}

/// Recurrences by azimuth (see [`layout::recurrences`]).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Recurrences<'a> {
    /// The first azimuth that has a recurrence.
    first: usize,
    /// Entries of each recurrence.
    stride: usize,
    numbers: &'a [layout::Recurrence],
}

impl<'a> Recurrences<'a> {
    /// No azimuth has a recurrence.
    pub const NONE: Self = Self { first: usize::MAX, stride: 0, numbers: &[] };

    /// The recurrences for polynomials of these lengths.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless each azimuth has as many entries as the longest polynomial has
    /// terms; [`Error::Series`] without the feature `series`.
    pub const fn new(lengths: &[u16], numbers: &'a [layout::Recurrence]) -> Result<Self, Error> {
        match layout::recurrences(lengths, numbers.len()) {
            Some([_, _]) if numbers.is_empty() => Ok(Self::NONE),
            Some(_) if !cfg!(feature = "series") => Err(Error::Series),
            Some([first, stride]) => Ok(Self { first, stride, numbers }),
            None => Err(Error::Length {
                argument: Argument::Recurrences,
                expected: 0,
                found: numbers.len(),
            }),
        }
    }

    /// The first azimuth that has a recurrence, or a number above all azimuths.
    pub(crate) const fn first(&self) -> usize {
        self.first
    }

    /// Whether no azimuth has one.
    #[inline]
    pub(crate) const fn is_empty(&self) -> bool {
        !cfg!(feature = "series") || self.numbers.is_empty()
    }

    /// The recurrence of an azimuth, or empty.
    #[inline]
    pub(crate) fn of(&self, azimuth: usize) -> &'a [layout::Recurrence] {
        if self.is_empty() {
            return &[];
        }
        let row = azimuth.checked_sub(self.first);
        let start = row.and_then(|row| row.checked_mul(self.stride));
        let rest = start.and_then(|start| self.numbers.get(start..));
        rest.and_then(|rest| rest.get(..self.stride)).unwrap_or_default()
    }
}

impl<S> Parts<'_, S> {
    /// Number of terms of an azimuth's polynomials; 0 if it has none.
    pub(crate) const fn length(&self, azimuth: usize) -> usize {
        match self.lengths.split_at_checked(azimuth) {
            Some((_, [length, ..])) => *length as usize,
            _ => 0,
        }
    }
}
