//! The irradiances of a frame by normal, for objects whose pixels have colors of their own.

use crate::color::Rgb;
use crate::display::Linear;
use crate::grid::{AnyNormal, Grid};
use crate::nodes::{Nodes, SIDE};
use crate::normal_code::NormalCode;

/// Bits of a node's values after the binary point.
const POINT: u32 = 12;

/// The exposed irradiances of one material under one light, by normal, not yet encoded: 6.5 KB.
///
/// It is a [`Palette`](crate::screen::Palette) for textured objects: a pixel's irradiance is
/// multiplied by its own base color, then encoded. Base colors are linear: decode those of an sRGB
/// texture first. The product tints all of the irradiance, highlights too, which is right for matte
/// materials and for metals. Irradiances are in steps of 2^-12 of white, up to 16.
///
/// ```
/// # #[cfg(all(feature = "baked", feature = "presets"))] {
/// use eigenshade::object::Disc;
/// use eigenshade::presets::{light::LOBBY, material::PTFE_633NM};
/// use eigenshade::screen::{Display, LinearPalette, Nodes, Target, Tone};
/// use eigenshade::{Rgb, sphere};
///
/// static DISPLAY: Display = Display::new(Tone::Filmic);
/// let scene = sphere::color::scene(LOBBY, PTFE_633NM)?;
/// let exposure = scene.exposure_by_factor(1.5)?;
/// let mut palette = LinearPalette::default();
/// palette.fill(&Nodes::ALL, |normal| exposure.of(scene.shade(normal)));
///
/// // Stripes: base colors in units of 2^-16.
/// let colors = [Rgb::new(50_000, 9_000, 4_000), Rgb::gray(45_000)];
/// let mut picture = [0_u16; 64 * 64];
/// let mut target = Target::new(&mut picture, 64)?;
/// for pixel in Disc::new(64)? {
///     let base = colors[pixel.row() / 8 % 2];
///     let color = palette.color(pixel.code()).zip(base).map(|(light, base)| light.times(base));
///     pixel.put(&mut target, DISPLAY.rgb565(color));
/// }
/// # }
/// # Ok::<(), eigenshade::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct LinearPalette(Grid<[u16; 3]>);

/// A palette in which every irradiance is 0.
impl Default for LinearPalette {
    fn default() -> Self {
        Self::BLACK
    }
}

impl LinearPalette {
    /// A palette in which every irradiance is 0.
    pub const BLACK: Self = Self(Grid([[0; 3]; SIDE * SIDE]));

    /// Shades and exposes nodes, as [`Palette::fill`](crate::screen::Palette::fill).
    pub fn fill<N: AnyNormal, L: Into<Linear>>(
        &mut self,
        nodes: &Nodes,
        mut exposed: impl FnMut(N) -> Rgb<L>,
    ) {
        self.0.fill(nodes, |normal| packed(exposed(normal)));
    }

    /// [`fill`](Self::fill) of four nodes at a time, as
    /// [`Palette::fill_mirrored`](crate::screen::Palette::fill_mirrored).
    pub fn fill_mirrored<N: AnyNormal, L: Into<Linear>>(
        &mut self,
        nodes: &Nodes,
        mut exposed: impl FnMut(N) -> [Rgb<L>; 4],
    ) {
        self.0.fill_mirrored(nodes, |normal| exposed(normal).map(packed));
    }

    /// The irradiance of a code, interpolated between four nodes. Cost: 27 products and sums.
    #[inline]
    #[must_use]
    pub fn color(&self, code: NormalCode) -> Rgb<Linear> {
        let Some(([a, b, c, d], [across, up])) = self.0.around(code) else {
            return Rgb::gray(Linear(0));
        };
        let between = |a: u32, b: u32, way: u32| a * (8 - way) + b * way;
        let row = |a: [u16; 3], b: [u16; 3]| {
            Rgb::from(a).zip(Rgb::from(b)).map(|(a, b)| between(a.into(), b.into(), across))
        };
        // 64 times the irradiance.
        row(a, b).zip(row(c, d)).map(|(a, b)| Linear(between(a, b, up) >> (6 + POINT - 16)))
    }
}

/// An irradiance as a node.
fn packed<L: Into<Linear>>(color: Rgb<L>) -> [u16; 3] {
    <[L; 3]>::from(color).map(|channel| {
        let Linear(units) = channel.into();
        (units.saturating_add(8) >> (16 - POINT)).min(u16::MAX.into()) as u16
    })
}
