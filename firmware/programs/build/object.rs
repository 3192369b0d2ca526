//! The codes of a sphere, a textured one as a packed object, and the file of an object with shadows.

use crate::Result;
use eigenshade::object::{Disc, NormalMap, Region};
use eigenshade_table::object::{Pixel, encode};
use eigenshade_table::shadowed;

/// The codes of a sphere. The compiler takes seconds to compute them.
pub fn ball(size: usize) -> Result<Vec<u8>> {
    let mut codes = vec![NormalMap::BACKGROUND; size * size];
    NormalMap::sphere(size, &mut codes).map_err(|error| error.to_string())?;
    Ok(codes.into_flattened())
}

/// A sphere of glossy plastic, with a checkerboard of 16 base colors.
pub fn sphere(size: u16) -> Result<Vec<u8>> {
    let fault = |error: eigenshade::Error| error.to_string();
    let region = Region::new(0.0, 0.3).map_err(fault)?;
    let disc = Disc::new(size.into()).map_err(fault)?;
    let pixel = |pixel: eigenshade::object::DiscPixel| {
        let (column, row) = (pixel.column(), pixel.row());
        let number = ((column / 8 + 3 * (row / 8)) % 16) as u8;
        let [u, v] = pixel.code().bytes();
        let record = [u, v, 16 * number, 250 - 8 * number, 160, pixel.coverage()];
        Pixel { column: column as u16, row: row as u16, region: 0, record }
    };
    Ok(encode([size; 2], &[region.bytes()], &disc.map(pixel).collect::<Vec<_>>()))
}

/// A disc of 96 x 96 pixels with as many codes, clusters and components as `pack-object --shadows`
/// gives a gray object. Its numbers are any: counts do not depend on them.
pub fn shadowed() -> Result<Vec<u8>> {
    const RANK: usize = 64;
    let mut state = 1_u32;
    let mut next = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 16) as u16
    };
    let mut cluster = || shadowed::Cluster {
        mean: (-14, (0..RANK).map(|_| next().cast_signed() / 4).collect()),
        images: (0..8).map(|_| (-14, (0..RANK).map(|_| next() as i8).collect())).collect(),
        weights: (0..128).map(|_| (0..8).map(|_| next() as i8).collect()).collect(),
    };
    let clusters = (0..32).map(|_| cluster()).collect();
    let row = |_| shadowed::Row {
        exponent: -12,
        shifts: vec![0; 17],
        mantissas: (0..289).map(|_| next() as i8).collect(),
    };
    let rows = vec![(0..RANK).map(row).collect()];
    let disc = Disc::new(96).map_err(|error| error.to_string())?;
    let pixels = disc.map(|pixel| shadowed::Pixel {
        column: pixel.column() as u16,
        row: pixel.row() as u16,
        code: next() % 4096,
        coverage: pixel.coverage(),
    });
    let pixels = pixels.collect();
    let shares = vec![[i16::MAX; 3]];
    Ok(shadowed::File { size: [96; 2], degree: 16, shares, rows, clusters, pixels, tints: vec![] }
        .encode())
}
