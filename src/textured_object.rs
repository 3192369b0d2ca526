//! Objects with shadows whose pixels have base colors.

use crate::color::Rgb;
use crate::display::{Display, Exposure, NEAREST};
use crate::error::{Argument, Error};
use crate::index::shadowed::TINTED_WORDS;
use crate::light::Light;
use crate::linear_palette::{packed, tinted_color};
use crate::object_coefficients::ObjectCoefficients;
use crate::packed_object::linear;
use crate::painted::put;
use crate::pixel::Pixel;
use crate::q15;
use crate::shadowed::ShadowedObject;
use crate::target::Target;

/// A [`ShadowedObject`] in its own materials: its pixels have base colors.
///
/// `eigenshade pack-object --shadows` makes one of a file with materials. The irradiance of a pixel is
/// base color x T + P, where the tinted part T and the plain part P are colors of two codes. A frame takes
/// the coefficients d and the colors of the codes as for a [`ShadowedObject`]; then each pixel takes two
/// look-ups, three products and the encoding of its color.
///
/// ```no_run
/// # static FILE: [u8; 6] = *b"eigsh\x03";
/// use eigenshade::object::TexturedObject;
/// use eigenshade::screen::{Display, Exposure, Target, Tone};
/// use eigenshade::{Light, Rgb};
///
/// static DISPLAY: Display = Display::new(Tone::Filmic);
/// let watch = TexturedObject::new(&FILE)?;
/// let light = [[1.0, 0.2, 0.5, -0.1], [0.9, 0.2, 0.5, -0.1], [0.8, 0.2, 0.5, -0.1]];
/// let light = Rgb::from(light.each_ref()).try_map(|channel| Light::new(channel))?;
/// let mut colors = [[0_u16; 3]; 4096]; // as many as it has codes
/// let mut screen = [0_u16; 96 * 96];
///
/// // Every frame:
/// let d = watch.coefficients(light)?;
/// watch.colors(&d, Exposure::new(0.5)?, &mut colors)?;
/// watch.draw(&colors, &DISPLAY, &mut Target::new(&mut screen, 96)?);
/// # Ok::<(), eigenshade::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TexturedObject<'a>(ShadowedObject<'a>);

impl<'a> TexturedObject<'a> {
    /// The object of a file that `eigenshade pack-object --shadows` wrote of a file with materials. Bytes
    /// after it are ignored.
    ///
    /// Cost: some instructions for each row of pixels, each run and each cluster.
    ///
    /// # Errors
    ///
    /// [`Error::Object`] if the bytes are something else, such as a [`ShadowedObject`], were cut or
    /// changed.
    pub const fn new(bytes: &'a [u8]) -> Result<Self, Error> {
        match ShadowedObject::read(bytes) {
            Some((object, true)) => Ok(Self(object)),
            _ => Err(Error::Object),
        }
    }

    /// Pixels across.
    #[must_use]
    pub const fn width(&self) -> usize {
        self.0.width()
    }

    /// Pixels down.
    #[must_use]
    pub const fn height(&self) -> usize {
        self.0.height()
    }

    /// The number of codes: as many colors a frame has.
    #[must_use]
    pub const fn codes(&self) -> usize {
        self.0.codes()
    }

    /// The degree of the light that it takes. Lights of a lower degree fit as well.
    #[must_use]
    pub const fn degree(&self) -> usize {
        self.0.degree()
    }

    /// d of a light, as [`ShadowedObject::coefficients`].
    ///
    /// # Errors
    ///
    /// [`Error::Beyond`] if the light has a higher degree.
    pub fn coefficients(&self, light: Rgb<Light<'_>>) -> Result<Rgb<ObjectCoefficients>, Error> {
        self.0.coefficients(light)
    }

    /// [`coefficients`](Self::coefficients) in integers.
    ///
    /// # Errors
    ///
    /// [`Error::Beyond`] if the light has a higher degree.
    pub fn coefficients_q15(
        &self,
        light: Rgb<q15::Light<'_>>,
    ) -> Result<Rgb<ObjectCoefficients>, Error> {
        self.0.coefficients_q15(light)
    }

    /// The colors of all codes, exposed but not encoded: red, green and blue in units of 2^-12 of white,
    /// up to 16, rounded.
    ///
    /// Cost: as [`ShadowedObject::shade`].
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless there are as many colors as codes.
    pub fn colors(
        &self,
        d: &Rgb<ObjectCoefficients>,
        exposure: Exposure,
        colors: &mut [[u16; 3]],
    ) -> Result<(), Error> {
        Error::check(Argument::Colors, self.codes(), colors.len())?;
        let mut colors = colors.iter_mut();
        self.0.shade(d, exposure, |color| {
            if let Some(to) = colors.next() {
                *to = packed(color);
            }
        });
        Ok(())
    }

    /// Draws the rows of the object that the target has, in the colors of its codes. A pixel of a code
    /// without a color is not drawn.
    pub fn draw<P: Pixel>(
        &self,
        colors: &[[u16; 3]],
        display: &Display,
        target: &mut Target<'_, P>,
    ) {
        for row in target.rows(self.height()) {
            let (first, pixels) = target.row(row);
            let mut words = self.0.words.get(row).unwrap_or_default();
            while let [start, count, rest @ ..] = words {
                let [start, count] =
                    [*start, *count].map(|one| usize::from(u16::from_le_bytes(one)));
                let (run, after) = rest.split_at_checked(TINTED_WORDS * count).unwrap_or_default();
                words = after;
                let skipped = first.saturating_sub(start);
                let to = pixels.get_mut((start + skipped).saturating_sub(first)..);
                let run = run.as_chunks().0.get(skipped..).unwrap_or_default();
                tinted(colors, display, run, to.unwrap_or_default());
            }
        }
    }
}

// Apart, so that the loop has all registers.
#[inline(never)]
fn tinted<P: Pixel>(
    colors: &[[u16; 3]],
    display: &Display,
    run: &[[[u8; 2]; TINTED_WORDS]],
    pixels: &mut [P],
) {
    for (pixel, [t, p, [r, g], [b, coverage]]) in pixels.iter_mut().zip(run) {
        let color = |code: &[u8; 2]| colors.get(usize::from(u16::from_le_bytes(*code)));
        if let (Some(&t), Some(&p)) = (color(t), color(p)) {
            let [t, p] =
                [t, p].map(|color| Rgb::from(color).map(|channel| u32::from(channel) << 6));
            put(pixel, tinted_color(t, p, linear([*r, *g, *b])), *coverage, display, NEAREST);
        }
    }
}
