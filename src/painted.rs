//! Draws textured objects from the palettes of a frame.

use crate::color::Rgb;
use crate::display::{Display, Linear, NEAREST, ranks, threshold};
use crate::error::{Argument, Error};
use crate::linear_palette::LinearPalette;
use crate::packed_object::{Object, Run, linear, pixel};
use crate::pixel::Pixel;
use crate::target::Target;
use core::borrow::Borrow;

/// An [`Object`] in the colors of a frame.
///
/// ```
/// # let bytes = [
/// #     b"eigob\x01\x02\0\x01\0\x01\0".as_slice(), &[0, 0, 0, 0x40, 0, 0x7b],
/// #     &[0, 0, 0, 0, 2, 0, 0, 0], &[1, 0, 1, 0, 0, 0], &[0, 0, 200, 90, 10, 255],
/// # ].concat();
/// # let bytes = bytes.as_slice();
/// # #[cfg(all(feature = "baked", feature = "presets"))] {
/// use eigenshade::object::Object;
/// use eigenshade::presets::light::LOBBY;
/// use eigenshade::screen::{Display, LinearPalette, Target, Tone};
/// use eigenshade::{Material, Rotation, sphere};
///
/// static DISPLAY: Display = Display::new(Tone::Filmic);
/// // A file of `eigenshade pack-object` with one region.
/// let object = Object::new(bytes)?;
/// let region = object.regions().next().expect("it has one");
/// let nodes = object.nodes(0);
/// let [tinted, plain] = region.materials()?;
/// let tinted = sphere::transfer(&Material::new(&tinted)?)?;
/// let plain = sphere::transfer(&Material::new(&plain)?)?;
/// let mut palette = LinearPalette::default();
///
/// // Every frame:
/// let light = LOBBY.turned::<100>(&Rotation::from_euler(0.1, 0.0, 0.0)?)?;
/// let tinted = sphere::color::relight(&tinted, light.lights()?)?;
/// let plain = sphere::color::relight(&plain, light.lights()?)?;
/// let exposure = tinted.exposure_by_factor(1.5)?; // once, if it shall not follow the light
/// palette.fill_mirrored(&nodes, |normal| {
///     [&tinted, &plain].map(|part| part.shade_mirrored(normal).map(|color| exposure.of(color)))
/// });
/// let mut screen = [0_u16; 20 * 10];
/// let painted = object.painted(core::slice::from_ref(&palette), &DISPLAY)?;
/// painted.draw(&mut Target::new(&mut screen, 20)?);
/// assert!(screen[1] != 0);
/// # }
/// # Ok::<(), eigenshade::Error>(())
/// ```
#[derive(Debug)]
pub struct Painted<'a, L = LinearPalette> {
    object: Object<'a>,
    palettes: &'a [L],
    display: &'a Display,
    is_dithered: bool,
}

impl<L> Copy for Painted<'_, L> {}

impl<L> Clone for Painted<'_, L> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<'a> Object<'a> {
    /// The object in the colors of these palettes or references to them, one for each region.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] if there are fewer palettes than regions.
    pub fn painted<L: Borrow<LinearPalette>>(
        &self,
        palettes: &'a [L],
        display: &'a Display,
    ) -> Result<Painted<'a, L>, Error> {
        let (argument, expected, found) =
            (Argument::Palettes, self.regions().len(), palettes.len());
        if found < expected {
            return Err(Error::Length { argument, expected, found });
        }
        Ok(Painted { object: *self, palettes, display, is_dithered: false })
    }
}

impl<L: Borrow<LinearPalette>> Painted<'_, L> {
    /// The same colors with ordered dithering of RGB565, as
    /// [`Display::rgb565_dithered`](crate::screen::Display::rgb565_dithered).
    #[must_use]
    pub const fn dithered(self) -> Self {
        Self { is_dithered: true, ..self }
    }

    /// Draws the rows of the object that the target has.
    pub fn draw<P: Pixel>(&self, target: &mut Target<'_, P>) {
        for row in target.rows(self.object.height()) {
            let (first, pixels) = target.row(row);
            for run in self.object.runs(row) {
                if self.is_dithered {
                    let ranks = ranks(row);
                    self.run(&run, first, pixels, |column| threshold(ranks(column)));
                } else {
                    self.run(&run, first, pixels, |_| NEAREST);
                }
            }
        }
    }

    /// Draws the part of a run that a row of pixels has, which begins at a column of the object.
    fn run<P: Pixel>(
        &self,
        run: &Run<'_>,
        first: usize,
        pixels: &mut [P],
        threshold: impl Fn(usize) -> u32,
    ) {
        let Some(palette) = self.palettes.get(run.region) else { return };
        let start = run.column.max(first);
        let records = run.pixels.get(start - run.column..).unwrap_or_default();
        let pixels = pixels.get_mut(start - first..).unwrap_or_default();
        draw(palette.borrow(), self.display, records, pixels, |index| threshold(start + index));
    }
}

// Apart, so that the loop has all registers.
#[inline(never)]
fn draw<P: Pixel>(
    palette: &LinearPalette,
    display: &Display,
    records: &[[u8; 6]],
    pixels: &mut [P],
    threshold: impl Fn(usize) -> u32,
) {
    for (index, (to, &record)) in pixels.iter_mut().zip(records).enumerate() {
        if let Some((code, base, coverage)) = pixel(record) {
            put(to, palette.color(code, linear(base)), coverage, display, threshold(index));
        }
    }
}

/// Draws over a pixel, which the color covers by `coverage` / 255.
#[inline(always)]
pub(crate) fn put<P: Pixel>(
    to: &mut P,
    color: Rgb<Linear>,
    coverage: u8,
    display: &Display,
    threshold: u32,
) {
    let color = P::of_display(color.map(|channel| display.encode(channel)), threshold);
    *to = if coverage == u8::MAX { color } else { color.over(*to, coverage) };
}
