//! Exposure in integers: from mantissas to multiples of white.

use crate::color::Rgb;
use crate::display::{Linear, POINT};
use crate::error::Error;

/// Exposes irradiances in integers: a mantissa of a scene becomes a [`Linear`].
///
/// ```
/// use eigenshade::screen::Linear;
/// use eigenshade::q15::Exposure;
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
        match crate::display::Exposure::new(exposure) {
            Ok(exposure) => Ok(Self::of_float(exposure, exponent)),
            Err(error) => Err(error),
        }
    }

    /// [`new`](Self::new) of an exposure of scenes in floats.
    pub(crate) const fn of_float(exposure: crate::display::Exposure, exponent: i32) -> Self {
        let bits = exposure.factor().to_bits();
        let biased = (bits >> 23).cast_signed();
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
        Self { factor: factor << left, shift }
    }

    /// The exposed irradiance of a mantissa of at most 47 bits, rounded, in the unit of [`Linear`], of
    /// either sign.
    pub(crate) fn signed(self, mantissa: i64) -> i64 {
        let shift = self.shift.min(62);
        let half = (1 << shift) >> 1;
        mantissa.saturating_mul(i64::from(self.factor)).saturating_add(half) >> shift
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

#[cfg(test)]
mod tests {
    use super::*;

    /// The irradiance from which on every pixel is white.
    const WHITE: u32 = 16;

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
}
