//! A canvas with blended pixels and text.

use font8x8::{BASIC_FONTS, UnicodeFonts};

/// Width of a letter of scale 1 in pixels, and the distance between its baselines.
pub const LETTER: usize = 8;

/// An opaque picture in sRGB.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Canvas {
    /// Width in pixels.
    pub width: usize,
    /// Height in pixels.
    pub height: usize,
    /// r, g, b of each pixel, row by row from the top.
    pub bytes: Vec<u8>,
}

impl Canvas {
    /// A canvas filled with one color.
    #[must_use]
    pub fn new(width: usize, height: usize, background: [u8; 3]) -> Self {
        Self { width, height, bytes: background.repeat(width * height) }
    }

    /// Blends a color over one pixel with opacity `coverage` in \[0, 1\]. Pixels outside the canvas
    /// are ignored.
    pub fn blend(&mut self, column: usize, row: usize, color: [u8; 3], coverage: f64) {
        if column >= self.width || row >= self.height {
            return;
        }
        let start = 3 * (row * self.width + column);
        for (byte, color) in self.bytes.iter_mut().skip(start).zip(color) {
            let (below, above) = (f64::from(*byte), f64::from(color));
            *byte = (below + coverage * (above - below)).round() as u8;
        }
    }

    /// Writes a line of text whose top left corner is at `column` and `row`.
    pub fn text(&mut self, column: usize, row: usize, scale: usize, color: [u8; 3], text: &str) {
        for (place, letter) in text.chars().enumerate() {
            let glyph = BASIC_FONTS.get(letter).unwrap_or([0x7e; 8]);
            for (y, bits) in glyph.iter().enumerate() {
                for x in (0..LETTER).filter(|x| bits >> x & 1 == 1) {
                    let left = column + scale * (place * LETTER + x);
                    let top = row + scale * y;
                    for pixel in 0..scale * scale {
                        self.blend(left + pixel % scale, top + pixel / scale, color, 1.0);
                    }
                }
            }
        }
    }
}

/// Width of a line of text in pixels.
#[must_use]
pub fn text_width(scale: usize, text: &str) -> usize {
    scale * LETTER * text.chars().count()
}
