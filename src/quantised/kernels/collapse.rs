//! A scene with every size a constant: the steps of
//! [`Basis::collapse_into`](crate::quantised::Basis::collapse_into), azimuth by azimuth.

use crate::format::{Fixed, Wide as _};
use crate::quantised::collapse::{Scene, SceneBuffer};
use crate::quantised::{Basis, Coefficients, Profile};

/// A scene's terms, to be written as those of this basis.
#[inline(always)]
pub fn terms<'s, 'a, Q: Fixed, const N: usize>(
    basis: &Basis<'a, Q>,
    scene: &'s mut Scene<'a, Q, SceneBuffer<N>>,
) -> Option<&'s mut [i32; N]> {
    scene.lengths = basis.parts.lengths;
    let _ = scene.buffer.resize_default(N);
    scene.buffer.as_mut_slice().try_into().ok()
}

/// The mantissas of exactly `K` coefficients, if their exponent is one that
/// [`Basis::collapse_into`](crate::quantised::Basis::collapse_into) takes.
#[inline(always)]
#[must_use]
pub fn mantissas<const K: usize>(coefficients: &Coefficients<K>) -> Option<&[i32; K]> {
    if coefficients.exponent.unsigned_abs() > 1 << 16 {
        return None;
    }
    coefficients.mantissas.as_slice().try_into().ok()
}

/// The polynomials of one azimuth: `P` profiles from `FIRST` on, of `L` terms from `START`
/// on, times the coefficients of their components, of +m alone (`W` = 1) or of +m and -m,
/// into the scene's terms from `TO` on.
#[inline(never)]
pub fn azimuth<
    Q: Fixed,
    const FIRST: usize,
    const START: usize,
    const TO: usize,
    const P: usize,
    const W: usize,
    const L: usize,
    const T: usize,
    const E: usize,
    const K: usize,
    const N: usize,
>(
    terms: &'static [Q; T],
    profiles: &'static [Profile; E],
    common: i32,
    mantissas: &[i32; K],
    scene: &mut [i32; N],
) {
    let profiles = profiles.get(FIRST..).unwrap_or_default();
    let mut weights = [[0; W]; P];
    for (weights, profile) in weights.iter_mut().zip(profiles) {
        let by = i32::from(profile.exponent) - common;
        let components = [profile.plus, profile.minus];
        for (sign, (weight, component)) in weights.iter_mut().zip(components).enumerate() {
            let found = mantissas.get(usize::from(component)).copied().unwrap_or(0);
            let found = found.shifted(by);
            // Φ_-m = √2 sin(-mβ) = -√2 Im (n_x + i n_y)^m / sin^m.
            *weight = if sign == 0 { found } else { -found };
        }
    }
    let rows = terms.get(START..).unwrap_or_default().as_chunks::<L>().0;
    let sums = scene.get_mut(TO..).unwrap_or_default().as_chunks_mut::<L>().0;
    for (sign, sums) in sums.iter_mut().take(W).enumerate() {
        sums.fill(0);
        for (row, weights) in rows.iter().zip(&weights) {
            let weight = weights.get(sign).copied().unwrap_or(0);
            for (sum, term) in sums.iter_mut().zip(row) {
                *sum += term.weigh(weight);
            }
        }
    }
}

/// Scales a scene's terms, and writes their exponent.
#[inline(always)]
pub fn finish<'a, Q: Fixed, const K: usize, const N: usize>(
    basis: &Basis<'a, Q>,
    coefficients: &Coefficients<K>,
    common: i32,
    scene: &mut Scene<'a, Q, SceneBuffer<N>>,
) {
    let (mantissas, exponent) = (coefficients.mantissas.as_slice(), coefficients.exponent);
    scene.exponent = basis.finish(mantissas, exponent, common, scene.buffer.as_mut_slice());
}
