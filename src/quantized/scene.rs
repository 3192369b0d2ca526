//! One image in fixed point, with the components of each azimuth summed,
//! I(n) = Σ_m Re/Im (n_x + i n_y)^m H_m(n_z), and the irradiance of a normal.

use super::pixel::Pixel;
use super::{Basis, Normal};
use crate::buffer::Buffer;
use crate::error::{Argument, Error};
use crate::format::FixedPoint;
use crate::invariant::split_row;
use crate::specialized::shade_each;
use core::marker::PhantomData;

/// Storage for a collapsed scene.
pub type SceneBuffer<const N: usize> = Buffer<i32, N>;

/// One image: `buffer` holds the polynomials of +m and -m for each azimuth |m|, all to be
/// multiplied by 2^exponent.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Scene<'a, Q, B> {
    pub(crate) lengths: &'a [u8],
    pub(crate) exponent: i32,
    pub(crate) buffer: B,
    format: PhantomData<Q>,
}

impl<'a, Q: FixedPoint> Basis<'a, Q> {
    /// The scene of polynomials and an exponent that were collapsed earlier and stored. The
    /// irradiances are meaningless for any other numbers.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless there are [`scene_len`](Self::scene_len) numbers.
    pub fn scene<B: AsRef<[i32]>>(
        &self,
        exponent: i32,
        buffer: B,
    ) -> Result<Scene<'a, Q, B>, Error> {
        Error::check(Argument::Scene, self.scene_len(), buffer.as_ref().len())?;
        Ok(Scene::of(self.parts.lengths, exponent, buffer))
    }
}

impl<Q: FixedPoint, B: AsRef<[i32]>> Scene<'_, Q, B> {
    /// Shades one normal. The irradiance is the result times 2 to the scene's
    /// [`exponent`](Self::exponent).
    #[inline]
    #[must_use]
    pub fn shade(&self, normal: Normal<Q>) -> i32 {
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

    /// Writes the irradiance of each normal into `irradiance`: bit for bit that of
    /// [`shade`](Self::shade).
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless `irradiance` and `normals` have the same length.
    pub fn shade_slice(&self, normals: &[Normal<Q>], irradiance: &mut [i32]) -> Result<(), Error> {
        shade_each(normals, irradiance, |normal| self.shade(normal))
    }

    /// The polynomial of m = 0, and the lengths and polynomials of the other azimuths.
    #[inline]
    fn constant(&self) -> (&[i32], &[u8], &[i32]) {
        let (length, lengths) = self.lengths.split_first().unwrap_or((&0, &[]));
        let terms = self.buffer.as_ref();
        let (first, rest) = split_row(terms, usize::from(*length));
        (first, lengths, rest)
    }
}

impl<Q, B: AsRef<[i32]>> Scene<'_, Q, B> {
    /// The polynomials of each azimuth: those of +m, and those of -m (empty for m = 0).
    #[must_use]
    pub fn terms(&self) -> &[i32] {
        self.buffer.as_ref()
    }
}

impl<'a, Q, B> Scene<'a, Q, B> {
    /// The scene of polynomials of these lengths, times 2^exponent.
    pub(super) const fn of(lengths: &'a [u8], exponent: i32, buffer: B) -> Self {
        Self { lengths, exponent, buffer, format: PhantomData }
    }

    /// The exponent of every irradiance.
    #[must_use]
    pub const fn exponent(&self) -> i32 {
        self.exponent
    }
}
