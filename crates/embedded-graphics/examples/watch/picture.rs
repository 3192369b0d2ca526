//! Frames as pictures.

use super::face;
use embedded_graphics::framebuffer::{Framebuffer, buffer_size};
use embedded_graphics::image::GetPixel as _;
use embedded_graphics::pixelcolor::raw::{LittleEndian, RawU16};
use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use embedded_graphics::prelude::*;

/// Frames from a picture to the next.
pub const STEP: i32 = 2;

/// The side of a picture in pixels.
pub const SIDE: u32 = face::LARGE.size;

/// A frame in floats: three bytes a pixel.
pub fn rgb(frame: i32) -> Result<Vec<u8>, eigenshade::Error> {
    const SIDE: usize = self::SIDE as usize;
    const BYTES: usize = buffer_size::<Rgb565>(SIDE, SIDE);
    let mut display = Framebuffer::<Rgb565, RawU16, LittleEndian, SIDE, SIDE, BYTES>::new();
    let mut watch = face::floats::watch(&face::LARGE)?;
    face::floats::relight(frame, &mut watch)?;
    let Ok(()) = watch.draw(&mut display);
    let pixels = display.bounding_box().points().filter_map(|place| display.pixel(place));
    let pixels = pixels.map(Rgb888::from).map(|color| [color.r(), color.g(), color.b()]);
    Ok(pixels.flatten().collect())
}
