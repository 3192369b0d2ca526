//! Encoded colors with room for the fractions between them, and their levels on a display.

use crate::color::Rgb;

/// Units of a value: steps of a level of RGB565, 31 levels for red and blue and 63 for green. 64 times
/// the largest value has 16 bits.
const STEPS: [u32; 2] = [31 << 5, 63 << 4];

/// The threshold of [`Encoded::rgb565`] that rounds to the nearest level.
pub const NEAREST: u32 = 1 << 10;

/// An encoded color: red in the upper half of the first word and blue in the lower one, green in the
/// second.
#[derive(Clone, Copy, Debug)]
pub struct Encoded(pub [u32; 2]);

impl Encoded {
    pub const BLACK: Self = Self([0; 2]);

    /// Of encoded values from 0 to 65,535.
    pub fn of(color: Rgb<u16>) -> Self {
        let [of_red_blue, of_green] = STEPS;
        let steps = |channel: u16, most: u32| (u32::from(channel) * most + (1 << 15)) >> 16;
        let Rgb { r, g, b } = color;
        Self([steps(r, of_red_blue) << 16 | steps(b, of_red_blue), steps(g, of_green)])
    }
}

/// Of 64 times a color.
impl Encoded {
    /// The levels, each rounded down after adding a threshold: 2^11 of it are a level of red and
    /// blue.
    #[inline(always)]
    pub fn rgb565(self, threshold: u32) -> u16 {
        let Self([red_blue, green]) = self;
        let red_blue = red_blue + (threshold << 16 | threshold);
        let green = green + (threshold >> 1);
        ((red_blue >> 16 & 0xf800) | (green >> 5 & 0x07e0) | (red_blue >> 11 & 0x1f)) as u16
    }

    #[inline(always)]
    pub fn rgb888(self) -> Rgb<u8> {
        /// 255 of the largest sums, times 2^22.
        const SCALES: [u32; 2] = [(255 << 22) / (STEPS[0] << 6), (255 << 22) / (STEPS[1] << 6)];
        let Self([red_blue, green]) = self;
        let level = |sum: u32, scale: u32| ((sum * scale + (1 << 21)) >> 22) as u8;
        let [of_red_blue, of_green] = SCALES;
        Rgb {
            r: level(red_blue >> 16, of_red_blue),
            g: level(green, of_green),
            b: level(red_blue & 0xffff, of_red_blue),
        }
    }
}
