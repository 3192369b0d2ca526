//! A pixel for which every length is known at compile time, for the generated modules of
//! `eigenshade-table`: the steps of [`Scene::shade`](super::Scene::shade), unrolled.

pub mod collapse;
pub mod relight;
pub mod transfer;

use super::Normal;
use crate::format::{FixedPoint, Wide as _};

/// A pixel in progress: the sum so far, and (n_x + i n_y)^m.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Pixel<Q: FixedPoint> {
    normal: Normal<Q>,
    t: i32,
    cosine: i32,
    sine: i32,
    sum: Q::Wide,
}

impl<Q: FixedPoint> Pixel<Q> {
    /// Starts with m = 0, whose polynomial is the first `LENGTH` terms.
    #[inline(always)]
    #[must_use]
    pub fn new<const LENGTH: usize, const N: usize>(terms: &[i32; N], normal: Normal<Q>) -> Self {
        let t = Q::argument(normal.z);
        let first = terms.get(..LENGTH).unwrap_or_default();
        let (last, first) = first.split_last().unwrap_or((&0, &[]));
        let sum = Q::product(value::<Q>(first, t), t).wrapping_plus(Q::of_value(*last));
        Self { normal, t, cosine: normal.x.halved(), sine: normal.y.halved(), sum }
    }

    /// Adds the current m. The polynomial of +m begins at `START`, and that of -m follows it. Adds
    /// nothing if `LENGTH` is 0.
    #[inline(always)]
    #[must_use]
    pub fn azimuth<const START: usize, const LENGTH: usize, const N: usize>(
        self,
        terms: &[i32; N],
    ) -> Self {
        let plus = terms.get(START..START + LENGTH).unwrap_or_default();
        let minus = terms.get(START + LENGTH..START + 2 * LENGTH).unwrap_or_default();
        let plus = Q::product(value::<Q>(plus, self.t), self.cosine);
        let minus = Q::product(value::<Q>(minus, self.t), self.sine);
        Self { sum: self.sum.wrapping_plus(plus).wrapping_plus(minus), ..self }
    }

    /// Moves from m to m + 1.
    #[inline(always)]
    #[must_use]
    pub fn turned(self) -> Self {
        let (x, y) = (self.normal.x, self.normal.y);
        Self {
            cosine: Q::dot(self.cosine, x, -self.sine, y),
            sine: Q::dot(self.cosine, y, self.sine, x),
            ..self
        }
    }

    /// The irradiance.
    #[inline(always)]
    #[must_use]
    pub fn irradiance(self) -> i32 {
        Q::sum(self.sum)
    }
}

/// The value of a polynomial by Horner's rule, with each step rounded down. No step overflows for a
/// table; the steps of a table that states its sizes too small may wrap.
#[inline(always)]
pub(crate) fn value<Q: FixedPoint>(terms: &[i32], t: i32) -> i32 {
    let Some((&first, rest)) = terms.split_first() else { return 0 };
    let mut sum = first;
    for &term in rest {
        sum = Q::argument_times(sum, t).wrapping_add(term);
    }
    sum
}
