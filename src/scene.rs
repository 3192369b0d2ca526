//! One image, with the components of each azimuth summed: I(n) = Σ_m Re/Im (n_x + i n_y)^m
//! H_m(n_z).

use crate::basis::{Basis, signs};
use crate::buffer::{Buffer, zeros};
use crate::checked_slice::{part, rows, split, split_mut, split_row};
use crate::error::{Argument, Error};
use crate::float;
use crate::known_table::{KnownTable, at, components, tail};

/// One image: `buffer` holds the polynomials of +m and -m for each azimuth |m|.
///
/// A pixel costs at most 2 degree + 1 polynomials, whatever the number of components.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Scene<'a, B> {
    pub(crate) lengths: &'a [u16],
    pub(crate) buffer: B,
}

/// Number of terms of polynomials of these lengths, of +m and of -m.
pub(crate) fn count(lengths: &[u16]) -> usize {
    let lengths = lengths.iter().enumerate();
    lengths.map(|(azimuth, &length)| signs(azimuth) * usize::from(length)).sum()
}

impl<'a> Basis<'a> {
    /// Sums the components of each azimuth.
    ///
    /// `N` must be at least [`scene_len`](Self::scene_len). `coefficients` holds the leading
    /// components; missing ones count as zero.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] if there are more coefficients than components, [`Error::Capacity`] if `N`
    /// is too small.
    pub fn collapse<const N: usize>(
        &self,
        coefficients: &[f32],
    ) -> Result<Scene<'a, Buffer<f32, N>>, Error> {
        self.collapse_into(coefficients, zeros::<f32, N>(Argument::Scene, self.scene_len())?)
    }

    /// [`collapse`](Self::collapse) into a buffer that the caller provides, of length
    /// [`scene_len`](Self::scene_len).
    ///
    /// # Errors
    ///
    /// [`Error::Length`] if there are more coefficients than components, or if the buffer has
    /// another length.
    pub fn collapse_into<B: AsMut<[f32]>>(
        &self,
        coefficients: &[f32],
        mut buffer: B,
    ) -> Result<Scene<'a, B>, Error> {
        let scene = buffer.as_mut();
        Error::check(Argument::Scene, self.scene_len(), scene.len())?;
        Error::check_components(self.components(), coefficients.len())?;
        for (azimuth, place) in self.parts.azimuths.iter().enumerate() {
            let length = self.length(azimuth);
            let (_, scene) = split_mut(scene, place.start as usize);
            let (_, terms) = split(self.parts.terms, place.terms as usize);
            let profiles = part(self.parts.profiles, place.first.into()..);
            let profiles = profiles.iter().zip(rows(terms, length));
            for (number, (profile, terms)) in profiles.take(place.profiles.into()).enumerate() {
                let weights = weights(profile.components(), coefficients);
                if azimuth == 0 {
                    let [plus, _] = weights;
                    sum_profiles(length, terms, &[[plus]], number > 0, scene);
                } else {
                    sum_profiles(length, terms, &[weights], number > 0, scene);
                }
            }
        }
        Ok(Scene::of(self.parts.lengths, buffer))
    }

    /// The scene of polynomials that were collapsed earlier and stored. The irradiances are
    /// meaningless for any other numbers.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless there are [`scene_len`](Self::scene_len) numbers.
    pub fn scene<B: AsRef<[f32]>>(&self, buffer: B) -> Result<Scene<'a, B>, Error> {
        Error::check(Argument::Scene, self.scene_len(), buffer.as_ref().len())?;
        Ok(Scene::of(self.parts.lengths, buffer))
    }
}

/// The weights of a profile's polynomial in the sums of +m and of -m, from its components. One that
/// is missing counts as zero.
#[inline(always)]
pub(crate) fn weights([plus, minus]: [u16; 2], coefficients: &[f32]) -> [f32; 2] {
    let weight = |component: u16| coefficients.get(usize::from(component)).copied().unwrap_or(0.0);
    // Φ_-m = √2 sin(-mβ) = -√2 Im (n_x + i n_y)^m / sin^m.
    [weight(plus), -weight(minus)]
}

/// Sums the polynomials of `P` profiles of `length` terms, with weights for `W` sums each, or adds
/// them to what is there.
#[inline(always)]
fn sum_profiles<const W: usize, const P: usize>(
    length: usize,
    terms: &[f32],
    weights: &[[f32; W]; P],
    is_more: bool,
    scene: &mut [f32],
) {
    for j in 0..length {
        let mut sums = [0.0; W];
        if is_more {
            for (sign, sum) in sums.iter_mut().enumerate() {
                *sum = scene.get(sign * length + j).copied().unwrap_or(0.0);
            }
        }
        for (profile, weights) in weights.iter().enumerate() {
            let Some(&term) = terms.get(profile * length + j) else { continue };
            for (sum, &weight) in sums.iter_mut().zip(weights) {
                *sum = if profile == 0 && !is_more {
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

impl<'a, B> Scene<'a, B> {
    #[inline]
    pub(crate) fn of(lengths: &'a [u16], buffer: B) -> Self {
        Self { lengths, buffer }
    }

    /// The polynomials of each azimuth: of +m, and of -m (empty for m = 0).
    #[inline]
    pub(crate) fn azimuths(&self) -> impl Iterator<Item = (&[f32], &[f32])>
    where
        B: AsRef<[f32]>,
    {
        let mut rest = self.buffer.as_ref();
        self.lengths.iter().enumerate().map(move |(azimuth, &length)| {
            let length = usize::from(length);
            let (plus, after) = split_row(rest, length);
            let (minus, after) = match azimuth {
                0 => (&[] as &[f32], after),
                _ => split_row(after, length),
            };
            rest = after;
            (plus, minus)
        })
    }

    /// The polynomials, from the highest azimuth to the lowest.
    #[inline]
    pub(crate) fn descent(&self) -> Descent<'_>
    where
        B: AsRef<[f32]>,
    {
        let last = self.lengths.iter().rposition(|&length| length > 0);
        let lengths = part(self.lengths, ..last.map_or(0, |last| last + 1));
        let terms = self.buffer.as_ref();
        let (&pole, lengths) = lengths.split_first().unwrap_or((&0, &[]));
        let (pole, around) = split(terms, usize::from(pole));
        let len = lengths.iter().map(|&length| 2 * usize::from(length)).sum();
        let around = part(around, ..len);
        Descent { lengths, pole, around }
    }
}

/// Iterates over the polynomials of a scene, downward from the highest azimuth that has any. Each
/// item holds the polynomials of +m and -m.
#[derive(Clone, Copy)]
pub(crate) struct Descent<'s> {
    /// Lengths of the polynomials of m = 1, 2, ...
    pub(crate) lengths: &'s [u16],
    pub(crate) pole: &'s [f32],
    pub(crate) around: &'s [f32],
}

impl<'s> Iterator for Descent<'s> {
    type Item = (&'s [f32], &'s [f32]);

    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        let (&length, lower) = self.lengths.split_last()?;
        let length = usize::from(length);
        let (rest, of_both) = self.around.split_at_checked(self.around.len() - 2 * length)?;
        (self.lengths, self.around) = (lower, rest);
        of_both.split_at_checked(length)
    }
}
