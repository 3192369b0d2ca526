//! The colors of a frame by normal: nodes are shaded, exposed and encoded once, and a pixel is
//! interpolated between four of them.
//!
//! Display values are interpolated, not irradiances: a tone curve and an encoding make an irradiance
//! much less smooth.

use crate::color::Rgb;
use crate::display::{Display, Linear, rank, ranks};
use crate::encoded::{Encoded, NEAREST};
use crate::grid::{AnyNormal, Grid};
use crate::nodes::{Nodes, SIDE};
use crate::normal_code::NormalCode;
use crate::normal_map::NormalMap;
use crate::pixel::Pixel;
use crate::target::Target;

/// The colors of one material under one light, by normal: 8.7 KB.
///
/// Fill it for each frame, which shades the nodes, and draw any number of pixels from it: a pixel takes
/// six interpolations in integers. On the display, pictures differ from those with every pixel shaded
/// by CIEDE2000 0.37 in the median, and by more than 1 in one of five: where a highlight is narrower
/// than the 5.7 degrees between two nodes, or an edge is black because the light rings.
///
/// ```
/// # #[cfg(all(feature = "baked", feature = "presets"))] {
/// use eigenshade::object::Disc;
/// use eigenshade::presets::{light::LOBBY, material::GOLD_METALLIC_PAINT};
/// use eigenshade::screen::{Display, Nodes, Palette, Target, Tone};
/// use eigenshade::sphere;
///
/// static DISPLAY: Display = Display::new(Tone::Filmic);
/// let scene = sphere::color::scene(LOBBY, GOLD_METALLIC_PAINT)?;
/// let exposure = scene.exposure_by_factor(1.5)?;
/// let mut palette = Palette::default();
/// palette.fill(&Nodes::ALL, &DISPLAY, |normal| exposure.of(scene.shade(normal)));
///
/// let mut picture = [0_u16; 64 * 64];
/// let mut target = Target::new(&mut picture, 64)?;
/// for pixel in Disc::new(64)? {
///     pixel.put(&mut target, palette.rgb565(pixel.code()));
/// }
/// # }
/// # Ok::<(), eigenshade::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Palette(Grid<Encoded>);

/// A palette in which every color is black.
impl Default for Palette {
    fn default() -> Self {
        Self::BLACK
    }
}

impl Palette {
    /// A palette in which every color is black.
    pub const BLACK: Self = Self(Grid([Encoded::BLACK; SIDE * SIDE]));

    /// Shades, exposes and encodes nodes. `exposed` gives the exposed irradiance of a normal, in
    /// floats or in integers. Nodes beyond the rim of a sphere have the colors of the rim. Other
    /// nodes keep their colors: fill the nodes of an object before you draw it.
    ///
    /// Cost: `exposed` and three calls of [`Display::encode`] for each node.
    pub fn fill<N: AnyNormal, L: Into<Linear>>(
        &mut self,
        nodes: &Nodes,
        display: &Display,
        mut exposed: impl FnMut(N) -> Rgb<L>,
    ) {
        self.0.fill(nodes, |normal| {
            Encoded::of(exposed(normal).map(|channel| display.encode(channel.into())))
        });
    }

    /// [`fill`](Self::fill) of four nodes at a time, which are shaded for little more than one.
    /// `exposed` gives the exposed irradiances of [`Normal::mirrored`](crate::Normal::mirrored). Nodes
    /// that mirror one of `nodes` are set as well, so an object that faces one side may be filled
    /// faster by `fill`.
    ///
    /// ```
    /// # #[cfg(all(feature = "baked", feature = "presets"))] {
    /// # use eigenshade::presets::{light::LOBBY, material::GOLD_METALLIC_PAINT};
    /// # use eigenshade::screen::{Display, Nodes, Palette, Tone};
    /// # use eigenshade::sphere;
    /// # static DISPLAY: Display = Display::new(Tone::Filmic);
    /// # let scene = sphere::color::scene(LOBBY, GOLD_METALLIC_PAINT)?;
    /// # let exposure = scene.exposure_by_factor(1.5)?;
    /// # let mut palette = Palette::default();
    /// palette.fill_mirrored(&Nodes::ALL, &DISPLAY, |normal| {
    ///     scene.shade_mirrored(normal).map(|color| exposure.of(color))
    /// });
    ///
    /// // With the highlights of sources.
    /// # use eigenshade::presets::{gloss, sources};
    /// # use eigenshade::Highlights;
    /// # let highlights = Highlights::<2>::new(&gloss::GOLD_METALLIC_PAINT, &sources::LOBBY[..2])?;
    /// palette.fill_mirrored(&Nodes::ALL, &DISPLAY, |normal| {
    ///     let mut colors = scene.shade_mirrored(normal);
    ///     for (color, normal) in colors.iter_mut().zip(normal.mirrored()) {
    ///         *color = exposure.of(*color + highlights.shade(normal));
    ///     }
    ///     colors
    /// });
    /// # }
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    pub fn fill_mirrored<N: AnyNormal, L: Into<Linear>>(
        &mut self,
        nodes: &Nodes,
        display: &Display,
        mut exposed: impl FnMut(N) -> [Rgb<L>; 4],
    ) {
        self.0.fill_mirrored(nodes, |normal| {
            exposed(normal)
                .map(|color| Encoded::of(color.map(|channel| display.encode(channel.into()))))
        });
    }

    /// 64 times the color of a code.
    #[inline(always)]
    fn sums(&self, code: NormalCode) -> Encoded {
        let Some(([a, b, c, d], [across, up])) = self.0.around(code) else {
            return Encoded::BLACK;
        };
        // Modulo 2^32: differences may be negative.
        let between =
            |a: u32, b: u32, way: u32| (a << 3).wrapping_add(b.wrapping_sub(a).wrapping_mul(way));
        let rows = [(a, b), (c, d)].map(|(Encoded([a, c]), Encoded([b, d]))| {
            [between(a, b, across), between(c, d, across)]
        });
        let [[a, c], [b, d]] = rows;
        Encoded([between(a, b, up), between(c, d, up)])
    }

    /// A pixel of 5, 6 and 5 bits: red in the highest bits.
    #[inline]
    #[must_use]
    pub fn rgb565(&self, code: NormalCode) -> u16 {
        self.sums(code).rgb565(NEAREST)
    }

    /// The same colors with ordered dithering of RGB565.
    #[inline]
    #[must_use]
    pub const fn dithered(&self) -> Dithered<'_> {
        Dithered(self)
    }

    /// A pixel of 8 bits a channel.
    #[inline]
    #[must_use]
    pub fn rgb888(&self, code: NormalCode) -> Rgb<u8> {
        self.sums(code).rgb888()
    }
}

/// Whole objects.
impl Palette {
    /// Draws the rows of an object that the target has.
    ///
    /// ```
    /// # use eigenshade::Rgb;
    /// # use eigenshade::object::NormalMap;
    /// # use eigenshade::screen::{Display, Linear, Palette, Target, Tone};
    /// # static DISPLAY: Display = Display::new(Tone::Filmic);
    /// # let mut codes = [NormalMap::BACKGROUND; 64 * 64];
    /// # NormalMap::sphere(64, &mut codes)?;
    /// # let map = NormalMap::new(64, 64, codes.as_flattened())?;
    /// # let mut palette = Palette::default();
    /// # let gray = |_: eigenshade::Normal| Rgb::gray(Linear(40_000));
    /// # palette.fill(&map.nodes(), &DISPLAY, gray);
    /// # let mut send = |bytes: &[u8]| assert!(bytes.len() == 128 && bytes[64] != 0);
    /// // Row by row, in the byte order of a display on SPI.
    /// for row in 0..64 {
    ///     let mut pixels = [[0_u8; 2]; 64];
    ///     palette.draw(&map, &mut Target::new(&mut pixels, 64)?.at(0, -row));
    ///     send(pixels.as_flattened());
    /// }
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    pub fn draw<P: Pixel>(&self, map: &NormalMap<'_>, target: &mut Target<'_, P>) {
        for row in target.rows(map.height()) {
            self.row(map, row, target, |_| NEAREST);
        }
    }

    fn row<P: Pixel>(
        &self,
        map: &NormalMap<'_>,
        row: usize,
        target: &mut Target<'_, P>,
        threshold: impl Fn(usize) -> u32,
    ) {
        let (mut column, mut pixels) = target.row(row);
        let mut codes = map.codes(row).get(column..).unwrap_or_default();
        loop {
            let count = self.run(codes, pixels, |index| threshold(column + index));
            let rest = codes.get(count..).and_then(|codes| codes.split_first());
            let (Some((&code, codes_after)), Some((pixel, pixels_after))) =
                (rest, pixels.get_mut(count..).and_then(|pixels| pixels.split_first_mut()))
            else {
                return;
            };
            column += count;
            if let Some((code, coverage)) = map.edge(code, column, row) {
                *pixel = P::of(self.sums(code), threshold(column)).over(*pixel, coverage);
            }
            (column, codes, pixels) = (column + 1, codes_after, pixels_after);
        }
    }

    /// Draws pixels up to the first one that the object may cover in part. Returns their number.
    // Apart, so that the loop has all registers.
    #[inline(never)]
    fn run<P: Pixel>(
        &self,
        codes: &[[u8; 2]],
        pixels: &mut [P],
        threshold: impl Fn(usize) -> u32,
    ) -> usize {
        let mut count = 0;
        for (pixel, &code) in pixels.iter_mut().zip(codes) {
            if let Some(code) = NormalCode::inside(code) {
                *pixel = P::of(self.sums(code), threshold(count));
            } else if code != NormalMap::BACKGROUND {
                break;
            }
            count += 1;
        }
        count
    }
}

/// A [`Palette`] with ordered dithering of RGB565, by the column and the row in an object: bands of
/// similar colors do not show edges. It changes nothing with 8 bits a channel.
#[derive(Clone, Copy, Debug)]
pub struct Dithered<'p>(&'p Palette);

impl Dithered<'_> {
    /// A pixel of 5, 6 and 5 bits at this column and row, as
    /// [`Display::rgb565_dithered`](crate::screen::Display::rgb565_dithered).
    #[inline]
    #[must_use]
    pub fn rgb565(self, code: NormalCode, x: usize, y: usize) -> u16 {
        self.0.sums(code).rgb565(threshold(rank(x, y)))
    }

    /// A pixel of 8 bits a channel, as [`Palette::rgb888`].
    #[inline]
    #[must_use]
    pub fn rgb888(self, code: NormalCode) -> Rgb<u8> {
        self.0.rgb888(code)
    }

    /// [`Palette::draw`].
    pub fn draw<P: Pixel>(self, map: &NormalMap<'_>, target: &mut Target<'_, P>) {
        for row in target.rows(map.height()) {
            let ranks = ranks(row);
            self.0.row(map, row, target, |column| threshold(ranks(column)));
        }
    }
}

/// The threshold of a rank in the matrix of the display.
#[inline(always)]
fn threshold(rank: u32) -> u32 {
    (rank << 7) + (1 << 6)
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test may panic")]
mod tests {
    use super::*;
    use crate::blend::blend565;
    use crate::normal::Normal;
    use crate::q15;
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
                    let dithered = palette.dithered().rgb565(code, x, y);
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
            let mut target = Target::new(&mut found, 40).unwrap();
            let mut target = target.at(0, -(y as i32));
            if dithered {
                palette.dithered().draw(&map, &mut target);
            } else {
                palette.draw(&map, &mut target);
            }
            for pixel in map.row(y) {
                let (code, x) = (pixel.code(), pixel.column());
                let color = if dithered {
                    palette.dithered().rgb565(code, x, y)
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
}
