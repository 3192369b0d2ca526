//! The file of a packed object: a picture of its normals and base colors, six bytes a pixel.
//!
//! All parts but the table of rows are records of six bytes; numbers have the low byte first:
//!
//! | bytes | |
//! |---|---|
//! | 6 | `eigob` and the version, 1 |
//! | 6 | width and height in pixels, and the number of regions: 16 bits each |
//! | 6 for each region | metallic, roughness and the matte share of what the base color tints: 16 bits each, in units of 1 / 32,767 |
//! | 4 for each row, and 4 | the number of the row's first record, counted from the end of this table; the last one is the number of records |
//! | 6 for each record | of each row its runs from left to right: the first column, the number of pixels and the region, 16 bits each, then the pixels |
//!
//! A pixel is the code of its normal (u, v), its base color in sRGB (r, g, b) and its coverage of 255,
//! eight bits each. Pixels without an object have no record.

/// The bytes of a record.
pub const RECORD: usize = 6;

/// The first record of a file.
pub const MAGIC: [u8; RECORD] = *b"eigob\x01";

/// A pixel to be written.
#[cfg(feature = "alloc")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pixel {
    /// The column, from the left.
    pub column: u16,
    /// The row, from the top.
    pub row: u16,
    /// The number of its region.
    pub region: u16,
    /// Its record.
    pub record: [u8; RECORD],
}

/// The file of an object of `width` x `height` pixels with these regions. `pixels` are in the order of
/// their rows and columns, each inside of the picture and of one of the regions.
#[cfg(feature = "alloc")]
#[must_use]
pub fn encode(
    [width, height]: [u16; 2],
    regions: &[[u8; RECORD]],
    pixels: &[Pixel],
) -> alloc::vec::Vec<u8> {
    use alloc::vec::Vec;
    let words = |words: [u16; 3]| words.map(u16::to_le_bytes);
    let mut rows = Vec::new();
    let mut records: Vec<[u8; RECORD]> = Vec::new();
    for row in 0..height {
        rows.push(records.len() as u32);
        let start = pixels.partition_point(|pixel| pixel.row < row);
        let end = pixels.partition_point(|pixel| pixel.row <= row);
        let follow = |a: &Pixel, b: &Pixel| b.column == a.column + 1 && a.region == b.region;
        for run in pixels[start..end].chunk_by(follow) {
            let head = words([run[0].column, run.len() as u16, run[0].region]);
            records.push(head.as_flattened().try_into().expect("three words"));
            records.extend(run.iter().map(|pixel| pixel.record));
        }
    }
    rows.push(records.len() as u32);
    let mut bytes = MAGIC.to_vec();
    bytes.extend_from_slice(words([width, height, regions.len() as u16]).as_flattened());
    bytes.extend_from_slice(regions.as_flattened());
    rows.iter().for_each(|first| bytes.extend_from_slice(&first.to_le_bytes()));
    bytes.extend_from_slice(records.as_flattened());
    bytes
}
