//! The face of a watch: a blue dial with an embossed golden emblem and hands, on a display of
//! 128 x 128 or of 240 x 240 pixels. The light turns as the wrist does.
//!
//! The program of `main.rs` draws it, tests do, and so do the programs of emulated boards.
#![allow(dead_code, reason = "each of them draws in one number format or in both")]

use core::convert::Infallible;
use eigenshade::Error;
use eigenshade::object::NormalMap;
use eigenshade::screen::{Display, Nodes, Palette, Tone};
use eigenshade_embedded_graphics::{DisplayColor, Frame, Layer};
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{OriginDimensions, Point, Size};
use embedded_graphics_core::pixelcolor::raw::{RawData as _, RawU16};
use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor as _};
use embedded_graphics_core::primitives::Rectangle;
use embedded_graphics_core::{Drawable as _, Pixel};

/// The normals of a watch, and its measures in pixels.
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
    relief_codes: &'static [u8],
}

/// On a display of 128 x 128 pixels.
pub static SMALL: Face = Face {
    size: 128,
    relief: 74,
    bezel: 8,
    mark: 4,
    dial_codes: include_bytes!("dial_128.bin"),
    relief_codes: include_bytes!("relief_128.bin"),
};

/// On a display of 240 x 240 pixels.
pub static LARGE: Face = Face {
    size: 240,
    relief: 140,
    bezel: 15,
    mark: 7,
    dial_codes: include_bytes!("dial_240.bin"),
    relief_codes: include_bytes!("relief_240.bin"),
};

impl Face {
    /// The normals of the dial and of the relief.
    ///
    /// # Errors
    ///
    /// None: the sizes are right.
    pub fn maps(&self) -> Result<[NormalMap<'static>; 2], Error> {
        let map = |side: u32, codes| NormalMap::new(side as usize, side as usize, codes);
        Ok([map(self.size, self.dial_codes)?, map(self.relief, self.relief_codes)?])
    }
}

/// Frames until the wrist is back where it was.
pub const FRAMES: i32 = 24;

static DISPLAY: Display = Display::new(Tone::Filmic);

/// The checksums of [`integers`] on a [`Panel`] of both sizes, every sixth frame from the first on:
/// the same on every machine.
pub const CHECKSUMS: [u32; 2] = [0x2bc9_a17e, 0xb8b0_1237];

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

/// The normals, materials and palettes of the dial and of the relief: all memory between frames.
/// `T` is the transfer of a material in a number format.
#[derive(Debug)]
pub struct Watch<T> {
    maps: [NormalMap<'static>; 2],
    nodes: [Nodes; 2],
    transfers: [T; 2],
    palettes: [Palette; 2],
}

impl<T> Watch<T> {
    /// A watch whose palettes are black.
    fn new(face: &Face, transfers: [T; 2]) -> Result<Self, Error> {
        let maps = face.maps()?;
        let nodes = maps.map(|map| map.nodes());
        Ok(Self { maps, nodes, transfers, palettes: [Palette::BLACK; 2] })
    }

    /// Draws the dial and the relief above it from the palettes.
    ///
    /// # Errors
    ///
    /// The display's.
    pub fn draw<D: DrawTarget<Color: DisplayColor + From<Rgb565>>>(
        &self,
        target: &mut D,
    ) -> Result<(), D::Error> {
        let ([dial, relief], [blue, gold]) = (self.maps, &self.palettes);
        let corner = (dial.width() - relief.width()) as i32 / 2;
        let layers = [
            Layer::new(Point::zero(), dial, blue),
            Layer::new(Point::new(corner, corner), relief, gold),
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
        I: IntoIterator<Item = Pixel<Rgb565>>,
    {
        for Pixel(place, color) in pixels {
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

/// The functions of a module that draws in a number format. The module has the light and
/// the materials in it; `$wrist` gives the quaternion of a frame.
macro_rules! frames {
    ($wrist:expr) => {
        /// A watch whose palettes are black.
        ///
        /// # Errors
        ///
        /// None: the sizes are right.
        pub fn watch(face: &Face) -> Result<Watch<color::Transfer>, Error> {
            let transfers =
                [color::transfer(BLUE_METALLIC_PAINT2)?, color::transfer(GOLD_METALLIC_PAINT)?];
            Watch::new(face, transfers)
        }

        /// Lights a frame: turns the light, and fills both palettes.
        ///
        /// # Errors
        ///
        /// None: the rotation has a direction.
        pub fn relight(frame: i32, watch: &mut Watch<color::Transfer>) -> Result<(), Error> {
            let light = light(frame)?;
            let palettes = watch.palettes.iter_mut().zip(&watch.nodes).zip(&watch.transfers);
            for ((palette, nodes), transfer) in palettes {
                let scene = color::relight(transfer, light.lights()?)?;
                let exposure = scene.exposure_by_factor(EXPOSURE)?;
                palette.fill_mirrored(nodes, &DISPLAY, |normal| {
                    scene.shade_mirrored(normal).map(|color| exposure.of(color))
                });
            }
            Ok(())
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
    use eigenshade::presets::material::{BLUE_METALLIC_PAINT2, GOLD_METALLIC_PAINT};
    use eigenshade::sphere::color;
    use eigenshade::{Rgb, Rotation};

    type Buffer = eigenshade::Buffer<f32, 100>;
    frames!(|frame| wrist(frame).map(|part| part as f32));
}

/// In integers.
pub mod integers {
    use super::*;
    use eigenshade::Rgb;
    use eigenshade::presets::light::q15::HALL;
    use eigenshade::presets::material::q15::{BLUE_METALLIC_PAINT2, GOLD_METALLIC_PAINT};
    use eigenshade::q15::{LightBuffer, Rotation};
    use eigenshade::sphere::q15::color;

    type Buffer = LightBuffer<100>;
    frames!(wrist);
}
