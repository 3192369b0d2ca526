//! Frames as pictures.

use super::face;
use embedded_graphics::framebuffer::{Framebuffer, buffer_size};
use embedded_graphics::image::GetPixel as _;
use embedded_graphics::pixelcolor::raw::{LittleEndian, RawU16};
use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use embedded_graphics::prelude::*;

/// Pixels of the picture for one of the display, along each side.
const SCALE: usize = 2;

/// The side of a picture in pixels.
pub const SIDE: u32 = face::SIZE * SCALE as u32;

/// A frame in floats: three bytes a pixel, each pixel of the display as a square of two by two.
pub fn rgb(frame: i32) -> Result<Vec<u8>, eigenshade::Error> {
    const SIDE: usize = face::SIZE as usize;
    const BYTES: usize = buffer_size::<Rgb565>(SIDE, SIDE);
    let mut display = Framebuffer::<Rgb565, RawU16, LittleEndian, SIDE, SIDE, BYTES>::new();
    let Ok(()) = face::floats::draw(frame, &mut face::Watch::default(), &mut display)?;
    let mut bytes = Vec::new();
    for y in 0..face::SIZE.cast_signed() {
        let row = (0..face::SIZE.cast_signed()).map(|x| Point::new(x, y));
        let pixels = row.filter_map(|place| display.pixel(place));
        let pixels = pixels.map(Rgb888::from).map(|color| [color.r(), color.g(), color.b()]);
        let row: Vec<u8> = pixels.flat_map(|pixel| [pixel; SCALE]).flatten().collect();
        bytes.extend(row.repeat(SCALE));
    }
    Ok(bytes)
}
