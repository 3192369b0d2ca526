//! Chooses the terms of several images' polynomials that a tolerance allows to leave out.
//!
//! Terms are removed from the highest of an azimuth down, those of +m and -m together. The price of
//! a removal rises from sweep to sweep, so the first terms to go are those that cost least for each
//! product that a pixel saves. The result has few terms, but not provably the fewest.
//!
//! Each image keeps its own account. Terms are removed only if every image can pay for them. The
//! price is the same fraction of each image's allowed error, so every image's bound is exact.

use super::density::mean_square;
use super::report::Truncation;
use super::terms::{Place, Polynomials, signs, used};
use crate::scalar::Scalar;

/// The factor by which the price rises from one sweep to the next.
const RISE: usize = 16;

/// Whether a loop over twenty nodes costs little more than one over four numbers.
const LANES_ARE_CHEAP: bool = cfg!(any(target_arch = "x86_64", target_arch = "aarch64"));

/// Number of multiply-adds in the complex products that sum the azimuths up to the highest.
const fn around(highest: usize) -> usize {
    (4 * highest).saturating_sub(2)
}

/// Images in orthonormal polynomials, and the report on each. At this stage the reports hold
/// squares, and `bound` holds the square of the allowed error.
pub(super) struct Accounts<'s, S> {
    pub(super) polynomials: Polynomials<'s>,
    /// The numbers of all images, `len` for each.
    pub(super) numbers: &'s [S],
    pub(super) len: usize,
    pub(super) report: &'s mut [Truncation<S>],
}

impl<S: Scalar> Accounts<'_, S> {
    /// Leaves out whole azimuths from the highest down, as the first sweep would, as long as all
    /// images can pay. Their cost is known before anything is rewritten. `scale` is the factor by
    /// which an image's numbers have yet to be multiplied.
    pub(super) fn truncate_azimuths(
        &mut self,
        lengths: &mut [u16],
        scale: impl Fn(&Truncation<S>) -> S,
    ) {
        // Without vector lanes this costs more than it saves.
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
            for (numbers, report) in
                self.numbers.chunks_exact(self.len.max(1)).zip(&mut *self.report)
            {
                let both = place.both(numbers);
                let Some(square) = mean_square(azimuth, both, scale(report)) else { return };
                // Stored here until every image has been asked.
                report.floor = square;
                let pays = report.floor <= left(report) && report.floor <= worth * report.bound;
                if !pays {
                    return;
                }
            }
            self.report.iter_mut().for_each(|report| report.left_out_by_terms += report.floor);
            *length = 0;
        }
    }

    /// The price of the first sweep, low enough that removals at this price use little of the
    /// allowed error.
    fn first_price(&self) -> S {
        S::from_whole(self.len.max(1)).reciprocal()
    }

    /// Shortens `lengths`, which are initially those of the polynomials or 0, as long as no image
    /// exceeds its allowed error.
    pub(super) fn truncate(&mut self, lengths: &mut [u16]) {
        let rise = S::from_whole(RISE);
        let mut price = self.first_price();
        while price < S::ONE {
            self.sweep(lengths, price);
            price = price * rise;
        }
        // Finally accept any price: a term that stays now could never be removed.
        self.sweep(lengths, S::from_whole(self.len.max(1)));
    }

    /// Removes all terms that are worth a price, from the highest azimuth down.
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

    /// Removes as many terms of an azimuth as all images can pay for, at most this share of each
    /// image's allowed error for each product that a pixel saves. The last term saves no product by
    /// itself; in the highest azimuth it saves `around`.
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
            for (numbers, report) in images.clone().zip(&*self.report) {
                let (left, of_one) = (left(report), of_one * report.bound);
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
                        worth = worth.add_product(of_last, report.bound);
                    }
                    if sum <= worth {
                        (gone, paid) = (index + 1, sum);
                    } else if around.is_none() {
                        break;
                    }
                }
                terms = gone;
            }
            // If an image could pay for fewer terms, the images before it are asked again.
            if terms == before || self.report.len() == 1 {
                break;
            }
        }
        if let [report] = &mut *self.report {
            report.left_out_by_terms += paid;
        } else if terms > 0 {
            for (numbers, report) in images.zip(&mut *self.report) {
                let squares = place.squares(numbers, length).take(terms);
                squares.for_each(|square| report.left_out_by_terms += square);
            }
        }
        terms
    }
}

/// The part of an image's allowed error that is left.
fn left<S: Scalar>(report: &Truncation<S>) -> S {
    let left = report.bound - report.left_out_by_components - report.left_out_by_terms;
    if left > S::ZERO { left } else { S::ZERO }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recurrences::Recurrences;

    /// Asked first, one image could lose both terms of m = 2 in exchange for the azimuth that a
    /// pixel saves. The other can lose only one term, and for one term the first image would pay
    /// too much. Terms of m = 0 then use what these would have cost.
    #[test]
    fn the_order_of_images_changes_nothing() {
        const LENGTHS: &[u16] = &[6, 0, 2];
        const LEN: usize = 10;
        let polynomials = Polynomials { lengths: LENGTHS, recurrences: Recurrences::NONE };
        // Squares, in units of the first price.
        let image = |zero: f64, [highest, lowest]: [f64; 2]| {
            let squares = [zero, zero, zero, zero, zero, 9.0, highest, lowest, 0.0, 0.0];
            squares.map(|square| libm::sqrt(square / LEN as f64))
        };
        let (one, two) = (image(0.9, [7.0, 0.9]), image(0.0, [0.9, 100.0]));
        let spared = |images: [[f64; LEN]; 2]| {
            let mut report = [Truncation { bound: 1.0, ..Truncation::default() }; 2];
            let (numbers, mut lengths) = (images.as_flattened(), [6, 0, 2]);
            Accounts { polynomials, numbers, len: LEN, report: &mut report }.truncate(&mut lengths);
            for (image, report) in images.iter().zip(report) {
                let left_out = polynomials.left_out(&lengths, image);
                assert!((left_out - report.left_out_by_terms).abs() < 1e-15 && left_out <= 1.0);
            }
            lengths
        };
        assert_eq!(spared([one, two]), [1, 0, 2]);
        assert_eq!(spared([two, one]), [1, 0, 2]);
    }

    /// Azimuths that are removed as a whole before anything is rewritten would also have been
    /// removed afterward.
    #[test]
    fn whole_azimuths_go_as_in_the_sweeps() {
        const LENGTHS: [u16; 5] = [6, 4, 5, 3, 4];
        const LEN: usize = 6 + 2 * (4 + 5 + 3 + 4);
        let polynomials = Polynomials { lengths: &LENGTHS, recurrences: Recurrences::NONE };
        let mut early = 0;
        for exponent in 0..40 {
            let numbers: [f64; LEN] = core::array::from_fn(|k| {
                let number = (7 * k % 19) as f64 - 9.0;
                if k < 6 { number } else { number * libm::exp(-(k as f64) / 4.0) }
            });
            let report = [Truncation { bound: 2f64.powi(-exponent), ..Truncation::default() }];
            let shape = |first: bool| {
                let (mut lengths, mut numbers, mut report) = (LENGTHS, numbers, report);
                if first {
                    Accounts { polynomials, numbers: &numbers, len: LEN, report: &mut report }
                        .truncate_azimuths(&mut lengths, |_| 1.0);
                }
                let gone = lengths.iter().filter(|&&length| length == 0).count();
                polynomials.orthonormalize(&lengths, &mut numbers, 1.0);
                Accounts { polynomials, numbers: &numbers, len: LEN, report: &mut report }
                    .truncate(&mut lengths);
                (lengths, gone)
            };
            let ((found, gone), (expected, _)) = (shape(true), shape(false));
            assert_eq!(found, expected, "2^-{exponent}");
            early += gone;
        }
        assert!(early > 0 || !LANES_ARE_CHEAP);
    }
}
