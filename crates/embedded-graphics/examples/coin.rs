//! A golden coin on a blue dial, as docs/guides/watch.md builds it: `coin FILE.png`.

use eigenshade::object::NormalMap;
use eigenshade::presets::light::HALL;
use eigenshade::presets::material::{BLUE_METALLIC_PAINT2, GOLD_METALLIC_PAINT};
use eigenshade::screen::{Display, Tone};
use eigenshade::{Rotation, sphere};
use eigenshade_embedded_graphics::{Dial, Paint, Relief};
use embedded_graphics::framebuffer::{Framebuffer, buffer_size};
use embedded_graphics::image::GetPixel as _;
use embedded_graphics::pixelcolor::raw::{LittleEndian, RawU16};
use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use embedded_graphics::prelude::*;

static COIN: &[u8] = include_bytes!("coin.bin");
static DISPLAY: Display = Display::new(Tone::Filmic);

/// Draws the face when the wrist is tilted by this many radians.
fn draw<D>(tilt: f32, target: &mut D) -> Result<Result<(), D::Error>, eigenshade::Error>
where
    D: DrawTarget<Color = Rgb565>,
{
    let rotation = Rotation::from_euler(tilt, 0.0, 0.0)?;
    let light = HALL.turned::<100>(&rotation)?;

    let scene = sphere::color::scene(light.lights()?, BLUE_METALLIC_PAINT2)?;
    let blue = Paint::new(|normal| scene.shade(normal), scene.exposure_by_factor(2.0)?, &DISPLAY);
    if let Err(error) = Dial::new(Point::zero(), 128, 8, 4, &blue)?.draw(target) {
        return Ok(Err(error));
    }

    let scene = sphere::color::scene(light.lights()?, GOLD_METALLIC_PAINT)?;
    let gold = Paint::new(|normal| scene.shade(normal), scene.exposure_by_factor(2.0)?, &DISPLAY);
    let map = NormalMap::new(90, 90, COIN)?;
    Ok(Relief::new(Point::new(19, 19), map, &gold).draw(target))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let file = std::env::args().nth(1).ok_or("usage: coin FILE.png")?;
    // Three moments, side by side.
    const WIDTH: usize = 3 * 128;
    const BYTES: usize = buffer_size::<Rgb565>(WIDTH, 128);
    let mut display = Framebuffer::<Rgb565, RawU16, LittleEndian, WIDTH, 128, BYTES>::new();
    for (place, tilt) in [(0, -0.5), (128, 0.0), (256, 0.5)] {
        draw(tilt, &mut display.translated(Point::new(place, 0)))??;
    }
    let colors = display.bounding_box().points().filter_map(|place| display.pixel(place));
    let colors = colors.map(Rgb888::from).flat_map(|color| [color.r(), color.g(), color.b()]);
    let mut png = png::Encoder::new(std::fs::File::create(file)?, WIDTH as u32, 128);
    png.set_color(png::ColorType::Rgb);
    Ok(png.write_header()?.write_image_data(&colors.collect::<Vec<u8>>())?)
}
