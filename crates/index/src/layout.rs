//! Layout of the runtime's rows, so that a compiler can take [`LANES`] numbers at
//! a time.
//!
//! Polar integrals run along l: for each pair a row of [`groups`] groups, zero
//! beyond the degree. Factors of UᵀM run along the pairs: for each l from |m|
//! on a row of [`row`] numbers, zero-padded. The profiles of an azimuth go two by
//! two, group by group beside each other, the last of an odd number with zeros.
//!
//! Transfers run along m: a pass takes the orders m = first..first + [`LANES`],
//! `first` a multiple of [`LANES`], and at most [`PASS`] profiles of each; for
//! each l from [`lowest_degree`] on, for each of its profiles, one group.

/// Most terms of a profile's polynomial in powers of t = 2z - 1: they cancel, of n terms up
/// to (1 + √2)^n to one.
pub const POWERS: usize = 16;

/// Most terms in [`Form::Halves`], whose powers cancel as those of half as many terms do.
pub const HALVES: usize = 2 * POWERS;

/// How a polynomial in t is written, highest term first, where its azimuth has no
/// [`Recurrence`]: its length decides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// In 1, t, t², ...: a multiplication and an addition a term.
    Powers,
    /// In 1, t, u, tu, u², tu², ... of u = 2t² - 1, the even and the odd half by turns: as
    /// many, and one more of each for u.
    Halves,
}

impl Form {
    /// That of a polynomial of so many terms.
    #[inline]
    #[must_use]
    pub const fn of(terms: usize) -> Self {
        if terms <= POWERS { Self::Powers } else { Self::Halves }
    }

    /// above and below of t e_k = above e_k+1 + below e_k-1, of the polynomials e_k of this
    /// form.
    #[inline]
    #[must_use]
    pub const fn recurrence(self, k: usize) -> [f64; 2] {
        match (self, k) {
            (Self::Powers, _) => [1.0, 0.0],
            (Self::Halves, _) if k.is_multiple_of(2) => [1.0, 0.0],
            (Self::Halves, _) => [0.5, 0.5],
        }
    }
}

/// Coefficients a_k and b_k of the recurrence e_k+1 = (2t - a_k) e_k - b_k e_k-1, e_0 = 1,
/// e_-1 = 0, of polynomials that are orthogonal over a sphere's normals times sin^2m.
///
/// A profile h = u / sin^|m| of a high azimuth is far larger near the pole than at the rim, so
/// that in powers, halves or Chebyshev polynomials the rim's value is a small difference of
/// large terms. These polynomials grow toward the pole as h does. The coefficients are `f32` in
/// every number format: rounded, they define the polynomials.
pub type Recurrence = [f32; 2];

/// The first azimuth that has recurrences, and how many numbers each has: those of a table
/// are of its last azimuths, each as many as its longest polynomial has terms. No azimuth has
/// one if they are none; `None` if they are no such number.
#[must_use]
pub const fn recurrences(lengths: &[u16], count: usize) -> Option<[usize; 2]> {
    let (mut longest, mut rest) = (0, lengths);
    while let [length, tail @ ..] = rest {
        if *length as usize > longest {
            longest = *length as usize;
        }
        rest = tail;
    }
    if count == 0 {
        return Some([lengths.len(), longest]);
    }
    if longest == 0 || !count.is_multiple_of(longest) || count / longest > lengths.len() {
        return None;
    }
    Some([lengths.len() - count / longest, longest])
}

/// Most numbers whose rounding sums in integers leave room for, a weight for +m and one for
/// -m of each profile: the half units that a scene's weights are off are 2^23 in its sums of
/// 31 bits at most, and these keep a 64th free; those of a transfer's row of half as many
/// numbers are a 256th of what they may sum to.
pub const MOST_WEIGHTS: usize = 1023;

/// Numbers in one group.
pub const LANES: usize = 4;

/// Most profiles of one order in a pass.
pub const PASS: usize = 8;

/// Groups over l = 0..=degree.
#[inline]
#[must_use]
pub const fn groups(degree: usize) -> usize {
    degree / LANES + 1
}

/// Length of a row over the pairs of an order. Domain: order <= 2047; beyond it the answer is
/// meaningless, but never a panic.
#[inline]
#[must_use]
pub const fn row(order: usize) -> usize {
    crate::pair::count(order).div_ceil(LANES).saturating_mul(LANES)
}

/// Number of factors of `profiles` profiles of `azimuth`, `usize::MAX` where that overflows; 0
/// unless azimuth <= degree.
#[inline]
#[must_use]
pub const fn factors(degree: usize, order: usize, azimuth: usize, profiles: usize) -> usize {
    let degrees = degree.saturating_add(1).saturating_sub(azimuth);
    profiles.div_ceil(2).saturating_mul(2).saturating_mul(degrees).saturating_mul(row(order))
}

/// The least l of a pass whose orders start at `first`: the least |m| of them.
/// Domain: `first` a multiple of [`LANES`].
#[inline]
#[must_use]
pub const fn lowest_degree(first: isize) -> usize {
    let last = first + LANES.cast_signed() - 1;
    if first >= 0 { first.unsigned_abs() } else { last.unsigned_abs() }
}

/// The `first` of the pass that holds order m.
#[inline]
#[must_use]
pub const fn first_order(order: isize) -> isize {
    order.div_euclid(LANES.cast_signed()) * LANES.cast_signed()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_hold_every_degree() {
        for degree in 0..70 {
            assert!(LANES * groups(degree) > degree);
            assert!(LANES * (groups(degree) - 1) <= degree);
        }
    }

    #[test]
    fn every_order_has_a_lane() {
        for order in -70..=70_isize {
            let first = first_order(order);
            assert!((0..LANES.cast_signed()).contains(&(order - first)));
            let least = (first..first + LANES.cast_signed()).map(isize::unsigned_abs).min();
            assert_eq!(Some(lowest_degree(first)), least);
        }
    }
    #[test]
    fn sizes_that_nothing_has_are_no_panic() {
        assert_eq!(factors(usize::MAX, 7, 0, 2), usize::MAX);
        assert_eq!(factors(7, usize::MAX, 0, usize::MAX), usize::MAX);
        assert_eq!(factors(7, 7, 8, 2), 0);
        assert!(row(usize::MAX) > row(2047));
    }
}
