//! The scene of an image, term by term: the components' weights stay in registers.

use crate::scalar::Scalar;
use crate::scene::{Scene, SceneBuffer};

/// The polynomials of one azimuth, `P` profiles of `L` terms from `START` on, summed with
/// their weights, one for each sign of m (`W` is 1 for m = 0, else 2), into the
/// scene's terms from `TO` on.
#[inline(always)]
pub fn collapse<
    S: Scalar,
    const START: usize,
    const TO: usize,
    const P: usize,
    const W: usize,
    const L: usize,
    const T: usize,
    const N: usize,
>(
    terms: &[S; T],
    weights: &[[S; W]; P],
    scene: &mut [S; N],
) {
    let terms = terms.get(START..).map(|terms| terms.as_chunks::<L>().0);
    let Some(terms) = terms.and_then(<[[S; L]]>::first_chunk::<P>) else { return };
    let sums = scene.get_mut(TO..).map(|sums| sums.as_chunks_mut::<L>().0);
    let Some(sums) = sums.and_then(<[[S; L]]>::first_chunk_mut::<W>) else { return };
    for j in 0..L {
        let mut sum = [S::ZERO; W];
        for (weights, terms) in weights.iter().zip(terms) {
            let Some(&term) = terms.get(j) else { continue };
            for (sum, &weight) in sum.iter_mut().zip(weights) {
                *sum = sum.add_product(weight, term);
            }
        }
        for (of_sign, sum) in sums.iter_mut().zip(sum) {
            if let Some(to) = of_sign.get_mut(j) {
                *to = sum;
            }
        }
    }
}

/// The scene of these numbers.
#[inline(always)]
pub fn collapsed<S: Scalar, const N: usize>(
    lengths: &[u16],
    numbers: [S; N],
) -> Scene<'_, SceneBuffer<S, N>> {
    Scene::of(lengths, heapless::Vec::from_array(numbers))
}
