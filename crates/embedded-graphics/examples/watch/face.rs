//! The face of a watch: a blue dial with an embossed golden emblem and hands, on a display of
//! 128 x 128 pixels. The light turns as the wrist does.
//!
//! The program of `main.rs` draws it, tests do, and so do the programs of emulated boards.
#![allow(dead_code, reason = "each of them draws in one number format or in both")]

use core::convert::Infallible;
use eigenshade::Error;
use eigenshade::object::NormalMap;
use eigenshade::screen::{Display, Tone};
use eigenshade_embedded_graphics::{Dial, DisplayColor, Relief, Shader};
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{OriginDimensions, Point, Size};
use embedded_graphics_core::pixelcolor::Rgb565;
use embedded_graphics_core::pixelcolor::raw::{RawData as _, RawU16};
use embedded_graphics_core::primitives::Rectangle;
use embedded_graphics_core::{Drawable as _, Pixel};

/// The side of the display in pixels.
pub const SIZE: u32 = 128;

/// Frames until the wrist is back where it was.
pub const FRAMES: i32 = 24;

/// The side of the relief in pixels.
pub const RELIEF: u32 = 74;

/// The relief's normals.
static CODES: [u8; 2 * (RELIEF * RELIEF) as usize] = *include_bytes!("relief.bin");

static DISPLAY: Display = Display::new(Tone::Filmic);

/// The checksum of [`integers`] on a [`Panel`], every sixth frame from the first on: the same on
/// every machine.
pub const CHECKSUM: u32 = 0x17ed_4f9d;

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

/// Draws the dial.
fn draw_dial<D>(paint: &impl Shader, target: &mut D) -> Result<(), D::Error>
where
    D: DrawTarget<Color: DisplayColor>,
{
    // This size is valid.
    Dial::new(Point::zero(), SIZE, 8, 4, paint).map_or(Ok(()), |dial| dial.draw(target))
}

/// Draws the relief.
fn draw_relief<D>(paint: &impl Shader, target: &mut D) -> Result<(), D::Error>
where
    D: DrawTarget<Color: DisplayColor>,
{
    let Ok(map) = NormalMap::new(RELIEF as usize, RELIEF as usize, &CODES) else { return Ok(()) };
    let corner = (SIZE - RELIEF).cast_signed() / 2;
    Relief::new(Point::new(corner, corner), map, paint).draw(target)
}

/// A display without memory, which computes a checksum of what it is sent: where each row of
/// pixels begins, and the pixels.
#[derive(Debug, Default)]
pub struct Panel {
    /// The checksum.
    pub checksum: u32,
}

impl Panel {
    fn send(&mut self, word: u32) {
        self.checksum = (self.checksum.rotate_left(5) ^ word).wrapping_mul(0x9e37_79b9);
    }
}

impl OriginDimensions for Panel {
    fn size(&self) -> Size {
        Size::new_equal(SIZE)
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
        self.send((area.top_left.y * SIZE.cast_signed() + area.top_left.x).cast_unsigned());
        for color in colors {
            self.send(RawU16::from(color).into_inner().into());
        }
        Ok(())
    }
}

/// The functions of a module that draws in a number format. The module has the light, the materials
/// and `paint` in it; `$wrist` gives the quaternion of a frame.
macro_rules! frames {
    ($wrist:expr) => {
        /// Draws a frame. It takes the materials in anew for each frame, which costs little beside
        /// the pixels and needs no memory between frames.
        pub fn draw<D: DrawTarget<Color: DisplayColor>>(
            frame: i32,
            target: &mut D,
        ) -> Result<Result<(), D::Error>, Error> {
            let light = light(frame)?;
            match dial(light.lights()?, target)? {
                Ok(()) => relief(light.lights()?, target),
                failed => Ok(failed),
            }
        }

        /// The light after the wrist has turned.
        // Apart, like the objects, so that its stack is free again for them.
        #[inline(never)]
        fn light(frame: i32) -> Result<Rgb<Buffer>, Error> {
            HALL.turned(&Rotation::from_quaternion(($wrist)(frame))?)
        }

        #[inline(never)]
        fn dial<D: DrawTarget<Color: DisplayColor>>(
            light: Rgb<Light<'_>>,
            target: &mut D,
        ) -> Result<Result<(), D::Error>, Error> {
            let scene = color::scene(light, BLUE_METALLIC_PAINT2)?;
            Ok(draw_dial(&paint(&scene)?, target))
        }

        #[inline(never)]
        fn relief<D: DrawTarget<Color: DisplayColor>>(
            light: Rgb<Light<'_>>,
            target: &mut D,
        ) -> Result<Result<(), D::Error>, Error> {
            let scene = color::scene(light, GOLD_METALLIC_PAINT)?;
            Ok(draw_relief(&paint(&scene)?, target))
        }
    };
}

/// In `f32`.
pub mod floats {
    use super::*;
    use eigenshade::presets::light::HALL;
    use eigenshade::presets::material::{BLUE_METALLIC_PAINT2, GOLD_METALLIC_PAINT};
    use eigenshade::sphere::color::{self, Scene};
    use eigenshade::{Rgb, Rotation};
    use eigenshade_embedded_graphics::Paint;

    type Light<'a> = eigenshade::Light<'a>;
    type Buffer = eigenshade::Buffer<f32, 100>;
    frames!(|frame| wrist(frame).map(|part| part as f32));

    fn paint(scene: &Scene) -> Result<impl Shader, Error> {
        Ok(Paint::new(|normal| scene.shade(normal), scene.exposure_by_factor(EXPOSURE)?, &DISPLAY))
    }
}

/// In integers.
pub mod integers {
    use super::*;
    use eigenshade::Rgb;
    use eigenshade::presets::light::q15::HALL;
    use eigenshade::presets::material::q15::{BLUE_METALLIC_PAINT2, GOLD_METALLIC_PAINT};
    use eigenshade::q15::{Light, LightBuffer, Rotation};
    use eigenshade::sphere::q15::color::{self, Scene};
    use eigenshade_embedded_graphics::Paint;

    type Buffer = LightBuffer<100>;
    frames!(wrist);

    fn paint(scene: &Scene) -> Result<impl Shader, Error> {
        let exposure = scene.exposure_by_factor(EXPOSURE)?;
        Ok(Paint::q15(|normal| scene.shade(normal), exposure, &DISPLAY))
    }
}
