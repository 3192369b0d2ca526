//! The terms of scenes' polynomials that tolerances spare.
//!
//! Written in polynomials that are orthogonal over a sphere's normals, as azimuths are, terms
//! cost what Parseval says when they are left out: the sum of their squares, no more; and those
//! that stay are the nearest image that so many terms can show. They go from the highest of an
//! azimuth down, of +m and -m together, always those that add the least for what a pixel saves;
//! at the end one may come back if others can then go that save more. Few are left, not provably
//! the fewest.
//!
//! Of several images each keeps its own account: terms go if every image can pay for them, and
//! cost the share of what is left to the one that they cost most. So each image's bound is exact,
//! and what all could pay for goes. One account for all, of the largest number that any image
//! has in each place, would need room for no image, but pays for each term what the worst image
//! pays, whichever that is.

use super::Economy;
use super::basis::{MOST, rewrite};
use super::density::{Density, longest};
use crate::index::layout::Form;
use crate::scalar::Scalar;

/// Polynomials of an azimuth.
const fn signs(azimuth: usize) -> usize {
    if azimuth == 0 { 1 } else { 2 }
}

/// Rewrites a scene's polynomials, times `scale`, in orthonormal ones; those that are too long
/// stay, unscaled.
pub(super) fn to_orthonormal<S: Scalar>(lengths: &[u16], mut numbers: &mut [S], scale: S) {
    let mut density = Density::new(lengths);
    for (azimuth, &length) in lengths.iter().enumerate() {
        let length = usize::from(length);
        let both = numbers.split_at_mut_checked(signs(azimuth) * length);
        let Some((both, rest)) = both else { return };
        numbers = rest;
        if length <= longest(azimuth) {
            for terms in both.chunks_exact_mut(length.max(1)) {
                rewrite(terms, &Form::of(length), &density);
                for (term, size) in terms.iter_mut().rev().zip(density.sizes()) {
                    *term = *term * (size * scale);
                }
            }
        }
        density.next();
    }
}

/// Where an azimuth's polynomials lie.
#[derive(Clone, Copy)]
struct Place {
    azimuth: usize,
    start: usize,
    /// Terms of either.
    original: usize,
}

impl Place {
    /// Each azimuth's.
    fn all(originals: &[u16]) -> impl Iterator<Item = Self> {
        let mut start = 0;
        originals.iter().enumerate().map(move |(azimuth, &original)| {
            let original = usize::from(original);
            let place = Self { azimuth, start, original };
            start += signs(azimuth) * original;
            place
        })
    }

    /// Of the terms from the highest of `length` down: the squares of +m's and -m's.
    fn squares<S: Scalar>(self, numbers: &[S], length: usize) -> impl Iterator<Item = S> {
        let of = |start: usize| {
            let terms = numbers.get(start..start + self.original).unwrap_or_default();
            terms.get(self.original.saturating_sub(length)..).unwrap_or_default()
        };
        let plus = of(self.start);
        let (minus, some) = match self.azimuth {
            0 => (plus, S::ZERO),
            _ => (of(self.start + self.original), S::ONE),
        };
        let both = plus.iter().zip(minus);
        both.map(move |(&plus, &minus)| (plus * plus).add_product(some * minus, minus))
    }
}

/// Sum of the squares of the terms that lengths leave out.
pub(super) fn left_out<S: Scalar>(originals: &[u16], lengths: &[u16], numbers: &[S]) -> S {
    let mut sum = S::ZERO;
    let lengths = lengths.iter().copied().chain(core::iter::repeat(0));
    for (place, length) in Place::all(originals).zip(lengths) {
        let gone = place.original.saturating_sub(usize::from(length));
        place.squares(numbers, place.original).take(gone).for_each(|square| sum += square);
    }
    sum
}

/// Whether polynomials of these lengths can be made of those of `originals`: none is longer,
/// and none shorter that stays as it is.
pub(super) fn can_be(originals: &[u16], lengths: &[u16]) -> bool {
    let padded = lengths.iter().copied().chain(core::iter::repeat(0));
    lengths.len() <= originals.len()
        && originals.iter().zip(padded).enumerate().all(|(azimuth, (&original, length))| {
            length == original || length < original && usize::from(original) <= longest(azimuth)
        })
}

/// Multiply-adds of a pixel: of polynomials by Horner's rule, of the complex products by which
/// azimuths are summed, of t = 2z - 1.
fn products(lengths: impl Iterator<Item = u16>) -> usize {
    let (mut polynomials, mut highest) = (0, 0);
    for (azimuth, length) in lengths.enumerate() {
        polynomials += signs(azimuth) * usize::from(length).saturating_sub(1);
        if length > 0 {
            highest = azimuth;
        }
    }
    polynomials + usize::from(polynomials > 0) + (4 * highest).saturating_sub(2)
}

/// Images in orthonormal polynomials, and what is told of each: by now squares, in `bound` of
/// what it may be off.
pub(super) struct Accounts<'s, S> {
    pub(super) originals: &'s [u16],
    /// `len` of each image.
    pub(super) numbers: &'s [S],
    pub(super) len: usize,
    pub(super) told: &'s mut [Economy<S>],
}

/// Terms of an azimuth to be left out: of +m and of -m so many.
struct Cut<S> {
    place: Place,
    terms: u16,
    /// The largest share of what is left to an image.
    share: S,
    /// Products that a pixel saves.
    saved: S,
}

impl<S: Scalar> Accounts<'_, S> {
    /// Shortens `lengths`, at first the polynomials' own, as long as no image is off by more
    /// than it may be.
    pub(super) fn spare(&mut self, lengths: &mut [u16]) {
        loop {
            while let Some(cut) = self.cheapest(lengths, 0, None) {
                self.shorten(lengths, &cut);
            }
            let better = Place::all(self.originals).find_map(|more| self.exchange(lengths, more));
            let Some((azimuth, cut)) = better else { return };
            if let Some(length) = lengths.get_mut(azimuth) {
                *length += 1;
            }
            self.shorten(lengths, &cut);
            // Nothing is left of what rounding did to a term that came back.
            for (numbers, told) in self.numbers.chunks_exact(self.len.max(1)).zip(&mut *self.told) {
                told.left_out_by_terms = left_out(self.originals, lengths, numbers);
            }
        }
    }

    fn shorten(&mut self, lengths: &mut [u16], cut: &Cut<S>) {
        let Some(length) = lengths.get_mut(cut.place.azimuth) else { return };
        for (numbers, told) in self.numbers.chunks_exact(self.len.max(1)).zip(&mut *self.told) {
            let squares = cut.place.squares(numbers, usize::from(*length));
            squares.take(cut.terms.into()).for_each(|square| told.left_out_by_terms += square);
        }
        *length -= cut.terms;
    }

    /// Terms of other azimuths that could go if this one had a term more, and a pixel would
    /// save by it.
    fn exchange(&self, lengths: &[u16], more: Place) -> Option<(usize, Cut<S>)> {
        let azimuth = more.azimuth;
        let &length = lengths.get(azimuth).filter(|&&length| length > 0)?;
        if usize::from(length) == more.original {
            return None;
        }
        let longer = lengths.iter().enumerate();
        let longer = longer.map(|(m, &length)| if m == azimuth { length + 1 } else { length });
        let dearer = products(longer) - products(lengths.iter().copied());
        let cut = self.cheapest(lengths, dearer + 1, Some((more, usize::from(length) + 1)))?;
        Some((azimuth, cut))
    }

    /// Of all cuts that leave every image off by no more than it may be, and save so many
    /// products at least, the one that saves most for what it costs. What saves none goes if it
    /// costs nothing. An azimuth may be given back a term, to become so long.
    fn cheapest(
        &self,
        lengths: &[u16],
        least: usize,
        back: Option<(Place, usize)>,
    ) -> Option<Cut<S>> {
        let whole = products(lengths.iter().copied());
        let (mut best, mut shares): (Option<Cut<S>>, _) = (None, [S::ZERO; MOST]);
        for (place, &length) in Place::all(self.originals).zip(lengths) {
            let azimuth = place.azimuth;
            if place.original > longest(azimuth)
                || back.is_some_and(|(of, _)| of.azimuth == azimuth)
            {
                continue;
            }
            let most = self.shares(place, length, back, &mut shares);
            for (&share, terms) in shares.iter().zip(1..=most) {
                let saved = if terms == length {
                    let others = lengths.iter().enumerate();
                    let others = others.map(|(m, &length)| if m == azimuth { 0 } else { length });
                    whole - products(others)
                } else {
                    signs(azimuth) * usize::from(terms)
                };
                let enough = saved >= least && (saved > 0 || share == S::ZERO);
                let saved = S::from_whole(saved);
                let better =
                    best.as_ref().is_none_or(|best| share * best.saved < best.share * saved);
                if better && enough {
                    best = Some(Cut { place, terms, share, saved });
                }
            }
        }
        best
    }

    /// What 1, 2, ... terms of an azimuth cost the image that they cost most, as `shares` of what
    /// it has left; gives how many terms all can pay for.
    fn shares(
        &self,
        place: Place,
        length: u16,
        back: Option<(Place, usize)>,
        shares: &mut [S; MOST],
    ) -> u16 {
        let mut most = length;
        shares.iter_mut().take(length.into()).for_each(|share| *share = S::ZERO);
        for (numbers, told) in self.numbers.chunks_exact(self.len.max(1)).zip(&*self.told) {
            let back = back.and_then(|(place, length)| place.squares(numbers, length).next());
            let left = told.bound - told.left_out_by_components - told.left_out_by_terms;
            let left = left + back.unwrap_or_default();
            let left = if left > S::ZERO { left } else { S::ZERO };
            let of_left = left.reciprocal();
            let (mut sum, mut paid) = (S::ZERO, 0);
            let squares = place.squares(numbers, length.into()).take(most.into());
            for (share, square) in shares.iter_mut().zip(squares) {
                sum += square;
                let within = sum <= left;
                if !within {
                    break;
                }
                paid += 1;
                // Nothing is no share of nothing.
                if sum > S::ZERO && sum * of_left > *share {
                    *share = sum * of_left;
                }
            }
            most = paid;
        }
        most
    }
}

/// Moves what is left of the polynomials to the beginning, in the form of these
/// lengths, times `unit`; gives how many terms they are.
pub(super) fn from_orthonormal<S: Scalar>(
    originals: &[u16],
    lengths: &[u16],
    numbers: &mut [S],
    unit: S,
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
                    *term = *term * (size.reciprocal() * unit);
                }
                rewrite(terms, &density, &Form::of(length));
            }
            (start, end) = (start + original, end + length);
        }
        density.next();
    }
    end
}
