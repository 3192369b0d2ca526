//! A golden coin on a blue dial, as docs/guides/watch.md builds it: `coin FILE.png`.

use eigenshade::mathematics::SinglePrecision;
use eigenshade::presets::light::HALL;
use eigenshade::presets::material::{BLUE_METALLIC_PAINT2, GOLD_METALLIC_PAINT};
use eigenshade::{Display, NormalMap, Rotation, Tone, sphere};
use eigenshade_embedded_graphics::{Dial, Paint, Relief};
use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};

static COIN: &[u8] = include_bytes!("coin.bin");
static DISPLAY: Display = Display::new(Tone::Filmic);

/// Draws the face when the wrist is tilted by this many radians.
fn draw<D>(tilt: f32, target: &mut D) -> Result<Result<(), D::Error>, eigenshade::Error>
where
    D: DrawTarget<Color = Rgb565>,
{
    let rotation = Rotation::from_euler::<SinglePrecision>(tilt, 0.0, 0.0)?;
    let light = HALL.turned::<100>(&rotation)?;

    let scene = sphere::color::scene(light.lights()?, BLUE_METALLIC_PAINT2)?;
    let blue = Paint::new(|normal| scene.shade(normal), 2.0, &DISPLAY)?;
    if let Err(error) = Dial::new(Point::zero(), 128, 8, 4, &blue).draw(target) {
        return Ok(Err(error));
    }

    let scene = sphere::color::scene(light.lights()?, GOLD_METALLIC_PAINT)?;
    let gold = Paint::new(|normal| scene.shade(normal), 2.0, &DISPLAY)?;
    let map = NormalMap::new(90, 90, COIN)?;
    Ok(Relief::new(Point::new(19, 19), map, &gold).draw(target))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let file = std::env::args().nth(1).ok_or("usage: coin FILE.png")?;
    // Three moments, side by side.
    let mut display = SimulatorDisplay::<Rgb565>::new(Size::new(3 * 128, 128));
    for (place, tilt) in [(0, -0.5), (128, 0.0), (256, 0.5)] {
        draw(tilt, &mut display.translated(Point::new(place, 0)))??;
    }
    display.to_rgb_output_image(&OutputSettings::default()).save_png(file)?;
    Ok(())
}
