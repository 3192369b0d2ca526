//! The irradiance of one normal: I(n) = Σ_m Re/Im (n_x + i n_y)^m H_m(n_z), azimuth by azimuth.

use super::{Basis, Normal};
use crate::format::{FixedPoint, Wide as _};
use crate::invariant::part;
use crate::places::{AzimuthPlace, KnownTable};

/// A pixel in progress: the sum so far, and (n_x + i n_y)^m for the next m.
#[derive(Clone, Copy, Debug)]
pub struct Pixel<Q: FixedPoint> {
    normal: Normal<Q>,
    t: i32,
    cosine: i32,
    sine: i32,
    sum: Q::Wide,
}

impl<Q: FixedPoint> Pixel<Q> {
    /// Starts with the polynomial of m = 0.
    #[inline(always)]
    pub(crate) fn new(polynomial: &[i32], normal: Normal<Q>) -> Self {
        let t = Q::argument(normal.z);
        // The last step of m = 0 needs no rounding.
        let (last, first) = polynomial.split_last().unwrap_or((&0, &[]));
        let sum = Q::product(value::<Q>(first, t), t).wrapping_plus(Q::of_value(*last));
        Self { normal, t, cosine: normal.x.halved(), sine: normal.y.halved(), sum }
    }

    /// Adds the polynomials of +m and -m, and moves to m + 1.
    #[inline(always)]
    pub(crate) fn add(self, plus: &[i32], minus: &[i32]) -> Self {
        let Self { normal: Normal { x, y, .. }, t, cosine, sine, sum } = self;
        let plus = Q::product(value::<Q>(plus, t), cosine);
        let minus = Q::product(value::<Q>(minus, t), sine);
        Self {
            cosine: Q::dot(cosine, x, -sine, y),
            sine: Q::dot(cosine, y, sine, x),
            sum: sum.wrapping_plus(plus).wrapping_plus(minus),
            ..self
        }
    }

    /// Starts with m = 0 of a scene of `B`.
    #[inline(always)]
    pub fn start<B: KnownTable<Basis<'static, Q>>, const N: usize>(
        terms: &[i32; N],
        normal: Normal<Q>,
    ) -> Self {
        let length = const { B::BASIS.length(0) };
        Self::new(part(terms, ..length), normal)
    }

    /// Adds azimuth `M` of a scene of `B`.
    #[inline(always)]
    pub fn azimuth<B: KnownTable<Basis<'static, Q>>, const M: usize, const N: usize>(
        self,
        terms: &[i32; N],
    ) -> Self {
        let AzimuthPlace { start, length, .. } = const { B::BASIS.azimuth_at(M) };
        let [plus, minus] = [start, start + length].map(|start| part(terms, start..start + length));
        self.add(plus, minus)
    }

    /// The irradiance.
    #[inline(always)]
    pub fn irradiance(self) -> i32 {
        Q::sum(self.sum)
    }
}

/// The value of a polynomial by Horner's rule, with each step rounded down. No step overflows for a
/// table; the steps of a table that states its sizes too small may wrap.
#[inline(always)]
fn value<Q: FixedPoint>(terms: &[i32], t: i32) -> i32 {
    let Some((&first, rest)) = terms.split_first() else { return 0 };
    let mut sum = first;
    for &term in rest {
        sum = Q::argument_times(sum, t).wrapping_add(term);
    }
    sum
}
