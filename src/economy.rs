//! A scene no better than asked for: components, azimuths and terms are left out as long as
//! a tolerance holds.
//!
//! Components are orthonormal, so leaving some out costs Σ d_i², the mean square over the
//! normals. What a polynomial loses is read off its Chebyshev series in t. Azimuths are
//! orthogonal over a sphere, and in the mean of sin^2m T_k² a T_k² counts 0.64 at most, so
//! terms that are left out cost at most Σ_m w_m ((Σ s_k |c_m,k|)² + (Σ s_k |c_-m,k|)²) squared,
//! s_0 = 1, s_k = 0.8, w_0 = 1 and w_m = 1 / (2 (m + 1)), the mean of sin^2m cos². Terms are
//! left out one by one, always that which adds the least: few are left, not provably the fewest.

use crate::basis::Basis;
use crate::error::{Error, What};
use crate::index::layout::POWERS;
use crate::mathematics::{Libm, Mathematics};
use crate::normal::Normal;
use crate::scalar::Scalar;
use crate::scene::Scene;

/// What an image may be off, root mean square over a sphere's normals.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Tolerance<S> {
    /// A share of the image's peak, above 0.
    OfPeak(S),
    /// So many decibels below the peak; 20 are a tenth.
    Decibels(u8),
    /// An irradiance, above 0.
    Irradiance(S),
}

/// What was chosen, and what it costs at most.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Economy<S> {
    /// The first so many components are in it.
    pub components: usize,
    /// Azimuths |m| from 0 on that are left.
    pub azimuths: usize,
    /// Terms of all polynomials: a pixel costs a multiplication for each, and six for each
    /// azimuth but the first.
    pub terms: usize,
    /// At most so far is the image off that of all components, root mean square over a
    /// sphere's normals; rounding apart.
    pub bound: S,
    /// The largest of 41 pixels of the image, at most its peak.
    pub peak: S,
}

/// At most so large is the root mean square of T_k, k > 0, under sin^2m over a sphere, m <= 64.
const ROOT_MEAN_SQUARE: f64 = 0.8;

/// What of the tolerance is for components: terms are what a pixel costs.
const COMPONENTS: f64 = 0.25;

/// Where the peak is looked for: toward the camera, and slants of these cosines and sines,
/// each at eight azimuths.
const SLANTS: [(f64, f64); 5] = [
    (0.92, 0.391_918_358_845_308_5),
    (0.75, 0.661_437_827_766_147_6),
    (0.5, 0.866_025_403_784_438_6),
    (0.25, 0.968_245_836_551_854_2),
    (0.0, 1.0),
];

impl<S: Scalar> Basis<'_, S> {
    /// A cheaper scene within a tolerance of that of all `coefficients`:
    /// [`collapse_into`](Self::collapse_into), then fewer components, azimuths and terms. A
    /// quarter of the tolerance is for components, the rest for terms.
    ///
    /// The scene's polynomials lie at the beginning of `buffer`, of length
    /// [`scene_len`](Self::scene_len); their lengths in `lengths`, which has room for
    /// [`azimuths`](Self::azimuths). Set-up cost: two collapses, 41 pixels, and for each term
    /// that goes a look at each azimuth.
    ///
    /// # Errors
    ///
    /// As [`collapse_into`](Self::collapse_into); [`Error::Length`] if `lengths` is too short;
    /// [`Error::Tolerance`] unless the tolerance is above zero.
    pub fn collapse_within<'l, B: AsMut<[S]> + AsRef<[S]>>(
        &self,
        coefficients: &[S],
        tolerance: Tolerance<S>,
        lengths: &'l mut [u16],
        buffer: B,
    ) -> Result<(Scene<'l, B>, Economy<S>), Error> {
        let scene = self.collapse_into(coefficients, buffer)?;
        let peak = peak(&scene);
        let tolerance = tolerance.irradiance(peak)?;
        let of_components = S::from_f64(COMPONENTS) * tolerance;
        let mut components = coefficients.len();
        let mut energy = S::ZERO;
        for &d in coefficients.iter().rev() {
            let more = energy.add_product(d, d);
            if more <= of_components * of_components {
                (energy, components) = (more, components - 1);
            } else {
                break;
            }
        }
        let scene = match components {
            all if all == coefficients.len() => scene,
            some => self
                .collapse_into(coefficients.get(..some).unwrap_or_default(), scene.into_buffer())?,
        };
        let of_components = Libm::square_root(energy);
        let (scene, terms, squares) = shortened(scene, tolerance - of_components, lengths)?;
        let azimuths = scene.lengths().len();
        let bound = of_components + Libm::square_root(squares);
        Ok((scene, Economy { components, azimuths, terms, bound, peak }))
    }
}

impl<S: Scalar> Tolerance<S> {
    /// As an irradiance.
    fn irradiance(self, peak: S) -> Result<S, Error> {
        let (share, of) = match self {
            Self::OfPeak(share) => (share, peak),
            Self::Decibels(decibels) => {
                // 10^(-1/20) so many times.
                let one = S::from_f64(0.891_250_938_133_745_5);
                ((0..decibels).fold(S::ONE, |share, _| share * one), peak)
            }
            Self::Irradiance(irradiance) => (irradiance, S::ONE),
        };
        if share > S::ZERO && share.is_finite() { Ok(share * of) } else { Err(Error::Tolerance) }
    }
}

/// The largest |I| at some normals.
fn peak<S: Scalar, B: AsRef<[S]>>(scene: &Scene<'_, B>) -> S {
    let at = |x: S, y: S, z: S| size(scene.shade(Normal { x, y, z }));
    let mut largest = at(S::ZERO, S::ZERO, S::ONE);
    let diagonal = S::from_f64(core::f64::consts::FRAC_1_SQRT_2);
    for (z, sine) in SLANTS {
        let (z, sine) = (S::from_f64(z), S::from_f64(sine));
        let aslant = sine * diagonal;
        for (x, y) in [(sine, S::ZERO), (S::ZERO, sine), (aslant, aslant), (aslant, -aslant)] {
            for found in [at(x, y, z), at(-x, -y, z)] {
                if found > largest {
                    largest = found;
                }
            }
        }
    }
    largest
}

fn size<S: Scalar>(value: S) -> S {
    if value < S::ZERO { -value } else { value }
}

/// The mean over a sphere of sin^2m, times that of cos² mβ.
fn weight<S: Scalar>(azimuth: usize) -> S {
    match azimuth {
        0 => S::ONE,
        m => S::from_whole(2 * m + 2).reciprocal(),
    }
}

/// The scene without the terms that `tolerance` spares, how many are left, and the square of
/// what they lack.
fn shortened<'l, S: Scalar, B: AsMut<[S]>>(
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

/// Powers, highest first, to the Chebyshev series that is the same polynomial.
fn to_chebyshev<S: Scalar>(terms: &mut [S]) {
    if terms.len() > POWERS {
        return;
    }
    let half = S::from_f64(0.5);
    // By Horner's rule, lowest first; 2 t T_k = T_k+1 + T_k-1.
    let mut series = [S::ZERO; POWERS];
    for &term in terms.iter() {
        let mut next = [S::ZERO; POWERS];
        for (k, &c) in series.iter().enumerate() {
            for (place, share) in
                if k == 0 { [(1, c), (0, S::ZERO)] } else { [(k + 1, half * c), (k - 1, half * c)] }
            {
                if let Some(place) = next.get_mut(place) {
                    *place += share;
                }
            }
        }
        next[0] += term;
        series = next;
    }
    for (term, c) in terms.iter_mut().rev().zip(series) {
        *term = c;
    }
}

/// The way back.
fn to_powers<S: Scalar>(terms: &mut [S]) {
    if terms.len() > POWERS {
        return;
    }
    // By Clenshaw's recurrence on polynomials, b_k = c_k + 2 t b_k+1 - b_k+2, lowest first.
    let (mut next, mut after) = ([S::ZERO; POWERS], [S::ZERO; POWERS]);
    for (k, &c) in terms.iter().enumerate() {
        let last = k + 1 == terms.len();
        let mut sum = after.map(|one| -one);
        for (place, &one) in sum.iter_mut().skip(1).zip(&next) {
            *place += if last { one } else { one + one };
        }
        sum[0] += c;
        (after, next) = (next, sum);
    }
    for (term, power) in terms.iter_mut().rev().zip(next) {
        *term = power;
    }
}
