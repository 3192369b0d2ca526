//! The irradiances of a frame by normal, for pixels with base colors of their own.

use crate::color::Rgb;
use crate::display::Linear;
use crate::grid::{AnyNormal, Grid};
use crate::nodes::{Nodes, SIDE};
use crate::normal_code::NormalCode;

/// Bits of a node's values after the binary point.
const POINT: u32 = 12;

/// The exposed irradiances of one region of an [`Object`](crate::object::Object) under one light, by
/// normal, not yet encoded: 13 KB.
///
/// It is a [`Palette`](crate::screen::Palette) for pixels with base colors of their own. A pixel's
/// irradiance is E = base color x T(n) + P(n): the part that the base color tints, and the plain part
/// that it does not, such as the white highlights of plastic. [`Region`](crate::object::Region) has
/// the materials of both parts. Irradiances are in steps of 2^-12 of white, up to 16.
///
/// ```
/// # #[cfg(all(feature = "baked", feature = "presets"))] {
/// use eigenshade::object::{Disc, Region};
/// use eigenshade::presets::light::LOBBY;
/// use eigenshade::screen::{Display, LinearPalette, Nodes, Target, Tone};
/// use eigenshade::{Material, Rgb, sphere};
///
/// static DISPLAY: Display = Display::new(Tone::Filmic);
/// // Plastic of roughness 0.3.
/// let [tinted, plain] = Region::new(0.0, 0.3)?.materials()?;
/// let tinted = sphere::color::scene(LOBBY, Material::new(&tinted)?)?;
/// let plain = sphere::color::scene(LOBBY, Material::new(&plain)?)?;
/// let exposure = tinted.exposure_by_factor(1.5)?;
/// let mut palette = LinearPalette::default();
/// palette.fill(&Nodes::ALL, |normal| {
///     [&tinted, &plain].map(|scene| exposure.of(scene.shade(normal)))
/// });
///
/// // Stripes: linear base colors in units of 2^-16.
/// let colors = [Rgb::new(50_000, 9_000, 4_000), Rgb::gray(45_000)];
/// let mut picture = [0_u16; 64 * 64];
/// let mut target = Target::new(&mut picture, 64)?;
/// for pixel in Disc::new(64)? {
///     let base = colors[pixel.row() / 8 % 2];
///     pixel.put(&mut target, DISPLAY.rgb565(palette.color(pixel.code(), base)));
/// }
/// # }
/// # Ok::<(), eigenshade::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct LinearPalette(Grid<Node>);

/// The irradiances of a normal: the tinted part, then the plain one.
type Node = [[u16; 3]; 2];

/// A palette in which every irradiance is 0.
impl Default for LinearPalette {
    fn default() -> Self {
        Self::BLACK
    }
}

impl LinearPalette {
    /// A palette in which every irradiance is 0.
    pub const BLACK: Self = Self(Grid([[[0; 3]; 2]; SIDE * SIDE]));

    /// Shades and exposes nodes, as [`Palette::fill`](crate::screen::Palette::fill): `exposed` gives
    /// the tinted part and the plain one.
    pub fn fill<N: AnyNormal, L: Into<Linear>>(
        &mut self,
        nodes: &Nodes,
        mut exposed: impl FnMut(N) -> [Rgb<L>; 2],
    ) {
        self.0.fill(nodes, |normal| exposed(normal).map(packed));
    }

    /// [`fill`](Self::fill) of four nodes at a time, as
    /// [`Palette::fill_mirrored`](crate::screen::Palette::fill_mirrored): `exposed` gives the four
    /// irradiances of the tinted part, then those of the plain one.
    pub fn fill_mirrored<N: AnyNormal, L: Into<Linear>>(
        &mut self,
        nodes: &Nodes,
        mut exposed: impl FnMut(N) -> [[Rgb<L>; 4]; 2],
    ) {
        self.0.fill_mirrored(nodes, |normal| {
            let [[a, b, c, d], [e, f, g, h]] = exposed(normal);
            [[a, e], [b, f], [c, g], [d, h]].map(|parts| parts.map(packed))
        });
    }

    /// The irradiance of a code for a linear base color in units of 2^-16.
    #[inline(always)]
    #[must_use]
    pub fn color(&self, code: NormalCode, base: Rgb<u16>) -> Rgb<Linear> {
        let Some(([a, b, c, d], [across, up])) = self.0.around(code) else {
            return Rgb::gray(Linear(0));
        };
        let between = |a: u32, b: u32, way: u32| (a << 3) + b * way - a * way;
        // 64 times a part's irradiance.
        let part = |[a, b, c, d]: [[u16; 3]; 4]| {
            let row = |a: [u16; 3], b: [u16; 3]| {
                Rgb::from(a).zip(b.into()).map(|(a, b)| between(a.into(), b.into(), across))
            };
            row(a, b).zip(row(c, d)).map(|(a, b)| between(a, b, up))
        };
        let tinted = part([a, b, c, d].map(|[tinted, _]| tinted));
        let plain = part([a, b, c, d].map(|[_, plain]| plain));
        tinted_color(tinted, plain, base)
    }
}

/// The irradiance of a linear base color in units of 2^-16, from 64 times those of the parts.
#[inline(always)]
pub(crate) fn tinted_color(tinted: Rgb<u32>, plain: Rgb<u32>, base: Rgb<u16>) -> Rgb<Linear> {
    tinted.zip(plain).zip(base).map(|((tinted, plain), base)| {
        Linear((((tinted >> 6) * u32::from(base)) >> POINT) + (plain >> (6 + POINT - 16)))
    })
}

/// An irradiance in units of 2^-12 of white.
pub(crate) fn packed<L: Into<Linear>>(color: Rgb<L>) -> [u16; 3] {
    <[L; 3]>::from(color).map(|channel| {
        let Linear(units) = channel.into();
        (units.saturating_add(8) >> (16 - POINT)).min(u16::MAX.into()) as u16
    })
}
