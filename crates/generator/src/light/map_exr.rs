//! OpenEXR maps: scan lines or tiles; half, float or integer samples; every common compression.
//!
//! The claims of a file are checked against its actual size before it is decoded. The decoder
//! allocates whatever memory a header claims, including by tile sizes and the counters of DWA
//! blocks. A single wrong byte could end the program instead of returning an error.

use crate::light::environment::{EnvironmentMap, MOST_TEXELS, believable, broken, other_type};
use crate::light::exr_layer::ExrLayer;
use crate::light::primaries::{Primaries, product};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use exr::block::UncompressedBlock;
use exr::block::chunk::{Chunk, CompressedBlock};
use exr::block::lines::LineIndex;
use exr::block::reader::ChunksReader;
use exr::compression::Compression;
use exr::error::{Error as ExrError, Result as ExrResult};
use exr::meta::BlockDescription;
use exr::meta::attribute::{Chromaticities, EnvironmentMap as Stated, IntegerBounds, SampleType};
use exr::meta::header::Header;
use exr::prelude::{Vec2, f16};
use std::fs::File;
use std::io::{BufRead, BufReader, Seek};

/// A file's picture.
pub(crate) struct Decoded {
    pub(crate) map: EnvironmentMap,
    /// The opacity of each pixel, by which the file has multiplied its color: none if they are not
    /// needed or there is no channel A.
    pub(crate) opacities: Vec<f32>,
    /// The projection that its attribute `envmap` states.
    pub(crate) projection: Option<Stated>,
}

/// Decodes one layer of an OpenEXR file, see [`ExrLayer::of`], with `needs_opacity` also its
/// opacity. Colors of other primaries are converted to linear sRGB, with a warning.
pub(crate) fn decode(
    reader: &mut BufReader<File>,
    length: u64,
    file: &InputFile,
    needs_opacity: bool,
) -> Result<Decoded> {
    let io = |error: std::io::Error| Error::io(file.path(), &error);
    if !reader.fill_buf().map_err(io)?.starts_with(&[0x76, 0x2f, 0x31, 0x01]) {
        return Err(other_type("OpenEXR"));
    }
    let parts = exr::block::read(&mut *reader, false).map_err(fault)?;
    let headers = parts.meta_data().headers.clone();
    check_sizes(&headers, length)?;
    let layer = ExrLayer::of(&headers, file)?;
    let header = &headers[layer.part];
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
    let has_opacities = needs_opacity && layer.opacity.is_some();
    check_counters(&headers, parts.all_chunks(false).map_err(fault)?)?;
    reader.rewind().map_err(io)?;
    let mut grid = Grid {
        width,
        texels: vec![[0.0; 3]; count],
        opacities: if has_opacities { vec![1.0; count] } else { Vec::new() },
        is_transparent: false,
    };
    let parts = exr::block::read(&mut *reader, false).map_err(fault)?;
    let chunks = parts
        .filter_chunks(false, |_, _, block| (block.layer, block.level) == (layer.part, Vec2(0, 0)))
        .map_err(fault)?;
    let mut blocks = chunks.sequential_decompressor(false);
    while let Some(block) = blocks.decompress_next_block() {
        grid.fill(&layer, header, &block.map_err(fault)?)?;
    }
    let Grid { mut texels, opacities, is_transparent, .. } = grid;
    if is_transparent && !needs_opacity {
        file.warn("its opacity (channel A) is ignored");
    }
    if let Some(stated) = header.shared_attributes.chromaticities {
        convert(&mut texels, stated, file);
    }
    let projection = header.own_attributes.environment_map;
    Ok(Decoded { map: EnvironmentMap::new(width, height, texels)?, opacities, projection })
}

/// Converts colors to linear sRGB.
fn convert(texels: &mut [[f32; 3]], stated: Chromaticities, file: &InputFile) {
    let Chromaticities { red, green, blue, white } = stated;
    let list = [red, green, blue, white].map(|Vec2(x, y)| [x, y].map(f64::from));
    let [rgb @ .., white] = list;
    let primaries = Primaries { rgb, white };
    if primaries.is_srgb() {
        return;
    }
    let text = list.map(|[x, y]| format!("({x:.4}, {y:.4})")).join(" ");
    let Some(matrix) = primaries.to_srgb() else {
        file.warn(format!("its chromaticities, {text}, are no primaries: nothing is converted"));
        return;
    };
    file.warn(format!(
        "its chromaticities, {text}, are not those of sRGB: its colors are converted"
    ));
    for texel in texels {
        *texel = product(&matrix, texel.map(f64::from)).map(|value| value as f32);
    }
}

/// Texels row by row, and their opacities or none.
struct Grid {
    width: usize,
    texels: Vec<[f32; 3]>,
    opacities: Vec<f32>,
    is_transparent: bool,
}

impl Grid {
    /// Takes the samples of a block.
    fn fill(&mut self, layer: &ExrLayer, header: &Header, block: &UncompressedBlock) -> Result<()> {
        for (bytes, line) in LineIndex::lines_in_block(block.index, &header.channels) {
            let is_color = layer.color.contains(&line.channel);
            let is_opacity = layer.opacity == Some(line.channel);
            if !is_color && !is_opacity {
                continue;
            }
            let kind = header.channels.list[line.channel].sample_type;
            let bytes = block.data.get(bytes).ok_or_else(|| broken("a block is too short"))?;
            let start = line.position.y() * self.width + line.position.x();
            for (place, value) in (start..).zip(samples(kind, bytes)) {
                if let Some(texel) = self.texels.get_mut(place) {
                    for (to, channel) in texel.iter_mut().zip(layer.color) {
                        if channel == line.channel {
                            *to = value;
                        }
                    }
                }
                if is_opacity {
                    self.is_transparent |= value < 1.0;
                    if let Some(to) = self.opacities.get_mut(place) {
                        *to = value;
                    }
                }
            }
        }
        Ok(())
    }
}

/// The numbers of a line, in the byte order of this machine.
fn samples(kind: SampleType, bytes: &[u8]) -> Vec<f32> {
    match kind {
        SampleType::F16 => {
            let halves = bytes.as_chunks::<2>().0.iter();
            halves.map(|half| f16::from_ne_bytes(*half).to_f32()).collect()
        }
        SampleType::F32 => {
            bytes.as_chunks::<4>().0.iter().map(|float| f32::from_ne_bytes(*float)).collect()
        }
        SampleType::U32 => {
            let numbers = bytes.as_chunks::<4>().0.iter();
            numbers.map(|number| u32::from_ne_bytes(*number) as f32).collect()
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

/// The most bytes of an unpacked block, of which the decoder makes four copies.
const MOST_BYTES_PER_BLOCK: u64 = 1 << 28;

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
        let Vec2(width, height) = header.max_block_pixel_size();
        let block = width as u64 * height as u64 * header.channels.bytes_per_pixel as u64;
        if block > MOST_BYTES_PER_BLOCK {
            let what = format!("a block of it has {block} bytes, too many to read");
            return Err(Error::new(what, "export it as scan lines, without other layers"));
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
