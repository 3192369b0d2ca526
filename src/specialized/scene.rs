//! Shades a pixel of a scene with all sizes constant.
//!
//! For a pixel, Horner's rule is applied twice: to each polynomial in t = 2z - 1, and to the
//! azimuths, from the highest downward, in w = n_x + i n_y. I(n) = Re Σ_m (P_m + i Q_m) w̄^m.

use crate::basis::Basis;
use crate::normal::Normal;
use crate::places::{AzimuthPlace, Shape};
use crate::polynomial;
use crate::scalar::Scalar;
use crate::scene::{Scene, SceneBuffer};

/// A scene of this basis, with all terms zero.
#[inline(always)]
pub fn blank_scene<'a, S: Scalar, const N: usize>(
    basis: &Basis<'a, S>,
) -> Scene<'a, SceneBuffer<S, N>> {
    Scene::of(basis.parts.lengths, basis.recurrences, SceneBuffer::from([S::ZERO; N]))
}

/// The numbers of a scene, to be overwritten with polynomials of this basis; `None` unless there are
/// `N` in all.
#[inline(always)]
pub fn scene_mut<'s, 'a, S: Scalar, const N: usize>(
    basis: &Basis<'a, S>,
    scene: &'s mut Scene<'a, SceneBuffer<S, N>>,
) -> Option<&'s mut [S; N]> {
    scene.rewritten(basis.parts.lengths, basis.recurrences).as_mut_slice().try_into().ok()
}

const fn azimuth_of<B: Shape<Basis<'static, S>>, S: 'static>(azimuth: usize) -> AzimuthPlace {
    B::BASIS.azimuth_at(azimuth)
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

/// P_m + i Q_m + w̄ `above` for azimuth `M` > 0. The highest azimuth has nothing above it.
#[inline(always)]
pub fn azimuth<B: Shape<Basis<'static, S>>, S: Scalar, const M: usize, const N: usize>(
    terms: &[S; N],
    normal: Normal<S>,
    above: Option<[S; 2]>,
) -> Option<[S; 2]> {
    let AzimuthPlace { start, length, .. } = const { azimuth_of::<B, S>(M) };
    let t = polynomial::argument(normal.z);
    let [plus, minus] = [start, start + length].map(|start| {
        let terms = terms.get(start..).and_then(|rest| rest.get(..length));
        terms.map_or(S::ZERO, |terms| polynomial::short(terms, t))
    });
    let Some([real, imaginary]) = above else { return Some([plus, minus]) };
    let Normal { x, y, .. } = normal;
    Some([
        plus.add_product(real, x).add_product(imaginary, y),
        minus.add_product(imaginary, x).add_product(-real, y),
    ])
}

/// The irradiance P_0 + Re w̄ `above`.
#[inline(always)]
pub fn pole<B: Shape<Basis<'static, S>>, S: Scalar, const N: usize>(
    terms: &[S; N],
    normal: Normal<S>,
    above: Option<[S; 2]>,
) -> S {
    let terms = terms.get(..const { azimuth_of::<B, S>(0).length });
    let t = polynomial::argument(normal.z);
    let value = terms.map_or(S::ZERO, |terms| polynomial::short(terms, t));
    let [real, imaginary] = above.unwrap_or([S::ZERO; 2]);
    value.add_product(real, normal.x).add_product(imaginary, normal.y)
}

/// Shades a pixel of any other scene. Not inlined, so that callers that do not use it do not pay
/// for its stack and registers.
#[cold]
#[inline(never)]
pub fn shade<S: Scalar, B: AsRef<[S]>>(scene: &Scene<'_, B>, normal: Normal<S>) -> S {
    scene.shade(normal)
}
