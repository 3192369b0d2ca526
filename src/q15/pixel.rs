//! The irradiance of one normal: I(n) = Σ_m Re/Im (n_x + i n_y)^m H_m(n_z), azimuth by azimuth.

use super::arithmetic::{self, argument, argument_times, dot, halved, of_value, product};
use super::{Basis, Normal};
use crate::checked_slice::part;
use crate::specialized::{KnownTable, at};

/// A pixel in progress: the sum so far, and (n_x + i n_y)^m for the next m.
#[derive(Clone, Copy, Debug)]
pub struct Pixel {
    normal: Normal,
    t: i32,
    cosine: i32,
    sine: i32,
    sum: i32,
}

impl Pixel {
    /// Starts with the polynomial of m = 0.
    #[inline(always)]
    pub(crate) fn new(polynomial: &[i32], normal: Normal) -> Self {
        let t = argument(normal.z);
        // The last step of m = 0 needs no rounding.
        let (last, first) = polynomial.split_last().unwrap_or((&0, &[]));
        let sum = product(value(first, t), t).wrapping_add(of_value(*last));
        Self { normal, t, cosine: halved(normal.x), sine: halved(normal.y), sum }
    }

    /// Adds the polynomials of +m and -m, and moves to m + 1.
    #[inline(always)]
    pub(crate) fn add(self, plus: &[i32], minus: &[i32]) -> Self {
        let Self { normal: Normal { x, y, .. }, t, cosine, sine, sum } = self;
        let plus = product(value(plus, t), cosine);
        let minus = product(value(minus, t), sine);
        Self {
            cosine: dot(cosine, x, -sine, y),
            sine: dot(cosine, y, sine, x),
            sum: sum.wrapping_add(plus).wrapping_add(minus),
            ..self
        }
    }

    /// Starts with m = 0 of a scene of `B`.
    #[inline(always)]
    pub fn start<B: KnownTable<Basis<'static>>, const N: usize>(
        terms: &[i32; N],
        normal: Normal,
    ) -> Self {
        let length = const { B::BASIS.length(0) };
        Self::new(part(terms, ..length), normal)
    }

    /// Adds azimuth `M` of a scene of `B`.
    #[inline(always)]
    pub fn azimuth<B: KnownTable<Basis<'static>>, const M: usize, const N: usize>(
        self,
        terms: &[i32; N],
    ) -> Self {
        let start = const { at(B::BASIS.parts.azimuths, M).start as usize };
        let length = const { B::BASIS.length(M) };
        let [plus, minus] = [start, start + length].map(|start| part(terms, start..start + length));
        self.add(plus, minus)
    }

    /// The irradiance.
    #[inline(always)]
    pub fn irradiance(self) -> i32 {
        arithmetic::sum(self.sum)
    }
}

/// The value of a polynomial by Horner's rule, with each step rounded down. No step overflows for a
/// table; the steps of a table that states its sizes too small may wrap.
#[inline(always)]
fn value(terms: &[i32], t: i32) -> i32 {
    let Some((&first, rest)) = terms.split_first() else { return 0 };
    let mut sum = first;
    for &term in rest {
        sum = argument_times(sum, t).wrapping_add(term);
    }
    sum
}
