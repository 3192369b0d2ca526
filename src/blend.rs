//! Draws a pixel that an object covers in part over what is below it.

use crate::color::Rgb;

/// A pixel of 5, 6 and 5 bits that `above` covers by `coverage` / 255, with `below` in the rest.
///
/// Coverage is rounded to 1/32. Channels are within 0.6 of a step of the mean of the encoded
/// values. Costs two products for all three channels.
///
/// ```
/// use eigenshade::screen::blend565;
///
/// let (black, white) = (0x0000, 0xffff);
/// assert_eq!([0, 255].map(|coverage| blend565(black, white, coverage)), [black, white]);
/// assert_eq!(blend565(black, white, 128), 0b10000_100000_10000);
/// ```
#[inline]
#[must_use]
pub fn blend565(below: u16, above: u16, coverage: u8) -> u16 {
    // Green in the high half, red and blue in the low one, with room for five bits above each.
    const CHANNELS: u32 = 0x07e0_f81f;
    const HALVES: u32 = 16 | 16 << 11 | 16 << 21;
    let apart = |pixel: u16| (u32::from(pixel) | u32::from(pixel) << 16) & CHANNELS;
    let weight = (u32::from(coverage) + 4) >> 3;
    let sum = apart(below) * (32 - weight) + apart(above) * weight;
    let mean = ((sum + HALVES) >> 5) & CHANNELS;
    (mean | mean >> 16) as u16
}

/// A pixel of red, green, blue and opacity that `above` covers by `coverage` / 255, with `below` in
/// the rest: their mean color, within a level, and their opacity.
///
/// ```
/// use eigenshade::Rgb;
/// use eigenshade::screen::blend8888;
///
/// let red = Rgb { r: 255, g: 0, b: 0 };
/// assert_eq!(blend8888([0; 4], red, 100), [255, 0, 0, 100]);
/// assert_eq!(blend8888([0, 0, 255, 255], red, 51), [51, 0, 204, 255]);
/// ```
#[inline]
#[must_use]
pub fn blend8888([r, g, b, opacity]: [u8; 4], above: Rgb<u8>, coverage: u8) -> [u8; 4] {
    let covered = 255 * u32::from(coverage);
    let total = covered + (255 - u32::from(coverage)) * u32::from(opacity);
    // The share of `above`, which is nothing if both are transparent.
    let share = (255 * covered + total / 2).checked_div(total).unwrap_or_default();
    let Rgb { r, g, b } = above.over(Rgb { r, g, b }, share as u8);
    [r, g, b, ((total + 127) / 255) as u8]
}

impl Rgb<u8> {
    /// A pixel that this color covers by `coverage` / 255, with `below` in the rest of it: the mean
    /// of the encoded values, rounded.
    #[inline]
    #[must_use]
    pub fn over(self, below: Self, coverage: u8) -> Self {
        let weight = u32::from(coverage);
        self.zip(below).map(|(above, below)| {
            let sum = u32::from(above) * weight + u32::from(below) * (255 - weight);
            ((sum + 127) / 255) as u8
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn channels(pixel: u16) -> [f64; 3] {
        [pixel >> 11, (pixel >> 5) & 63, pixel & 31].map(f64::from)
    }

    #[test]
    fn channels_are_blended_by_themselves() {
        let mut state = 1_u32;
        for _ in 0..10_000 {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let [a, b, c, coverage] = state.to_be_bytes();
            let (below, above) = (u16::from_be_bytes([a, b]), u16::from_be_bytes([b ^ c, a]));
            let blended = channels(blend565(below, above, coverage));
            let pairs = channels(below).into_iter().zip(channels(above));
            for (found, (below, above)) in blended.into_iter().zip(pairs) {
                let whole = f64::from((u32::from(coverage) + 4) / 8) / 32.0;
                assert!((found - (below + whole * (above - below))).abs() <= 0.5);
            }
            let [below, above] = [[a, b, c], [c, a, b]].map(Rgb::from);
            let blended = above.over(below, coverage);
            for (found, (above, below)) in <[_; 3]>::from(blended.zip(above.zip(below))) {
                let [above, below] = [above, below].map(f64::from);
                let exact = below + f64::from(coverage) / 255.0 * (above - below);
                assert!((f64::from(found) - exact).abs() <= 0.5);
            }
        }
    }
}
