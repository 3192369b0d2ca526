//! Exposure: from irradiance to a multiple of white, and how bright a picture is.

use crate::color::Rgb;
use crate::error::{Argument, Error};

/// Bits of a [`Linear`] after the binary point.
pub(crate) const POINT: u32 = 16;

/// An exposed irradiance in units of 2^-16: 65,536 is white under
/// [`Tone::Linear`](crate::Tone::Linear).
///
/// It converts from `f32`: values below 0 and NaN become 0, large ones the largest number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Linear(pub u32);

impl From<f32> for Linear {
    #[inline]
    fn from(exposed: f32) -> Self {
        Self((exposed * (1_u32 << POINT) as f32 + 0.5) as u32)
    }
}

/// Exposes irradiances in integers: a mantissa of a [`quantized`](crate::quantized) scene becomes a
/// [`Linear`].
///
/// ```
/// use eigenshade::{Exposure, Linear};
///
/// // 0.5 times 3 x 2^-3.
/// let exposure = Exposure::new(0.5, -3)?;
/// assert_eq!(exposure.of(3), Linear((0.1875 * 65_536.0) as u32));
/// # Ok::<(), eigenshade::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Exposure {
    /// 15 bits of the exposure, the highest one set; more if there is nothing to shift.
    factor: u32,
    /// The product of mantissa and factor is shifted to the right by this.
    shift: u32,
}

impl Exposure {
    /// The exposure of a scene whose irradiances are mantissas times 2^`exponent`. Decodes the
    /// exposure with integer operations, once per scene and channel.
    ///
    /// # Errors
    ///
    /// [`Error::NotFinite`] unless the exposure is a normal number above 0.
    pub const fn new(exposure: f32, exponent: i32) -> Result<Self, Error> {
        let bits = exposure.to_bits();
        let biased = (bits >> 23).cast_signed();
        // With the sign bit set, it is above 255.
        if biased <= 0 || biased >= 255 {
            return Err(Error::NotFinite { argument: Argument::Exposure, index: 0 });
        }
        let fraction = (bits & 0x7f_ffff) | 0x80_0000;
        let factor = (fraction + (1 << 8)) >> 9;
        let left = exponent.saturating_add(biased - 127 - 14 + POINT.cast_signed());
        let (left, shift) = match left {
            // 30 bits are beyond white.
            17.. => (16, 0),
            0..=16 => (left, 0),
            -63..=-1 => (0, left.unsigned_abs()),
            _ => (0, 63),
        };
        Ok(Self { factor: factor << left, shift })
    }

    /// The exposed irradiance of a mantissa, rounded down; 0 for negative ones.
    #[inline]
    #[must_use]
    pub fn of(self, mantissa: i32) -> Linear {
        let product = u64::from(mantissa.max(0).cast_unsigned()) * u64::from(self.factor);
        Linear(u32::try_from(product >> self.shift).unwrap_or(u32::MAX))
    }
}

impl Rgb<Exposure> {
    /// The exposed irradiances of a pixel's mantissas.
    #[inline]
    #[must_use]
    pub fn of(self, mantissas: Rgb<i32>) -> Rgb<Linear> {
        self.zip(mantissas).map(|(exposure, mantissa)| exposure.of(mantissa))
    }
}

impl Rgb<f32> {
    /// This color times an exposure.
    #[inline]
    #[must_use]
    pub fn exposed(self, exposure: f32) -> Self {
        self.map(|channel| channel * exposure)
    }

    /// The largest channel.
    #[inline]
    #[must_use]
    pub fn largest(self) -> f32 {
        self.r.max(self.g).max(self.b)
    }
}

/// Meters a picture for its exposure: how bright all but a share of its pixels are.
///
/// ```
/// use eigenshade::{Meter, Rgb};
///
/// let mut meter = Meter::default();
/// (1..=100).for_each(|i| meter.add(Rgb::new(0.0, 0.02 * i as f32, 0.0)));
/// let exposure = meter.exposure(0.9).expect("there are pixels"); // near 1 / 1.8
/// assert!((exposure * 1.8 - 1.0).abs() < 0.07);
/// ```
///
/// The largest channels are counted in eight steps for each power of two, from 2^-16 to 2^16.
#[derive(Clone, Debug)]
pub struct Meter {
    counts: [u32; 256],
    total: u32,
}

impl Default for Meter {
    fn default() -> Self {
        Self { counts: [0; 256], total: 0 }
    }
}

impl Meter {
    /// Counts a pixel. One that is black in all channels, or not finite, counts as the darkest.
    pub fn add(&mut self, color: Rgb<f32>) {
        let largest = color.largest();
        let largest = if largest > 0.0 && largest.is_finite() { largest } else { 0.0 };
        // Exponent and three bits of the fraction, from 2^-16 on.
        let step = (largest.to_bits() >> 20).saturating_sub((127 - 16) << 3).min(255);
        if let Some(count) = self.counts.get_mut(step as usize) {
            *count = count.saturating_add(1);
        }
        self.total = self.total.saturating_add(1);
    }

    /// The exposure with which this share of the pixels, from 0 to 1, is not brighter than white,
    /// to within 7 %. `None` if no pixel was counted or all of them are black.
    #[must_use]
    pub fn exposure(&self, share: f32) -> Option<f32> {
        let enough = (share * self.total as f32) as u32;
        let mut counted = 0_u32;
        let step = self.counts.iter().position(|&count| {
            counted = counted.saturating_add(count);
            counted >= enough && counted > 0
        })?;
        let brightest = self.counts.iter().rposition(|&count| count > 0)?;
        // The middle of the step.
        let middle = f32::from_bits((((127 - 16) << 3) + step as u32) << 20 | 1 << 19);
        (brightest > 0).then_some(1.0 / middle)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The irradiance from which on every pixel is white.
    const WHITE: u32 = 16;

    #[test]
    fn floats_saturate() {
        let cases = [(-1.0, 0), (f32::NAN, 0), (f32::INFINITY, u32::MAX), (0.5, 1 << 15)];
        for (from, to) in cases {
            assert_eq!(Linear::from(from), Linear(to));
        }
    }

    #[test]
    fn integers_are_exposed_as_floats() {
        for exposure in [1e-6_f32, 0.3, 1.0, 1.7, 9e4] {
            for exponent in [-40, -20, -16, -3, 0] {
                let scaled = Exposure::new(exposure, exponent);
                for mantissa in [-5, 0, 1, 1000, 70_001, i32::MAX] {
                    let exact = f64::from(exposure)
                        * f64::from(mantissa.max(0))
                        * libm::exp2(f64::from(exponent) + 16.0);
                    let found = f64::from(scaled.map_or(0, |scaled| scaled.of(mantissa).0));
                    let white = f64::from(WHITE << POINT);
                    let off = found.min(white) - exact.min(white);
                    assert!(
                        off.abs() <= 1.0 + exact / 32_000.0,
                        "{exposure} {exponent} {mantissa}"
                    );
                }
            }
        }
        for refused in [0.0, -1.0, f32::NAN, f32::INFINITY, 1e-40] {
            assert!(Exposure::new(refused, 0).is_err(), "{refused}");
        }
    }

    #[test]
    fn metered_exposures_are_within_seven_percent() {
        for k in -150..150 {
            let brightness = libm::exp2f(0.1 * k as f32);
            let mut meter = Meter::default();
            meter.add(Rgb::new(brightness, 0.0, -1.0));
            let white = meter.exposure(1.0).map_or(0.0, |exposure| exposure * brightness);
            assert!((white - 1.0).abs() < 0.07, "{brightness}: {white}");
        }
    }

    #[test]
    fn nothing_is_metered_in_the_dark() {
        let mut meter = Meter::default();
        assert_eq!(meter.exposure(0.5), None);
        meter.add(Rgb::gray(0.0));
        meter.add(Rgb::gray(f32::NAN));
        assert_eq!(meter.exposure(0.5), None);
        meter.add(Rgb::gray(1e30));
        assert!(meter.exposure(1.0).is_some_and(|exposure| exposure < 2e-5));
    }
}
