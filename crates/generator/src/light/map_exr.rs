//! OpenEXR maps: scan lines or tiles; half, float or integer samples; every common compression.
//!
//! The claims of a file are checked against its actual size before it is decoded. The decoder
//! allocates whatever memory a header claims, including by tile sizes and the counters of DWA
//! blocks. A single wrong byte could end the program instead of returning an error.

use crate::light::environment::{
    BYTES_PER_TEXEL, EnvironmentMap, MOST_TEXELS, believable, broken, other_type,
};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use exr::block::chunk::{Chunk, CompressedBlock};
use exr::compression::Compression;
use exr::error::{Error as ExrError, Result as ExrResult};
use exr::image::read::specific_channels::ReadSpecificChannel;
use exr::meta::BlockDescription;
use exr::meta::attribute::IntegerBounds;
use exr::meta::header::Header;
use exr::prelude::{ReadChannels, ReadLayers, Text, Vec2, read};
use std::cell::Cell;
use std::fs::File;
use std::io::{BufRead, BufReader, Seek};

/// Decodes the first part of an OpenEXR file that has the channels R, G, B, those of a layer
/// (`name.R`, ...), or the gray channel Y, in this order of preference. With `needs_opacity`, also
/// the opacity of each pixel, by which the file has multiplied its color: none if there is no
/// channel A.
///
/// Primaries that differ from the project's are not converted.
pub(crate) fn decode(
    reader: &mut BufReader<File>,
    length: u64,
    file: &InputFile,
    needs_opacity: bool,
) -> Result<(EnvironmentMap, Vec<f32>)> {
    let io = |error: std::io::Error| Error::io(file.path(), &error);
    if !reader.fill_buf().map_err(io)?.starts_with(&[0x76, 0x2f, 0x31, 0x01]) {
        return Err(other_type("OpenEXR"));
    }
    let parts = exr::block::read(&mut *reader, false).map_err(fault)?;
    let headers = parts.meta_data().headers.clone();
    check_sizes(&headers, length)?;
    let (header, channels) = headers
        .iter()
        .find_map(|header| Some((header, color(header)?)))
        .ok_or_else(|| without_color(&headers))?;
    let Vec2(width, height) = header.layer_size;
    let (data, display) = (header.data_window(), header.shared_attributes.display_window);
    if data != display {
        let named = |IntegerBounds { position: Vec2(x, y), size: Vec2(width, height) }| {
            format!("{width} x {height} pixels from {x}, {y}")
        };
        return Err(Error::new(
            format!("it stores {}, but shows {}", named(data), named(display)),
            "save the map whole, with equal data and display windows",
        ));
    }
    let count = width * height;
    let opacity = channels.opacity(header).filter(|_| needs_opacity);
    let has_opacity = opacity.is_some();
    // Without, a name that no channel has.
    let opacity = opacity.unwrap_or_default();
    let bytes = BYTES_PER_TEXEL + if has_opacity { BYTES_PER_OPACITY } else { 0 };
    file.admit_pixels(count as u64, bytes, bytes_beside(&headers, length))?;
    check_counters(&headers, parts.all_chunks(false).map_err(fault)?)?;
    reader.rewind().map_err(io)?;
    let opacities = if has_opacity { vec![1.0; count] } else { Vec::new() };
    let grid = Cell::new((vec![[0.0; 3]; count], opacities));
    // A part of another size is not the one to read.
    let empty = |size: Vec2<usize>| {
        let (texels, opacities) =
            if size == Vec2(width, height) { grid.take() } else { Default::default() };
        Grid { width, texels, opacities }
    };
    let Grid { texels, opacities, .. } = match channels {
        Color::Rgb([r, g, b]) => read()
            .no_deep_data()
            .largest_resolution_level()
            .specific_channels()
            .required(r)
            .required(g)
            .required(b)
            .optional(opacity, 1.0)
            .collect_pixels(
                |size, _: &_| empty(size),
                |grid: &mut Grid, place, (r, g, b, a)| {
                    grid.set(place, [r, g, b], a);
                },
            )
            .first_valid_layer()
            .all_attributes()
            .non_parallel()
            .from_buffered(reader)
            .map(|image| image.layer_data.channel_data.pixels),
        Color::Gray(y) => read()
            .no_deep_data()
            .largest_resolution_level()
            .specific_channels()
            .required(y)
            .optional(opacity, 1.0)
            .collect_pixels(
                |size, _: &_| empty(size),
                |grid: &mut Grid, place, (y, a)| {
                    grid.set(place, [y; 3], a);
                },
            )
            .first_valid_layer()
            .all_attributes()
            .non_parallel()
            .from_buffered(reader)
            .map(|image| image.layer_data.channel_data.pixels),
    }
    .map_err(fault)?;
    Ok((EnvironmentMap::new(width, height, texels)?, opacities))
}

enum Color {
    Rgb([Text; 3]),
    Gray(Text),
}

impl Color {
    /// The channel A of the same layer, if the part has it.
    fn opacity(&self, header: &Header) -> Option<Text> {
        let (Self::Rgb([name, ..]) | Self::Gray(name)) = self;
        let name = name.to_string();
        let layer = name.rfind('.').map_or("", |dot| &name[..=dot]);
        let wanted = format!("{layer}A");
        whole_channels(header).find(|name| **name == *wanted).cloned()
    }
}

/// The names of the channels with a sample for each pixel.
fn whole_channels(header: &Header) -> impl Iterator<Item = &Text> {
    let whole = header.channels.list.iter().filter(|one| one.sampling == Vec2(1, 1));
    whole.filter(|_| !header.deep).map(|channel| &channel.name)
}

/// The color channels of one part, if it has them at full resolution.
fn color(header: &Header) -> Option<Color> {
    let names: Vec<&Text> = whole_channels(header).collect();
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
    // With RY and BY, or X and Z, Y is the luminance of a color image, not a gray map. Z alone is a
    // depth.
    let has = |name: &str| header.channels.list.iter().any(|channel| channel.name == *name);
    let colored = has("RY") || has("X");
    rgb.map(Color::Rgb).or_else(|| Some(Color::Gray(find("", "Y").filter(|_| !colored)?.clone())))
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
        "export it with the channels R, G, B, or Y alone if it is gray, one sample a pixel",
    )
}

/// Bytes of an opacity.
const BYTES_PER_OPACITY: u64 = 4;

/// Texels row by row, and their opacities or none.
struct Grid {
    width: usize,
    texels: Vec<[f32; 3]>,
    opacities: Vec<f32>,
}

impl Grid {
    fn set(&mut self, Vec2(column, row): Vec2<usize>, value: [f32; 3], opacity: f32) {
        let place = row * self.width + column;
        if let Some(texel) = self.texels.get_mut(place) {
            *texel = value;
        }
        if let Some(to) = self.opacities.get_mut(place) {
            *to = opacity;
        }
    }
}

fn fault(error: ExrError) -> Error {
    match error {
        ExrError::NotSupported(why) => Error::new(
            format!("it is of a kind that is not supported ({why})"),
            "export it as scan lines, with ZIP compression or none",
        ),
        error => broken(error),
    }
}

/// Copies of a block that the decoder makes: as stored, unpacked, and two on the way from one to
/// the other.
const COPIES: u64 = 4;

/// Bytes in which the decoder keeps the position of a block in the file.
const PLACE: u64 = 24;

/// Bytes that decoding needs in addition to the pixels.
fn bytes_beside(headers: &[Header], length: u64) -> u64 {
    let places = headers.iter().map(|header| PLACE * header.chunk_count as u64);
    let block = |header: &Header| {
        let Vec2(width, height) = header.max_block_pixel_size();
        (width as u64)
            .saturating_mul(height as u64)
            .saturating_mul(header.channels.bytes_per_pixel as u64)
    };
    let largest = headers.iter().map(block).max().unwrap_or(0);
    places
        .fold(largest.saturating_mul(COPIES), u64::saturating_add)
        .saturating_add(length.min(largest))
}

/// Checks the sizes of every part of a file of `bytes` bytes.
fn check_sizes(headers: &[Header], bytes: u64) -> Result<()> {
    for header in headers {
        let Vec2(width, height) = header.layer_size;
        believable(width, height, bytes)?;
        if let BlockDescription::Tiles(tiles) = header.blocks {
            let Vec2(width, height) = tiles.tile_size;
            if width.checked_mul(height).is_none_or(|area| area > MOST_TEXELS) {
                return Err(broken(format!("its tiles are {width} x {height}")));
            }
        }
    }
    Ok(())
}

/// Checks the counters of every DWA block.
fn check_counters(
    headers: &[Header],
    chunks: impl Iterator<Item = ExrResult<Chunk>>,
) -> Result<()> {
    for chunk in chunks {
        let chunk = chunk.map_err(broken)?;
        let Some(header) = headers.get(chunk.layer_index) else {
            continue;
        };
        let block = match &chunk.compressed_block {
            CompressedBlock::ScanLine(block) => &block.compressed_pixels_le,
            CompressedBlock::Tile(block) => &block.compressed_pixels_le,
            _ => continue,
        };
        let dwa = matches!(header.compression, Compression::DWAA(_) | Compression::DWAB(_));
        if dwa && !is_raw(header, &chunk.compressed_block, block.len())? {
            check_dwa(header, block)?;
        }
    }
    Ok(())
}

/// Whether a block of `length` bytes is stored uncompressed, without counters.
fn is_raw(header: &Header, block: &CompressedBlock, length: usize) -> Result<bool> {
    let size = header
        .get_block_data_indices(block)
        .and_then(|tile| header.get_absolute_block_pixel_coordinates(tile))
        .map_err(broken)?
        .size;
    Ok(length == size.area() * header.channels.bytes_per_pixel)
}

/// Eleven little-endian numbers: the version, the bytes of each section, packed and unpacked, the
/// numbers of coefficients, and how the coefficients are packed.
fn check_dwa(header: &Header, block: &[u8]) -> Result<()> {
    // No section unpacks to more than the pixels, padded to blocks of 8 x 8, or twice that when the
    // run lengths of noise take more space than the noise.
    let Vec2(width, height) = header.max_block_pixel_size();
    let samples = width.next_multiple_of(8) * height.next_multiple_of(8);
    let most = 2 * samples * header.channels.bytes_per_pixel.max(4);
    let (counters, _) = block.as_chunks::<8>();
    let claims = counters.iter().take(10).map(|bytes| u64::from_le_bytes(*bytes));
    match claims.max() {
        Some(largest) if largest <= most as u64 => Ok(()),
        _ => Err(broken("a DWA block claims more than it can hold")),
    }
}
