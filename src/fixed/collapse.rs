//! Collapses an image into a scene, term by term, with the components' weights in registers.

use crate::parts::Recurrences;
use crate::scalar::Scalar;
use crate::scene::{Scene, SceneBuffer};

/// A scene of polynomials of these lengths, all zero, without recurrences.
#[inline(always)]
pub fn blank_scene<S: Scalar, const N: usize>(lengths: &[u16]) -> Scene<'_, SceneBuffer<S, N>> {
    Scene::of(lengths, Recurrences::NONE, heapless::Vec::from_array([S::ZERO; N]))
}

/// The numbers of a scene, to be overwritten with polynomials of these lengths; `None` unless there
/// are `N` in all.
#[inline(always)]
pub fn scene_mut<'s, 'a, S: Scalar, const N: usize>(
    scene: &'s mut Scene<'a, SceneBuffer<S, N>>,
    lengths: &'a [u16],
) -> Option<&'s mut [S; N]> {
    let numbers: &mut [S; N] = scene.rewritten(lengths).try_into().ok()?;
    Some(numbers)
}

/// Sums the polynomials of one azimuth: `P` profiles of `L` terms from `START` on, weighted by the
/// coefficients of their components.
///
/// With `W` = 1, for m = 0, there are components of +m only, else of +m and -m. The sums go to the
/// scene's terms from `TO` on. A component that the basis does not have counts as zero.
///
/// Not inlined: a compiler that sees several azimuths at once runs out of registers.
#[inline(never)]
pub fn collapse<
    S: Scalar,
    const START: usize,
    const TO: usize,
    const P: usize,
    const W: usize,
    const L: usize,
    const T: usize,
    const K: usize,
    const N: usize,
>(
    terms: &'static [S; T],
    components: &'static [[u16; W]; P],
    coefficients: &[S; K],
    scene: &mut [S; N],
) {
    let mut weights = [[S::ZERO; W]; P];
    for (weights, components) in weights.iter_mut().zip(components) {
        for (sign, (weight, &component)) in weights.iter_mut().zip(components).enumerate() {
            let found = coefficients.get(usize::from(component)).copied().unwrap_or(S::ZERO);
            // Φ_-m = √2 sin(-mβ) = -√2 Im (n_x + i n_y)^m / sin^m.
            *weight = if sign == 0 { found } else { -found };
        }
    }
    for j in 0..L {
        let mut sums = [S::ZERO; W];
        for (profile, weights) in weights.iter().enumerate() {
            let Some(&term) = terms.get(START + profile * L + j) else { continue };
            for (sum, &weight) in sums.iter_mut().zip(weights) {
                *sum = if profile == 0 { weight * term } else { sum.add_product(weight, term) };
            }
        }
        for (sign, sum) in sums.into_iter().enumerate() {
            if let Some(to) = scene.get_mut(TO + sign * L + j) {
                *to = sum;
            }
        }
    }
}
