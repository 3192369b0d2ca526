//! Compares a picture (PPM) with a PNG, or writes the PNG with `--update`:
//! `cargo run -p eigenshade-capi --example picture -- [--update] FROM.ppm TO.png`.

use std::error::Error;
use std::fs::File;
use std::io::{BufReader, BufWriter};
use std::{env, fs};

/// Width, height and the bytes of the pixels.
type Picture = (u32, u32, Vec<u8>);

/// Reads a picture as the examples in C print it: a header of three lines, then RGB.
fn ppm(bytes: &[u8]) -> Option<Picture> {
    let mut lines = bytes.splitn(4, |&byte| byte == b'\n');
    let [magic, size, _, pixels] = [lines.next()?, lines.next()?, lines.next()?, lines.next()?];
    let (width, height) = str::from_utf8(size).ok()?.split_once(' ')?;
    let (width, height) = (width.parse().ok()?, height.parse().ok()?);
    (magic == b"P6").then(|| (width, height, pixels.to_vec()))
}

fn read_png(path: &str) -> Result<Picture, Box<dyn Error>> {
    let mut reader = png::Decoder::new(BufReader::new(File::open(path)?)).read_info()?;
    let mut pixels = vec![0; reader.output_buffer_size().ok_or("too large")?];
    let info = reader.next_frame(&mut pixels)?;
    Ok((info.width, info.height, pixels))
}

fn write_png(path: &str, (width, height, pixels): &Picture) -> Result<(), Box<dyn Error>> {
    let mut encoder = png::Encoder::new(BufWriter::new(File::create(path)?), *width, *height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::High);
    Ok(encoder.write_header()?.write_image_data(pixels)?)
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let (update, from, to) = match &arguments[..] {
        [from, to] => (false, from, to),
        [option, from, to] if option == "--update" => (true, from, to),
        _ => return Err("usage: picture [--update] FROM.ppm TO.png".into()),
    };
    let drawn = ppm(&fs::read(from)?).ok_or_else(|| format!("{from}: not a picture"))?;
    if update {
        return write_png(to, &drawn);
    }
    if read_png(to)? != drawn {
        return Err(format!("{from} is not {to}; look at both, and update the latter").into());
    }
    Ok(())
}
