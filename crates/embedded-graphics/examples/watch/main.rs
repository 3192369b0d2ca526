//! Draws the large watch in a frame buffer and writes its frames as an animated PNG:
//! `watch FILE.png`. `watch --relief FILE.obj` makes the mesh of the relief, and
//! `watch --dials FOLDER` the normals of both dials.

mod face;
mod picture;
mod relief;

use std::error::Error;
use std::fs::{File, write};
use std::io::BufWriter;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match &arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["--relief", file] => Ok(write(file, relief::mesh())?),
        ["--dials", folder] => {
            for face in [&face::SMALL, &face::LARGE] {
                let file = Path::new(folder).join(format!("dial_{}.bin", face.size));
                write(file, relief::dial(face).as_flattened())?;
            }
            Ok(())
        }
        [file] => animate(file),
        _ => {
            Err("expected `watch FILE.png`, `watch --relief FILE.obj` or `watch --dials FOLDER`"
                .into())
        }
    }
}

/// Writes every second frame, for a smaller file.
fn animate(file: &str) -> Result<(), Box<dyn Error>> {
    let out = BufWriter::new(File::create(file)?);
    let mut encoder = png::Encoder::new(out, picture::SIDE, picture::SIDE);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::High);
    encoder.set_animated((face::FRAMES / picture::STEP).cast_unsigned(), 0)?;
    encoder.set_frame_delay(1, 6)?;
    let mut frames = encoder.write_header()?;
    for frame in (0..face::FRAMES).step_by(picture::STEP as usize) {
        frames.write_image_data(&picture::rgb(frame)?)?;
    }
    Ok(frames.finish()?)
}
