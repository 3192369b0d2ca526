//! The colors of a frame by normal: nodes are shaded, exposed and encoded once, and a pixel is
//! interpolated between four of them.
//!
//! A node is every eighth code of each axis of a [`NormalCode`], and the three low bits of a code are
//! the place between two nodes. Display values are interpolated, not irradiances: a tone curve and
//! an encoding make an irradiance much less smooth.

use crate::blend::blend565;
use crate::color::Rgb;
use crate::display::{Display, Linear, rank, ranks};
use crate::nodes::{Nodes, SIDE};
use crate::normal::Normal;
use crate::normal_code::{NormalCode, RIM, normal_at, normal_q15_at};
use crate::normal_map::NormalMap;
use crate::q15;

/// Bits of a node's place after the binary point, in codes.
const POINT: u32 = 4;

/// Units of a node's values: steps of a level of RGB565, 31 levels for red and blue and 63 for
/// green. 64 times the largest value has 16 bits.
const STEPS: [u32; 2] = [31 << 5, 63 << 4];

/// The encoded color at a node: red in the upper half of the first word and blue in the lower one,
/// green in the second.
type Node = [u32; 2];

/// A normal in one of the number formats.
pub trait OfNode: sealed::OfNode {}
impl OfNode for Normal {}
impl OfNode for q15::Normal {}

mod sealed {
    use super::{Normal, POINT, normal_at, normal_q15_at, q15};

    pub trait OfNode {
        /// The normal at a point of the map of codes, in units of 2^-[`POINT`] of a code.
        fn of_point(point: [i32; 2]) -> Self;
    }
    impl OfNode for Normal {
        #[inline]
        fn of_point(point: [i32; 2]) -> Self {
            normal_at::<POINT>(point)
        }
    }
    impl OfNode for q15::Normal {
        #[inline]
        fn of_point(point: [i32; 2]) -> Self {
            normal_q15_at::<POINT>(point)
        }
    }
}

/// The colors of one material under one light, by normal: 8.7 KB.
///
/// Fill it for each frame, which shades the nodes, and draw any number of pixels from it. A pixel to
/// RGB565 takes 60 instructions on a Cortex-M4F and 112 on a Cortex-M0. On the display, pictures
/// differ from those with every pixel shaded by CIEDE2000 0.36 in the median and by more than 1 in
/// one of five (`docs/palette.csv`): where a highlight is narrower than the 5.7 degrees between two
/// nodes, or an edge is black because the light rings.
///
/// ```
/// # #[cfg(all(feature = "baked", feature = "presets"))] {
/// use eigenshade::object::Disc;
/// use eigenshade::presets::{light::LOBBY, material::GOLD_METALLIC_PAINT};
/// use eigenshade::screen::{Display, Nodes, Palette, Tone};
/// use eigenshade::sphere;
///
/// static DISPLAY: Display = Display::new(Tone::Filmic);
/// let scene = sphere::color::scene(LOBBY, GOLD_METALLIC_PAINT)?;
/// let exposure = scene.exposure_by_factor(1.5)?;
/// let mut palette = Palette::default();
/// palette.fill(&Nodes::ALL, &DISPLAY, |normal| exposure.of(scene.shade(normal)));
///
/// let mut picture = [0_u16; 64 * 64];
/// for pixel in Disc::new(64)? {
///     pixel.put(&mut picture, palette.rgb565(pixel.code()))?;
/// }
/// # }
/// # Ok::<(), eigenshade::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Palette {
    /// Row by row from the bottom.
    nodes: [Node; SIDE * SIDE],
}

/// A palette in which every color is black.
impl Default for Palette {
    fn default() -> Self {
        Self::BLACK
    }
}

impl Palette {
    /// A palette in which every color is black.
    pub const BLACK: Self = Self { nodes: [[0; 2]; SIDE * SIDE] };

    /// Shades, exposes and encodes nodes. `exposed` gives the exposed irradiance of a normal, in
    /// floats or in integers. Nodes beyond the rim of a sphere have the colors of the rim. Other
    /// nodes keep their colors: fill the nodes of an object before you draw it.
    ///
    /// Cost: `exposed` and three calls of [`Display::encode`] for each node.
    pub fn fill<N: OfNode, L: Into<Linear>>(
        &mut self,
        nodes: &Nodes,
        display: &Display,
        mut exposed: impl FnMut(N) -> Rgb<L>,
    ) {
        let rows = self.nodes.as_chunks_mut::<SIDE>().0;
        for (row, (places, used)) in rows.iter_mut().zip(nodes.0).enumerate() {
            for (column, node) in places.iter_mut().enumerate() {
                if used >> column & 1 == 1 {
                    let color = exposed(N::of_point(point([column, row])));
                    *node = packed(color.map(|channel| display.encode(channel.into())));
                }
            }
        }
    }

    /// 64 times the color of a code: red and blue, and green.
    #[inline(always)]
    fn sums(&self, code: NormalCode) -> Node {
        let ([column, row], [across, up]) = code.cell();
        let cell = self.nodes.get(row * SIDE + column..).and_then(|nodes| nodes.first_chunk());
        let Some(&[a, b, .., c, d]) = cell.map(|cell: &[Node; SIDE + 2]| cell) else {
            return [0; 2];
        };
        // Modulo 2^32: differences may be negative.
        let between =
            |a: u32, b: u32, way: u32| (a << 3).wrapping_add(b.wrapping_sub(a).wrapping_mul(way));
        let rows =
            [(a, b), (c, d)].map(|([a, c], [b, d])| [between(a, b, across), between(c, d, across)]);
        let [[a, c], [b, d]] = rows;
        [between(a, b, up), between(c, d, up)]
    }

    /// A pixel of 5, 6 and 5 bits: red in the highest bits.
    #[inline]
    #[must_use]
    pub fn rgb565(&self, code: NormalCode) -> u16 {
        // Half a level.
        pixel565(self.sums(code), 1 << 10)
    }

    /// [`rgb565`](Self::rgb565) with ordered dithering, as
    /// [`Display::rgb565_dithered`](crate::screen::Display::rgb565_dithered).
    #[inline]
    #[must_use]
    pub fn rgb565_dithered(&self, code: NormalCode, x: usize, y: usize) -> u16 {
        pixel565(self.sums(code), (rank(x, y) << 7) + (1 << 6))
    }

    /// A pixel of 8 bits a channel.
    #[inline]
    #[must_use]
    pub fn rgb888(&self, code: NormalCode) -> Rgb<u8> {
        /// 255 of the largest sums, times 2^22.
        const SCALES: [u32; 2] = [(255 << 22) / (STEPS[0] << 6), (255 << 22) / (STEPS[1] << 6)];
        let [red_blue, green] = self.sums(code);
        let level = |sum: u32, scale: u32| ((sum * scale + (1 << 21)) >> 22) as u8;
        let [of_red_blue, of_green] = SCALES;
        Rgb {
            r: level(red_blue >> 16, of_red_blue),
            g: level(green, of_green),
            b: level(red_blue & 0xffff, of_red_blue),
        }
    }
}

/// Rows of pixels of 5, 6 and 5 bits.
impl Palette {
    /// Draws a row of an object over the pixels in `to`, the first of which is the first one of the
    /// row. Pixels that the object covers in part are mixed with what is there, and background
    /// stays. With `dithered`, pixels are as [`rgb565_dithered`](Self::rgb565_dithered) has them for
    /// this column and row.
    ///
    /// A row beyond the last one draws nothing, and pixels beyond the end of `to` are not drawn.
    /// Clear `to` for each row if nothing is below the object:
    ///
    /// ```
    /// # use eigenshade::Rgb;
    /// # use eigenshade::object::NormalMap;
    /// # use eigenshade::screen::{Display, Linear, Palette, Tone};
    /// # static DISPLAY: Display = Display::new(Tone::Filmic);
    /// # let mut codes = [NormalMap::BACKGROUND; 64 * 64];
    /// # NormalMap::sphere(64, &mut codes)?;
    /// # let map = NormalMap::new(64, 64, codes.as_flattened())?;
    /// # let mut palette = Palette::default();
    /// # let gray = |_: eigenshade::Normal| Rgb::gray(Linear(40_000));
    /// # palette.fill(&map.nodes(), &DISPLAY, gray);
    /// # let mut send = |row: &[u16; 64]| assert!(row[32] != 0);
    /// for y in 0..map.height() {
    ///     let mut row = [0; 64];
    ///     palette.draw_row565(&map, y, false, &mut row);
    ///     send(&row);
    /// }
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    pub fn draw_row565(&self, map: &NormalMap<'_>, row: usize, dithered: bool, to: &mut [u16]) {
        if dithered {
            let ranks = ranks(row);
            self.row565(map, row, to, |column| (ranks(column) << 7) + (1 << 6));
        } else {
            self.row565(map, row, to, |_| 1 << 10);
        }
    }

    // Apart, so that the loop has all registers.
    #[inline(never)]
    fn row565(
        &self,
        map: &NormalMap<'_>,
        row: usize,
        to: &mut [u16],
        threshold: impl Fn(usize) -> u32,
    ) {
        for (column, (pixel, &code)) in to.iter_mut().zip(map.codes(row)).enumerate() {
            if let Some(code) = NormalCode::of_pixel(code) {
                *pixel = pixel565(self.sums(code), threshold(column));
            } else if code != NormalMap::BACKGROUND {
                self.blend565(map, [column, row], code, threshold(column), pixel);
            }
        }
    }

    /// A pixel that the object may cover in part. Apart: there are few, and the loop needs the
    /// registers.
    #[cold]
    #[inline(never)]
    fn blend565(
        &self,
        map: &NormalMap<'_>,
        [column, row]: [usize; 2],
        code: [u8; 2],
        threshold: u32,
        pixel: &mut u16,
    ) {
        if let Some((code, coverage)) = map.edge(code, column, row) {
            *pixel = blend565(*pixel, pixel565(self.sums(code), threshold), coverage);
        }
    }
}

/// The levels of sums, each rounded down after adding a threshold: 2^11 of it are a level of red and
/// blue.
#[inline(always)]
fn pixel565([red_blue, green]: Node, threshold: u32) -> u16 {
    let red_blue = red_blue + (threshold << 16 | threshold);
    let green = green + (threshold >> 1);
    ((red_blue >> 16 & 0xf800) | (green >> 5 & 0x07e0) | (red_blue >> 11 & 0x1f)) as u16
}

/// An encoded color as a node.
fn packed(color: Rgb<u16>) -> Node {
    let [of_red_blue, of_green] = STEPS;
    let steps = |channel: u16, most: u32| (u32::from(channel) * most + (1 << 15)) >> 16;
    let Rgb { r, g, b } = color;
    [steps(r, of_red_blue) << 16 | steps(b, of_red_blue), steps(g, of_green)]
}

/// The point of a node in units of 2^-[`POINT`] of a code: its place, or the nearest one of the rim.
fn point(node: [usize; 2]) -> [i32; 2] {
    let point = node.map(|place| (8 * place as i32 - 128) << POINT);
    let [u, v] = point;
    let (square, rim) = ((u * u + v * v).cast_unsigned(), (RIM as i32) << POINT);
    if square <= (rim * rim).cast_unsigned() {
        return point;
    }
    // Above zero, which a compiler does not see.
    let distance = square.isqrt().cast_signed().max(1);
    point.map(|along| along * rim / distance)
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test may panic")]
mod tests {
    use super::*;
    use crate::screen::Tone;

    /// A smooth picture, without a table.
    fn exposed([x, y, z]: [f32; 3]) -> Rgb<f32> {
        Rgb::new(0.5 + 0.4 * x, z * z, (0.3 - 0.3 * y) * (1.0 - 0.5 * z))
    }

    fn filled(display: &Display) -> Palette {
        let mut palette = Palette::default();
        palette.fill(&Nodes::ALL, display, |normal: Normal| exposed(normal.components()));
        palette
    }

    fn codes() -> impl Iterator<Item = NormalCode> {
        (0..=u16::MAX).filter_map(|code| NormalCode::inside(code.to_le_bytes()))
    }

    #[test]
    fn colors_are_near_those_of_every_code() {
        let display = Display::new(Tone::Filmic);
        let palette = filled(&display);
        let (mut worst, mut count) = (0, 0);
        for code in codes() {
            let exact = display.rgb888(exposed(code.normal().components()));
            let found = palette.rgb888(code);
            for (exact, found) in <[_; 3]>::from(exact.zip(found)) {
                worst = worst.max(exact.abs_diff(found));
            }
            count += 1;
        }
        assert!(count > 50_000 && worst <= 5, "{worst} of {count}");
    }

    /// A color that does not change has the levels of the display, in all encodings.
    #[test]
    fn even_colors_are_those_of_the_display() {
        let display = Display::new(Tone::Linear);
        let mut palette = Palette::default();
        let (mut different, mut count) = (0, 0);
        for level in 0..=256_u32 {
            let color = Rgb::gray(Linear(level << 8));
            palette.fill(&Nodes::ALL, &display, |_: q15::Normal| color);
            for code in codes().step_by(77) {
                let found = palette.rgb888(code);
                let exact = display.rgb888(color);
                let off = <[_; 3]>::from(found.zip(exact)).map(|(a, b)| a.abs_diff(b));
                assert!(off.iter().all(|&off| off <= 1), "{found:?} {exact:?}");
                // Levels are those of the display but where an encoded value is nearly halfway.
                let levels = |pixel: u16| [pixel >> 11, pixel >> 5 & 63, pixel & 31];
                let near = |found: u16, exact: u16| {
                    let pairs = levels(found).into_iter().zip(levels(exact));
                    pairs.filter(|(found, exact)| found != exact).count()
                };
                different += near(palette.rgb565(code), display.rgb565(color));
                let mut sums = [0, 0];
                for (x, y) in (0..16).map(|place| (place % 4, place / 4)) {
                    let dithered = palette.rgb565_dithered(code, x, y);
                    different += near(dithered, display.rgb565_dithered(color, x, y));
                    sums[0] += levels(dithered)[1];
                    sums[1] += levels(display.rgb565_dithered(color, x, y))[1];
                }
                assert!(sums[0].abs_diff(sums[1]) <= 1, "{sums:?}");
                count += 3 * 17;
            }
        }
        assert!(different * 50 < count, "{different} of {count}");
        assert_eq!(palette.rgb565(NormalCode::of(Normal { x: 0.0, y: 0.0, z: 1.0 })), 0xffff);
        assert_eq!(
            palette.rgb888(NormalCode::of(Normal { x: 1.0, y: 0.0, z: 0.0 })),
            Rgb::gray(255)
        );
    }

    #[test]
    fn rows_are_the_pixels_of_the_map_over_what_is_there() {
        let display = Display::new(Tone::Linear);
        let palette = filled(&display);
        let mut codes = [NormalMap::BACKGROUND; 40 * 40];
        assert!(NormalMap::sphere(40, &mut codes).is_ok());
        let map = NormalMap::new(40, 40, codes.as_flattened()).unwrap();
        let (mut partial, below) = (0, 0x1234);
        for (y, dithered) in (0..41).flat_map(|y| [(y, false), (y, true)]) {
            let (mut found, mut expected) = ([below; 40], [below; 40]);
            palette.draw_row565(&map, y, dithered, &mut found);
            for pixel in map.row(y) {
                let (code, x) = (pixel.code(), pixel.column());
                let color = if dithered {
                    palette.rgb565_dithered(code, x, y)
                } else {
                    palette.rgb565(code)
                };
                partial += usize::from(pixel.coverage() < 255);
                if let Some(to) = expected.get_mut(x) {
                    *to = blend565(below, color, pixel.coverage());
                }
            }
            assert_eq!(found, expected);
        }
        assert!(partial > 100);
    }

    #[test]
    fn both_formats_have_the_same_nodes() {
        for (row, used) in Nodes::ALL.0.into_iter().enumerate() {
            for column in (0..SIDE).filter(|column| used >> column & 1 == 1) {
                let point = point([column, row]);
                let floats = normal_at::<POINT>(point).components();
                let integers = normal_q15_at::<POINT>(point).components();
                let square: f32 = floats.iter().map(|along| along * along).sum();
                assert!((square - 1.0).abs() < 1e-4, "{floats:?}");
                for (float, integer) in floats.into_iter().zip(integers) {
                    assert!((32_768.0 * float - f32::from(integer.0)).abs() < 3.0);
                }
            }
        }
    }
}
