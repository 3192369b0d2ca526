//! The pixels and normals of a sphere, without a root for each pixel.

use crate::display::{INTERVALS, Piece, interpolated};
use crate::error::Error;
use crate::normal::Normal;
use crate::normal_code::NormalCode;
use crate::pixel::Pixel;
use crate::q15;
use crate::q15::Q15;
use crate::target::Target;

/// The bits of an interval's width in each piece of [`ROOTS`], in units of 2^-24.
const WIDTHS: [u32; 4] = [5, 9, 13, 17];

/// Square roots in units of 2^-15: from 0 to 1/4096, to 1/256, to 1/16 and to 1.
static ROOTS: [Piece; 4] = roots();

#[expect(clippy::indexing_slicing, reason = "a constant function has no iterators")]
const fn roots() -> [Piece; 4] {
    let mut pieces = [[0; INTERVALS + 1]; 4];
    let mut piece = 0;
    while piece < pieces.len() {
        let mut index = 1_u64;
        while index <= INTERVALS as u64 {
            // A square in units of 2^-32, whose root is in units of 2^-16.
            let root = (index << (WIDTHS[piece] + 8)).isqrt();
            pieces[piece][index as usize] = ((root + 1) >> 1) as u16;
            index += 1;
        }
        piece += 1;
    }
    pieces
}

/// The root of a number in units of 2^-24, below 2^24, in units of 2^-15.
#[inline]
fn root(square: u32) -> u16 {
    let [first, second, third, last] = &ROOTS;
    match square {
        0..0x1000 => interpolated(first, square, WIDTHS[0]),
        0x1000..0x1_0000 => interpolated(second, square, WIDTHS[1]),
        0x1_0000..0x10_0000 => interpolated(third, square, WIDTHS[2]),
        _ => interpolated(last, square, WIDTHS[3]),
    }
}

/// Iterates over the pixels of a sphere that fills a square picture, row by row from the top.
///
/// Yields the pixels whose centers are inside the circle, and all others that the circle covers in
/// part, with the normals of the nearest points of the rim: see [`DiscPixel::coverage`]. A disc of
/// less than 8 pixels has no such others. Cost: two divisions in [`new`](Self::new), and a look-up of
/// a root per pixel.
///
/// ```
/// use eigenshade::object::Disc;
///
/// let mut picture = [' '; 4 * 4];
/// for pixel in Disc::new(4)? {
///     picture[pixel.index()] = if pixel.normal().components()[1] > 0.0 { '^' } else { 'v' };
/// }
/// assert_eq!(picture.iter().collect::<String>(), " ^^ ^^^^vvvv vv ");
/// # Ok::<(), eigenshade::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Disc {
    size: i32,
    /// The next pixel.
    column: i32,
    row: i32,
    /// The row after the last one.
    end: i32,
    /// 2^56 / size².
    unit: u64,
    /// 2^31 / size.
    scale: i32,
}

impl Disc {
    /// The largest size.
    pub const MOST: usize = 4096;

    /// The pixels of a picture of `size` x `size` pixels.
    ///
    /// # Errors
    ///
    /// [`Error::Size`] unless the size is 1 to [`MOST`](Self::MOST).
    pub const fn new(size: usize) -> Result<Self, Error> {
        if size == 0 || size > Self::MOST {
            return Err(Error::Size { found: size });
        }
        let unit = (1 << 56) / (size as u64 * size as u64);
        let size = size as i32;
        // 2^31 itself does not fit.
        let scale = i32::MAX / size;
        Ok(Self { size, column: 0, row: 0, end: size, unit, scale })
    }

    /// A pixel whose center is outside the circle, with the normal of the nearest point of the rim.
    #[cold]
    fn at_the_rim(&self, [column, row]: [i32; 2]) -> DiscPixel {
        let size = self.size;
        let (x, y) = (2 * column + 1 - size, size - 1 - 2 * row);
        // 1 / √(1 + e) is 1 - e/2, within 6 e²/16, and e below 2.2 / size. The half of e in 2^-16.
        let beyond = (x * x + y * y - size * size).cast_unsigned();
        let half = ((u64::from(beyond) * self.unit) >> 41) as i32;
        let [x, y] = [x, y].map(|place| {
            let along = place * self.scale;
            along - (along >> 16) * half
        });
        DiscPixel { column, row, size, x, y, z: 0 }
    }

    /// The pixels of one row, from the left. A row beyond the last one has none.
    #[must_use]
    pub const fn row(&self, row: usize) -> Self {
        let row = if row < self.size as usize { row as i32 } else { self.size };
        let end = if row < self.size { row + 1 } else { row };
        Self { row, end, column: 0, ..*self }
    }
}

impl Iterator for Disc {
    type Item = DiscPixel;

    #[inline]
    fn next(&mut self) -> Option<DiscPixel> {
        while self.row < self.end {
            let (column, row) = (self.column, self.row);
            // Twice the distance from the center, an odd number in pictures of even size.
            let (x, y) = (2 * column + 1 - self.size, self.size - 1 - 2 * row);
            (self.column, self.row) =
                if column + 1 < self.size { (column + 1, row) } else { (0, row + 1) };
            let square = x * x + y * y;
            let outside = square as u64 * self.unit;
            if outside <= 1 << 56 {
                let square = (((1 << 56) - outside) >> 32) as u32;
                let z = root(square.min((1 << 24) - 1));
                let [x, y] = [x, y].map(|place| place * self.scale);
                return Some(DiscPixel { column, row, size: self.size, x, y, z });
            }
            let most = self.size + 1;
            if square <= most * most && self.size >= 8 {
                return Some(self.at_the_rim([column, row]));
            }
        }
        None
    }
}

/// The share of a pixel that a circle covers, in units of 1/32, by the distance of the pixel's
/// center from the circle: below 0 or above 32 for pixels that it does not touch. The place of the
/// center and the size are in half pixels.
#[inline]
pub(crate) const fn coverage([x, y]: [i32; 2], size: i32) -> i32 {
    let distance = ((((x * x + y * y) as u64) << 10).isqrt() as i32 + 1) >> 1;
    // In sixteenths of half a pixel.
    16 * size - distance + 16
}

/// A pixel of a [`Disc`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DiscPixel {
    column: i32,
    row: i32,
    size: i32,
    /// In units of 2^-31.
    x: i32,
    y: i32,
    /// In units of 2^-15.
    z: u16,
}

impl DiscPixel {
    /// The column, from 0 at the left.
    #[inline]
    #[must_use]
    pub const fn column(self) -> usize {
        self.column as usize
    }

    /// The row, from 0 at the top.
    #[inline]
    #[must_use]
    pub const fn row(self) -> usize {
        self.row as usize
    }

    /// The index in a picture of the disc's size, stored row by row.
    #[inline]
    #[must_use]
    pub const fn index(self) -> usize {
        (self.row * self.size + self.column) as usize
    }

    /// The share of the pixel that the circle covers, of 255, by the distance of the pixel's center
    /// from it: see [`blend565`](crate::screen::blend565). Cost: a root at the rim.
    #[inline]
    #[must_use]
    pub fn coverage(self) -> u8 {
        let center = [self.column, self.row].map(|place| 2 * place + 1 - self.size);
        let ([x, y], inner) = (center, self.size - 2);
        if inner > 0 && x * x + y * y <= inner * inner {
            return u8::MAX;
        }
        (8 * coverage(center, self.size)).clamp(0, 255) as u8
    }

    /// Draws this pixel. Where the circle covers it in part, it is mixed with what is there.
    #[inline]
    pub fn put<P: Pixel>(self, target: &mut Target<'_, P>, color: P) {
        target.put([self.column(), self.row()], color, self.coverage());
    }

    /// The code of the normal, within 0.6 of its exact place in u and in v.
    #[inline]
    #[must_use]
    pub fn code(self) -> NormalCode {
        NormalCode::of_sphere([self.x, self.y].map(|place| place >> 16), self.z.into())
    }

    /// The normal. z is within 1.5e-4 of the exact root, at the rim within 4e-4.
    #[inline]
    #[must_use]
    pub fn normal(self) -> Normal {
        let [x, y] = [self.x, self.y].map(|place| place as f32 * (1.0 / (1_u32 << 31) as f32));
        Normal { x, y, z: f32::from(self.z) * (1.0 / 32_768.0) }
    }

    /// The normal in integers, as exact as [`normal`](Self::normal).
    #[inline]
    #[must_use]
    pub fn normal_q15(self) -> q15::Normal {
        let [x, y] = [self.x, self.y].map(|place| Q15((place >> 16) as i16));
        q15::Normal { x, y, z: Q15(self.z.min(32_767) as i16) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normals_are_those_of_a_sphere() {
        let (mut worst, mut at_the_rim) = (0.0_f64, 0.0_f64);
        for size in [1, 2, 3, 17, 240, 1023, 4096] {
            let mut next = 0;
            for pixel in Disc::new(size).into_iter().flatten() {
                assert!(pixel.index() >= next && pixel.index() < size * size);
                next = pixel.index() + 1;
                assert_eq!(pixel.index(), pixel.row() * size + pixel.column());
                let place = |k: usize| (2.0 * k as f64 + 1.0) / size as f64 - 1.0;
                let (x, y) = (place(pixel.column()), -place(pixel.row()));
                if x * x + y * y > 1.0 {
                    continue;
                }
                let z = libm::sqrt((1.0 - x * x - y * y).max(0.0));
                let found = pixel.normal().components().map(f64::from);
                // The scale is rounded down to a whole 2^-31 / size.
                let allowed = size as f64 * libm::exp2(-31.0) + 1e-7;
                assert!((found[0] - x).abs() < allowed && (found[1] - y).abs() < allowed);
                let off = (found[2] - z).abs();
                worst = worst.max(if z < 0.02 { 0.0 } else { off });
                at_the_rim = at_the_rim.max(off);
                let integers = pixel.normal_q15().components();
                for (integer, exact) in integers.into_iter().zip([x, y, found[2]]) {
                    assert!((f64::from(integer.0) - 32_768.0 * exact).abs() <= 1.01);
                }
            }
            assert!(next > 0, "{size}");
        }
        assert!(worst < 1.5e-4 && at_the_rim < 4e-4, "{worst} {at_the_rim}");
    }

    /// Pixels beyond the circle have unit normals to the side, and the coverages sum to the area.
    #[test]
    fn the_rim_has_the_nearest_normals() {
        for size in [7, 8, 17, 64, 240, 4096] {
            let (mut area, mut count) = (0.0, 0);
            for pixel in Disc::new(size).into_iter().flatten() {
                area += f64::from(pixel.coverage()) / 255.0;
                let place = |k: usize| (2.0 * k as f64 + 1.0) / size as f64 - 1.0;
                let (x, y) = (place(pixel.column()), -place(pixel.row()));
                let distance = libm::hypot(x, y);
                if distance <= 1.0 {
                    continue;
                }
                count += 1;
                let [found_x, found_y, z] = pixel.normal().components().map(f64::from);
                let allowed = 0.3 / size as f64;
                assert!((found_x - x / distance).abs() < allowed && z == 0.0, "{size}");
                assert!((found_y - y / distance).abs() < allowed, "{size}");
            }
            assert_eq!(count > 0, size >= 8);
            let circle = core::f64::consts::PI / 4.0 * (size * size) as f64;
            let off = (area - circle).abs() / size as f64;
            assert!(size < 8 || off < 0.1, "{size}: {area} {circle}");
        }
    }

    #[test]
    fn the_circle_has_the_pixels_that_it_covers() {
        for size in 1..60_usize {
            let inside = |x: usize, y: usize| {
                let place = |k: usize| (2 * k + 1).abs_diff(size);
                let most = if size < 8 { size } else { size + 1 };
                place(x).pow(2) + place(y).pow(2) <= most * most
            };
            let expected = (0..size * size).filter(|k| inside(k % size, k / size));
            let pixels = || Disc::new(size).into_iter().flatten();
            assert!(pixels().map(DiscPixel::index).eq(expected), "{size}");
            let of_rows = |disc: Disc| (0..size + 2).flat_map(move |row| disc.row(row));
            assert!(Disc::new(size).into_iter().flat_map(of_rows).eq(pixels()), "{size}");
        }
        for found in [0, Disc::MOST + 1] {
            assert_eq!(Disc::new(found).err(), Some(Error::Size { found }));
        }
    }
}
