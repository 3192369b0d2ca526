//! Chooses the terms of several images' polynomials that a tolerance allows to leave out.
//!
//! Terms are removed from the highest of an azimuth down, with +m and -m together. The price of a
//! removal rises from sweep to sweep, so the first terms to go are those that cost least for each
//! product that a pixel saves. The result has few terms, but not provably the fewest.
//!
//! Each image keeps its own account. Terms are removed only if the account of every image covers
//! the price. The price is the same fraction of each image's allowed error, so every image's bound
//! is exact.

use super::density::{NODES, mean_square};
use super::report::Truncation;
use super::terms::{Polynomials, trimmed};
use crate::basis::signs;
use crate::checked_slice::rows;

/// The factor by which the price rises from one sweep to the next.
const RISE: usize = 16;

/// Whether a loop over twenty nodes costs little more than one over four numbers.
const LANES_ARE_CHEAP: bool = cfg!(any(target_arch = "x86_64", target_arch = "aarch64"));

/// Number of multiply-adds in the complex products that sum the azimuths up to the highest.
const fn around(highest: usize) -> usize {
    (4 * highest).saturating_sub(2)
}

/// Number of these multiply-adds that go with the highest azimuth, from the lengths below it.
fn around_saved(below: &[u16]) -> usize {
    around(below.len()) - around(trimmed(below).len().saturating_sub(1))
}

/// Images in the same polynomials, and the report on each. At this stage the reports hold squares,
/// and `bound` holds the square of the allowed error.
pub(super) struct Accounts<'s> {
    pub(super) polynomials: Polynomials<'s>,
    /// The numbers of all images, `len` for each.
    pub(super) numbers: &'s [f32],
    pub(super) len: usize,
    pub(super) reports: &'s mut [Truncation],
}

impl<'s> Accounts<'s> {
    /// Leaves out whole azimuths from the highest down, as the first sweep would, as long as all
    /// images can pay. This precedes the conversion into orthonormal polynomials.
    pub(super) fn truncate_azimuths(&mut self, lengths: &mut [u16]) {
        // Without vector lanes this costs more than it saves.
        if !LANES_ARE_CHEAP {
            return;
        }
        for place in self.polynomials.descent(self.len).filter(|place| place.original > 0) {
            let (azimuth, terms) = (place.azimuth, place.original);
            let exact = azimuth + terms <= NODES.len();
            let Some((below, [length, ..])) = lengths.split_at_mut_checked(azimuth) else { return };
            if !exact {
                return;
            }
            let saved = signs(azimuth) * (terms - 1) + around_saved(below);
            let square = |numbers: &'s [f32], report: &Truncation| {
                core::iter::once(mean_square(azimuth, place.both(numbers), report.scale()))
            };
            if self.pay(1, 0, Some(saved), square, self.first_price()) == 0 {
                return;
            }
            *length = 0;
        }
    }

    /// The price of the first sweep, so low that its removals use little of the allowed error.
    fn first_price(&self) -> f32 {
        ((self.len.max(1)) as f32).recip()
    }

    /// Shortens `lengths`, which are initially the polynomials' lengths or 0, as long as no image
    /// exceeds its allowed error. The polynomials are orthonormal.
    pub(super) fn truncate(&mut self, lengths: &mut [u16]) {
        let rise = RISE as f32;
        let mut price = self.first_price();
        while price < 1.0 {
            self.sweep(lengths, price);
            price *= rise;
        }
        // Finally accept any price: a term that stays now could never be removed.
        self.sweep(lengths, (self.len.max(1)) as f32);
    }

    /// Removes all terms that are worth a price, from the highest azimuth down.
    fn sweep(&mut self, lengths: &mut [u16], price: f32) {
        for place in self.polynomials.descent(self.len) {
            let at = lengths.split_at_mut_checked(place.azimuth);
            let Some((below, [length, above @ ..])) = at else { continue };
            if *length == 0 {
                continue;
            }
            let is_highest = above.iter().all(|&length| length == 0);
            let around = is_highest.then(|| around_saved(below));
            let terms = usize::from(*length);
            let each = signs(place.azimuth);
            let squares = |numbers: &'s [f32], _: &Truncation| place.squares(numbers, terms);
            *length -= self.pay(terms, each, around, squares, price) as u16;
        }
    }

    /// Lets all images pay for the first `terms` of these squares, or for as many as all can, and
    /// returns how many these are. Each saves a pixel `each` products, and the last of all saves
    /// `last`, or stays if that is `None`. A product is worth the price.
    fn pay<I: Iterator<Item = f32>>(
        &mut self,
        terms: usize,
        each: usize,
        last: Option<usize>,
        squares: impl Fn(&'s [f32], &Truncation) -> I,
        price: f32,
    ) -> usize {
        let (each, last) = ((each as f32), last.map(|number| number as f32));
        let (all, mut terms) = (terms, if last.is_some() { terms } else { terms - 1 });
        loop {
            let before = terms;
            for (numbers, report) in rows(self.numbers, self.len).zip(&mut *self.reports) {
                let (left, share) = (report.left(), price * report.bound);
                let (of_each, of_last) = (each * share, last.map(|last| last * share));
                let (mut sum, mut worth) = (0.0, 0.0);
                let (mut gone, mut paid) = (0, 0.0);
                for (index, square) in squares(numbers, report).take(terms).enumerate() {
                    sum += square;
                    let within = sum <= left;
                    if !within {
                        break;
                    }
                    worth += of_last.filter(|_| index + 1 == all).unwrap_or(of_each);
                    if sum <= worth {
                        (gone, paid) = (index + 1, sum);
                    } else if last.is_none() {
                        break;
                    }
                }
                // Held in `floor` until all images agree.
                (terms, report.floor) = (gone, paid);
            }
            // If an image could pay for fewer terms, the images before it are asked again.
            if terms == before || self.reports.len() == 1 {
                break;
            }
        }
        self.reports.iter_mut().for_each(|report| report.left_out_by_terms += report.floor);
        terms
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Asked first, one image could lose both terms of m = 2 in exchange for the azimuth that a
    /// pixel saves. The other can lose only one term, and for one term the first image would pay
    /// too much. Terms of m = 0 then use what these would have cost.
    #[test]
    fn the_order_of_images_changes_nothing() {
        const LENGTHS: &[u16] = &[6, 0, 2];
        const LEN: usize = 10;
        let polynomials = Polynomials { lengths: LENGTHS };
        // Squares, in units of the first price.
        let image = |zero: f32, [highest, lowest]: [f32; 2]| {
            let squares = [zero, zero, zero, zero, zero, 9.0, highest, lowest, 0.0, 0.0];
            squares.map(|square| libm::sqrtf(square / LEN as f32))
        };
        let (one, two) = (image(0.9, [7.0, 0.9]), image(0.0, [0.9, 100.0]));
        let spared = |images: [[f32; LEN]; 2]| {
            let mut report = [Truncation { bound: 1.0, ..Truncation::default() }; 2];
            let (numbers, mut lengths) = (images.as_flattened(), [6, 0, 2]);
            Accounts { polynomials, numbers, len: LEN, reports: &mut report }
                .truncate(&mut lengths);
            for (image, report) in images.iter().zip(report) {
                let left_out = polynomials.left_out(&lengths, image);
                assert!((left_out - report.left_out_by_terms).abs() < 1e-6 && left_out <= 1.0);
            }
            lengths
        };
        assert_eq!(spared([one, two]), [1, 0, 2]);
        assert_eq!(spared([two, one]), [1, 0, 2]);
    }

    /// The last term of an azimuth stays as long as a higher one has terms.
    #[test]
    fn last_terms_below_the_highest_azimuth_stay() {
        const LEN: usize = 3 + 2 * (2 + 2);
        let polynomials = Polynomials { lengths: &[3, 2, 2] };
        for (highest, expected) in [(100.0, [1, 1, 1]), (0.0, [0, 0, 0])] {
            // From the highest term down: the last of m = 2.
            let numbers: [f32; LEN] = core::array::from_fn(|k| if k == 8 { highest } else { 0.0 });
            let mut report = [Truncation { bound: 1.0, ..Truncation::default() }];
            let mut lengths = [3, 2, 2];
            Accounts { polynomials, numbers: &numbers, len: LEN, reports: &mut report }
                .truncate(&mut lengths);
            assert_eq!(lengths, expected, "{highest}");
        }
    }

    /// Azimuths removed as a whole before anything is rewritten would also be removed afterward.
    #[test]
    fn whole_azimuths_go_as_in_the_sweeps() {
        const LENGTHS: [u16; 5] = [6, 4, 5, 3, 4];
        const LEN: usize = 6 + 2 * (4 + 5 + 3 + 4);
        let polynomials = Polynomials { lengths: &LENGTHS };
        let mut early = 0;
        for exponent in 0..40 {
            let numbers: [f32; LEN] = core::array::from_fn(|k| {
                let number = (7 * k % 19) as f32 - 9.0;
                if k < 6 { number } else { number * libm::expf(-(k as f32) / 4.0) }
            });
            let report =
                Truncation { bound: 2f32.powi(-exponent), peak: 1.0, ..Default::default() };
            let shape = |first: bool| {
                let (mut lengths, mut numbers, mut report) = (LENGTHS, numbers, [report]);
                if first {
                    Accounts { polynomials, numbers: &numbers, len: LEN, reports: &mut report }
                        .truncate_azimuths(&mut lengths);
                }
                let gone = lengths.iter().filter(|&&length| length == 0).count();
                polynomials.orthonormalize(&lengths, &mut numbers, 1.0);
                Accounts { polynomials, numbers: &numbers, len: LEN, reports: &mut report }
                    .truncate(&mut lengths);
                (lengths, gone)
            };
            let ((found, gone), (expected, _)) = (shape(true), shape(false));
            assert_eq!(found, expected, "2^-{exponent}");
            early += gone;
        }
        assert!(early > 0 || !LANES_ARE_CHEAP);
    }

    /// The rule of whole azimuths is exact for as many terms as it has nodes, less the azimuth.
    #[test]
    fn whole_azimuths_go_only_if_the_rule_is_exact() {
        for (length, goes) in [(NODES.len() - 1, LANES_ARE_CHEAP), (NODES.len(), false)] {
            let (original, len) = ([0, length as u16], 2 * length);
            let polynomials = Polynomials { lengths: &original };
            let mut report = [Truncation { bound: 1.0, peak: 1.0, ..Truncation::default() }];
            let (numbers, mut lengths) = ([0.0; 2 * NODES.len()], original);
            let numbers = numbers.get(..len).unwrap_or(&numbers);
            Accounts { polynomials, numbers, len, reports: &mut report }
                .truncate_azimuths(&mut lengths);
            assert_eq!(lengths == [0, 0], goes, "{length}");
        }
    }
}
