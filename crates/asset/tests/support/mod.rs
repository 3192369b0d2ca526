//! Files of objects, and what their pictures show.

use eigenshade_asset::asset::Asset;
use eigenshade_asset::texels::Texels;
use eigenshade_generator::object::surface::View;
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_shading::textured::Texel;
use eigenshade_testing::glb::Glb;
use png::{BitDepth, ColorType, Encoder};
use std::cell::RefCell;
use std::path::Path;

thread_local! {
    static WARNINGS: RefCell<Vec<String>> = const { RefCell::new(Vec::new()) };
}

/// A PNG of 8 bits, from the color of each pixel.
pub fn png([width, height]: [u32; 2], of: impl Fn(u32, u32) -> [u8; 4]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, width, height);
    encoder.set_color(ColorType::Rgba);
    encoder.set_depth(BitDepth::Eight);
    let mut writer = encoder.write_header().expect("a header");
    let pixels = (0..height).flat_map(|row| (0..width).map(move |column| (column, row)));
    let pixels: Vec<u8> = pixels.flat_map(|(column, row)| of(column, row)).collect();
    writer.write_image_data(&pixels).expect("pixels");
    writer.finish().expect("an end");
    bytes
}

/// The picture of the first of these files, beside the others, and the warnings.
pub fn read(files: &[(&str, &[u8])], size: usize, view: &View) -> (Result<Texels, String>, String) {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, bytes) in files {
        std::fs::write(folder.path().join(name), bytes).expect("a file");
    }
    let warn = |_: &Path, what: &str| WARNINGS.with_borrow_mut(|all| all.push(what.to_owned()));
    let file = InputFile::from(folder.path().join(files[0].0)).with_warnings(warn);
    let texels = Asset::read(&file).and_then(|asset| {
        let asset = asset.expect("materials of its own");
        Texels::of(&file, &asset, size, view)
    });
    (texels.map_err(|error| error.to_string()), WARNINGS.take().join("\n"))
}

/// The picture of a file without a warning.
pub fn drawn(glb: &Glb, size: usize) -> Texels {
    let (texels, warnings) = read(&[("a.glb", &glb.bytes())], size, &View::default());
    assert_eq!(warnings, "");
    texels.expect("a picture")
}

/// The first texel of a pixel, if it shows anything.
pub fn at(texels: &Texels, column: usize, row: usize) -> Option<Texel> {
    let mut first = 0;
    for pixel in &texels.pixels {
        if (pixel.column, pixel.row) == (column, row) {
            return Some(texels.texels[first]);
        }
        first += pixel.texels;
    }
    None
}

/// A square in this material with these pictures.
pub fn square(material: &str, images: Vec<Vec<u8>>) -> Glb {
    Glb { material: material.to_owned(), images, ..Glb::square() }
}
