//! Pictures of normals in two bytes a pixel.
//!
//! A code is a point (u, v) with |u|, |v| <= 127: the normal's direction in the picture, and its
//! angle from the camera as the distance from (0, 0), 127 for 90°. In this azimuthal equidistant map
//! a step of u or v turns the normal by at most 0.71° everywhere, so rounding turns it by at most
//! 0.51°. Octahedral codes are off by up to 0.55° and paraboloid codes by up to 0.64°. Both sin θ / θ
//! and cos θ are series in θ², which is u² + v², so a short polynomial decodes each.
//!
//! The codes with u = -128 have no normal of their own. Their other byte is a neighbor's number in
//! the three low bits and a coverage in units of 1/32 above them: a pixel that the object covers in
//! part has the normal of that neighbor. Without coverage, a pixel is background. So is a code
//! beyond the rim, and one that refers to a pixel without a normal of its own.

use crate::error::{Argument, Error};
use crate::normal::Normal;
use crate::{Q15, quantized};
use core::f32::consts::FRAC_PI_2;

/// The distance of the rim from the center.
const RIM: f32 = 127.0;

/// The square of the largest distance that counts as the rim, in which all rounded codes lie.
const LARGEST: i32 = 1 << 14;

/// The first byte of codes that have no normal of their own.
const WITHOUT: u8 = 0x80;

/// The steps to a neighbor, to the right and down, by its number.
const NEIGHBORS: [[i8; 2]; 8] =
    [[-1, -1], [0, -1], [1, -1], [-1, 0], [1, 0], [-1, 1], [0, 1], [1, 1]];

/// sin θ / s, with s = θ / (π/2), as a polynomial in (u² + v²) / 2^14, from the constant on: within
/// 1.3e-6.
const SINE: [f64; 4] = [1.570_795_05, -0.656_135_98, 0.082_027_47, -0.004_576_182];

/// (1 - cos θ) / t, with t = (u² + v²) / 2^14, in t: within 2.1e-7, times t.
const COSINE: [f64; 4] = [1.253_205_19, -0.261_747_396, 0.021_835_836, -0.000_925_671_56];

/// A picture of an object's normals, two bytes a pixel, to be drawn under any light.
///
/// `eigenshade pack-normals` makes one from a mesh or from a PNG. Normals are within 0.51° of the
/// packed ones. Pixels at an object's outline have a coverage.
///
/// ```
/// use eigenshade::{Disc, Display, NormalMap, Tone, blend565};
///
/// // A sphere of 32 x 32 pixels, and a display of the same size with a blue background.
/// let mut codes = [NormalMap::BACKGROUND; 32 * 32];
/// for pixel in Disc::new(32) {
///     codes[pixel.index()] = NormalMap::code(pixel.normal());
/// }
/// let map = NormalMap::new(32, 32, codes.as_flattened())?;
/// let mut screen = [0x001f_u16; 32 * 32];
///
/// # #[cfg(all(feature = "baked", feature = "presets"))] {
/// use eigenshade::presets::{light::PARK, material::DARK_RED_PAINT};
/// use eigenshade::sphere;
///
/// static DISPLAY: Display = Display::new(Tone::Filmic);
/// let scene = sphere::color::scene(PARK, DARK_RED_PAINT)?;
/// for pixel in map.pixels() {
///     let color = DISPLAY.rgb565(scene.shade(pixel.normal()).exposed(1.5));
///     let below = &mut screen[pixel.index()];
///     *below = blend565(*below, color, pixel.coverage());
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
    /// [`Error::Empty`] if there is no pixel; [`Error::Length`] unless there are two bytes for each.
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

    /// The pixels of one row, from the left. A row beyond the last one has none.
    #[must_use]
    pub fn row(&self, row: usize) -> NormalPixels<'a> {
        let start = row.saturating_mul(self.width);
        let codes = self.codes.get(start..).and_then(|rest| rest.get(..self.width));
        NormalPixels { map: *self, rest: codes.unwrap_or_default().iter(), column: 0, row }
    }

    /// The code of a pixel that the object covers completely: its normal.
    #[must_use]
    pub fn code(normal: Normal<f32>) -> [u8; 2] {
        let Normal { x, y, z } = normal;
        let sine = libm::sqrtf(x * x + y * y);
        let scale = if sine > 0.0 {
            RIM / FRAC_PI_2 * libm::atan2f(sine, z) / sine
        } else {
            return [0; 2];
        };
        [x, y].map(|along| (libm::roundf(along * scale).clamp(-RIM, RIM) as i8).cast_unsigned())
    }

    /// The code of a pixel that the object covers in part, by `coverage` / 255. It has the normal of
    /// the neighbor that is so many pixels to the right and down, each -1, 0 or 1. The code is that
    /// of the background unless that is one of the eight neighbors. Coverage is rounded to 1/32 to
    /// 31/32.
    #[must_use]
    pub fn edge_code(coverage: u8, neighbor: [i8; 2]) -> [u8; 2] {
        let Some(number) = NEIGHBORS.iter().position(|&step| step == neighbor) else {
            return Self::BACKGROUND;
        };
        let levels = ((u16::from(coverage) + 4) >> 3).clamp(1, 31) as u8;
        [WITHOUT, (levels << 3) | number as u8]
    }

    /// The point of a pixel that the object covers in part, and its coverage.
    fn edge(&self, rest: u8, column: usize, row: usize) -> Option<([i8; 2], u8)> {
        let coverage = rest & 0xf8;
        if coverage == 0 {
            return None;
        }
        let &[right, down] = NEIGHBORS.get(usize::from(rest & 7))?;
        let column = column.checked_add_signed(right.into()).filter(|&one| one < self.width)?;
        let row = row.checked_add_signed(down.into())?;
        let [x, y] = *self.codes.get(row.checked_mul(self.width)?.checked_add(column)?)?;
        let point = if x == WITHOUT { None } else { inside([x, y]) };
        Some((point?, coverage))
    }
}

/// The point of a code, if it is inside the rim.
#[inline(always)]
fn inside(code: [u8; 2]) -> Option<[i8; 2]> {
    let point = code.map(u8::cast_signed);
    (square(point) <= LARGEST).then_some(point)
}

#[inline(always)]
fn square([u, v]: [i8; 2]) -> i32 {
    let [u, v] = [i32::from(u), i32::from(v)];
    u * u + v * v
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
            let &[x, y] = self.rest.next()?;
            let (column, row, width) = (self.column, self.row, self.map.width);
            (self.column, self.row) =
                if column + 1 < width { (column + 1, row) } else { (0, row + 1) };
            let found = if x == WITHOUT {
                self.map.edge(y, column, row)
            } else {
                inside([x, y]).map(|point| (point, u8::MAX))
            };
            if let Some((point, coverage)) = found {
                return Some(NormalPixel { column, row, width, point, coverage });
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
    point: [i8; 2],
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
    /// [`blend565`](crate::blend565).
    #[inline]
    #[must_use]
    pub const fn coverage(self) -> u8 {
        self.coverage
    }

    /// The normal. Components are within 2e-6 of those of its code.
    #[inline]
    #[must_use]
    pub fn normal(self) -> Normal<f32> {
        const SINE_32: [f32; 4] = rounded(SINE, 1.0 / 127.0);
        const COSINE_32: [f32; 4] = rounded(COSINE, 1.0);
        let t = square(self.point) as f32 * (1.0 / LARGEST as f32);
        let value = |[a, b, c, d]: [f32; 4]| ((d * t + c) * t + b) * t + a;
        let scale = value(SINE_32);
        let [x, y] = self.point.map(|along| f32::from(along) * scale);
        Normal { x, y, z: (1.0 - t * value(COSINE_32)).max(0.0) }
    }

    /// The normal in integers. Components are within 2.5 units of 2^-15 of those of its code.
    #[inline]
    #[must_use]
    pub fn quantized_normal(self) -> quantized::Normal<Q15> {
        const SINE_15: [i32; 4] = whole(SINE, 32_767.0 * 128.0 / 127.0);
        const COSINE_15: [i32; 4] = whole(COSINE, 32_767.0);
        let t = square(self.point);
        let value = |[a, b, c, d]: [i32; 4]| {
            let sum = ((d * t) >> 14) + c;
            let sum = ((sum * t) >> 14) + b;
            ((sum * t) >> 14) + a
        };
        let scale = value(SINE_15);
        let [x, y] = self.point.map(|along| {
            // At most 2^15 before.
            Q15(((i32::from(along) * scale + 64) >> 7).min(32_767) as i16)
        });
        let z = 32_767 - ((value(COSINE_15) * t + (1 << 13)) >> 14);
        quantized::Normal { x, y, z: Q15(z.max(0) as i16) }
    }
}

const fn rounded([a, b, c, d]: [f64; 4], scale: f64) -> [f32; 4] {
    [(a * scale) as f32, (b * scale) as f32, (c * scale) as f32, (d * scale) as f32]
}

/// Rounds up what is added to a step of Horner's rule, which rounds down, and the first coefficient
/// to the nearest integer. The signs alternate.
const fn whole([a, b, c, d]: [f64; 4], scale: f64) -> [i32; 4] {
    let [a, b, c, d] = [a * scale, b * scale, c * scale, d * scale - 0.5];
    [a as i32 + 1, b as i32, c as i32 + 1, d as i32]
}

#[cfg(test)]
#[expect(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test may panic")]
mod tests {
    use super::*;
    use core::f64::consts::FRAC_PI_2;

    /// The normal of a code, by the definition of the map.
    fn exact([u, v]: [i8; 2]) -> [f64; 3] {
        let [u, v] = [u, v].map(f64::from);
        let distance = libm::sqrt(u * u + v * v);
        let angle = (distance / 127.0 * FRAC_PI_2).min(FRAC_PI_2);
        let scale = if distance > 0.0 { libm::sin(angle) / distance } else { 0.0 };
        [u * scale, v * scale, libm::cos(angle)]
    }

    /// The angle between two unit vectors in degrees, precise for small ones.
    fn degrees(a: [f64; 3], b: [f64; 3]) -> f64 {
        let square: f64 = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum();
        (2.0 * libm::asin(0.5 * libm::sqrt(square))).to_degrees()
    }

    /// Calls a function with unit vectors, spread evenly over the visible hemisphere.
    fn spread(mut with: impl FnMut([f64; 3])) {
        const COUNT: usize = 200_000;
        for k in 0..COUNT {
            let z = k as f64 / (COUNT - 1) as f64;
            let (sine, turn) = (libm::sqrt(1.0 - z * z), k as f64 * 2.399_963_229_728_653);
            with([sine * libm::cos(turn), sine * libm::sin(turn), z]);
        }
    }

    #[test]
    fn every_code_is_decoded_in_floats_and_integers() {
        // Codes just beyond the rim have its normals, which are too short by 7e-5.
        const AT_THE_RIM: f64 = 8e-5;
        for code in 0..=u16::MAX {
            let code = code.to_le_bytes();
            let map = NormalMap::new(1, 1, &code).unwrap();
            let point = code.map(u8::cast_signed);
            let Some(pixel) = map.pixels().next() else {
                assert!(point[0] == -128 || square(point) > LARGEST);
                continue;
            };
            assert_eq!((pixel.coverage(), pixel.index(), pixel.point), (255, 0, point));
            let exact = exact(point);
            let beyond = square(point) > 127 * 127;
            let found = pixel.normal().components().map(f64::from);
            let integers = pixel.quantized_normal().components();
            for ((found, integer), exact) in found.into_iter().zip(integers).zip(exact) {
                let more = if beyond { AT_THE_RIM } else { 0.0 };
                assert!((found - exact).abs() < 2e-6 + more, "{point:?}: {found} {exact}");
                let off = (f64::from(integer.0) - 32_768.0 * exact).abs();
                assert!(off < 2.5 + 32_768.0 * more, "{point:?}: {integer:?} {exact}");
            }
            assert!(found[2] >= 0.0 && found[2] <= 1.0 && integers[2].0 >= 0);
        }
    }

    #[test]
    fn rounding_turns_normals_by_half_a_degree_at_most() {
        let (mut worst, mut sum, mut count) = (0.0_f64, 0.0, 0.0);
        spread(|[x, y, z]| {
            let code = NormalMap::code(Normal { x: x as f32, y: y as f32, z: z as f32 });
            let map = NormalMap::new(1, 1, &code).unwrap();
            let pixel = map.pixels().next().unwrap();
            let found = pixel.normal().components().map(f64::from);
            let off = degrees(found, [x, y, z]);
            worst = worst.max(off);
            // By the projected area.
            (sum, count) = (sum + z * off * off, count + z);
        });
        let rms = libm::sqrt(sum / count);
        assert!(worst < 0.51 && rms < 0.28, "{worst} {rms}");
    }

    /// The two other maps that need no trigonometry, rounded to the same number of steps.
    #[test]
    fn other_maps_are_less_exact() {
        let round = |x: f64| libm::round(x * 127.0) / 127.0;
        let unit = |[x, y, z]: [f64; 3]| {
            let length = libm::sqrt(x * x + y * y + z * z);
            [x / length, y / length, z / length]
        };
        let (mut paraboloid, mut octahedral) = (0.0_f64, 0.0_f64);
        spread(|[x, y, z]| {
            let [u, v] = [x, y].map(|along| round(along / (1.0 + z)));
            let found = unit([2.0 * u, 2.0 * v, 1.0 - u * u - v * v]);
            paraboloid = paraboloid.max(degrees(found, [x, y, z]));
            // The hemisphere fills the square turned by 45 degrees.
            let sum = x.abs() + y.abs() + z;
            let [u, v] = [(x + y) / sum, (x - y) / sum].map(round);
            let [p, q] = [(u + v) / 2.0, (u - v) / 2.0];
            let found = unit([p, q, 1.0 - p.abs() - q.abs()]);
            octahedral = octahedral.max(degrees(found, [x, y, z]));
        });
        assert!((paraboloid - 0.64).abs() < 0.01, "{paraboloid}");
        assert!((octahedral - 0.55).abs() < 0.01, "{octahedral}");
    }

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
            assert_eq!(pixel.point, [10, 20]);
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
