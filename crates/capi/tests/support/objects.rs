//! Textured spheres as packed objects, and as a C header.

use eigenshade::Error;
use eigenshade::object::{Disc, DiscPixel, Region};
use eigenshade_table::object::{Pixel, encode};
use std::fmt::Write as _;

/// A sphere of these regions in stripes, with a checkerboard of 16 base colors.
fn sphere(size: u16, regions: &[Region]) -> Result<Vec<u8>, Error> {
    let pixel = |pixel: DiscPixel| {
        let (column, row) = (pixel.column(), pixel.row());
        let number = ((column / 8 + 3 * (row / 8)) % 16) as u8;
        let [u, v] = pixel.code().bytes();
        Pixel {
            column: column as u16,
            row: row as u16,
            region: (column / 12 % regions.len()) as u16,
            record: [u, v, 16 * number, 250 - 8 * number, 160, pixel.coverage()],
        }
    };
    let pixels: Vec<Pixel> = Disc::new(size.into())?.map(pixel).collect();
    let regions: Vec<_> = regions.iter().map(|region| region.bytes()).collect();
    Ok(encode([size; 2], &regions, &pixels))
}

/// A sphere of 48 pixels across, of plastic, metal and what is between them.
pub fn striped() -> Result<Vec<u8>, Error> {
    sphere(48, &[Region::new(0.0, 0.3)?, Region::new(1.0, 0.4)?, Region::new(0.5, 0.8)?])
}

/// The sphere of plastic whose frames the runtime's counts are of.
pub fn plastic() -> Result<Vec<u8>, Error> {
    sphere(120, &[Region::new(0.0, 0.3)?])
}

/// Objects by name, as `eigenshade pack-object` writes one.
pub fn header(objects: &[(&str, Vec<u8>)]) -> String {
    let mut text = String::from("#include \"eigenshade.h\"\n");
    for (name, bytes) in objects {
        // Writing to a string cannot fail.
        let _ = write!(text, "\nstatic const uint8_t {name}_bytes[] = {{");
        for (index, byte) in bytes.iter().enumerate() {
            let _ = write!(text, "{}{byte},", if index % 24 == 0 { "\n" } else { "" });
        }
        let _ = write!(
            text,
            "\n}};\nstatic const eigenshade_object_t {name} = {{sizeof {name}_bytes, {name}_bytes}};\n"
        );
    }
    text
}

/// The header of both.
pub fn text() -> Result<String, Error> {
    Ok(header(&[("striped", striped()?), ("plastic", plastic()?)]))
}
