//! Meters how bright a picture is.

use crate::color::Rgb;
use crate::display::{Exposure, Linear};

impl Rgb<f32> {
    /// The largest channel.
    #[inline]
    #[must_use]
    pub fn largest(self) -> f32 {
        self.r.max(self.g).max(self.b)
    }
}

/// The biased exponent of 2^-16, below which a [`Meter`] takes a pixel for black.
const DARKEST: u32 = 127 - 16;

/// The share of white that the median pixel has at least, if highlights leave room.
const MIDDLE: f32 = 0.12;
/// The shares of the pixels that are not brighter than white: without a dark median, and at least.
const UNCLIPPED: [f32; 2] = [0.99, 0.9];

/// Meters a picture for its exposure.
///
/// One pixel in a hundred is brighter than white. If the median pixel is then darker than 0.12 of
/// white, which a display shows as a dark gray, the exposure rises until the median has 0.12 or one
/// pixel in ten is brighter than white. The largest channel counts as the brightness of a pixel.
///
/// Pixels in integers are exposed first, say by `e`; the picture's exposure is `e` times the one
/// found.
///
/// ```
/// use eigenshade::screen::Meter;
/// use eigenshade::Rgb;
///
/// let mut meter = Meter::default();
/// (1..=100).for_each(|i| meter.add(Rgb::new(0.0, 0.02 * i as f32, 0.0)));
/// let exposure = meter.exposure().expect("there are pixels"); // near 1 / 1.98
/// assert!((exposure.factor() * 1.98 - 1.0).abs() < 0.07);
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
    /// Counts a pixel: as the darkest if it is black in all channels or not finite.
    pub fn add(&mut self, color: Rgb<f32>) {
        let largest = color.largest();
        let largest = if largest > 0.0 && largest.is_finite() { largest } else { 0.0 };
        self.count((largest.to_bits() >> 20).saturating_sub(DARKEST << 3));
    }

    /// Counts an exposed pixel in integers.
    pub fn add_linear(&mut self, color: Rgb<Linear>) {
        let Linear(units) = color.r.max(color.g).max(color.b);
        // As in a float: the exponent, and the three bits after the highest.
        let zeros = units.leading_zeros().min(31);
        self.count((31 - zeros) << 3 | ((units << zeros) >> 28) & 7);
    }

    /// Counts a step of an eighth of a power of two, from [`DARKEST`] on.
    fn count(&mut self, step: u32) {
        let step = step.min(255);
        if let Some(count) = self.counts.get_mut(step as usize) {
            *count = count.saturating_add(1);
        }
        self.total = self.total.saturating_add(1);
    }

    /// The exposure of the picture, to within 7 %. `None` if no pixel was counted or all of them are
    /// black.
    #[must_use]
    pub fn exposure(&self) -> Option<Exposure> {
        let [brightest, bright] = UNCLIPPED;
        // The median of a picture that is mostly black is its darkest other pixel.
        let middle = MIDDLE / self.brightness(0.5)?;
        let unclipped = middle.min(1.0 / self.brightness(bright)?);
        Some(Exposure(unclipped.max(1.0 / self.brightness(brightest)?)))
    }

    /// The brightness that this share of the pixels, from 0 to 1, does not exceed: the middle of
    /// its step. If more pixels are black, the brightness of the darkest other one.
    fn brightness(&self, share: f32) -> Option<f32> {
        // The product rounds up for more than 2^24 pixels.
        let enough = ((share * self.total as f32) as u32).min(self.total);
        let mut counted = 0_u32;
        let step = self.counts.iter().enumerate().position(|(step, &count)| {
            counted = counted.saturating_add(count);
            counted >= enough && count > 0 && step > 0
        })?;
        Some(f32::from_bits(((DARKEST << 3) + step as u32) << 20 | 1 << 19))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_pixels_are_metered() {
        let mut meter = Meter::default();
        meter.add_linear(Rgb::gray(Linear(1 << 16)));
        meter.counts.iter_mut().for_each(|count| *count *= 16_777_219);
        meter.total = 16_777_219;
        assert!(meter.exposure().is_some());
    }

    #[test]
    fn metered_exposures_are_within_seven_percent() {
        for k in -150..150 {
            let brightness = libm::exp2f(0.1 * k as f32);
            let mut meter = Meter::default();
            meter.add(Rgb::new(brightness, 0.0, -1.0));
            let white_of = |meter: &Meter| {
                meter.exposure().map_or(0.0, |exposure| exposure.factor() * brightness)
            };
            let white = white_of(&meter);
            assert!((white - 1.0).abs() < 0.07, "{brightness}: {white}");
            let mut of_integers = Meter::default();
            of_integers.add_linear(Rgb::from([brightness, 0.0, 0.0]).map(Linear::from));
            // Half a unit of rounding comes on top.
            if brightness > 1e-4 {
                let white = white_of(&of_integers);
                let rounded = 0.5 / (65_536.0 * brightness);
                assert!((white - 1.0).abs() < 0.07 + rounded, "{brightness}: {white}");
            }
        }
    }

    /// The exposure of a picture of these shares of pixels in a hundred, with their brightnesses.
    fn metered(pixels: &[(usize, f32)]) -> Option<f32> {
        let mut meter = Meter::default();
        for &(count, brightness) in pixels {
            (0..count).for_each(|_| meter.add(Rgb::gray(brightness)));
        }
        meter.exposure().map(Exposure::factor)
    }

    #[test]
    fn a_dark_median_is_raised_until_a_tenth_is_clipped() {
        for (pixels, expected) in [
            // An even picture: the brightest hundredth.
            (&[(50, 0.5), (49, 1.0), (1, 50.0)][..], 1.0),
            // A lamp of 5 % and its glow: the median.
            (&[(70, 0.1), (25, 0.3), (5, 40.0)], 1.2),
            // A tenth and more is bright: it is not clipped.
            (&[(70, 0.1), (10, 0.3), (20, 4.0)], 0.25),
            (&[(95, 0.0), (5, 4.0)], 0.25),
        ] {
            let found = metered(pixels);
            assert!(found.is_some_and(|found| (found / expected - 1.0).abs() < 0.07), "{found:?}");
        }
    }

    #[test]
    fn nothing_is_metered_in_the_dark() {
        assert_eq!(metered(&[]), None);
        assert_eq!(metered(&[(1, 0.0), (1, f32::NAN)]), None);
        assert!(metered(&[(1, 0.0), (1, 1e30)]).is_some_and(|factor| factor < 2e-5));
    }
}
