//! Memory layout of the runtime's rows, arranged so that a compiler can process [`LANES`] numbers
//! at a time.
//!
//! Polar integrals run along l: each pair has a row of [`groups`] groups, padded with zeros beyond
//! the degree. Factors of UᵀM run along the pairs: each l >= |m| has a row of [`row`] numbers,
//! padded with zeros. The profiles of an azimuth are stored in twos, with their groups interleaved.
//! If their number is odd, the last profile is paired with zeros.
//!
//! Transfers run along m. A pass covers the orders m = first..first + [`LANES`], where `first` is a
//! multiple of [`LANES`], and at most [`PASS`] profiles of each order. It holds one group for each
//! l from [`lowest_degree`] on and each of its profiles.

/// Maximum number of terms of a profile's polynomial in powers of t = 2z - 1. The powers cancel:
/// with n terms by up to (1 + √2)^n to one.
pub const MONOMIAL_TERMS: usize = 16;

/// Maximum number of terms in [`Form::EvenOdd`], whose powers cancel like those of half as many
/// terms.
pub const EVEN_ODD_TERMS: usize = 2 * MONOMIAL_TERMS;

/// How a polynomial in t is written, highest term first, if its azimuth has no [`Recurrence`]. The
/// number of terms determines the form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// In 1, t, t², ...: one multiplication and one addition per term.
    Monomial,
    /// In 1, t, u, tu, u², tu², ... with u = 2t² - 1, alternating between the even and the odd
    /// half: the same operations per term, plus one multiplication and one addition for u.
    EvenOdd,
}

impl Form {
    /// The form of a polynomial with this number of terms.
    #[inline]
    #[must_use]
    pub const fn of(terms: usize) -> Self {
        if terms <= MONOMIAL_TERMS { Self::Monomial } else { Self::EvenOdd }
    }

    /// `[above, below]` in t e_k = above e_k+1 + below e_k-1, where e_k are the polynomials of this
    /// form.
    #[inline]
    #[must_use]
    pub const fn recurrence(self, k: usize) -> [f64; 2] {
        match (self, k) {
            (Self::Monomial, _) => [1.0, 0.0],
            (Self::EvenOdd, _) if k.is_multiple_of(2) => [1.0, 0.0],
            (Self::EvenOdd, _) => [0.5, 0.5],
        }
    }
}

/// Coefficients a_k and b_k of the recurrence e_k+1 = (2t - a_k) e_k - b_k e_k-1, e_0 = 1, e_-1 =
/// 0, of polynomials that are orthogonal over a sphere's normals with the weight sin^2m.
///
/// At a high azimuth a profile h = u / sin^|m| is far larger near the pole than at the rim. In
/// powers, halves or Chebyshev polynomials its value at the rim is a small difference of large
/// terms. These polynomials grow toward the pole as h does. The coefficients are `f32` in every
/// number format; the rounded values define the polynomials.
pub type Recurrence = [f32; 2];

/// `[first, length]`: the first azimuth that has recurrences, and the length of each recurrence.
///
/// A table stores recurrences for its last azimuths. Each has as many coefficient pairs as the
/// longest of the polynomial `lengths` has terms; `count` is their total number. If `count` is 0,
/// no azimuth has a recurrence. Returns `None` if `count` is not possible for these lengths.
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

/// Maximum number of weights in one integer sum: one for +m and one for -m of each profile. The
/// limit leaves headroom for rounding. The weights of a scene are off by half a unit each, which
/// adds up to at most 2^23 in the scene's 31-bit sums; the limit keeps a 64th of the range free. A
/// transfer's row has half as many numbers, whose rounding is a 256th of the row's largest possible
/// sum.
pub const MAX_WEIGHTS: usize = 1023;

/// Numbers in one group.
pub const LANES: usize = 4;

/// Maximum number of profiles of one order in a pass.
pub const PASS: usize = 8;

/// Number of groups over l = 0..=degree.
#[inline]
#[must_use]
pub const fn groups(degree: usize) -> usize {
    degree / LANES + 1
}

/// Length of a row over the pairs of an order.
///
/// Domain: order <= 2047. For larger orders the result is meaningless, but the function does not
/// panic.
#[inline]
#[must_use]
pub const fn row(order: usize) -> usize {
    crate::pair::count(order).div_ceil(LANES).saturating_mul(LANES)
}

/// Number of factors of `profiles` profiles of `azimuth`; `usize::MAX` on overflow, 0 unless
/// azimuth <= degree.
#[inline]
#[must_use]
pub const fn factors(degree: usize, order: usize, azimuth: usize, profiles: usize) -> usize {
    let degrees = degree.saturating_add(1).saturating_sub(azimuth);
    profiles.div_ceil(2).saturating_mul(2).saturating_mul(degrees).saturating_mul(row(order))
}

/// The smallest l of a pass whose orders start at `first`: the smallest |m| in the pass.
///
/// Domain: `first` is a multiple of [`LANES`].
#[inline]
#[must_use]
pub const fn lowest_degree(first: isize) -> usize {
    let last = first + LANES.cast_signed() - 1;
    if first >= 0 { first.unsigned_abs() } else { last.unsigned_abs() }
}

/// The `first` of the pass that contains order m.
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
    fn impossible_sizes_do_not_panic() {
        assert_eq!(factors(usize::MAX, 7, 0, 2), usize::MAX);
        assert_eq!(factors(7, usize::MAX, 0, usize::MAX), usize::MAX);
        assert_eq!(factors(7, 7, 8, 2), 0);
        assert!(row(usize::MAX) > row(2047));
    }
}
