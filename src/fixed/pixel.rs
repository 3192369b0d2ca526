//! A pixel of a scene whose polynomials have known lengths, by Horner's rule twice:
//! each polynomial in t = 2z - 1, and the azimuths, from the highest down, in
//! w = n_x + i n_y. I(n) = Re Σ_m (P_m + i Q_m) w̄^m.

use crate::normal::Normal;
use crate::polynomial;
use crate::polynomial::argument;
use crate::scalar::Scalar;
use crate::scene::Scene;

/// The numbers of a scene whose azimuths have these lengths, `N` in all.
///
/// `None` for a scene of another basis. It is known by the place of its lengths, since
/// comparing the numbers takes longer than a pixel may; as many terms in all leave
/// no terms for lengths beyond these.
#[inline(always)]
pub fn scene<'s, S: Scalar, B: AsRef<[S]>, const N: usize>(
    scene: &'s Scene<'_, B>,
    lengths: &[u16],
) -> Option<&'s [S; N]> {
    let same = core::ptr::eq(scene.lengths().as_ptr(), lengths.as_ptr());
    scene.numbers().try_into().ok().filter(|_| same)
}

/// P_m + i Q_m of the highest azimuth m > 0, whose polynomials of `L` terms each stand at
/// `START`.
#[inline(always)]
pub fn highest<S: Scalar, const START: usize, const L: usize, const N: usize>(
    terms: &[S; N],
    normal: Normal<S>,
) -> [S; 2] {
    let t = argument(normal.z);
    [START, START + L].map(|start| match terms.get(start..).and_then(<[S]>::first_chunk::<L>) {
        Some(terms) => polynomial::short(terms, t),
        None => S::ZERO,
    })
}

/// P_m + i Q_m + w̄ `above` of a lower azimuth m > 0.
#[inline(always)]
pub fn azimuth<S: Scalar, const START: usize, const L: usize, const N: usize>(
    terms: &[S; N],
    normal: Normal<S>,
    [real, imaginary]: [S; 2],
) -> [S; 2] {
    let [plus, minus] = highest::<S, START, L, N>(terms, normal);
    let Normal { x, y, .. } = normal;
    [
        plus.add_product(real, x).add_product(imaginary, y),
        minus.add_product(imaginary, x).add_product(-real, y),
    ]
}

/// The irradiance: P_0, whose `L` terms are the first, + Re w̄ `above`.
#[inline(always)]
pub fn pole<S: Scalar, const L: usize, const N: usize>(
    terms: &[S; N],
    normal: Normal<S>,
    [real, imaginary]: [S; 2],
) -> S {
    let value = match terms.first_chunk::<L>() {
        Some(terms) => polynomial::short(terms, argument(normal.z)),
        None => S::ZERO,
    };
    value.add_product(real, normal.x).add_product(imaginary, normal.y)
}

/// A pixel of any other scene, apart from its caller: what it needs of the stack and the
/// registers is not to be paid for where it is not called.
#[cold]
#[inline(never)]
pub fn shade<S: Scalar, B: AsRef<[S]>>(scene: &Scene<'_, B>, normal: Normal<S>) -> S {
    scene.shade(normal)
}
