//! Checks the claims of an OpenEXR file against its actual size before it is decoded.
//!
//! The decoder allocates whatever memory a header claims, including by tile sizes and the counters
//! of DWA blocks. A single wrong byte could end the program instead of returning an error.

use crate::light::environment::{MOST_TEXELS, believable, broken};
use eigenshade_model::error::Result;
use exr::block::chunk::{Chunk, CompressedBlock};
use exr::compression::Compression;
use exr::error::Result as ExrResult;
use exr::meta::BlockDescription;
use exr::meta::header::Header;
use exr::prelude::Vec2;

/// Copies of a block that the decoder makes: as stored, unpacked, and two on the way from one to
/// the other.
const COPIES: u64 = 4;

/// Bytes in which the decoder keeps the position of a block in the file.
const PLACE: u64 = 24;

/// Bytes that decoding needs in addition to the pixels.
pub(crate) fn blocks(headers: &[Header], length: u64) -> u64 {
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
pub(crate) fn sizes(headers: &[Header], bytes: u64) -> Result<()> {
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
pub(crate) fn counters(
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
            dwa_counters(header, block)?;
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
fn dwa_counters(header: &Header, block: &[u8]) -> Result<()> {
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
