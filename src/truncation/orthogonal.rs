//! Converts polynomials from an even and an odd half into orthogonal polynomials, and back. Both
//! directions use Horner's rule: the sum so far times 2t, plus the next term. +m and -m are
//! converted side by side.

use super::density::Density;
use crate::groups::multiply_add;
use crate::index::layout::{LANES, MAX_TERMS};

/// Room for numbers, lowest first, after a zero and with zeros behind them.
const ROOM: usize = MAX_TERMS + 4;

/// Pairs of numbers, one of +m and one of -m.
type Row = [[f32; 2]; ROOM];

pub(super) struct Rows {
    now: Row,
    next: Row,
    at: Row,
    below: Row,
    /// Stands in for the terms of -m if there are none.
    none: [f32; MAX_TERMS],
}

impl Rows {
    pub(super) const fn new() -> Self {
        let row = [[0.0; 2]; ROOM];
        Self { now: row, next: row, at: row, below: row, none: [0.0; MAX_TERMS] }
    }

    /// Converts polynomials of +m and -m, highest term first, into orthogonal ones times `numbers`.
    pub(super) fn orthogonalize(
        &mut self,
        [plus, minus]: [&mut [f32]; 2],
        density: &Density,
        numbers: impl Iterator<Item = f32>,
    ) {
        let length = plus.len();
        self.start(length, density);
        let Self { now, next, at, below, none } = self;
        let (mut now, mut next) = (now, next);
        let minus = if minus.is_empty() { none.as_mut_slice() } else { minus };
        for (index, (&term, &other)) in plus.iter().zip(&*minus).enumerate() {
            let ([_, here @ ..], [_, below @ ..]) = (&*now, &*below);
            let ([_, higher @ ..], [_, sums @ ..]) = (here, &mut *next);
            let terms = groups(now).iter().zip(groups(here)).zip(groups(higher));
            let terms = groups(at).iter().zip(groups(below)).zip(terms);
            let sums = groups_mut(sums).iter_mut().zip(terms).take(index / 2 + 1);
            // u = (2t)²/2 - 1: the last sum already contains one factor 2t, and `sum` is the one
            // before it.
            if (length - index) % 2 == 1 {
                for (sum, ((at, below), ((lower, here), higher))) in sums {
                    let whole = multiply_add(multiply_add(*lower, here, at), higher, below);
                    *sum = multiply_add(sum.map(|sum| -sum), &whole, &[0.5; LANES]);
                }
            } else {
                for (sum, ((at, below), ((lower, here), higher))) in sums {
                    *sum = multiply_add(multiply_add(*lower, here, at), higher, below);
                }
            }
            add(next, [term, other]);
            (now, next) = (next, now);
        }
        let both = plus.iter_mut().rev().zip(minus.iter_mut().rev());
        for ((pair, number), (plus, minus)) in now.iter().skip(1).zip(numbers).zip(both) {
            [*plus, *minus] = pair.map(|sum| sum * number);
        }
    }

    /// Converts orthogonal polynomials of +m and -m into an even and an odd half.
    pub(super) fn rewrite(&mut self, [plus, minus]: [&mut [f32]; 2], density: &Density) {
        let length = plus.len();
        self.start(length, density);
        let Self { now, next, at, below, none } = self;
        let (mut now, mut next) = (now, next);
        let minus = if minus.is_empty() { none.as_mut_slice() } else { minus };
        let recurrence = at.iter().zip(below.iter().skip(1)).take(length).rev();
        let both = plus.iter().zip(&*minus).zip(recurrence);
        for (index, ((&term, &other), (&[at, _], &[below, _]))) in both.enumerate() {
            let (at, below) = ([-at; LANES], [-below; LANES]);
            let ([_, here @ ..], [_, sums @ ..]) = (&*now, &mut *next);
            let [_, higher @ ..] = here;
            let terms = groups(now).iter().zip(groups(here)).zip(groups(higher));
            let sums = groups_mut(sums).iter_mut().zip(terms).take(index / 2 + 1);
            for (sum, ((&[even, more, odd, another], here), &[up, down, ..])) in sums {
                // 2t times t is u + 1.
                let times = [even + up, more + down, odd + odd, another + another];
                *sum = multiply_add(multiply_add(times, here, &at), sum, &below);
            }
            add(next, [term, other]);
            (now, next) = (next, now);
        }
        let both = plus.iter_mut().rev().zip(minus.iter_mut().rev());
        for (&pair, (plus, minus)) in now.iter().skip(1).zip(both) {
            [*plus, *minus] = pair;
        }
    }

    /// Clears the rows for polynomials of `length` terms, and loads the recurrence.
    fn start(&mut self, length: usize, density: &Density) {
        let of = self.now.iter_mut().zip(&mut self.next).zip(&mut self.at).zip(&mut self.below);
        for ((((now, next), at), below), &[of_at, of_below]) in
            of.zip(&density.recurrence).take(length + 4)
        {
            (*now, *next, *at, *below) = ([0.0; 2], [0.0; 2], [of_at; 2], [of_below; 2]);
        }
    }
}

/// Adds terms to the lowest numbers.
#[inline(always)]
fn add([_, lowest, ..]: &mut Row, terms: [f32; 2]) {
    let ([a, b], [c, d]) = (*lowest, terms);
    *lowest = [a + c, b + d];
}

/// The groups of a row's pairs.
#[inline(always)]
fn groups(row: &[[f32; 2]]) -> &[[f32; LANES]] {
    row.as_flattened().as_chunks().0
}

#[inline(always)]
fn groups_mut(row: &mut [[f32; 2]]) -> &mut [[f32; LANES]] {
    row.as_flattened_mut().as_chunks_mut().0
}
