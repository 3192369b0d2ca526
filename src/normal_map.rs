//! Pictures of normals in two bytes a pixel.
//!
//! A pixel that the object covers completely has the [code](crate::normal_code) of its normal.
//!
//! A code with u = -128 has no normal of its own. The other byte of such a code is a neighbor's
//! number in the three low bits and a coverage in units of 1/32 above them: a pixel that the object
//! covers in part has the normal of that neighbor. Without coverage, a pixel is background. A code
//! beyond the rim, or one that refers to a pixel without a normal of its own, is background too.

use crate::error::{Argument, Error};
use crate::nodes::Nodes;
use crate::normal::Normal;
use crate::normal_code::{NormalCode, WITHOUT};
use crate::pixel::Pixel;
use crate::q15;
use crate::target::Target;

/// The steps to a neighbor, to the right and down, by its number.
const NEIGHBORS: [[i8; 2]; 8] =
    [[-1, -1], [0, -1], [1, -1], [-1, 0], [1, 0], [-1, 1], [0, 1], [1, 1]];

/// A picture of an object's normals, two bytes a pixel, to be drawn under any light.
///
/// `eigenshade pack-object` makes a map from a mesh or from a PNG. Normals are within 0.51° of the
/// packed ones. Pixels at an object's outline have a coverage.
///
/// ```
/// use eigenshade::object::NormalMap;
/// use eigenshade::screen::{Display, Target, Tone};
///
/// // A sphere of 32 x 32 pixels, and a display of the same size with a blue background.
/// let mut codes = [NormalMap::BACKGROUND; 32 * 32];
/// NormalMap::sphere(32, &mut codes)?;
/// let map = NormalMap::new(32, 32, codes.as_flattened())?;
/// let mut screen = [0x001f_u16; 32 * 32];
///
/// # #[cfg(all(feature = "baked", feature = "presets"))] {
/// use eigenshade::presets::{light::PARK, material::DARK_RED_PAINT};
/// use eigenshade::sphere;
///
/// static DISPLAY: Display = Display::new(Tone::Filmic);
/// let scene = sphere::color::scene(PARK, DARK_RED_PAINT)?;
/// let exposure = scene.exposure_by_factor(1.5)?;
/// let mut target = Target::new(&mut screen, 32)?;
/// for pixel in map.pixels() {
///     let color = DISPLAY.rgb565(exposure.of(scene.shade(pixel.normal())));
///     pixel.put(&mut target, color);
/// }
/// assert!(screen[0] == 0x001f && screen[16 * 32 + 16] != 0x001f);
/// # }
/// # Ok::<(), eigenshade::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct NormalMap<'a> {
    width: usize,
    height: usize,
    codes: &'a [[u8; 2]],
}

impl<'a> NormalMap<'a> {
    /// The code of a pixel without an object.
    pub const BACKGROUND: [u8; 2] = [WITHOUT, 0];

    /// The map of `width` x `height` pixels with these codes, two bytes each, row by row from the
    /// top.
    ///
    /// # Errors
    ///
    /// [`Error::Empty`] if there is no pixel; [`Error::Length`] unless there are two bytes for
    /// each.
    pub const fn new(width: usize, height: usize, bytes: &'a [u8]) -> Result<Self, Error> {
        let expected = width.saturating_mul(height).saturating_mul(2);
        if expected == 0 {
            return Err(Error::Empty { argument: Argument::NormalMap });
        }
        match Error::check(Argument::NormalMap, expected, bytes.len()) {
            Ok(()) => Ok(Self { width, height, codes: bytes.as_chunks().0 }),
            Err(error) => Err(error),
        }
    }

    /// Pixels across.
    #[must_use]
    pub const fn width(&self) -> usize {
        self.width
    }

    /// Pixels down.
    #[must_use]
    pub const fn height(&self) -> usize {
        self.height
    }

    /// The pixels that the object covers at least in part, row by row from the top.
    ///
    /// Cost: a few loads and comparisons a pixel, background included, and for its normal twelve
    /// products and eight sums.
    #[must_use]
    pub fn pixels(&self) -> NormalPixels<'a> {
        NormalPixels { map: *self, rest: self.codes.iter(), column: 0, row: 0 }
    }

    /// The nodes of a [`Palette`](crate::screen::Palette) that the object needs. Cost: some 40
    /// instructions a pixel, once for a map.
    #[must_use]
    pub fn nodes(&self) -> Nodes {
        self.pixels().map(NormalPixel::code).collect()
    }

    /// The pixels of one row, from the left. A row beyond the last one has none.
    #[must_use]
    pub fn row(&self, row: usize) -> NormalPixels<'a> {
        NormalPixels { map: *self, rest: self.codes(row).iter(), column: 0, row }
    }

    /// The codes of one row; none beyond the last one.
    pub(crate) fn codes(&self, row: usize) -> &'a [[u8; 2]] {
        let start = row.saturating_mul(self.width);
        let codes = self.codes.get(start..).and_then(|rest| rest.get(..self.width));
        codes.unwrap_or_default()
    }

    /// The code of a pixel that the object covers completely: its normal.
    #[must_use]
    pub fn code(normal: Normal) -> [u8; 2] {
        NormalCode::of(normal).bytes()
    }

    /// The code of a pixel that the object covers in part, by `coverage` / 255. The pixel gets the
    /// normal of `neighbor`, an offset in pixels to the right and down, each -1, 0 or 1. If
    /// `neighbor` is none of the eight neighbors, the code is [`BACKGROUND`](Self::BACKGROUND).
    /// Coverage is rounded to 1/32 to 31/32.
    #[must_use]
    pub const fn edge_code(coverage: u8, [right, down]: [i8; 2]) -> [u8; 2] {
        let (mut neighbors, mut number) = (NEIGHBORS.as_slice(), 0);
        while let [[to_right, to_below], others @ ..] = neighbors {
            if *to_right == right && *to_below == down {
                let levels = (coverage as u16 + 4) >> 3;
                let levels = if levels < 1 { 1 } else { levels };
                let levels = if levels > 31 { 31 } else { levels };
                return [WITHOUT, (levels << 3) as u8 | number];
            }
            (neighbors, number) = (others, number + 1);
        }
        Self::BACKGROUND
    }

    /// Of a pixel that the object covers in part, the code of its normal and its coverage.
    pub(crate) fn edge(
        &self,
        [without, rest]: [u8; 2],
        column: usize,
        row: usize,
    ) -> Option<(NormalCode, u8)> {
        if without != WITHOUT {
            return None;
        }
        let coverage = rest & 0xf8;
        if coverage == 0 {
            return None;
        }
        let &[right, down] = NEIGHBORS.get(usize::from(rest & 7))?;
        let column = column.checked_add_signed(right.into()).filter(|&one| one < self.width)?;
        let row = row.checked_add_signed(down.into())?;
        let code = *self.codes.get(row.checked_mul(self.width)?.checked_add(column)?)?;
        Some((NormalCode::inside(code)?, coverage))
    }
}

/// Iterates over the pixels of a [`NormalMap`] that its object covers.
#[derive(Clone, Debug)]
pub struct NormalPixels<'a> {
    map: NormalMap<'a>,
    rest: core::slice::Iter<'a, [u8; 2]>,
    /// The next pixel.
    column: usize,
    row: usize,
}

impl Iterator for NormalPixels<'_> {
    type Item = NormalPixel;

    #[inline]
    fn next(&mut self) -> Option<NormalPixel> {
        loop {
            let &code = self.rest.next()?;
            let (column, row, width) = (self.column, self.row, self.map.width);
            (self.column, self.row) =
                if column + 1 < width { (column + 1, row) } else { (0, row + 1) };
            let found = match NormalCode::inside(code) {
                Some(code) => Some((code, u8::MAX)),
                None => self.map.edge(code, column, row),
            };
            if let Some((code, coverage)) = found {
                return Some(NormalPixel { column, row, width, code, coverage });
            }
        }
    }
}

/// A pixel of a [`NormalMap`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct NormalPixel {
    column: usize,
    row: usize,
    width: usize,
    code: NormalCode,
    coverage: u8,
}

impl NormalPixel {
    /// The column, from 0 at the left.
    #[inline]
    #[must_use]
    pub const fn column(self) -> usize {
        self.column
    }

    /// The row, from 0 at the top.
    #[inline]
    #[must_use]
    pub const fn row(self) -> usize {
        self.row
    }

    /// The index in a picture stored row by row.
    #[inline]
    #[must_use]
    pub const fn index(self) -> usize {
        self.row * self.width + self.column
    }

    /// The share of the pixel that the object covers, from 8 to 255: see
    /// [`blend565`](crate::screen::blend565).
    #[inline]
    #[must_use]
    pub const fn coverage(self) -> u8 {
        self.coverage
    }

    /// Draws this pixel. Where the object covers it in part, it is mixed with what is there.
    #[inline]
    pub fn put<P: Pixel>(self, target: &mut Target<'_, P>, color: P) {
        target.put([self.column, self.row], color, self.coverage);
    }

    /// The code of the normal: see [`Palette`](crate::screen::Palette).
    #[inline]
    #[must_use]
    pub const fn code(self) -> NormalCode {
        self.code
    }

    /// The normal of the pixel's code, each component within 2e-6 of the exact value.
    #[inline]
    #[must_use]
    pub fn normal(self) -> Normal {
        self.code.normal()
    }

    /// The normal of the pixel's code in integers, each component within 2.5 units of 2^-15 of the
    /// exact value.
    #[inline]
    #[must_use]
    pub fn normal_q15(self) -> q15::Normal {
        self.code.normal_q15()
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test may panic")]
mod tests {
    use super::*;

    #[test]
    fn pixels_of_the_outline_have_a_neighbors_normal() {
        let edge = NormalMap::edge_code;
        let own = [10, 20];
        let (none, far) = (NormalMap::BACKGROUND, [127, 127]);
        // From the left: a neighbor to the right, none, one beyond the map, one without a normal.
        let codes = [
            [edge(100, [1, 0]), own, edge(255, [-1, 0]), none],
            [edge(1, [1, -1]), edge(100, [0, -1]), edge(9, [1, 1]), far],
            [edge(100, [0, 1]), edge(100, [-1, 0]), edge(99, [0, 0]), edge(8, [1, 0])],
        ];
        let map = NormalMap::new(4, 3, codes.as_flattened().as_flattened()).unwrap();
        assert_eq!([map.width(), map.height()], [4, 3]);
        let found = map.pixels().map(|pixel| {
            assert_eq!(pixel.code.bytes(), [10, 20]);
            (pixel.column(), pixel.row(), pixel.coverage())
        });
        let expected = [(0, 0, 104), (1, 0, 255), (2, 0, 248), (0, 1, 8), (1, 1, 104)];
        assert!(found.eq(expected));
        let rows = (0..5).flat_map(|row| map.row(row));
        assert!(rows.eq(map.pixels()));
        assert!(map.row(1).all(|pixel| pixel.row() == 1 && pixel.index() < 8));
    }

    #[test]
    fn sizes_are_checked() {
        let bytes = [0; 12];
        assert!(NormalMap::new(3, 2, &bytes).is_ok());
        let found = |width, height, count: usize| NormalMap::new(width, height, &bytes[..count]);
        for (width, height) in [(0, 6), (6, 0), (0, 0)] {
            let empty = Error::Empty { argument: Argument::NormalMap };
            assert_eq!(found(width, height, 0), Err(empty));
        }
        let length =
            |expected, found| Err(Error::Length { argument: Argument::NormalMap, expected, found });
        assert_eq!(found(3, 2, 11), length(12, 11));
        assert_eq!(found(2, 2, 12), length(8, 12));
        assert_eq!(found(usize::MAX, 3, 12), length(usize::MAX, 12));
    }
}
