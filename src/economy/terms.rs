//! The terms of scenes' polynomials that tolerances spare.
//!
//! Written in polynomials that are orthonormal over a sphere's normals, as azimuths are, terms
//! cost what Parseval says when they are left out: the sum of their squares, no more; and those
//! that stay are the nearest image that so many terms can show. They go from the highest of an
//! azimuth down, of +m and -m together, at a price that rises: always those that cost no more
//! for each product that a pixel saves. Few are left, not provably the fewest.
//!
//! Of several images each keeps its own account: terms go if every image can pay for them, at a
//! price that is the same share of what each may be off. So each image's bound is exact, and what
//! all could pay for goes.

use super::Economy;
use super::basis::Rows;
use super::density::{Density, longest, sizes};
use super::energy::mean_square;
use crate::index::layout::Recurrence;
use crate::parts::Recurrences;
use crate::scalar::Scalar;

/// By how much the price rises from one sweep to the next.
const RISE: usize = 16;

/// Whether a loop over twenty nodes costs little more than one over four numbers.
const LANES_ARE_CHEAP: bool = cfg!(any(target_arch = "x86_64", target_arch = "aarch64"));

/// Polynomials of an azimuth.
const fn signs(azimuth: usize) -> usize {
    if azimuth == 0 { 1 } else { 2 }
}

/// Multiply-adds of the complex products by which azimuths up to the highest are summed.
const fn around(highest: usize) -> usize {
    (4 * highest).saturating_sub(2)
}

/// Polynomials of all azimuths.
#[derive(Clone, Copy)]
pub(super) struct Polynomials<'p> {
    /// Terms of either, by azimuth.
    pub(super) lengths: &'p [u16],
    pub(super) recurrences: Recurrences<'p>,
}

/// Where an azimuth's polynomials lie.
#[derive(Clone, Copy)]
struct Place {
    azimuth: usize,
    start: usize,
    /// Terms of either.
    original: usize,
    /// Whether they can be orthonormal ones: not if they are too long.
    known: bool,
}

impl Place {
    /// Those of +m, and of -m or none.
    fn both<S>(self, numbers: &[S]) -> [&[S]; 2] {
        let (plus, rest) = numbers
            .get(self.start..)
            .and_then(|n| n.split_at_checked(self.original))
            .unwrap_or_default();
        let others = if self.azimuth == 0 { 0 } else { self.original };
        [plus, rest.get(..others).unwrap_or_default()]
    }

    /// Of the terms from the highest of `length` down: the squares of +m's and -m's.
    #[inline(always)]
    fn squares<S: Scalar>(self, numbers: &[S], length: usize) -> impl Iterator<Item = S> {
        let of = |start: usize| {
            let end = start + self.original;
            numbers.get(end.saturating_sub(length)..end).unwrap_or_default()
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

impl<'p> Polynomials<'p> {
    #[inline]
    fn place(&self, azimuth: usize, start: usize) -> Place {
        let original = self.lengths.get(azimuth).map_or(0, |&length| length.into());
        let known = azimuth >= self.recurrences.first() || original <= longest(azimuth);
        Place { azimuth, start, original, known }
    }

    /// Each azimuth's place, up to the last that has any polynomial.
    fn places(self) -> impl Iterator<Item = Place> {
        let mut start = 0;
        (0..used(self.lengths)).map(move |azimuth| {
            let place = self.place(azimuth, start);
            start += signs(azimuth) * place.original;
            place
        })
    }

    /// The density of the azimuths without a recurrence.
    fn density<S: Scalar>(self, lengths: &[u16]) -> Density<S> {
        let left = lengths.iter().enumerate().take(self.recurrences.first());
        let terms =
            left.filter(|&(azimuth, &length)| (1..=longest(azimuth)).contains(&length.into()));
        let terms = terms.map(|(azimuth, &length)| azimuth + usize::from(length));
        Density::new(terms.max().unwrap_or_default())
    }

    /// Rewrites a scene's polynomials, times `scale`, in orthonormal ones; those that are too
    /// long or of which nothing is kept stay as they are.
    pub(super) fn orthonormalize<S: Scalar>(self, kept: &[u16], numbers: &mut [S], scale: S) {
        let (mut density, mut rows) = (self.density(kept), Rows::new());
        for (place, _) in self.places().zip(kept).filter(|(place, kept)| place.known && **kept > 0)
        {
            let both = numbers.get_mut(place.start..).unwrap_or_default();
            let both = split(both, place.azimuth, place.original);
            let recurrence = self.recurrences.of(place.azimuth);
            if recurrence.is_empty() {
                density.turn_to(place.azimuth);
                let sizes = sizes(place.azimuth, density.below());
                rows.orthogonalize(both, &density, sizes.map(|size| size * scale));
            } else {
                times(both, || sizes(place.azimuth, below(recurrence)).map(|size: S| size * scale));
            }
        }
    }

    /// Moves what is left of them to the beginning, in the form of these lengths, times `scale`.
    pub(super) fn restore<S: Scalar>(self, lengths: &[u16], numbers: &mut [S], scale: S) {
        let (mut density, mut rows) = (self.density(lengths), Rows::new());
        let mut end = 0;
        for (place, &length) in self.places().zip(lengths).filter(|&(_, &length)| length > 0) {
            let (azimuth, length, start) = (place.azimuth, usize::from(length), end);
            // They move toward the beginning, never past what is still to move.
            for sign in 1..=signs(azimuth) {
                for k in (place.start + sign * place.original - length..).take(length) {
                    let term = numbers.get(k).copied().unwrap_or_default();
                    if let Some(place) = numbers.get_mut(end) {
                        *place = term;
                    }
                    end += 1;
                }
            }
            if !place.known {
                continue;
            }
            let both = numbers.get_mut(start..).unwrap_or_default();
            let [plus, minus] = split(both, azimuth, length);
            let recurrence = self.recurrences.of(azimuth);
            let over = |size: S| size.reciprocal() * scale;
            if recurrence.is_empty() {
                density.turn_to(azimuth);
                times([plus, minus], || sizes(azimuth, density.below()).map(over));
                rows.rewrite([plus, minus], &density);
            } else {
                times([plus, minus], || sizes(azimuth, below(recurrence)).map(over));
            }
        }
    }

    /// Sum of the squares of the terms that lengths leave out.
    pub(super) fn left_out<S: Scalar>(self, lengths: &[u16], numbers: &[S]) -> S {
        let mut sum = S::ZERO;
        let lengths = lengths.iter().copied().chain(core::iter::repeat(0));
        for (place, length) in self.places().zip(lengths) {
            let gone = place.original.saturating_sub(usize::from(length));
            place.squares(numbers, place.original).take(gone).for_each(|square| sum += square);
        }
        sum
    }

    /// Whether polynomials of these lengths can be made of them: none is longer, and none shorter
    /// that stays as it is.
    pub(super) fn can_become(self, lengths: &[u16]) -> bool {
        let padded = lengths.iter().map(|&length| usize::from(length)).chain(core::iter::repeat(0));
        lengths.len() <= self.lengths.len()
            && (0..self.lengths.len()).zip(padded).all(|(azimuth, length)| {
                let Place { original, known, .. } = self.place(azimuth, 0);
                length == original || length < original && known
            })
    }
}

/// Azimuths up to the last that has any terms.
fn used(lengths: &[u16]) -> usize {
    lengths.iter().rposition(|&length| length > 0).map_or(0, |last| last + 1)
}

/// The first of these numbers: an azimuth's polynomials of so many terms, +m's, and -m's or none.
fn split<S>(numbers: &mut [S], azimuth: usize, length: usize) -> [&mut [S]; 2] {
    let (plus, rest) = numbers.split_at_mut_checked(length).unwrap_or_default();
    let others = if azimuth == 0 { 0 } else { length };
    [plus, rest.get_mut(..others).unwrap_or_default()]
}

/// The lowest terms of both times the first number, and so on.
fn times<S: Scalar, N: Iterator<Item = S>>(both: [&mut [S]; 2], numbers: impl Fn() -> N) {
    for terms in both {
        terms.iter_mut().rev().zip(numbers()).for_each(|(term, number)| *term = *term * number);
    }
}

/// below_k of a recurrence.
fn below<S: Scalar>(recurrence: &[Recurrence]) -> impl Iterator<Item = S> {
    recurrence.iter().map(|&[_, below]| S::from_f32(below))
}

/// Images in orthonormal polynomials, and what is told of each: by now squares, in `bound` of
/// what it may be off.
pub(super) struct Accounts<'s, S> {
    pub(super) polynomials: Polynomials<'s>,
    /// `len` of each image.
    pub(super) numbers: &'s [S],
    pub(super) len: usize,
    pub(super) told: &'s mut [Economy<S>],
}

impl<S: Scalar> Accounts<'_, S> {
    /// Leaves out whole azimuths from the highest down, as the first sweep would, as long as all
    /// images can pay: what they cost is known before anything is rewritten. `scale` is what an
    /// image's numbers are yet to be multiplied by.
    pub(super) fn spare_azimuths(&mut self, lengths: &mut [u16], scale: impl Fn(&Economy<S>) -> S) {
        // Numbers one by one cost more than they save.
        if !LANES_ARE_CHEAP {
            return;
        }
        let mut end = self.len;
        for azimuth in (0..used(lengths)).rev() {
            let mut place = self.polynomials.place(azimuth, end);
            end = end.saturating_sub(signs(azimuth) * place.original);
            place.start = end;
            let split = lengths.get_mut(..=azimuth).and_then(<[_]>::split_last_mut);
            let Some((length, below)) = split.filter(|(length, _)| **length > 0) else { continue };
            if !place.known || !self.polynomials.recurrences.of(azimuth).is_empty() {
                return;
            }
            let around = around(azimuth) - around(used(below).saturating_sub(1));
            let saved = signs(azimuth) * (place.original - 1) + around;
            let worth = S::from_whole(saved) * self.first_price();
            for (numbers, told) in self.numbers.chunks_exact(self.len.max(1)).zip(&mut *self.told) {
                let both = place.both(numbers);
                let Some(square) = mean_square(azimuth, both, scale(told)) else { return };
                // Until all have been asked.
                told.floor = square;
                let pays = told.floor <= left(told) && told.floor <= worth * told.bound;
                if !pays {
                    return;
                }
            }
            self.told.iter_mut().for_each(|told| told.left_out_by_terms += told.floor);
            *length = 0;
        }
    }

    /// Little enough that what goes at it leaves most of what an image may be off.
    fn first_price(&self) -> S {
        S::from_whole(self.len.max(1)).reciprocal()
    }

    /// Shortens `lengths`, at first the polynomials' own or 0, as long as no image is off by more
    /// than it may be.
    pub(super) fn spare(&mut self, lengths: &mut [u16]) {
        let rise = S::from_whole(RISE);
        let mut price = self.first_price();
        while price < S::ONE {
            self.sweep(lengths, price);
            price = price * rise;
        }
        // What anything may cost, at last: what stays then could never go.
        self.sweep(lengths, S::from_whole(self.len.max(1)));
    }

    /// Leaves out what goes at a price, from the highest azimuth down.
    fn sweep(&mut self, lengths: &mut [u16], price: S) {
        let mut end = self.len;
        let mut azimuths = used(lengths);
        for azimuth in (0..used(self.polynomials.lengths)).rev() {
            let mut place = self.polynomials.place(azimuth, end);
            end = end.saturating_sub(signs(azimuth) * place.original);
            place.start = end;
            let split = lengths.get_mut(..=azimuth).and_then(<[_]>::split_last_mut);
            let Some((length, below)) = split.filter(|(length, _)| **length > 0) else { continue };
            let around = (azimuth + 1 == azimuths).then(|| {
                azimuths = used(below);
                around(azimuth) - around(azimuths.saturating_sub(1))
            });
            if place.known {
                *length -= self.affordable(place, (*length).into(), around, price) as u16;
            }
            if *length > 0 {
                azimuths = azimuths.max(azimuth + 1);
            }
        }
    }

    /// Takes the most terms of an azimuth that all images can pay for, at most this share of what
    /// each may be off for each product that a pixel saves. The last saves none by itself, but
    /// `around` with the highest azimuth.
    fn affordable(
        &mut self,
        place: Place,
        length: usize,
        around: Option<usize>,
        price: S,
    ) -> usize {
        let of_one = S::from_whole(signs(place.azimuth)) * price;
        let of_last = around.map_or(S::ZERO, |around| S::from_whole(around) * price - of_one);
        let mut terms = if around.is_some() { length } else { length - 1 };
        let mut paid = S::ZERO;
        let images = self.numbers.chunks_exact(self.len.max(1));
        loop {
            let before = terms;
            for (numbers, told) in images.clone().zip(&*self.told) {
                let (left, of_one) = (left(told), of_one * told.bound);
                let (mut sum, mut worth, mut gone) = (S::ZERO, S::ZERO, 0);
                paid = S::ZERO;
                for (index, square) in place.squares(numbers, length).take(terms).enumerate() {
                    sum += square;
                    worth += of_one;
                    let within = sum <= left;
                    if !within {
                        break;
                    }
                    if index + 1 == length {
                        worth = worth.add_product(of_last, told.bound);
                    }
                    if sum <= worth {
                        (gone, paid) = (index + 1, sum);
                    } else if around.is_none() {
                        break;
                    }
                }
                terms = gone;
            }
            // Who was asked before one that can pay for fewer is asked again.
            if terms == before || self.told.len() == 1 {
                break;
            }
        }
        if let [told] = &mut *self.told {
            told.left_out_by_terms += paid;
        } else if terms > 0 {
            for (numbers, told) in images.zip(&mut *self.told) {
                let squares = place.squares(numbers, length).take(terms);
                squares.for_each(|square| told.left_out_by_terms += square);
            }
        }
        terms
    }
}

/// What an image may still be off.
fn left<S: Scalar>(told: &Economy<S>) -> S {
    let left = told.bound - told.left_out_by_components - told.left_out_by_terms;
    if left > S::ZERO { left } else { S::ZERO }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::normal::Normal;
    use crate::scene::Scene;

    /// Of each form, and so long that azimuth 40 takes what the recurrence knows at the end.
    const CASES: [&[u16]; 5] = [
        &[1],
        &[16, 3, 15, 16],
        &[17, 32, 31, 5],
        &[32, 30, 17, 16, 17],
        &[
            2, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
            0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 20,
        ],
    ];

    fn numbers(lengths: &[u16]) -> [f64; 500] {
        let used = lengths.iter().enumerate().map(|(m, &n)| signs(m) * usize::from(n)).sum();
        core::array::from_fn(|k| {
            let number = ((7 * k % 19) as f64 - 9.0) / (1 + k % 5) as f64;
            if k < used { number } else { 0.0 }
        })
    }

    /// The mean over a sphere's normals, of density 2z dz, by Simpson's rule and equal steps around.
    fn mean_square(scene: &Scene<'_, &[f64]>) -> f64 {
        const ALONG: usize = 4000;
        const AROUND: usize = 90;
        let mut sum = 0.0;
        for k in 0..=ALONG {
            let z = k as f64 / ALONG as f64;
            let weight =
                2.0 * z * f64::from(if k == 0 || k == ALONG { 1 } else { 2 + 2 * (k as i32 % 2) });
            let sine = libm::sqrt(1.0 - z * z);
            for turn in 0..AROUND {
                let (y, x) = libm::sincos(core::f64::consts::TAU * turn as f64 / AROUND as f64);
                let value = scene.shade(Normal { x: sine * x, y: sine * y, z });
                sum += weight * value * value;
            }
        }
        sum / (3 * ALONG * AROUND) as f64
    }

    #[test]
    fn squares_of_orthonormal_terms_are_those_of_the_image() {
        for lengths in CASES {
            let numbers = numbers(lengths);
            let mut terms = numbers;
            let polynomials = Polynomials { lengths, recurrences: Recurrences::NONE };
            polynomials.orthonormalize(lengths, &mut terms, 0.5);
            let sum: f64 = terms.iter().map(|term| term * term).sum();
            let mean = mean_square(&Scene::of(lengths, Recurrences::NONE, &numbers));
            assert!((4.0 * sum - mean).abs() < 1e-6 * mean, "{lengths:?}: {sum}, {mean}");
            polynomials.restore(lengths, &mut terms, 2.0);
            for (term, number) in terms.iter().zip(&numbers) {
                assert!((term - number).abs() < 1e-9, "{lengths:?}: {term}, {number}");
            }
        }
    }
}
