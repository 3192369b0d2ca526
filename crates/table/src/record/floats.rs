//! The record of a basis in floats.

use super::{Azimuth, Item, NONE, Word, item, record};
use crate::layout;
use zerocopy::{FromBytes, Immutable, KnownLayout};

record! {
    /// The arrays of a basis. `Basis::new` of the runtime checks that they are consistent.
    "eigenshade::wire::Parts" Parts OwnedParts
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
        profiles: [ProfilePlace],
        /// For each |m|, where its profiles, factors and terms are.
        azimuths: [Azimuth],
        /// The layout of a transfer, in groups of orders.
        passes: [Pass],
        /// The layout of a transfer, order by order: 0, 1, -1, 2, -2, ...
        runs: [Run],
        /// For each pass, profile and lane, the number of its component, or a number that the basis
        /// does not have.
        slots: [u16],
        /// Number of polynomial terms for each |m|.
        lengths: [u16],
        /// √(o+1) N_l^q C_lo^q of (11): for each pair a row over l, padded to `layout::groups`
        /// groups. Both `polar` and `factors` are empty in a basis that only holds transfers.
        polar: [S],
        /// Factors of UᵀM: for each profile and each l from |m| on, a row of `layout::row` numbers.
        /// The profiles of an azimuth are taken in twos, whose rows alternate group by group; if
        /// their number is odd, the last profile is paired with zeros.
        factors: [S],
        /// For each profile, its polynomial in t = 2z - 1 and u = 2t² - 1, times √2 if m is not 0:
        /// the factors of ..., tu, u, t, 1.
        terms: [S],
    }
}

item! {
    /// A slant profile: its azimuth, the components that use it, and their rows in a transfer.
    ProfilePlace {
        /// |m|.
        azimuth: u16,
        /// The component of +m, or of 0; [`NONE`] if there is none.
        plus: u16,
        /// The component of -m, or [`NONE`].
        minus: u16,
        /// The row of +m in a transfer.
        plus_row: Row,
        /// The row of -m in a transfer; for m = 0 the row of +m.
        minus_row: Row,
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
    /// The component of +m, or of 0.
    #[inline]
    #[must_use]
    pub const fn plus(self) -> Option<u16> {
        component(self.plus)
    }

    /// The component of -m.
    #[inline]
    #[must_use]
    pub const fn minus(self) -> Option<u16> {
        component(self.minus)
    }

    /// The numbers of the components of +m and of -m, or [`NONE`].
    #[inline]
    #[must_use]
    pub const fn components(self) -> [u16; 2] {
        [self.plus, self.minus]
    }

    /// The row of the component of this sign.
    #[must_use]
    pub const fn row(self, sign: isize) -> Row {
        if sign < 0 { self.minus_row } else { self.plus_row }
    }

    /// |m|.
    #[inline]
    #[must_use]
    pub const fn azimuth(self) -> usize {
        self.azimuth as usize
    }
}

item! {
    /// The positions in a transfer of one component's numbers for l = |m|, |m| + 1, ...
    #[derive(Default)]
    Row {
        /// Position of l = |m|.
        start: u32,
        /// Distance from one l to the next.
        step: u32,
    }
}

item! {
    /// Part of a transfer: [`layout::LANES`] orders m beginning with `first`, with `profiles`
    /// profiles each.
    Pass {
        /// The first order, a multiple of [`layout::LANES`].
        first: i16,
        /// Number of profiles of each order, at most [`layout::PASS`].
        profiles: u16,
        /// Position of the pass's numbers in a transfer.
        start: u32,
        /// Position of the pass's components among the slots.
        slots: u32,
    }
}

item! {
    /// Part of a transfer: profiles of one order whose rows stand side by side, [`layout::LANES`]
    /// numbers from one to the next.
    Run {
        /// The order m.
        order: i16,
        /// Number of profiles, at most [`layout::PASS`].
        profiles: u16,
        /// The number of the run's first profile.
        first: u16,
        /// Distance from one degree to the next.
        step: u16,
        /// Position of the number of the first profile and l = |m|.
        start: u32,
    }
}

impl Run {
    /// Whether a table may have a run of this order and number of profiles.
    #[must_use]
    pub const fn fits(self) -> bool {
        self.profiles > 0
            && self.profiles as usize <= layout::PASS
            && self.order.unsigned_abs() as usize <= layout::MAX_DEGREE
    }
}

impl Pass {
    /// Number of entries for one degree.
    #[must_use]
    pub const fn width(self) -> usize {
        layout::LANES * self.profiles as usize
    }

    /// Numbers of this pass in a transfer, or `None` if it does not fit the layout or the degree.
    #[must_use]
    pub const fn length(self, degree: usize) -> Option<usize> {
        let first = self.first as isize;
        let lowest = layout::lowest_degree(first);
        let aligned = first == layout::first_order(first);
        let profiles = self.profiles as usize;
        if !aligned || lowest > degree || profiles == 0 || profiles > layout::PASS {
            return None;
        }
        Some(self.width() * (degree + 1 - lowest))
    }
}
