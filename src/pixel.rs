//! The pixels of displays, as they are in memory.

use crate::blend::blend565;
use crate::color::Rgb;

/// A pixel as it is in memory: `u16`, `[u8; 2]` or `[u8; 3]`.
///
/// * `u16` is RGB565 in the byte order of the processor: red in the highest bits. Frame buffers and
///   LVGL take it.
/// * `[u8; 2]` is RGB565 with the high byte first, as most displays on SPI take it. A slice is sent
///   as it is: `row.as_flattened()` are its bytes.
/// * `[u8; 3]` is RGB888: the bytes red, green and blue.
pub trait Pixel: sealed::Pixel {}
impl Pixel for u16 {}
impl Pixel for [u8; 2] {}
impl Pixel for [u8; 3] {}

pub(crate) mod sealed {
    use super::{Rgb, blend565};
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
}
