//! Collapses an image into a scene and shades a pixel of it, with all sizes constant.
//!
//! For a pixel, Horner's rule is applied twice: to each polynomial in t = 2z - 1, and to the
//! azimuths, from the highest downward, in w = n_x + i n_y. I(n) = Re Σ_m (P_m + i Q_m) w̄^m.

use crate::basis::Basis;
use crate::float;
use crate::invariant::split_mut;
use crate::normal::Normal;
use crate::places::{AzimuthPlace, KnownTable};
use crate::polynomial;
use crate::scene::Scene;

/// A scene of polynomials of these lengths, all zero.
#[inline(always)]
pub fn blank_scene<const N: usize>(lengths: &[u16]) -> Scene<'_, [f32; N]> {
    Scene::of(lengths, [0.0; N])
}

/// The terms of a scene.
#[inline(always)]
pub const fn terms<'s, const N: usize>(scene: &'s Scene<'_, [f32; N]>) -> &'s [f32; N] {
    &scene.buffer
}

/// The terms of a scene, to be overwritten.
#[inline(always)]
pub const fn terms_mut<'s, const N: usize>(scene: &'s mut Scene<'_, [f32; N]>) -> &'s mut [f32; N] {
    &mut scene.buffer
}

/// Sums the polynomials of azimuth `M`, of `P` profiles, weighted by the coefficients of their
/// components. A component that the basis does not have counts as zero. Not inlined: a compiler
/// that sees several azimuths at once runs out of registers.
#[inline(never)]
pub fn collapse<B, const M: usize, const P: usize, const K: usize, const N: usize>(
    coefficients: &[f32; K],
    scene: &mut [f32; N],
) where
    B: KnownTable<Basis<'static>>,
{
    const { assert!(azimuth_of::<B>(M).profiles == P, "the azimuth has other profiles") };
    let place = const { &azimuth_of::<B>(M) };
    let components = const { &B::BASIS.components_of::<P>(M) };
    let terms = const { B::BASIS.parts.terms.split_at(azimuth_of::<B>(M).terms).1 };
    let (_, scene) = split_mut(scene, place.start);
    if M == 0 {
        let weights = components.map(|[plus, _]| [weight(coefficients, plus)]);
        sum_profiles(place.length, terms, &weights, scene);
    } else {
        let weights = components.map(|[plus, minus]| {
            // Φ_-m = √2 sin(-mβ) = -√2 Im (n_x + i n_y)^m / sin^m.
            [weight(coefficients, plus), -weight(coefficients, minus)]
        });
        sum_profiles(place.length, terms, &weights, scene);
    }
}

const fn azimuth_of<B: KnownTable<Basis<'static>>>(azimuth: usize) -> AzimuthPlace {
    B::BASIS.azimuth_at(azimuth)
}

#[inline(always)]
fn weight(coefficients: &[f32], component: u16) -> f32 {
    coefficients.get(usize::from(component)).copied().unwrap_or(0.0)
}

/// Sums `P` profiles of `length` terms, with weights for `W` polynomials each.
#[inline(always)]
fn sum_profiles<const W: usize, const P: usize>(
    length: usize,
    terms: &[f32],
    weights: &[[f32; W]; P],
    scene: &mut [f32],
) {
    for j in 0..length {
        let mut sums = [0.0; W];
        for (profile, weights) in weights.iter().enumerate() {
            let Some(&term) = terms.get(profile * length + j) else { continue };
            for (sum, &weight) in sums.iter_mut().zip(weights) {
                *sum = if profile == 0 {
                    weight * term
                } else {
                    float::add_product(*sum, weight, term)
                };
            }
        }
        for (sign, sum) in sums.into_iter().enumerate() {
            if let Some(to) = scene.get_mut(sign * length + j) {
                *to = sum;
            }
        }
    }
}

/// P_m + i Q_m + w̄ `above` for azimuth `M` > 0. The highest azimuth has nothing above it.
#[inline(always)]
pub fn azimuth<B: KnownTable<Basis<'static>>, const M: usize, const N: usize>(
    terms: &[f32; N],
    normal: Normal,
    above: Option<[f32; 2]>,
) -> Option<[f32; 2]> {
    let AzimuthPlace { start, length, .. } = const { azimuth_of::<B>(M) };
    let t = polynomial::argument(normal.z);
    let [plus, minus] = [start, start + length].map(|start| {
        let terms = terms.get(start..).and_then(|rest| rest.get(..length));
        terms.map_or(0.0, |terms| polynomial::value(terms, t))
    });
    let Some([real, imaginary]) = above else { return Some([plus, minus]) };
    let Normal { x, y, .. } = normal;
    Some([
        float::add_product(float::add_product(plus, real, x), imaginary, y),
        float::add_product(float::add_product(minus, imaginary, x), -real, y),
    ])
}

/// The irradiance P_0 + Re w̄ `above`.
#[inline(always)]
pub fn pole<B: KnownTable<Basis<'static>>, const N: usize>(
    terms: &[f32; N],
    normal: Normal,
    above: Option<[f32; 2]>,
) -> f32 {
    let terms = terms.get(..const { azimuth_of::<B>(0).length });
    let t = polynomial::argument(normal.z);
    let value = terms.map_or(0.0, |terms| polynomial::value(terms, t));
    let [real, imaginary] = above.unwrap_or([0.0; 2]);
    float::add_product(float::add_product(value, real, normal.x), imaginary, normal.y)
}
