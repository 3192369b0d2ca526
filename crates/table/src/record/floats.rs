//! The record of a basis in floats, and that of eigenimages over a span.

use super::{Item, NONE, Word, item, record};
use crate::effect::Effects;
use crate::layout;
use zerocopy::{FromBytes, Immutable, KnownLayout};

record! {
    /// The arrays of a basis. `Basis::new` of the runtime checks that they are consistent.
    "eigenshade::Parts" Parts OwnedParts
    sizes {
        /// Largest degree l of the light.
        degree: usize,
        /// Largest order o of the BRDF.
        order: usize,
        /// The effects that the basis covers.
        effects: Effects,
        /// Number of components K.
        components: usize,
    }
    arrays {
        /// Slant profiles, in order of |m|.
        profiles: [ProfilePlace],
        /// The layout of a transfer.
        passes: [Pass],
        /// For each pass, profile and lane, the number of its component, or a number that the basis
        /// does not have.
        slots: [u16],
        /// The pairs that each coefficient of the material couples, in the order of
        /// [`material`](crate::material), up to the largest order that the effects factor.
        /// Coefficients that are not factored have [`Coupling::NONE`].
        couplings: [Coupling],
        /// Number of polynomial terms for each |m|.
        lengths: [u16],
        /// √(o+1) N_l^q C_lo^q of (11): for each pair a row over l, padded to `layout::groups`
        /// groups. Both this and `factors` are empty in a basis that only holds transfers.
        polar: [S],
        /// Factors of UᵀM: for each profile and each l from |m| on, a row of `layout::row` numbers.
        /// The profiles of an azimuth are taken in twos, whose rows alternate group by group; if
        /// their number is odd, the last profile is paired with zeros.
        factors: [S],
        /// For each profile, its polynomial in t = 2z - 1 and u = 2t² - 1, times √2 if m is not 0:
        /// the factors of ..., tu, u, t, 1.
        terms: [S],
        /// The mean image's polynomial, or empty.
        mean: [S],
        /// The mean image's coefficients, or empty.
        mean_coefficients: [S],
        /// For each |m|, each (o, p, q) and each l, whether the mode is selected; empty if all
        /// modes are.
        selection: [bool],
        /// For each profile of m = 0, a row of UᵀM over the coefficients that are
        /// [not factored](crate::effect::Effects::unfactored); empty if all are.
        ambient: [S],
    }
}

record! {
    /// The arrays of a general basis. Matrices are stored row by row, with a row for each
    /// eigenimage and a column for each component of the span.
    "eigenshade::GeneralParts" GeneralParts OwnedGeneralParts
    sizes {
        /// Number of eigenimages K.
        components: usize,
    }
    arrays {
        /// The matrix P from coordinates in the span to d.
        projection: [S],
        /// The coordinates of each eigenimage in the span.
        synthesis: [S],
        /// The coordinates of the mean image in the span, or empty.
        span_mean: [S],
        /// The coefficients of the mean image, or empty.
        image_mean: [S],
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
        /// The row of -m in a transfer; for m = 0 the same as that of +m.
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

    /// The row of the component of this sign.
    #[must_use]
    pub const fn row(self, sign: isize) -> Row {
        if sign < 0 { self.minus_row } else { self.plus_row }
    }

    /// The number of the component of this sign, or [`NONE`].
    #[must_use]
    pub const fn component(self, sign: isize) -> u16 {
        if sign < 0 { self.minus } else { self.plus }
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
    /// The pairs that one coefficient b_op^q couples: polar integrals of (o, q) are added to the
    /// sum of (p, q), and vice versa.
    Coupling {
        /// Position of (o, q) among the pairs.
        o: u16,
        /// Position of (p, q) among the pairs.
        p: u16,
    }
}

impl Coupling {
    /// The coupling of a coefficient that the effects of the basis do not factor.
    pub const NONE: Self = Self { o: NONE, p: NONE };
}

item! {
    /// Part of a transfer: [`layout::LANES`] orders m beginning with `first`, with `profiles`
    /// profiles each.
    Pass {
        /// The first order, a multiple of [`layout::LANES`].
        first: i16,
        /// Number of profiles of each order, at most [`layout::PASS`].
        profiles: u16,
    }
}

impl Pass {
    /// Number of slots, which is the number of entries for one degree.
    #[must_use]
    pub const fn slots(self) -> usize {
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
        Some(self.slots() * (degree + 1 - lowest))
    }
}
