//! Draws the watch on a simulated display and writes its frames as an animated PNG:
//! `watch FILE.png`; `watch --relief FILE.bin` makes the relief's normal map.

mod face;
mod relief;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics_simulator::{OutputSettingsBuilder, SimulatorDisplay};
use std::error::Error;
use std::fs::{File, write};
use std::io::BufWriter;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match &arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["--relief", file] => Ok(write(file, relief::codes().as_flattened())?),
        [file] => animate(file),
        _ => Err("expected `watch FILE.png` or `watch --relief FILE.bin`".into()),
    }
}

/// Writes all frames, each pixel as a square of two by two.
fn animate(file: &str) -> Result<(), Box<dyn Error>> {
    let settings = OutputSettingsBuilder::new().scale(2).build();
    let out = BufWriter::new(File::create(file)?);
    let mut encoder = png::Encoder::new(out, 2 * face::SIZE, 2 * face::SIZE);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::High);
    encoder.set_animated(face::FRAMES.cast_unsigned(), 0)?;
    encoder.set_frame_delay(1, 12)?;
    let mut frames = encoder.write_header()?;
    for frame in 0..face::FRAMES {
        let mut display = SimulatorDisplay::<Rgb565>::new(Size::new_equal(face::SIZE));
        face::floats::draw(frame, &mut display)??;
        let image = display.to_rgb_output_image(&settings);
        frames.write_image_data(image.as_image_buffer().as_raw())?;
    }
    Ok(frames.finish()?)
}
