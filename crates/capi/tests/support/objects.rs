//! Textured spheres and an object with shadows as packed objects, and as a C header.

use eigenshade::Error;
use eigenshade::object::{Disc, DiscPixel, Region};
use eigenshade_table::object::{Pixel, encode};
use eigenshade_table::{light, shadowed};
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

/// An object with shadows of 48 pixels across: 40 codes in two clusters.
pub fn shaded() -> Result<Vec<u8>, Error> {
    shadowed(48, 20, 4, &[15, 25])
}

/// An object with shadows of 96 pixels across and 4,096 codes.
fn relief() -> Result<Vec<u8>, Error> {
    shadowed(96, 64, 8, &[64; 64])
}

/// A disc of pseudo-random numbers, of a rank and a number of images, with `codes` codes in each cluster.
fn shadowed(size: u16, rank: usize, images: usize, codes: &[usize]) -> Result<Vec<u8>, Error> {
    let mut state = 1_u32;
    let mut number = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 16) as i16
    };
    let mut row = || {
        let of_light =
            (0..light::count(9)).map(|k| (number() >> if k == 0 { 9 } else { 11 }) as i8);
        shadowed::Row { exponent: -12, shifts: vec![0; 10], mantissas: of_light.collect() }
    };
    let rows = vec![(0..rank).map(|_| row()).collect()];
    let clusters = codes.iter().zip([-14, -15].into_iter().cycle()).map(|(&codes, exponent)| {
        shadowed::Cluster {
            mean: (exponent, (0..rank).map(|_| number()).collect()),
            images: (0..images)
                .map(|_| (exponent, (0..rank).map(|_| number() as i8).collect()))
                .collect(),
            weights: (0..codes).map(|_| (0..images).map(|_| number() as i8).collect()).collect(),
        }
    });
    let clusters: Vec<_> = clusters.collect();
    let codes: usize = codes.iter().sum();
    let pixel = |pixel: DiscPixel| shadowed::Pixel {
        column: pixel.column() as u16,
        row: pixel.row() as u16,
        code: ((pixel.column() / 3 + 5 * (pixel.row() / 4)) % codes) as u16,
        coverage: pixel.coverage(),
    };
    let file = shadowed::File {
        size: [size; 2],
        degree: 9,
        shares: vec![[32_767, 20_000, 9_000]],
        rows,
        clusters,
        pixels: Disc::new(size.into())?.map(pixel).collect(),
        tints: vec![],
    };
    Ok(file.encode())
}

/// Objects by type and name, as `eigenshade pack-object` writes one.
pub fn header(objects: &[(&str, &str, Vec<u8>)]) -> String {
    let mut text = String::from("#include \"eigenshade.h\"\n");
    for (kind, name, bytes) in objects {
        // Writing to a string cannot fail.
        let _ = write!(text, "\nstatic const uint8_t {name}_bytes[] = {{");
        for (index, byte) in bytes.iter().enumerate() {
            let _ = write!(text, "{}{byte},", if index % 24 == 0 { "\n" } else { "" });
        }
        let _ = write!(
            text,
            "\n}};\nstatic const {kind} {name} = {{sizeof {name}_bytes, {name}_bytes}};\n"
        );
    }
    text
}

/// The header of all.
pub fn text() -> Result<String, Error> {
    Ok(header(&[
        ("eigenshade_object_t", "striped", striped()?),
        ("eigenshade_object_t", "plastic", plastic()?),
        ("eigenshade_shadowed_object_t", "shaded", shaded()?),
        ("eigenshade_shadowed_object_t", "relief", relief()?),
    ]))
}
