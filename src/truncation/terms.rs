//! The polynomials of a scene, made orthonormal over a sphere's normals.
//!
//! In this form, the square of a term is the mean square error of leaving it out (Parseval), and
//! the remaining terms are the nearest image with that many terms.

use super::density::{Density, sizes};
use super::orthogonal::Rows;
use crate::basis::signs;
use crate::checked_slice::{part, part_mut, split, split_mut};
use crate::float;
use core::cell::Cell;

/// The lengths without the azimuths above the highest that has terms.
pub(super) fn trimmed(mut lengths: &[u16]) -> &[u16] {
    while let [lower @ .., 0] = lengths {
        lengths = lower;
    }
    lengths
}

/// The shape of the polynomials of all azimuths.
#[derive(Clone, Copy)]
pub(super) struct Polynomials<'p> {
    /// Number of terms of each of the two polynomials, by azimuth.
    pub(super) lengths: &'p [u16],
}

/// The position of an azimuth's polynomials.
#[derive(Clone, Copy)]
pub(super) struct Place {
    pub(super) azimuth: usize,
    start: usize,
    /// Number of terms of each of the two polynomials.
    pub(super) original: usize,
}

impl Place {
    /// The polynomials of +m and of -m; the latter is empty for m = 0.
    pub(super) fn both<T>(self, numbers: &[T]) -> [&[T]; 2] {
        let (plus, rest) = split(part(numbers, self.start..), self.original);
        [plus, part(rest, ..self.of_minus())]
    }

    fn both_mut(self, numbers: &mut [f32]) -> [&mut [f32]; 2] {
        let (plus, rest) = split_mut(part_mut(numbers, self.start..), self.original);
        [plus, part_mut(rest, ..self.of_minus())]
    }

    /// Number of terms of the polynomial of -m.
    const fn of_minus(self) -> usize {
        if self.azimuth == 0 { 0 } else { self.original }
    }

    /// For each term from the highest of `length` down, the sum of the squares of +m and -m.
    #[inline(always)]
    pub(super) fn squares(self, numbers: &[f32], length: usize) -> impl Iterator<Item = f32> {
        let gone = self.original.saturating_sub(length);
        let [plus, minus] = self.both(numbers);
        let plus = part(plus, gone..);
        let (minus, weight) = match self.azimuth {
            0 => (plus, 0.0),
            _ => (part(minus, gone..), 1.0),
        };
        let both = plus.iter().zip(minus);
        both.map(move |(&plus, &minus)| float::add_product(plus * plus, weight * minus, minus))
    }
}

impl<'p> Polynomials<'p> {
    /// The position of the polynomials of an azimuth that begin at `start`.
    #[inline]
    fn place(&self, azimuth: usize, start: usize) -> Place {
        let original = self.lengths.get(azimuth).map_or(0, |&length| length.into());
        Place { azimuth, start, original }
    }

    fn places(self) -> impl Iterator<Item = Place> {
        let mut start = 0;
        (0..self.lengths.len()).map(move |azimuth| {
            let place = self.place(azimuth, start);
            start += signs(azimuth) * place.original;
            place
        })
    }

    /// The [`places`](Self::places) in `len` numbers, from the highest azimuth down.
    pub(super) fn descent(self, len: usize) -> impl Iterator<Item = Place> {
        let mut end = len;
        (0..self.lengths.len()).rev().map(move |azimuth| {
            let place = self.place(azimuth, end);
            end = end.saturating_sub(signs(azimuth) * place.original);
            Place { start: end, ..place }
        })
    }

    /// The density for polynomials of these lengths.
    fn density(lengths: &[u16]) -> Density {
        let left = lengths.iter().enumerate().filter(|(_, length)| **length > 0);
        let terms = left.map(|(azimuth, &length)| azimuth + usize::from(length));
        Density::new(terms.max().unwrap_or(0))
    }

    /// Converts a scene's polynomials, times `scale`, into orthonormal ones. Polynomials of
    /// which no term is kept stay as they are.
    pub(super) fn orthonormalize(self, kept: &[u16], numbers: &mut [f32], scale: f32) {
        let (mut density, mut rows) = (Self::density(kept), Rows::new());
        for (place, _) in self.places().zip(kept).filter(|(_, kept)| **kept > 0) {
            density.turn_to(place.azimuth);
            let sizes = sizes(place.azimuth, density.below());
            let both = place.both_mut(numbers);
            rows.orthogonalize(both, &density, sizes.map(|size| size * scale));
        }
    }

    /// Moves the remaining terms to the beginning, in the form of these lengths, times `scale`.
    pub(super) fn restore(self, lengths: &[u16], numbers: &mut [f32], scale: f32) {
        let (mut density, mut rows) = (Self::density(lengths), Rows::new());
        let (cells, mut end) = (Cell::from_mut(&mut *numbers).as_slice_of_cells(), 0);
        for (place, &length) in self.places().zip(lengths) {
            // Terms move toward the beginning, and never onto terms that have yet to move.
            for terms in place.both(cells) {
                let length = usize::from(length).min(terms.len());
                let kept = terms.iter().skip(terms.len() - length);
                cells.iter().skip(end).zip(kept).for_each(|(to, term)| to.set(term.get()));
                end += length;
            }
        }
        for made in (Polynomials { lengths }).places().filter(|made| made.original > 0) {
            let over = |size: f32| size.recip() * scale;
            density.turn_to(made.azimuth);
            times(made.both_mut(numbers), sizes(made.azimuth, density.below()).map(over));
            rows.rewrite(made.both_mut(numbers), &density);
        }
    }

    /// The sum of the squares of the terms that these lengths leave out.
    pub(super) fn left_out(self, lengths: &[u16], numbers: &[f32]) -> f32 {
        let mut sum = 0.0;
        let lengths = lengths.iter().copied().chain(core::iter::repeat(0));
        for (place, length) in self.places().zip(lengths) {
            let gone = place.original.saturating_sub(usize::from(length));
            place.squares(numbers, place.original).take(gone).for_each(|square| sum += square);
        }
        sum
    }

    /// Whether polynomials of these lengths can be made from these: none is longer.
    pub(super) fn can_become(self, lengths: &[u16]) -> bool {
        lengths.len() <= self.lengths.len()
            && lengths.iter().zip(self.lengths).all(|(length, original)| length <= original)
    }
}

/// Multiplies the terms of both polynomials by the numbers, beginning with the lowest term.
fn times([plus, minus]: [&mut [f32]; 2], numbers: impl Iterator<Item = f32>) {
    let mut minus = minus.iter_mut().rev();
    for (term, number) in plus.iter_mut().rev().zip(numbers) {
        *term *= number;
        minus.next().into_iter().for_each(|term| *term *= number);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::normal::Normal;
    use crate::scene::{Scene, count};

    /// Short and long polynomials, and an azimuth far above the others.
    const CASES: [&[u16]; 3] = [&[1], &[16, 3, 15, 16], &[2, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 12]];

    fn numbers(lengths: &[u16]) -> [f32; 500] {
        let used = count(lengths);
        core::array::from_fn(|k| {
            let number = ((7 * k % 19) as f32 - 9.0) / (1 + k % 5) as f32;
            if k < used { number } else { 0.0 }
        })
    }

    /// The mean square over a sphere's normals, of density 2z dz, by Simpson's rule along z and
    /// equal steps around.
    fn over_the_sphere(scene: &Scene<'_, &[f32]>) -> f64 {
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
                let [x, y, z] = [sine * x, sine * y, z].map(|along| along as f32);
                let value = f64::from(scene.shade(Normal { x, y, z }));
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
            let polynomials = Polynomials { lengths };
            polynomials.orthonormalize(lengths, &mut terms, 0.5);
            let sum: f64 = terms.iter().map(|&term| f64::from(term).powi(2)).sum();
            let mean = over_the_sphere(&Scene::of(lengths, &numbers));
            assert!((4.0 * sum - mean).abs() < 1e-4 * mean, "{lengths:?}: {sum}, {mean}");
            polynomials.restore(lengths, &mut terms, 2.0);
            for (term, number) in terms.iter().zip(&numbers) {
                assert!((term - number).abs() < 1e-3, "{lengths:?}: {term}, {number}");
            }
        }
    }
}
