//! A picture to draw on: blended pixels and text.

use font8x8::{BASIC_FONTS, UnicodeFonts};

/// Pixels across a letter of scale 1, and between two base lines.
pub const LETTER: usize = 8;

/// An opaque picture in sRGB.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Canvas {
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// r, g, b; row by row from the top.
    pub bytes: Vec<u8>,
}

impl Canvas {
    /// A canvas of one colour.
    #[must_use]
    pub fn new(width: usize, height: usize, background: [u8; 3]) -> Self {
        Self { width, height, bytes: background.repeat(width * height) }
    }

    /// Lays a colour over one pixel, as opaque as `coverage` in \[0, 1\] says.
    /// Beyond the edge nothing happens.
    pub fn blend(&mut self, column: usize, row: usize, colour: [u8; 3], coverage: f64) {
        if column >= self.width || row >= self.height {
            return;
        }
        let start = 3 * (row * self.width + column);
        for (byte, colour) in self.bytes.iter_mut().skip(start).zip(colour) {
            let (below, above) = (f64::from(*byte), f64::from(colour));
            *byte = (below + coverage * (above - below)).round() as u8;
        }
    }

    /// Writes a line of text with its top left corner there.
    pub fn text(&mut self, column: usize, row: usize, scale: usize, colour: [u8; 3], text: &str) {
        for (place, letter) in text.chars().enumerate() {
            let glyph = BASIC_FONTS.get(letter).unwrap_or([0x7e; 8]);
            for (y, bits) in glyph.iter().enumerate() {
                for x in (0..LETTER).filter(|x| bits >> x & 1 == 1) {
                    let left = column + scale * (place * LETTER + x);
                    let top = row + scale * y;
                    for pixel in 0..scale * scale {
                        self.blend(left + pixel % scale, top + pixel / scale, colour, 1.0);
                    }
                }
            }
        }
    }
}

/// Pixels across a line of text.
#[must_use]
pub fn text_width(scale: usize, text: &str) -> usize {
    scale * LETTER * text.chars().count()
}
