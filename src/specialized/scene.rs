//! Relights order by order, collapses an image into a scene, and shades a pixel of it, with all
//! sizes constant.
//!
//! Relighting is for machines that process numbers one at a time: it skips products with zero and
//! reads each coefficient of the light once.
//!
//! For a pixel, Horner's rule is applied twice: to each polynomial in t = 2z - 1, and to the
//! azimuths, from the highest downward, in w = n_x + i n_y. I(n) = Re Σ_m (P_m + i Q_m) w̄^m.

use crate::index::light::position;
use crate::normal::Normal;
use crate::parts::Recurrences;
use crate::polynomial;
use crate::scalar::Scalar;
use crate::scene::{Scene, SceneBuffer};

/// Whether the target processes numbers in groups, as [`pass`](super::pass) does.
pub const GROUPS: bool = cfg!(any(
    target_arch = "x86",
    target_arch = "x86_64",
    target_arch = "aarch64",
    target_arch = "wasm32",
    target_feature = "neon",
    target_feature = "v"
));

/// d_i = Σ_l T_i,l L_l^m for the components of `P` profiles of order `M`, over `D` degrees from
/// |m| on.
///
/// The transfer has `T` numbers. Those of this order start at `START`, `STEP` apart from one degree
/// to the next and four apart from one profile to the next. The sums are written to the indices in
/// `components`.
///
/// Not inlined: a compiler that sees several orders at once runs out of registers.
#[inline(never)]
pub fn order<
    S: Scalar,
    const M: isize,
    const START: usize,
    const STEP: usize,
    const P: usize,
    const D: usize,
    const T: usize,
    const N: usize,
    const K: usize,
>(
    transfer: &[S; T],
    light: &[S; N],
    components: &'static [u16; P],
    coefficients: &mut [S; K],
) {
    let mut sums = [S::ZERO; P];
    for l in 0..D {
        let degree = M.unsigned_abs() + l;
        let light = light.get(position(degree, M)).copied().unwrap_or(S::ZERO);
        for (profile, sum) in sums.iter_mut().enumerate() {
            if let Some(&number) = transfer.get(START + l * STEP + 4 * profile) {
                *sum = if l == 0 { number * light } else { sum.add_product(number, light) };
            }
        }
    }
    for (&component, sum) in components.iter().zip(sums) {
        if let Some(coefficient) = coefficients.get_mut(usize::from(component)) {
            *coefficient = sum;
        }
    }
}

/// Coefficients of an image, all zero.
#[inline(always)]
#[must_use]
pub fn blank_coefficients<S: Scalar, const K: usize>() -> crate::Coefficients<S, K> {
    crate::Buffer::from([S::ZERO; K])
}

/// The coefficients of an image, to be written, if there are exactly `K`.
#[inline(always)]
pub fn coefficients_mut<S: Scalar, const K: usize>(
    coefficients: &mut crate::Coefficients<S, K>,
) -> Option<&mut [S; K]> {
    coefficients.as_mut_slice().try_into().ok()
}

/// The numbers of a transfer, if there are exactly `T`.
#[inline(always)]
pub fn transfer<S: Scalar, const T: usize>(transfer: &crate::Transfer<S, T>) -> Option<&[S; T]> {
    transfer.as_slice().try_into().ok()
}

/// A scene of polynomials of these lengths, all zero, without recurrences.
#[inline(always)]
pub fn blank_scene<S: Scalar, const N: usize>(lengths: &[u16]) -> Scene<'_, SceneBuffer<S, N>> {
    Scene::of(lengths, Recurrences::NONE, SceneBuffer::from([S::ZERO; N]))
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

/// The numbers of a scene whose azimuths have these lengths, `N` in all.
///
/// Returns `None` for a scene of another basis. A scene is recognized by the address of its
/// lengths, because comparing the values takes too long for a pixel. If it also has `N` terms in
/// all, none are left for azimuths beyond these lengths.
#[inline(always)]
pub fn scene<'s, S: Scalar, B: AsRef<[S]>, const N: usize>(
    scene: &'s Scene<'_, B>,
    lengths: &[u16],
) -> Option<&'s [S; N]> {
    let same = core::ptr::eq(scene.lengths().as_ptr(), lengths.as_ptr());
    scene.numbers().try_into().ok().filter(|_| same)
}

/// P_m + i Q_m of the highest azimuth m > 0. Its two polynomials have `L` terms each and start at
/// `START`.
#[inline(always)]
pub fn highest<S: Scalar, const START: usize, const L: usize, const N: usize>(
    terms: &[S; N],
    normal: Normal<S>,
) -> [S; 2] {
    let t = polynomial::argument(normal.z);
    [START, START + L].map(|start| match terms.get(start..).and_then(<[S]>::first_chunk::<L>) {
        Some(terms) => polynomial::short(terms, t),
        None => S::ZERO,
    })
}

/// P_m + i Q_m + w̄ `above` for a lower azimuth m > 0; the last argument is `above`.
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

/// The irradiance P_0 + Re w̄ `above`. The first `L` terms are those of P_0; the last argument is
/// `above`.
#[inline(always)]
pub fn pole<S: Scalar, const L: usize, const N: usize>(
    terms: &[S; N],
    normal: Normal<S>,
    [real, imaginary]: [S; 2],
) -> S {
    let value = match terms.first_chunk::<L>() {
        Some(terms) => polynomial::short(terms, polynomial::argument(normal.z)),
        None => S::ZERO,
    };
    value.add_product(real, normal.x).add_product(imaginary, normal.y)
}

/// Shades a pixel of any other scene. Not inlined, so that callers that do not use it do not pay
/// for its stack and registers.
#[cold]
#[inline(never)]
pub fn shade<S: Scalar, B: AsRef<[S]>>(scene: &Scene<'_, B>, normal: Normal<S>) -> S {
    scene.shade(normal)
}
