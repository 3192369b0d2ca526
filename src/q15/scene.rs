//! One image in fixed point, and the irradiance of a normal: I(n) = Σ_m Re/Im (n_x + i n_y)^m
//! H_m(n_z), azimuth by azimuth.

use super::arithmetic::{self, argument, argument_times, dot, halved, of_value, product};
use super::{Basis, Normal};
use crate::checked_slice::{part, split_row};
use crate::error::{Argument, Error};
use crate::known_table::{KnownTable, at};
use crate::shade::slice::shade_each;

/// One image: `buffer` holds the polynomials of +m and -m for each azimuth |m|, all to be
/// multiplied by 2^exponent.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Scene<'a, B> {
    pub(crate) lengths: &'a [u8],
    pub(crate) exponent: i32,
    pub(crate) buffer: B,
}

impl<'a> Basis<'a> {
    /// The scene of polynomials and an exponent that were collapsed earlier and stored. The
    /// irradiances are meaningless for any other numbers.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless there are [`scene_len`](Self::scene_len) numbers.
    #[inline]
    pub fn scene<B: AsRef<[i32]>>(&self, exponent: i32, buffer: B) -> Result<Scene<'a, B>, Error> {
        Error::check(Argument::Scene, self.scene_len(), buffer.as_ref().len())?;
        Ok(Scene { lengths: self.parts.lengths, exponent, buffer })
    }
}

/// A scene of this basis, all zero.
#[inline(always)]
pub const fn blank_scene<'a, const N: usize>(basis: &Basis<'a>) -> Scene<'a, [i32; N]> {
    Scene { lengths: basis.parts.lengths, exponent: 0, buffer: [0; N] }
}

/// The terms of a scene.
#[inline(always)]
pub const fn terms<'s, const N: usize>(scene: &'s Scene<'_, [i32; N]>) -> &'s [i32; N] {
    &scene.buffer
}

/// The terms of a scene, to be overwritten.
#[inline(always)]
pub const fn terms_mut<'s, const N: usize>(scene: &'s mut Scene<'_, [i32; N]>) -> &'s mut [i32; N] {
    &mut scene.buffer
}

impl<B: AsRef<[i32]>> Scene<'_, B> {
    /// Shades one normal. The irradiance is the result times 2 to the scene's
    /// [`exponent`](Self::exponent).
    #[inline]
    #[must_use]
    pub fn shade(&self, normal: Normal) -> i32 {
        let (first, mut lengths, mut rest) = self.constant();
        let mut pixel = Pixel::new(first, normal);
        while let [length, others @ ..] = lengths {
            let length = usize::from(*length);
            let (plus, after) = split_row(rest, length);
            let (minus, after) = split_row(after, length);
            (lengths, rest) = (others, after);
            pixel = pixel.add(plus, minus);
        }
        pixel.irradiance()
    }

    /// Writes the irradiance of each normal into `irradiance`: bit for bit as
    /// [`shade`](Self::shade).
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless `irradiance` and `normals` have the same length.
    pub fn shade_slice(&self, normals: &[Normal], irradiance: &mut [i32]) -> Result<(), Error> {
        shade_each(normals, irradiance, |normal| self.shade(normal))
    }

    /// The polynomial of m = 0, and the lengths and polynomials of the other azimuths.
    #[inline]
    pub(super) fn constant(&self) -> (&[i32], &[u8], &[i32]) {
        let (length, lengths) = self.lengths.split_first().unwrap_or((&0, &[]));
        let terms = self.buffer.as_ref();
        let (first, rest) = split_row(terms, usize::from(*length));
        (first, lengths, rest)
    }
}

impl<B: AsRef<[i32]>> Scene<'_, B> {
    /// The terms of all polynomials, azimuth by azimuth, the ones of +m before the ones of -m.
    #[must_use]
    pub fn terms(&self) -> &[i32] {
        self.buffer.as_ref()
    }
}

impl<B> Scene<'_, B> {
    /// The exponent of every irradiance.
    #[must_use]
    pub const fn exponent(&self) -> i32 {
        self.exponent
    }
}

/// A pixel in progress: the sum so far, and (n_x + i n_y)^m for the next m.
#[derive(Clone, Copy, Debug)]
pub struct Pixel {
    normal: Normal,
    t: i32,
    cosine: i32,
    sine: i32,
    sum: i32,
}

impl Pixel {
    /// Starts with the polynomial of m = 0.
    #[inline(always)]
    pub(crate) fn new(polynomial: &[i32], normal: Normal) -> Self {
        let t = argument(normal.z);
        // The last step of m = 0 needs no rounding.
        let (last, first) = polynomial.split_last().unwrap_or((&0, &[]));
        let sum = product(value(first, t), t).wrapping_add(of_value(*last));
        Self { normal, t, cosine: halved(normal.x), sine: halved(normal.y), sum }
    }

    /// Adds the polynomials of +m and -m, and moves to m + 1.
    #[inline(always)]
    pub(crate) fn add(self, plus: &[i32], minus: &[i32]) -> Self {
        let Self { normal: Normal { x, y, .. }, t, cosine, sine, sum } = self;
        let plus = product(value(plus, t), cosine);
        let minus = product(value(minus, t), sine);
        Self {
            cosine: dot(cosine, x, -sine, y),
            sine: dot(cosine, y, sine, x),
            sum: sum.wrapping_add(plus).wrapping_add(minus),
            ..self
        }
    }

    /// Starts with m = 0 of a scene of `B`.
    #[inline(always)]
    pub fn start<B: KnownTable<Basis<'static>>, const N: usize>(
        terms: &[i32; N],
        normal: Normal,
    ) -> Self {
        let length = const { B::BASIS.length(0) };
        Self::new(part(terms, ..length), normal)
    }

    /// Adds azimuth `M` of a scene of `B`.
    #[inline(always)]
    pub fn azimuth<B: KnownTable<Basis<'static>>, const M: usize, const N: usize>(
        self,
        terms: &[i32; N],
    ) -> Self {
        let start = const { at(B::BASIS.parts.azimuths, M).start as usize };
        let length = const { B::BASIS.length(M) };
        let [plus, minus] = [start, start + length].map(|start| part(terms, start..start + length));
        self.add(plus, minus)
    }

    /// The irradiance.
    #[inline(always)]
    pub fn irradiance(self) -> i32 {
        arithmetic::sum(self.sum)
    }
}

/// The value of a polynomial by Horner's rule, with each step rounded down. No step overflows for a
/// table; the steps of a table that states its sizes too small may wrap.
#[inline(always)]
pub(super) fn value(terms: &[i32], t: i32) -> i32 {
    let Some((&first, rest)) = terms.split_first() else { return 0 };
    let mut sum = first;
    for &term in rest {
        sum = argument_times(sum, t).wrapping_add(term);
    }
    sum
}
