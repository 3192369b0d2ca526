//! Collapses an image into a scene and shades a pixel of it, with all sizes constant: the steps of
//! [`Basis::collapse`](crate::Basis::collapse) and [`Scene::shade`](crate::Scene::shade).

use super::{KnownTable, at, components, tail};
use crate::basis::Basis;
use crate::checked_slice::{part, split_mut};
use crate::scene::{Scene, sum_profiles, weights};
use crate::shade::Block;

/// A scene of polynomials of these lengths, all zero.
#[inline(always)]
pub const fn blank_scene<const N: usize>(lengths: &[u16]) -> Scene<'_, [f32; N]> {
    Scene { lengths, buffer: [0.0; N] }
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
/// components. Not inlined: a compiler that sees several azimuths at once runs out of registers.
#[inline(never)]
pub fn collapse<B, const M: usize, const P: usize, const K: usize, const N: usize>(
    coefficients: &[f32; K],
    scene: &mut [f32; N],
) where
    B: KnownTable<Basis<'static>>,
{
    let place = const { *at(B::BASIS.parts.azimuths, M) };
    const { assert!(at(B::BASIS.parts.azimuths, M).profiles as usize == P, "other profiles") };
    let terms = const { tail(B::BASIS.parts.terms, at(B::BASIS.parts.azimuths, M).terms as usize) };
    let (_, scene) = split_mut(scene, place.start as usize);
    let length = const { B::BASIS.length(M) };
    let components = const {
        components::<P>(B::BASIS.parts.profiles, at(B::BASIS.parts.azimuths, M).first as usize, P)
    };
    let weights = components.map(|components| weights(components, coefficients));
    if M == 0 {
        sum_profiles(length, terms, &weights.map(|[plus, _]| [plus]), false, scene);
    } else {
        sum_profiles(length, terms, &weights, false, scene);
    }
}

/// [`Block::azimuth`] of azimuth `M` > 0 of a scene of `B`.
#[inline(always)]
pub fn azimuth<B: KnownTable<Basis<'static>>, const M: usize, const N: usize>(
    terms: &[f32; N],
    pixel: &Block<'_, 1>,
    above: Option<[[f32; 1]; 2]>,
) -> Option<[[f32; 1]; 2]> {
    let length = const { B::BASIS.length(M) };
    let start = const { at(B::BASIS.parts.azimuths, M).start as usize };
    let [plus, minus] = [start, start + length].map(|start| part(terms, start..start + length));
    Some(pixel.azimuth(plus, minus, above))
}

/// The irradiance: [`Block::pole`] of a scene of `B`.
#[inline(always)]
pub fn pole<B: KnownTable<Basis<'static>>, const N: usize>(
    terms: &[f32; N],
    pixel: &Block<'_, 1>,
    above: Option<[[f32; 1]; 2]>,
) -> f32 {
    let [irradiance] = pixel.pole(part(terms, ..const { B::BASIS.length(0) }), above);
    irradiance
}
