//! The terms of a scene's polynomials that a tolerance spares.
//!
//! Written in polynomials that are orthogonal over a sphere's normals, as azimuths are, terms
//! cost what Parseval says when they are left out: the sum of their squares, no more; and those
//! that stay are the nearest image that so many terms can show. They go from the highest of an
//! azimuth down, of +m and -m together, always those that add the least for what a pixel saves:
//! few are left, not provably the fewest.

use super::basis::{Chebyshev, Powers, rewrite};
use super::density::{Density, longest};
use crate::index::layout::POWERS;
use crate::scalar::Scalar;

/// Polynomials of an azimuth.
const fn signs(azimuth: usize) -> usize {
    if azimuth == 0 { 1 } else { 2 }
}

/// Rewrites a scene's polynomials in orthonormal ones; those that are too long stay.
pub(super) fn to_orthonormal<S: Scalar>(lengths: &[u16], mut numbers: &mut [S]) {
    let mut density = Density::new(lengths);
    for (azimuth, &length) in lengths.iter().enumerate() {
        let length = usize::from(length);
        let both = numbers.split_at_mut_checked(signs(azimuth) * length);
        let Some((both, rest)) = both else { return };
        numbers = rest;
        if length <= longest(azimuth) {
            for terms in both.chunks_exact_mut(length.max(1)) {
                if length > POWERS {
                    rewrite(terms, &Chebyshev, &density);
                } else {
                    rewrite(terms, &Powers, &density);
                }
                for (term, size) in terms.iter_mut().rev().zip(density.sizes()) {
                    *term = *term * size;
                }
            }
        }
        density.next();
    }
}

/// Shortens `lengths`, at first the polynomials' own, as long as what is left out is within
/// `allowed`; gives what that is, squared.
pub(super) fn spared<S: Scalar>(
    originals: &[u16],
    lengths: &mut [u16],
    numbers: &[S],
    allowed: S,
) -> S {
    let mut squares = S::ZERO;
    while let Some(cut) = cheapest(originals, lengths, numbers, allowed - squares) {
        squares += cut.squares;
        if let Some(length) = lengths.get_mut(cut.azimuth) {
            *length -= cut.terms;
        }
    }
    squares
}

/// Terms of an azimuth to be left out: of +m and of -m so many.
struct Cut<S> {
    azimuth: usize,
    terms: u16,
    squares: S,
    /// Products that a pixel saves.
    saved: S,
}

/// What saves most for what it costs, of all that costs no more than allowed.
fn cheapest<S: Scalar>(
    originals: &[u16],
    lengths: &[u16],
    numbers: &[S],
    allowed: S,
) -> Option<Cut<S>> {
    let highest = lengths.iter().rposition(|&length| length > 0)?;
    let (mut best, mut rest): (Option<Cut<S>>, _) = (None, numbers);
    for (azimuth, (&original, &length)) in originals.iter().zip(lengths).enumerate() {
        let (plus, after) = rest.split_at_checked(usize::from(original))?;
        let of_minus = (signs(azimuth) - 1) * usize::from(original);
        let (minus, after) = after.split_at_checked(of_minus)?;
        rest = after;
        if usize::from(original) > longest(azimuth) {
            continue;
        }
        let gone = usize::from(original - length);
        let left = plus.iter().enumerate().skip(gone);
        let mut squares = S::ZERO;
        for ((place, &plus), terms) in left.zip(1..=length) {
            let minus = minus.get(place).copied().unwrap_or_default();
            squares = squares.add_product(plus, plus).add_product(minus, minus);
            if squares > allowed {
                break;
            }
            // The first term of a polynomial is no product; an azimuth is four.
            let products = match terms {
                all if all == length && azimuth == highest => usize::from(all) + 1,
                all if all == length => usize::from(all) - 1,
                some => usize::from(some),
            };
            let saved = S::from_whole(signs(azimuth) * products);
            let better =
                best.as_ref().is_none_or(|best| squares * best.saved < best.squares * saved);
            if better && (saved > S::ZERO || squares == S::ZERO) {
                best = Some(Cut { azimuth, terms, squares, saved });
            }
        }
    }
    best
}

/// Moves what is left of the polynomials to the beginning, as powers or series of these
/// lengths; gives how many terms they are.
pub(super) fn from_orthonormal<S: Scalar>(
    originals: &[u16],
    lengths: &[u16],
    numbers: &mut [S],
) -> usize {
    let mut density = Density::<S>::new(originals);
    let (mut start, mut end) = (0, 0);
    for (azimuth, (&original, &length)) in originals.iter().zip(lengths).enumerate() {
        let (original, length) = (usize::from(original), usize::from(length));
        for _ in 0..signs(azimuth) {
            let first = start + original - length;
            // It moves toward the beginning, never past what is still to move.
            for k in 0..length {
                let term = numbers.get(first + k).copied().unwrap_or_default();
                if let Some(place) = numbers.get_mut(end + k) {
                    *place = term;
                }
            }
            let terms = numbers.get_mut(end..end + length).unwrap_or_default();
            if original <= longest(azimuth) {
                for (term, size) in terms.iter_mut().rev().zip(density.sizes()) {
                    *term = *term * size.reciprocal();
                }
                if length > POWERS {
                    rewrite(terms, &density, &Chebyshev);
                } else {
                    rewrite(terms, &density, &Powers);
                }
            }
            (start, end) = (start + original, end + length);
        }
        density.next();
    }
    end
}
