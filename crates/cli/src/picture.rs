//! Pictures of spheres, and canvases with text.

use eigenshade_shading::picture::Pixel;
use noto_sans_mono_bitmap::{FontWeight, get_raster, get_raster_width};
use std::ops::Range;

/// Pixels from one line of text to the next.
pub use noto_sans_mono_bitmap::RasterHeight as TextHeight;

/// The pixels of a square picture that a sphere covers at least in part.
#[derive(Clone, Debug, PartialEq)]
pub struct SphereView {
    /// Width and height of the picture in pixels.
    pub size: usize,
    /// The pixels, row by row from the top.
    pub pixels: Vec<Pixel>,
    /// The unit normal of each pixel, with z >= 0. If the center of a pixel just misses the sphere,
    /// its normal lies on the rim.
    pub normals: Vec<[f64; 3]>,
}

impl SphereView {
    /// A sphere that fills a picture of `size` x `size` pixels up to a margin of half a pixel.
    #[must_use]
    pub fn new(size: usize) -> Self {
        let (pixels, normals) = Self::pixels(size).unzip();
        Self { size, pixels, normals }
    }

    /// The pixels of this picture with their normals, in the same order.
    pub fn pixels(size: usize) -> impl Iterator<Item = (Pixel, [f64; 3])> {
        Self::rows(size, 0..size)
    }

    /// The pixels of some rows of this picture with their normals.
    pub fn rows(size: usize, rows: Range<usize>) -> impl Iterator<Item = (Pixel, [f64; 3])> {
        let radius = 0.5 * size as f64 - 0.5;
        let offset = move |k: usize| k as f64 + 0.5 - 0.5 * size as f64;
        let places = rows.flat_map(move |row| (0..size).map(move |column| (row, column)));
        places.filter_map(move |(row, column)| {
            let (x, y) = (offset(column), -offset(row));
            let distance = x.hypot(y);
            let coverage = (radius - distance + 0.5).clamp(0.0, 1.0);
            let is_inside = distance < radius;
            let scale = if is_inside { radius } else { distance }.recip();
            let (x, y) = (scale * x, scale * y);
            let z = if is_inside { (1.0 - x * x - y * y).max(0.0).sqrt() } else { 0.0 };
            (coverage > 0.0).then_some((Pixel { column, row, coverage, is_inside }, [x, y, z]))
        })
    }
}

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
    pub fn text(
        &mut self,
        (column, row): (usize, usize),
        height: TextHeight,
        color: [u8; 3],
        text: &str,
    ) {
        let width = text_width(height, " ");
        for (place, letter) in text.chars().enumerate() {
            let raster = |letter| get_raster(letter, FontWeight::Regular, height);
            let Some(glyph) = raster(letter).or_else(|| raster('?')) else { continue };
            for (y, line) in glyph.rows().enumerate() {
                for (x, &ink) in line.iter().enumerate() {
                    let left = column + place * width + x;
                    self.blend(left, row + y, color, f64::from(ink) / 255.0);
                }
            }
        }
    }

    /// Writes a line of text about the column `middle`.
    pub fn centered_text(
        &mut self,
        (middle, row): (usize, usize),
        height: TextHeight,
        color: [u8; 3],
        text: &str,
    ) {
        let left = middle.saturating_sub(text_width(height, text) / 2);
        self.text((left, row), height, color, text);
    }
}

/// Width of a line of text in pixels.
#[must_use]
pub fn text_width(height: TextHeight, text: &str) -> usize {
    get_raster_width(FontWeight::Regular, height) * text.chars().count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_smooth_and_as_wide_as_stated() {
        for height in [TextHeight::Size16, TextHeight::Size32] {
            let drawn = |text: &str| {
                let mut canvas = Canvas::new(100, height.val(), [0; 3]);
                canvas.text((0, 0), height, [255; 3], text);
                canvas
            };
            let Canvas { width, bytes, .. } = drawn("Wg");
            assert!(bytes.iter().any(|&byte| byte > 200), "{height:?}");
            assert!(bytes.iter().any(|byte| (50..200).contains(byte)), "{height:?}");
            let inked = bytes.chunks(3).enumerate().filter(|(_, rgb)| rgb[0] > 0);
            let last = inked.map(|(place, _)| place % width).max();
            let expected = text_width(height, "Wg");
            assert!(last.is_some_and(|last| last < expected && last > expected / 2), "{last:?}");
            // A letter that the font lacks.
            assert_eq!(drawn("\u{9762}"), drawn("?"));
        }
    }
}
