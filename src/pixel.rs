//! The pixels of displays, as they are in memory.

use crate::blend::{blend565, blend8888};
use crate::color::Rgb;

/// A pixel as it is in memory: `u16`, `[u8; 2]`, `[u8; 3]` or `[u8; 4]`.
///
/// * `u16` is RGB565 in the byte order of the processor: red in the highest bits. Frame buffers and
///   LVGL take it.
/// * `[u8; 2]` is RGB565 with the high byte first, as most displays on SPI take it. A slice is sent
///   as it is: `row.as_flattened()` are its bytes.
/// * `[u8; 3]` is RGB888: the bytes red, green and blue.
/// * `[u8; 4]` is RGBA8888, as an `ImageData` of a browser: a color and its opacity. Over a buffer of
///   zeros, an object has the opacity of its coverage, and is transparent around it.
pub trait Pixel: sealed::Pixel {}
impl Pixel for u16 {}
impl Pixel for [u8; 2] {}
impl Pixel for [u8; 3] {}
impl Pixel for [u8; 4] {}

pub(crate) mod sealed {
    use super::{Rgb, blend565, blend8888};
    use crate::display::{NEAREST, levels, word565};
    use crate::encoded::Encoded;

    pub trait Pixel: Copy {
        /// The pixel of an encoded color. The levels of RGB565 are rounded down after adding a
        /// threshold, of which 2^11 are a level of red and blue.
        fn of(color: Encoded, threshold: u32) -> Self;
        /// The pixel of encoded values from 0 to 65,535. The levels of RGB565 are rounded down after
        /// adding a threshold in units of 2^-16 of a level.
        fn of_display(color: Rgb<u16>, threshold: u32) -> Self;
        /// This pixel where it covers `coverage` / 255 of a pixel, and `below` in the rest of it.
        fn over(self, below: Self, coverage: u8) -> Self;
        /// All of its bits.
        fn word(self) -> u32;
    }

    impl Pixel for u16 {
        #[inline(always)]
        fn of(color: Encoded, threshold: u32) -> Self {
            color.rgb565(threshold)
        }
        #[inline(always)]
        fn of_display(color: Rgb<u16>, threshold: u32) -> Self {
            word565(color, threshold)
        }
        #[inline]
        fn over(self, below: Self, coverage: u8) -> Self {
            blend565(below, self, coverage)
        }
        #[inline(always)]
        fn word(self) -> u32 {
            self.into()
        }
    }

    impl Pixel for [u8; 2] {
        #[inline(always)]
        fn of(color: Encoded, threshold: u32) -> Self {
            color.rgb565(threshold).to_be_bytes()
        }
        #[inline(always)]
        fn of_display(color: Rgb<u16>, threshold: u32) -> Self {
            word565(color, threshold).to_be_bytes()
        }
        #[inline]
        fn over(self, below: Self, coverage: u8) -> Self {
            let [below, above] = [below, self].map(u16::from_be_bytes);
            blend565(below, above, coverage).to_be_bytes()
        }
        #[inline(always)]
        fn word(self) -> u32 {
            u16::from_be_bytes(self).into()
        }
    }

    impl Pixel for [u8; 3] {
        #[inline(always)]
        fn of(color: Encoded, _: u32) -> Self {
            color.rgb888().into()
        }
        #[inline(always)]
        fn of_display(color: Rgb<u16>, _: u32) -> Self {
            color.map(|channel| levels::<255>(channel, NEAREST) as u8).into()
        }
        #[inline]
        fn over(self, below: Self, coverage: u8) -> Self {
            Rgb::from(self).over(below.into(), coverage).into()
        }
        #[inline(always)]
        fn word(self) -> u32 {
            let [r, g, b] = self;
            u32::from_le_bytes([r, g, b, 0])
        }
    }
    impl Pixel for [u8; 4] {
        #[inline(always)]
        fn of(color: Encoded, threshold: u32) -> Self {
            opaque(<[u8; 3]>::of(color, threshold))
        }
        #[inline(always)]
        fn of_display(color: Rgb<u16>, threshold: u32) -> Self {
            opaque(<[u8; 3]>::of_display(color, threshold))
        }
        #[inline]
        fn over(self, below: Self, coverage: u8) -> Self {
            let [r, g, b, _] = self;
            blend8888(below, Rgb { r, g, b }, coverage)
        }
        #[inline(always)]
        fn word(self) -> u32 {
            u32::from_le_bytes(self)
        }
    }

    #[inline(always)]
    fn opaque([r, g, b]: [u8; 3]) -> [u8; 4] {
        [r, g, b, u8::MAX]
    }
}

#[cfg(test)]
mod tests {
    use super::sealed::Pixel;

    #[test]
    fn a_pixel_over_another_has_their_opacity_and_mean_color_within_a_level() {
        let above = [200, 100, 0, 255];
        for opacity in [0, 1, 77, 254, 255] {
            for coverage in 0..=u8::MAX {
                let below = [40, 255, 9, opacity];
                let found = above.over(below, coverage);
                let [a, b] = [coverage, opacity].map(|of_255| f64::from(of_255) / 255.0);
                let total = a + (1.0 - a) * b;
                assert!((f64::from(found[3]) - 255.0 * total).abs() <= 0.5001);
                if found[3] == 0 {
                    continue;
                }
                for ((x, y), found) in above.into_iter().zip(below).zip(found).take(3) {
                    let mean = (a * f64::from(x) + (1.0 - a) * b * f64::from(y)) / total;
                    assert!((f64::from(found) - mean).abs() <= 1.0);
                }
                let [r, g, b, _] = found;
                if opacity == 255 {
                    assert_eq!([r, g, b], [200, 100, 0].over([40, 255, 9], coverage));
                }
                if opacity == 0 {
                    assert_eq!([r, g, b], [200, 100, 0]);
                }
            }
        }
    }
}
