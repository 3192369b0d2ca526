//! A textured sphere as a packed object.

use crate::Result;
use eigenshade::object::{Disc, Region};
use eigenshade_table::object::{Pixel, encode};

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
