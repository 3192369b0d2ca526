//! From normals to the colors of a display.

use eigenshade::object::{DiscPixel, NormalCode, NormalPixel};
use eigenshade::screen::{Display, Dithered, Exposure, Linear, Palette, Pixel, blend565};
use eigenshade::{Normal, Rgb, q15};
use embedded_graphics_core::pixelcolor::raw::{RawData as _, RawU16};
use embedded_graphics_core::pixelcolor::{
    Bgr565, Bgr888, PixelColor, Rgb565, Rgb888, RgbColor as _,
};

/// A pixel of an object.
pub trait Place: Copy {
    /// The column in the object, from 0 at the left.
    fn column(self) -> usize;
    /// The row in the object, from 0 at the top.
    fn row(self) -> usize;
    /// The share of the pixel that the object covers, of 255.
    fn coverage(self) -> u8;
    /// The normal.
    fn normal(self) -> Normal;
    /// The normal in integers.
    fn normal_q15(self) -> q15::Normal;
    /// The code of the normal.
    fn code(self) -> NormalCode;
}

/// Types of pixels as places, each with its coverage.
macro_rules! places {
    ($($pixel:ty, $coverage:expr;)*) => {
        $(
            impl Place for $pixel {
                #[inline]
                fn column(self) -> usize {
                    self.column()
                }
                #[inline]
                fn row(self) -> usize {
                    self.row()
                }
                #[inline]
                fn coverage(self) -> u8 {
                    let coverage: fn(Self) -> u8 = $coverage;
                    coverage(self)
                }
                #[inline]
                fn normal(self) -> Normal {
                    self.normal()
                }
                #[inline]
                fn normal_q15(self) -> q15::Normal {
                    self.normal_q15()
                }
                #[inline]
                fn code(self) -> NormalCode {
                    self.code()
                }
            }
        )*
    };
}
pub(crate) use places;
places! {
    DiscPixel, DiscPixel::coverage;
    NormalPixel, NormalPixel::coverage;
}

/// A source of the colors of an object's pixels: a [`Palette`], which is filled once for many pixels,
/// or a [`Paint`], which shades each of them.
pub trait Shader {
    /// The color of a pixel.
    fn color<C: DisplayColor>(&self, place: impl Place) -> C;
}

impl Shader for Palette {
    #[inline]
    fn color<C: DisplayColor>(&self, place: impl Place) -> C {
        C::of_palette(self, place.code())
    }
}

impl Shader for Dithered<'_> {
    #[inline]
    fn color<C: DisplayColor>(&self, place: impl Place) -> C {
        C::of_dithered(*self, place.code(), [place.column(), place.row()])
    }
}

/// A material under a light, exposed for a display: it shades every pixel exactly.
///
/// `F` is a function of a normal, usually `|normal| scene.shade(normal)`; `E` is the exposure.
#[derive(Clone, Copy, Debug)]
pub struct Paint<'d, F, E> {
    shade: F,
    exposure: E,
    display: &'d Display,
    is_dithered: bool,
}

impl<'d, F: Fn(Normal) -> Rgb<f32>> Paint<'d, F, Exposure> {
    /// Paint of which `shade` gives the irradiance.
    pub const fn new(shade: F, exposure: Exposure, display: &'d Display) -> Self {
        Self { shade, exposure, display, is_dithered: false }
    }
}

impl<'d, F: Fn(q15::Normal) -> Rgb<i32>> Paint<'d, F, Rgb<q15::Exposure>> {
    /// Paint in integers: `shade` gives mantissas, and `exposure` comes from the same scene.
    pub const fn q15(shade: F, exposure: Rgb<q15::Exposure>, display: &'d Display) -> Self {
        Self { shade, exposure, display, is_dithered: false }
    }
}

impl<F, E> Paint<'_, F, E> {
    /// This paint with ordered dithering on displays of 16 bits a pixel.
    #[must_use]
    pub fn dithered(self) -> Self {
        Self { is_dithered: true, ..self }
    }

    #[inline]
    fn encoded<C: DisplayColor>(&self, exposed: Rgb<Linear>, place: impl Place) -> C {
        let dither = self.is_dithered.then(|| [place.column(), place.row()]);
        C::encoded(self.display, exposed, dither)
    }
}

impl<F: Fn(Normal) -> Rgb<f32>> Shader for Paint<'_, F, Exposure> {
    #[inline]
    fn color<C: DisplayColor>(&self, place: impl Place) -> C {
        let exposed = self.exposure.of((self.shade)(place.normal()));
        self.encoded(exposed.map(Linear::from), place)
    }
}

impl<F: Fn(q15::Normal) -> Rgb<i32>> Shader for Paint<'_, F, Rgb<q15::Exposure>> {
    #[inline]
    fn color<C: DisplayColor>(&self, place: impl Place) -> C {
        self.encoded(self.exposure.of((self.shade)(place.normal_q15())), place)
    }
}

/// The color of a display that a [`Display`] encodes.
pub trait DisplayColor: PixelColor {
    /// The color in memory.
    type Pixel: Pixel;
    /// The color as it is in memory.
    fn pixel(self) -> Self::Pixel;
    /// The color of a pixel in memory.
    fn of_pixel(pixel: Self::Pixel) -> Self;
    /// The color of an exposed irradiance; with `dither`, for the pixel at this column and row.
    fn encoded(display: &Display, color: Rgb<Linear>, dither: Option<[usize; 2]>) -> Self;
    /// The color of a code in a palette.
    fn of_palette(palette: &Palette, code: NormalCode) -> Self;
    /// The color of a code in a dithered palette, for the pixel at this column and row.
    fn of_dithered(palette: Dithered<'_>, code: NormalCode, place: [usize; 2]) -> Self;
    /// This color where it covers `coverage` / 255 of a pixel, and `below` in the rest of it.
    #[must_use]
    fn over(self, below: Self, coverage: u8) -> Self;
}

impl DisplayColor for Rgb565 {
    type Pixel = u16;
    #[inline]
    fn pixel(self) -> u16 {
        RawU16::from(self).into_inner()
    }
    #[inline]
    fn of_pixel(pixel: u16) -> Self {
        RawU16::new(pixel).into()
    }
    #[inline]
    fn encoded(display: &Display, color: Rgb<Linear>, dither: Option<[usize; 2]>) -> Self {
        Self::of_pixel(match dither {
            Some([x, y]) => display.rgb565_dithered(color, x, y),
            None => display.rgb565(color),
        })
    }
    #[inline]
    fn of_palette(palette: &Palette, code: NormalCode) -> Self {
        Self::of_pixel(palette.rgb565(code))
    }
    #[inline]
    fn of_dithered(palette: Dithered<'_>, code: NormalCode, [x, y]: [usize; 2]) -> Self {
        Self::of_pixel(palette.rgb565(code, x, y))
    }
    #[inline]
    fn over(self, below: Self, coverage: u8) -> Self {
        Self::of_pixel(blend565(below.pixel(), self.pixel(), coverage))
    }
}

impl DisplayColor for Rgb888 {
    type Pixel = [u8; 3];
    #[inline]
    fn pixel(self) -> [u8; 3] {
        [self.r(), self.g(), self.b()]
    }
    #[inline]
    fn of_pixel([r, g, b]: [u8; 3]) -> Self {
        Self::new(r, g, b)
    }
    #[inline]
    fn encoded(display: &Display, color: Rgb<Linear>, _: Option<[usize; 2]>) -> Self {
        let Rgb { r, g, b } = display.rgb888(color);
        Self::new(r, g, b)
    }
    #[inline]
    fn of_palette(palette: &Palette, code: NormalCode) -> Self {
        Self::of_pixel(palette.rgb888(code).into())
    }
    #[inline]
    fn of_dithered(palette: Dithered<'_>, code: NormalCode, _: [usize; 2]) -> Self {
        Self::of_pixel(palette.rgb888(code).into())
    }
    #[inline]
    fn over(self, below: Self, coverage: u8) -> Self {
        let [above, below] = [self, below].map(|color| Rgb::from(color.pixel()));
        Self::of_pixel(above.over(below, coverage).into())
    }
}

/// Colors of displays that have the channels in the other order.
macro_rules! reversed {
    ($($color:ty, $of:ty;)*) => {
        $(
            impl DisplayColor for $color {
                type Pixel = <$of as DisplayColor>::Pixel;
                #[inline]
                fn pixel(self) -> Self::Pixel {
                    <$of>::from(self).pixel()
                }
                #[inline]
                fn of_pixel(pixel: Self::Pixel) -> Self {
                    <$of>::of_pixel(pixel).into()
                }
                #[inline]
                fn encoded(
                    display: &Display,
                    color: Rgb<Linear>,
                    dither: Option<[usize; 2]>,
                ) -> Self {
                    <$of>::encoded(display, color, dither).into()
                }
                #[inline]
                fn of_palette(palette: &Palette, code: NormalCode) -> Self {
                    <$of>::of_palette(palette, code).into()
                }
                #[inline]
                fn of_dithered(
                    palette: Dithered<'_>,
                    code: NormalCode,
                    place: [usize; 2],
                ) -> Self {
                    <$of>::of_dithered(palette, code, place).into()
                }
                #[inline]
                fn over(self, below: Self, coverage: u8) -> Self {
                    <$of>::from(self).over(below.into(), coverage).into()
                }
            }
        )*
    };
}
reversed! {
    Bgr565, Rgb565;
    Bgr888, Rgb888;
}
