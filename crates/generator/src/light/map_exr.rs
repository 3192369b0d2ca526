//! OpenEXR maps: scan lines or tiles; half, float or integer samples; every common compression.

use crate::light::environment::{BYTES_PER_TEXEL, EnvironmentMap, broken, other_type};
use crate::light::map_exr_check as check;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use exr::error::Error as ExrError;
use exr::image::read::specific_channels::ReadSpecificChannel;
use exr::meta::header::Header;
use exr::prelude::{ReadChannels, ReadLayers, Text, Vec2, read};
use std::cell::Cell;
use std::fs::File;
use std::io::{BufRead, BufReader, Seek};

/// Decodes the first part of an OpenEXR file that has the channels R, G, B, those of a layer
/// (`name.R`, ...), or the gray channel Y, in this order of preference.
///
/// Primaries that differ from the project's are not converted.
pub(crate) fn decode(
    reader: &mut BufReader<File>,
    length: u64,
    file: &InputFile,
) -> Result<EnvironmentMap> {
    let io = |error: std::io::Error| Error::io(file.path(), &error);
    if !reader.fill_buf().map_err(io)?.starts_with(&[0x76, 0x2f, 0x31, 0x01]) {
        return Err(other_type("OpenEXR"));
    }
    let parts = exr::block::read(&mut *reader, false).map_err(fault)?;
    let headers = parts.meta_data().headers.clone();
    check::sizes(&headers, length)?;
    let (header, channels) = headers
        .iter()
        .find_map(|header| Some((header, color(header)?)))
        .ok_or_else(|| without_color(&headers))?;
    let Vec2(width, height) = header.layer_size;
    let Vec2(whole_width, whole_height) = header.shared_attributes.display_window.size;
    if (width, height) != (whole_width, whole_height) {
        return Err(Error::new(
            format!("{width} x {height} pixels are stored of {whole_width} x {whole_height}"),
            "save the map whole, not cropped to its data window",
        ));
    }
    let count = width * height;
    file.admit_pixels(count as u64, BYTES_PER_TEXEL, check::blocks(&headers, length))?;
    check::counters(&headers, parts.all_chunks(false).map_err(fault)?)?;
    reader.rewind().map_err(io)?;
    let grid = Cell::new(vec![[0.0; 3]; count]);
    // A part of another size is not the one to read.
    let empty = |size: Vec2<usize>| Grid {
        width,
        texels: if size == Vec2(width, height) { grid.take() } else { Vec::new() },
    };
    let texels = match channels {
        Color::Rgb([r, g, b]) => read()
            .no_deep_data()
            .largest_resolution_level()
            .specific_channels()
            .required(r)
            .required(g)
            .required(b)
            .collect_pixels(
                |size, _: &_| empty(size),
                |grid: &mut Grid, place, (r, g, b)| {
                    grid.set(place, [r, g, b]);
                },
            )
            .first_valid_layer()
            .all_attributes()
            .non_parallel()
            .from_buffered(reader)
            .map(|image| image.layer_data.channel_data.pixels.texels),
        Color::Grey(y) => read()
            .no_deep_data()
            .largest_resolution_level()
            .specific_channels()
            .required(y)
            .collect_pixels(
                |size, _: &_| empty(size),
                |grid: &mut Grid, place, (y,)| {
                    grid.set(place, [y; 3]);
                },
            )
            .first_valid_layer()
            .all_attributes()
            .non_parallel()
            .from_buffered(reader)
            .map(|image| image.layer_data.channel_data.pixels.texels),
    }
    .map_err(fault)?;
    EnvironmentMap::new(width, height, texels)
}

enum Color {
    Rgb([Text; 3]),
    Grey(Text),
}

/// The color channels of one part, if it has them at full resolution.
fn color(header: &Header) -> Option<Color> {
    let full = Vec2(1, 1);
    let names: Vec<&Text> = header
        .channels
        .list
        .iter()
        .filter(|channel| !header.deep && channel.sampling == full)
        .map(|channel| &channel.name)
        .collect();
    let find = |prefix: &str, name: &str| {
        let wanted = format!("{prefix}{name}");
        names.iter().copied().find(|&name| *name == *wanted)
    };
    let triple = |prefix: &str| {
        Some([find(prefix, "R")?.clone(), find(prefix, "G")?.clone(), find(prefix, "B")?.clone()])
    };
    let layers = names.iter().filter_map(|name| {
        let name = name.to_string();
        name.strip_suffix('R').filter(|prefix| prefix.ends_with('.')).map(str::to_owned)
    });
    let rgb = std::iter::once(String::new()).chain(layers).find_map(|prefix| triple(&prefix));
    // With RY and BY present, Y is the luminance of a color image, not a gray map.
    let colored = header.channels.list.iter().any(|channel| channel.name == *"RY");
    rgb.map(Color::Rgb).or_else(|| Some(Color::Grey(find("", "Y").filter(|_| !colored)?.clone())))
}

fn without_color(headers: &[Header]) -> Error {
    let names: Vec<_> = headers
        .iter()
        .flat_map(|header| header.channels.list.iter())
        .map(|channel| channel.name.to_string())
        .take(8)
        .collect();
    Error::new(
        format!("its channels are {}, without R, G, B", names.join(", ")),
        "export it with the channels R, G, B, or a grey Y, one sample a pixel",
    )
}

/// Texels row by row.
struct Grid {
    width: usize,
    texels: Vec<[f32; 3]>,
}

impl Grid {
    fn set(&mut self, Vec2(column, row): Vec2<usize>, value: [f32; 3]) {
        if let Some(texel) = self.texels.get_mut(row * self.width + column) {
            *texel = value;
        }
    }
}

fn fault(error: ExrError) -> Error {
    match error {
        ExrError::NotSupported(why) => Error::new(
            format!("it is of a kind that is not read ({why})"),
            "export it as scan lines, with ZIP compression or none",
        ),
        error => broken(error),
    }
}
