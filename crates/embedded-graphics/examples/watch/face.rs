//! The face of a watch: a blue dial with an embossed golden emblem and hands, on a display of
//! 128 x 128 pixels. The light turns as the wrist does.
//!
//! The program of `main.rs` draws it, tests do, and so do the programs of emulated boards.
#![allow(dead_code, reason = "each of them draws in one number format or in both")]

use core::convert::Infallible;
use eigenshade::Error;
use eigenshade::object::NormalMap;
use eigenshade::screen::{Display, Nodes, Palette, Tone};
use eigenshade_embedded_graphics::{DisplayColor, Relief};
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
static CODES: &[u8; 2 * (RELIEF * RELIEF) as usize] = include_bytes!("relief.bin");

/// The dial's normals.
static DIAL: &[u8; 2 * (SIZE * SIZE) as usize] = include_bytes!("dial.bin");

/// The width of the bezel and of the marks in pixels.
pub const DIAL_WIDTHS: [u32; 2] = [8, 4];

static DISPLAY: Display = Display::new(Tone::Filmic);

/// The checksum of [`integers`] on a [`Panel`], every sixth frame from the first on: the same on
/// every machine.
pub const CHECKSUM: u32 = 0x0c44_eb90;

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

/// A palette for both objects, and the nodes of each: all memory between frames.
#[derive(Debug)]
pub struct Watch {
    palette: Palette,
    dial: Nodes,
    relief: Nodes,
}

impl Default for Watch {
    fn default() -> Self {
        Self { palette: Palette::default(), dial: nodes(DIAL, SIZE), relief: nodes(CODES, RELIEF) }
    }
}

/// An object's normals; `None` would be a map of another size.
fn map(codes: &'static [u8], side: u32) -> Option<NormalMap<'static>> {
    NormalMap::new(side as usize, side as usize, codes).ok()
}

/// The nodes that an object needs.
fn nodes(codes: &'static [u8], side: u32) -> Nodes {
    map(codes, side).map_or(Nodes::ALL, |map| map.nodes())
}

/// Draws an object in the middle of the display from a palette.
fn draw_object<D>(
    codes: &'static [u8],
    side: u32,
    palette: &Palette,
    target: &mut D,
) -> Result<(), D::Error>
where
    D: DrawTarget<Color: DisplayColor>,
{
    let corner = (SIZE - side).cast_signed() / 2;
    let Some(map) = map(codes, side) else { return Ok(()) };
    Relief::new(Point::new(corner, corner), map, palette).draw(target)
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

/// The functions of a module that draws in a number format. The module has the light and
/// the materials in it; `$wrist` gives the quaternion of a frame.
macro_rules! frames {
    ($wrist:expr) => {
        /// Draws a frame. It takes the materials in anew for each frame, which costs little beside
        /// the palettes and needs no memory for transfers. The two objects share a palette.
        pub fn draw<D: DrawTarget<Color: DisplayColor>>(
            frame: i32,
            watch: &mut Watch,
            target: &mut D,
        ) -> Result<Result<(), D::Error>, Error> {
            let light = light(frame)?;
            let Watch { palette, dial, relief } = watch;
            fill(light.lights()?, BLUE_METALLIC_PAINT2, palette, dial)?;
            if let Err(failed) = draw_object(DIAL, SIZE, palette, target) {
                return Ok(Err(failed));
            }
            fill(light.lights()?, GOLD_METALLIC_PAINT, palette, relief)?;
            Ok(draw_object(CODES, RELIEF, palette, target))
        }

        /// The light after the wrist has turned.
        // Apart, like `fill`, so that its stack is free again for the rows.
        #[inline(never)]
        fn light(frame: i32) -> Result<Rgb<Buffer>, Error> {
            HALL.turned(&Rotation::from_quaternion(($wrist)(frame))?)
        }

        /// Fills a palette with a material under a light.
        #[inline(never)]
        fn fill(
            light: Rgb<Light<'_>>,
            material: Rgb<Material<'_>>,
            palette: &mut Palette,
            nodes: &Nodes,
        ) -> Result<(), Error> {
            let scene = color::scene(light, material)?;
            let exposure = scene.exposure_by_factor(EXPOSURE)?;
            palette.fill(nodes, &DISPLAY, |normal| exposure.of(scene.shade(normal)));
            Ok(())
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

    type Light<'a> = eigenshade::Light<'a>;
    type Material<'a> = eigenshade::Material<'a>;
    type Buffer = eigenshade::Buffer<f32, 100>;
    frames!(|frame| wrist(frame).map(|part| part as f32));
}

/// In integers.
pub mod integers {
    use super::*;
    use eigenshade::Rgb;
    use eigenshade::presets::light::q15::HALL;
    use eigenshade::presets::material::q15::{BLUE_METALLIC_PAINT2, GOLD_METALLIC_PAINT};
    use eigenshade::q15::{Light, LightBuffer, Material, Rotation};
    use eigenshade::sphere::q15::color;

    type Buffer = LightBuffer<100>;
    frames!(wrist);
}
