//! From irradiance to a pixel of a display: exposure, tone curve, sRGB encoding, 24 or 16 bits.
//!
//! A tone curve and the encoding are one increasing function of the exposed irradiance. A
//! [`Display`] holds it as a table in three pieces, from 0 to 1/16, to 1 and to 16, of 128
//! intervals each, and interpolates. The table is computed when the program is compiled.

use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::srgb;

/// Bits of a [`Linear`] after the binary point.
pub(crate) const POINT: u32 = 16;

/// An exposed irradiance in units of 2^-16: 65,536 is white under [`Tone::Linear`].
///
/// A conversion from `f32` turns values below 0 and NaN into 0, and large values into the largest
/// number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Linear(pub u32);

impl From<f32> for Linear {
    #[inline]
    fn from(exposed: f32) -> Self {
        Self((exposed * (1_u32 << POINT) as f32 + 0.5) as u32)
    }
}

/// The factor by which an irradiance is multiplied, so that white is 1.
///
/// ```
/// use eigenshade::screen::Exposure;
/// use eigenshade::Rgb;
///
/// let exposure = Exposure::new(1.5)?;
/// assert_eq!(exposure.of(Rgb::new(0.5, 1.0, 2.0)), Rgb::new(0.75, 1.5, 3.0));
/// assert!(Exposure::new(0.0).is_err());
/// # Ok::<(), eigenshade::Error>(())
/// ```
///
/// Scenes in integers have an [`Exposure`](crate::q15::Exposure) in each channel.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Exposure(pub(crate) f32);

/// The exposure 1.
impl Default for Exposure {
    fn default() -> Self {
        Self(1.0)
    }
}

impl Exposure {
    /// An exposure that multiplies by this number.
    ///
    /// # Errors
    ///
    /// [`Error::NotFinite`] unless it is a normal number above 0.
    pub const fn new(exposure: f32) -> Result<Self, Error> {
        // Without a comparison of floats, which a processor may not have.
        if exposure.is_normal() && exposure.is_sign_positive() {
            Ok(Self(exposure))
        } else {
            Err(Error::NotFinite { argument: Argument::Exposure, index: 0 })
        }
    }

    /// The factor from irradiance to a multiple of white.
    #[inline]
    #[must_use]
    pub const fn factor(self) -> f32 {
        self.0
    }

    /// The exposed color.
    #[inline]
    #[must_use]
    pub fn of(self, color: Rgb<f32>) -> Rgb<f32> {
        color.map(|channel| channel * self.0)
    }
}

/// Intervals of a piece, all of the same width.
pub(crate) const INTERVALS: usize = 128;

/// The values of a function at both ends of every interval, from 0 on.
pub(crate) type Piece = [u16; INTERVALS + 1];

/// The value at `place`, with intervals of 2^`width`: interpolated, rounded down. The function must
/// rise. 0 beyond the end of the piece.
#[inline(always)]
pub(crate) fn interpolated(piece: &Piece, place: u32, width: u32) -> u16 {
    let interval = piece.get((place >> width) as usize..);
    let Some(&[from, to]) = interval.and_then(|rest| rest.first_chunk()) else { return 0 };
    let (from, to) = (u32::from(from), u32::from(to));
    let way = place & ((1 << width) - 1);
    (from + ((to.wrapping_sub(from).wrapping_mul(way)) >> width)) as u16
}

/// The bits of an interval's width in each piece, in units of 2^-[`POINT`].
const WIDTHS: [u32; 3] = [5, 9, 13];

/// The irradiance, as exposed, from which on every pixel is white.
const WHITE: u32 = 16;

/// A tone curve: maps an exposed irradiance x to a displayed value from 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Tone {
    /// x, clipped at 1.
    #[default]
    Linear,
    /// x (1 + x / 16²) / (1 + x), which reaches 1 at x = 16: E. Reinhard et al., "Photographic Tone
    /// Reproduction for Digital Images", 2002, equation 4.
    Reinhard,
    /// x (2.51 x + 0.03) / (x (2.43 x + 0.59) + 0.14), clipped at 1: the fit to the ACES curve of
    /// K. Narkowicz, "ACES Filmic Tone Mapping Curve", 2015.
    Filmic,
}

impl Tone {
    /// The displayed value of x >= 0.
    const fn of(self, x: f64) -> f64 {
        let shown = match self {
            Self::Linear => x,
            Self::Reinhard => x * (1.0 + x / (WHITE * WHITE) as f64) / (1.0 + x),
            Self::Filmic => x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14),
        };
        if shown < 1.0 { shown } else { 1.0 }
    }
}

/// A tone curve and the sRGB encoding, as a table of 774 bytes.
///
/// ```
/// use eigenshade::screen::{Display, Tone};
/// use eigenshade::Rgb;
///
/// static DISPLAY: Display = Display::new(Tone::Linear);
/// assert_eq!(DISPLAY.rgb888(Rgb::new(0.0, 0.2140, 1.0)), Rgb::new(0, 127, 255));
/// assert_eq!(DISPLAY.rgb565(Rgb::new(1.0, 0.0, 0.0)), 0xf800);
/// ```
///
/// A color is exposed first: the irradiance times the exposure. Encoded values are within 0.6 of a
/// step of 1/255 of the exact function, the half step of rounding included. An `f32` costs a
/// product and a conversion more than a [`Linear`], which needs integers only.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Display {
    /// The encoded values in units of 1/65,535, piece by piece.
    pieces: [Piece; 3],
}

impl Display {
    /// Computes the table with 25,000 divisions in `f64`: initialize a static with this function,
    /// so that the compiler computes the table.
    #[must_use]
    #[expect(clippy::indexing_slicing, reason = "a constant function has no iterators")]
    pub const fn new(tone: Tone) -> Self {
        let mut pieces = [[0; INTERVALS + 1]; 3];
        let mut piece = 0;
        while piece < pieces.len() {
            let mut index = 0;
            while index <= INTERVALS {
                let units = (index as u32) << WIDTHS[piece];
                let encoded = srgb::encoded(tone.of(units as f64 / (1_u32 << POINT) as f64));
                pieces[piece][index] = (encoded * 65_535.0 + 0.5) as u16;
                index += 1;
            }
            piece += 1;
        }
        Self { pieces }
    }

    /// The encoded value of an exposed irradiance, from 0 to 65,535. All curves rise.
    #[inline]
    #[must_use]
    pub fn encode(&self, Linear(units): Linear) -> u16 {
        let units = units.min((WHITE << POINT) - 1);
        let [dark, middle, bright] = &self.pieces;
        let [of_dark, of_middle, of_bright] = WIDTHS;
        if units < (INTERVALS as u32) << of_dark {
            interpolated(dark, units, of_dark)
        } else if units < (INTERVALS as u32) << of_middle {
            interpolated(middle, units, of_middle)
        } else {
            interpolated(bright, units, of_bright)
        }
    }

    /// A pixel of 8 bits a channel.
    #[inline]
    #[must_use]
    pub fn rgb888(&self, color: Rgb<impl Into<Linear>>) -> Rgb<u8> {
        color.map(|channel| levels::<255>(self.encode(channel.into()), NEAREST) as u8)
    }

    /// A pixel of 5, 6 and 5 bits: red in the highest bits.
    #[inline]
    #[must_use]
    pub fn rgb565(&self, color: Rgb<impl Into<Linear>>) -> u16 {
        self.rounded565(color, NEAREST)
    }

    /// [`rgb565`](Self::rgb565) with ordered dithering: the pixel in column x and row y rounds at a
    /// threshold of the 4 x 4 Bayer matrix, so that bands of similar colors do not show edges.
    #[inline]
    #[must_use]
    pub fn rgb565_dithered(&self, color: Rgb<impl Into<Linear>>, x: usize, y: usize) -> u16 {
        self.rounded565(color, threshold(rank(x, y)))
    }

    #[inline(always)]
    fn rounded565(&self, color: Rgb<impl Into<Linear>>, threshold: u32) -> u16 {
        word565(color.map(|channel| self.encode(channel.into())), threshold)
    }
}

/// The threshold in 2^-16 of a level that rounds to the nearest one.
pub(crate) const NEAREST: u32 = 1 << 15;

/// The threshold of a rank in the Bayer matrix.
#[inline(always)]
pub(crate) fn threshold(rank: u32) -> u32 {
    (rank << 12) + (1 << 11)
}

/// A pixel of 5, 6 and 5 bits, each rounded down after adding a threshold in 2^-16 of a level.
#[inline(always)]
pub(crate) fn word565(Rgb { r, g, b }: Rgb<u16>, threshold: u32) -> u16 {
    let [r, b] = [r, b].map(|channel| levels::<31>(channel, threshold));
    (r << 11) | (levels::<63>(g, threshold) << 5) | b
}

/// The rank of a pixel in the 4 x 4 Bayer matrix, from 0 to 15.
#[inline(always)]
pub(crate) fn rank(x: usize, y: usize) -> u32 {
    ranks(y)(x)
}

/// The ranks of the pixels of row `y`, by their column.
#[inline(always)]
pub(crate) fn ranks(y: usize) -> impl Fn(usize) -> u32 {
    /// Four bits each, row by row.
    const RANKS: u64 = 0x5d7f_91b3_4c6e_80a2;
    let row = (RANKS >> (16 * (y & 3))) as u32;
    move |x| row >> (4 * (x & 3)) & 15
}

/// One of the levels 0 to `MOST`: rounds down after adding a threshold in 2^-16 of a level.
#[inline(always)]
pub(crate) fn levels<const MOST: u32>(encoded: u16, threshold: u32) -> u16 {
    // At most 65,535 / 65,536 of a level above `MOST`.
    ((u32::from(encoded) * MOST + threshold) >> 16) as u16
}

#[cfg(test)]
mod tests {
    use super::*;

    const TONES: [Tone; 3] = [Tone::Linear, Tone::Reinhard, Tone::Filmic];

    /// The function that a display interpolates, with `powf` instead of Newton's method.
    fn exact(tone: Tone, x: f64) -> f64 {
        let shown = match tone {
            Tone::Linear => x,
            Tone::Reinhard => (x + x * x / 256.0) / (1.0 + x),
            Tone::Filmic => (2.51 * x * x + 0.03 * x) / (2.43 * x * x + 0.59 * x + 0.14),
        };
        let shown = shown.clamp(0.0, 1.0);
        if shown <= 0.0031308 { 12.92 * shown } else { 1.055 * libm::pow(shown, 1.0 / 2.4) - 0.055 }
    }

    #[test]
    fn floats_saturate() {
        let cases = [(-1.0, 0), (f32::NAN, 0), (f32::INFINITY, u32::MAX), (0.5, 1 << 15)];
        for (from, to) in cases {
            assert_eq!(Linear::from(from), Linear(to));
        }
    }

    #[test]
    fn exposures_are_above_zero() {
        for refused in [0.0, -1.0, f32::NAN, f32::INFINITY, 1e-40] {
            assert!(Exposure::new(refused).is_err(), "{refused}");
        }
    }

    #[test]
    fn encoded_values_are_within_six_tenths_of_a_step() {
        for tone in TONES {
            let display = Display::new(tone);
            let (mut worst, mut before) = (0.0_f64, 0);
            for units in 0..=(17_u32 << 16) {
                let exact = 255.0 * exact(tone, f64::from(units) / 65_536.0);
                let found = display.encode(Linear(units));
                assert!(found >= before, "{tone:?} falls at {units}");
                before = found;
                let pixel = display.rgb888(Rgb::gray(Linear(units))).r;
                worst = worst.max((f64::from(pixel) - exact).abs());
            }
            assert!(worst < 0.6, "{tone:?}: {worst}");
            assert_eq!(display.encode(Linear(0)), 0);
            assert!(display.encode(Linear(u32::MAX)) >= u16::MAX - 1);
        }
    }

    #[test]
    fn sixteen_bits_hold_the_channels_in_order_and_dithering_keeps_the_mean() {
        let display = Display::new(Tone::Linear);
        assert_eq!(display.rgb565(Rgb::new(0.0, 1.0, 0.0)), 0x07e0);
        assert_eq!(display.rgb565(Rgb::new(0.0, 0.0, 1.0)), 0x001f);
        for units in (0..=65_536).step_by(17) {
            let encoded = f64::from(display.encode(Linear(units))) / 65_535.0 * 63.0;
            let mut sum = 0;
            for place in 0..16 {
                let pixel = display.rgb565_dithered(Rgb::gray(Linear(units)), place % 4, place / 4);
                let green = (pixel >> 5) & 63;
                assert!((f64::from(green) - encoded).abs() < 1.0);
                sum += green;
            }
            assert!((f64::from(sum) / 16.0 - encoded).abs() < 1.0 / 31.0, "{units}");
        }
    }
}
