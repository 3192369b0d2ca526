//! The terms of a scene's polynomials that a tolerance spares.
//!
//! What a polynomial loses is read off its Chebyshev series in t. Azimuths are orthogonal over
//! a sphere, and in the mean of sin^2m T_k² a T_k² counts 0.64 at most, so terms that are left
//! out cost at most Σ_m w_m ((Σ s_k |c_m,k|)² + (Σ s_k |c_-m,k|)²) squared, s_0 = 1, s_k = 0.8,
//! w_0 = 1 and w_m = 1 / (2 (m + 1)), the mean of sin^2m cos². Terms are left out one by one,
//! always that which adds the least: few are left, not provably the fewest.

use super::series::{to_chebyshev, to_powers};
use super::size;
use crate::error::{Error, What};
use crate::index::layout::POWERS;
use crate::scalar::Scalar;
use crate::scene::Scene;

/// At most so large is the root mean square of T_k, k > 0, under sin^2m over a sphere, m <= 64.
const ROOT_MEAN_SQUARE: f64 = 0.8;

/// The mean over a sphere of sin^2m, times that of cos² mβ.
fn weight<S: Scalar>(azimuth: usize) -> S {
    match azimuth {
        0 => S::ONE,
        m => S::from_whole(2 * m + 2).reciprocal(),
    }
}

/// The scene without the terms that `tolerance` spares, how many are left, and the square of
/// what they lack.
pub(super) fn shortened<'l, S: Scalar, B: AsMut<[S]>>(
    mut scene: Scene<'_, B>,
    tolerance: S,
    lengths: &'l mut [u16],
) -> Result<(Scene<'l, B>, usize, S), Error> {
    let originals = scene.lengths();
    let found = lengths.len();
    let lengths = lengths.get_mut(..originals.len()).ok_or(Error::Length {
        what: What::Lengths,
        expected: originals.len(),
        found,
    })?;
    lengths.copy_from_slice(originals);
    let numbers = scene.numbers_mut();
    each(originals, |start, length, _| {
        with(numbers, start, length, |terms| to_chebyshev(terms));
    });
    let squares = drop_terms(originals, lengths, numbers, tolerance * tolerance);
    let mut end = 0;
    each(originals, |start, original, azimuth| {
        let length = lengths.get(azimuth).copied().map_or(0, usize::from);
        let first = start + original - length;
        // It moves toward the beginning, never past what is still to move.
        for k in 0..length {
            let term = numbers.get(first + k).copied().unwrap_or_default();
            if let Some(place) = numbers.get_mut(end + k) {
                *place = term;
            }
        }
        with(numbers, end, length, |terms| to_powers(terms));
        end += length;
    });
    let left = lengths.iter().rposition(|&length| length > 0).map_or(0, |last| last + 1);
    let lengths = lengths.get(..left).unwrap_or_default();
    Ok((Scene::of(lengths, scene.into_buffer()), end, squares))
}

/// Each polynomial's start, length and azimuth.
fn each(lengths: &[u16], mut visit: impl FnMut(usize, usize, usize)) {
    let mut start = 0;
    for (azimuth, &length) in lengths.iter().enumerate() {
        let length = usize::from(length);
        for _ in 0..signs(azimuth) {
            visit(start, length, azimuth);
            start += length;
        }
    }
}

fn signs(azimuth: usize) -> usize {
    if azimuth == 0 { 1 } else { 2 }
}

fn with<S>(numbers: &mut [S], start: usize, length: usize, change: impl FnOnce(&mut [S])) {
    if let Some(terms) = numbers.get_mut(start..start + length) {
        change(terms);
    }
}

/// Leaves out terms while what they cost, squared, is allowed. In the place of a term that
/// is left out stands the sum of the sizes of it and those before it.
fn drop_terms<S: Scalar>(
    originals: &[u16],
    lengths: &mut [u16],
    numbers: &mut [S],
    allowed: S,
) -> S {
    let mut squares = S::ZERO;
    loop {
        let mut least: Option<(usize, usize, S)> = None;
        let mut start = 0;
        for (azimuth, (&original, &length)) in originals.iter().zip(lengths.iter()).enumerate() {
            let (original, length) = (usize::from(original), usize::from(length));
            if length > shortest(original) {
                let mut more = S::ZERO;
                for sign in 0..signs(azimuth) {
                    let place = start + sign * original + original - length;
                    let (before, term) = sums(numbers, place, length, original);
                    more = more.add_product(term, term + before + before);
                }
                more = more * weight(azimuth);
                if least.is_none_or(|(_, _, least)| more < least) {
                    least = Some((azimuth, start, more));
                }
            }
            start += signs(azimuth) * original;
        }
        let least = least.filter(|(_, _, more)| squares + *more <= allowed);
        let Some((azimuth, start, more)) = least else { return squares };
        squares += more;
        let original = originals.get(azimuth).copied().map_or(0, usize::from);
        let Some(length) = lengths.get_mut(azimuth) else { return squares };
        for sign in 0..signs(azimuth) {
            let place = start + sign * original + original - usize::from(*length);
            let (before, term) = sums(numbers, place, usize::from(*length), original);
            if let Some(place) = numbers.get_mut(place) {
                *place = before + term;
            }
        }
        *length -= 1;
    }
}

/// What was left out before a place, and what the last of `length` terms, there, would add.
fn sums<S: Scalar>(numbers: &[S], place: usize, length: usize, original: usize) -> (S, S) {
    let at = |place: usize| numbers.get(place).copied().unwrap_or_default();
    let before = if length < original { at(place - 1) } else { S::ZERO };
    let scale = if length == 1 { S::ONE } else { S::from_f64(ROOT_MEAN_SQUARE) };
    (before, scale * size(at(place)))
}

/// How short a polynomial may become: what is a Chebyshev series stays one.
fn shortest(original: usize) -> usize {
    if original > POWERS { POWERS + 1 } else { 0 }
}
