//! Collapses a scene with all sizes constant: the steps of
//! [`Basis::collapse_into`](crate::quantized::Basis::collapse_into), azimuth by azimuth.

use crate::format::FixedPoint;
use crate::quantized::scene::{
    self, FINEST, Scene, SceneBuffer, bits, half_or_one, size, weight, with_margin,
};
use crate::quantized::{Basis, Coefficients};

/// The terms of a scene, to be filled for this basis.
#[inline(always)]
pub fn terms<'s, 'a, Q: FixedPoint, const N: usize>(
    basis: &Basis<'a, Q>,
    scene: &'s mut Scene<'a, Q, SceneBuffer<N>>,
) -> Option<&'s mut [i32; N]> {
    scene.lengths = basis.parts.lengths;
    scene.buffer.filled()
}

/// The mantissas of exactly `K` coefficients, if
/// [`Basis::collapse_into`](crate::quantized::Basis::collapse_into) accepts their exponent.
#[inline(always)]
#[must_use]
pub fn mantissas<const K: usize>(coefficients: &Coefficients<K>) -> Option<&[i32; K]> {
    if coefficients.exponent.unsigned_abs() > 1 << 16 {
        return None;
    }
    coefficients.mantissas.as_slice().try_into().ok()
}

/// How large the terms, steps and irradiances of a scene with `A` azimuths can get: sums of |d|
/// times the values that the table states for each profile. Domain: these values sum to less than
/// 2^16, the sizes over all components, the steps over those of an azimuth.
#[derive(Clone, Copy, Debug)]
pub struct Size<const A: usize> {
    image: u32,
    plus: u32,
    minus: u32,
    steps: [u32; A],
}

/// The number of bits of a scene, and the shifts of its weights.
#[derive(Clone, Copy, Debug)]
pub struct Shifts<const A: usize> {
    bits: i32,
    base: i32,
    finer: [u32; A],
}

impl<const A: usize> Size<A> {
    /// The size of a black image.
    #[inline(always)]
    #[must_use]
    pub const fn empty() -> Self {
        Self { image: 0, plus: 0, minus: 0, steps: [0; A] }
    }

    /// Adds the components `PLUS` and `MINUS` of a profile.
    #[inline(always)]
    #[must_use]
    pub fn profile<
        const PLUS: usize,
        const MINUS: usize,
        const SIZE: u32,
        const STEP: u32,
        const K: usize,
    >(
        self,
        d: &[i32; K],
    ) -> Self {
        let size = |index: usize| d.get(index).copied().map_or(0, size);
        let (plus, minus) = (size(PLUS), size(MINUS));
        Self {
            image: self.image.wrapping_add((plus + minus).wrapping_mul(SIZE)),
            plus: self.plus.wrapping_add(plus.wrapping_mul(STEP)),
            minus: self.minus.wrapping_add(minus.wrapping_mul(STEP)),
            ..self
        }
    }

    /// Finishes azimuth number `M` of those that have profiles.
    #[inline(always)]
    #[must_use]
    pub fn azimuth<const M: usize>(mut self) -> Self {
        if let Some(step) = self.steps.get_mut(M) {
            *step = self.plus.max(self.minus);
        }
        Self { plus: 0, minus: 0, ..self }
    }

    /// The shifts for a table of this degree, whose profiles have exponents from `least` to
    /// `largest`. `None` if there is hardly an image, or if weights that are coarser than d would
    /// have to be shifted left, or right by more bits than they have.
    #[inline(never)]
    #[must_use]
    pub fn shifts<Q: FixedPoint>(
        &self,
        degree: usize,
        [least, largest]: [i32; 2],
    ) -> Option<Shifts<A>> {
        let most = self.steps.iter().copied().fold(self.image, u32::max);
        let bits = bits(most.into(), degree);
        let base = -scene::base::<Q>(bits);
        let most_finer = FINEST.cast_signed();
        let beyond = base - most_finer <= largest || base - least > 31;
        if bits < 20 || (is_coarse::<Q>() && beyond) {
            return None;
        }
        let finer = self.steps.map(|step| {
            // The top bits show by how many bits the step is shorter, up to `FINEST`: the same
            // result as with `bits`.
            let upper = with_margin(step, degree) >> (bits - 12 - most_finer);
            FINEST.saturating_sub(upper)
        });
        Some(Shifts { bits, base, finer })
    }
}

impl<const A: usize> Shifts<A> {
    /// By how many bits the weights of azimuth number `M` are finer.
    #[inline(always)]
    #[must_use]
    pub fn finer<const M: usize>(&self) -> u32 {
        self.finer.get(M).copied().unwrap_or(0)
    }

    /// The rounded weight of a component whose profile has the exponent `EXPONENT`.
    #[inline(always)]
    #[must_use]
    pub fn weight<Q: FixedPoint, const COMPONENT: usize, const EXPONENT: i32, const K: usize>(
        &self,
        d: &[i32; K],
        finer: u32,
    ) -> i32 {
        let d = d.get(COMPONENT).copied().unwrap_or(0);
        if !is_coarse::<Q>() {
            return weight(d, EXPONENT - self.base + finer.cast_signed());
        }
        let by = (self.base - EXPONENT - 1).cast_unsigned().wrapping_sub(finer) & 31;
        (d >> by).wrapping_add(1) >> 1
    }
}

/// Whether weights have no more bits than d.
#[inline(always)]
const fn is_coarse<Q: FixedPoint>() -> bool {
    Q::WEIGHT_BITS + Q::TERM_BITS <= 31
}

/// Writes the polynomials of one azimuth: `P` profiles of `L` terms from `START` on, times the
/// weights of their components, which are `finer` by that many bits. With `W` = 1 only +m is
/// computed, otherwise +m and -m. The result goes to the scene's terms from `TO` on.
#[inline(never)]
pub fn azimuth<
    Q: FixedPoint,
    const START: usize,
    const TO: usize,
    const P: usize,
    const W: usize,
    const L: usize,
    const T: usize,
    const N: usize,
>(
    terms: &'static [Q; T],
    weights: &[[i32; W]; P],
    finer: u32,
    scene: &mut [i32; N],
) {
    let by = Q::SUM_SHIFT + finer;
    let rows = terms.get(START..).unwrap_or_default().as_chunks::<L>().0;
    let Some(rows) = rows.first_chunk::<P>() else { return };
    let polynomials = scene.get_mut(TO..).unwrap_or_default().as_chunks_mut::<L>().0;
    let Some(polynomials) = polynomials.first_chunk_mut::<W>() else { return };
    for k in 0..L {
        let mut sums = [half_or_one(k == 0 || (W == 1 && k == L - 1), by); W];
        for (row, weights) in rows.iter().zip(weights) {
            let term = row.get(k).copied().unwrap_or_default();
            for (sum, &weight) in sums.iter_mut().zip(weights) {
                *sum = sum.wrapping_add(term.weigh(weight));
            }
        }
        for (polynomial, sum) in polynomials.iter_mut().zip(sums) {
            if let Some(place) = polynomial.get_mut(k) {
                *place = sum >> (by & 31);
            }
        }
    }
    let mut either = [0; W];
    for weights in weights {
        for (either, weight) in either.iter_mut().zip(weights) {
            *either |= weight;
        }
    }
    for (polynomial, either) in polynomials.iter_mut().zip(either) {
        if either == 0 {
            polynomial.fill(0);
        }
    }
}

/// Writes the exponent of a scene.
#[inline(always)]
pub fn finish<'a, Q: FixedPoint, const K: usize, const N: usize, const A: usize>(
    coefficients: &Coefficients<K>,
    shifts: &Shifts<A>,
    scene: &mut Scene<'a, Q, SceneBuffer<N>>,
) {
    scene.exponent = coefficients.exponent + shifts.bits - Q::TERM_BITS.cast_signed();
}
