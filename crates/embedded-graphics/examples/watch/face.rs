//! The face of a watch: a blue dial around a golden relief, whose hands throw shadows on it, on a
//! display of 128 x 128 or of 240 x 240 pixels. The light turns as the wrist does.
//!
//! The program of `main.rs` draws it, tests do, and so do the programs of emulated boards.
#![allow(dead_code, reason = "each of them draws in one number format or in both")]

use core::convert::Infallible;
use eigenshade::Error;
use eigenshade::object::{NormalMap, ShadowedObject};
use eigenshade::screen::{Display, Exposure, Nodes, Palette, Pixel, Tone};
use eigenshade_embedded_graphics::{DisplayColor, Frame, Layer};
use embedded_graphics_core::Drawable as _;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{OriginDimensions, Point, Size};
use embedded_graphics_core::pixelcolor::raw::{RawData as _, RawU16};
use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor as _};
use embedded_graphics_core::primitives::Rectangle;

/// The normals of a dial, a relief with shadows, and their measures in pixels.
#[derive(Debug)]
pub struct Face {
    /// The side of the display.
    pub size: u32,
    /// The side of the relief in the middle.
    pub relief: u32,
    /// The width of the bezel.
    pub bezel: u32,
    /// The width of the marks.
    pub mark: u32,
    dial_codes: &'static [u8],
    relief_file: &'static [u8],
}

/// On a display of 128 x 128 pixels.
pub static SMALL: Face = Face {
    size: 128,
    relief: 74,
    bezel: 8,
    mark: 4,
    dial_codes: include_bytes!("dial_128.bin"),
    relief_file: include_bytes!("relief_128.bin"),
};

/// On a display of 240 x 240 pixels.
pub static LARGE: Face = Face {
    size: 240,
    relief: 140,
    bezel: 15,
    mark: 7,
    dial_codes: include_bytes!("dial_240.bin"),
    relief_file: include_bytes!("relief_240.bin"),
};

impl Face {
    /// The normals of the dial.
    ///
    /// # Errors
    ///
    /// None: the size is right.
    pub fn dial(&self) -> Result<NormalMap<'static>, Error> {
        NormalMap::new(self.size as usize, self.size as usize, self.dial_codes)
    }

    /// The relief.
    ///
    /// # Errors
    ///
    /// None: the file is right.
    pub fn relief(&self) -> Result<ShadowedObject<'static>, Error> {
        ShadowedObject::new(self.relief_file)
    }
}

/// The colors of the larger relief.
pub const COLORS: usize = 2700;

/// Frames until the wrist is back where it was.
pub const FRAMES: i32 = 24;

static DISPLAY: Display = Display::new(Tone::Filmic);

/// The checksums of [`integers`] on a [`Panel`] of both sizes, every sixth frame from the first on:
/// the same on every machine.
pub const CHECKSUMS: [u32; 2] = [0xf614_c26d, 0x91bc_1543];

/// How bright the picture is.
const EXPOSURE: f32 = 2.0;

/// How far the wrist is turned in a frame, as a quaternion of integers: it swings about an axis to
/// the upper right.
fn wrist(frame: i32) -> [i32; 4] {
    let quarter = FRAMES / 4;
    let (half, place) = (frame / (2 * quarter), frame % (2 * quarter));
    // A parabola in place of each half of a sine.
    let angle = place * (2 * quarter - place) * if half % 2 == 0 { 1 } else { -1 };
    [angle, 2 * angle, -angle, 5 * quarter * quarter]
}

/// The dial with its material and palette, and the relief with the colors of its codes: all memory
/// between frames. `T` is the transfer of a material in a number format, `P` a pixel of a display.
#[derive(Debug)]
pub struct Watch<T, P> {
    dial: NormalMap<'static>,
    nodes: Nodes,
    transfer: T,
    palette: Palette,
    relief: ShadowedObject<'static>,
    colors: [P; COLORS],
}

impl<T, P: Pixel + Default> Watch<T, P> {
    /// A watch whose colors are black.
    fn new(face: &Face, transfer: T) -> Result<Self, Error> {
        let (dial, relief) = (face.dial()?, face.relief()?);
        let (palette, colors) = (Palette::BLACK, [P::default(); COLORS]);
        Ok(Self { dial, nodes: dial.nodes(), transfer, palette, relief, colors })
    }

    /// Draws the dial and the relief above it.
    ///
    /// # Errors
    ///
    /// The display's.
    pub fn draw<D>(&self, target: &mut D) -> Result<(), D::Error>
    where
        D: DrawTarget<Color: DisplayColor<Pixel = P> + From<Rgb565>>,
    {
        let (dial, relief) = (self.dial, &self.relief);
        let corner = (dial.width() - relief.width()) as i32 / 2;
        let layers = [
            Layer::new(Point::zero(), dial, &self.palette),
            Layer::shadowed(Point::new(corner, corner), relief, &self.colors),
        ];
        let size = Size::new(dial.width() as u32, dial.height() as u32);
        let area = Rectangle::new(Point::zero(), size);
        Frame::new(area, &layers, Rgb565::BLACK.into()).draw(target)
    }
}

/// A display without memory, which computes a checksum of what it is sent: where each row of
/// pixels begins, and the pixels.
#[derive(Debug)]
pub struct Panel {
    size: u32,
    /// The checksum.
    pub checksum: u32,
}

impl Panel {
    /// The display of a watch.
    #[must_use]
    pub const fn new(face: &Face) -> Self {
        Self { size: face.size, checksum: 0 }
    }

    fn send(&mut self, word: u32) {
        self.checksum = self.checksum.wrapping_mul(0x0100_0193).wrapping_add(word);
    }
}

impl OriginDimensions for Panel {
    fn size(&self) -> Size {
        Size::new_equal(self.size)
    }
}

impl DrawTarget for Panel {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = embedded_graphics_core::Pixel<Rgb565>>,
    {
        for embedded_graphics_core::Pixel(place, color) in pixels {
            self.fill_contiguous(&Rectangle::new(place, Size::new_equal(1)), [color])?;
        }
        Ok(())
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Rgb565>,
    {
        let Point { x, y } = area.top_left;
        self.send((y * self.size.cast_signed() + x).cast_unsigned());
        for color in colors {
            self.send(RawU16::from(color).into_inner().into());
        }
        Ok(())
    }
}

/// The functions of a module that draws in a number format. The module has the light and the
/// material in it; `$coefficients` gives those of the relief, and `$wrist` the quaternion of a frame.
macro_rules! frames {
    ($coefficients:ident, $wrist:expr) => {
        /// A watch whose colors are black.
        ///
        /// # Errors
        ///
        /// None: the sizes are right.
        pub fn watch<P: Pixel + Default>(face: &Face) -> Result<Watch<color::Transfer, P>, Error> {
            Watch::new(face, color::transfer(BLUE_METALLIC_PAINT2)?)
        }

        /// Lights a frame: turns the light, and fills the palette of the dial and the colors of the
        /// relief.
        ///
        /// # Errors
        ///
        /// None: the rotation has a direction.
        pub fn relight<P: Pixel>(
            frame: i32,
            watch: &mut Watch<color::Transfer, P>,
        ) -> Result<(), Error> {
            let light = light(frame)?;
            let scene = color::relight(&watch.transfer, light.lights()?)?;
            let exposure = scene.exposure_by_factor(EXPOSURE)?;
            watch.palette.fill_mirrored(&watch.nodes, &DISPLAY, |normal| {
                scene.shade_mirrored(normal).map(|color| exposure.of(color))
            });
            let d = watch.relief.$coefficients(light.lights()?)?;
            let colors = watch.colors.get_mut(..watch.relief.codes()).unwrap_or_default();
            watch.relief.colors(&d, Exposure::new(EXPOSURE)?, &DISPLAY, colors)
        }

        /// The light after the wrist has turned.
        // Apart, so that its stack is free again.
        #[inline(never)]
        fn light(frame: i32) -> Result<Rgb<Buffer>, Error> {
            HALL.turned(&Rotation::from_quaternion(($wrist)(frame))?)
        }
    };
}

/// In `f32`.
pub mod floats {
    use super::*;
    use eigenshade::presets::light::HALL;
    use eigenshade::presets::material::BLUE_METALLIC_PAINT2;
    use eigenshade::sphere::color;
    use eigenshade::{Rgb, Rotation};

    type Buffer = eigenshade::Buffer<f32, 100>;
    frames!(coefficients, |frame| wrist(frame).map(|part| part as f32));
}

/// In integers.
pub mod integers {
    use super::*;
    use eigenshade::Rgb;
    use eigenshade::presets::light::q15::HALL;
    use eigenshade::presets::material::q15::BLUE_METALLIC_PAINT2;
    use eigenshade::q15::{LightBuffer, Rotation};
    use eigenshade::sphere::q15::color;

    type Buffer = LightBuffer<100>;
    frames!(coefficients_q15, wrist);
}
