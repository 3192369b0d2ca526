//! Rows of RGB565 pixels: a program needs memory for one of them.
#![expect(unsafe_code, reason = "memory of C")]

use super::format::Format;
use super::picture::{Opened, Picture, Shade};
use crate::boundary::{Input, Output, Place, Plain, disjoint};
use crate::export::records;
use crate::status::Status;
use eigenshade::{Disc, Display, Linear, Rgb, blend565};

records! {
    NormalMap = "normal_map": width: usize, height: usize, length: usize, codes: Input<u8>;
}

/// Where to draw, and how bright.
struct Target {
    row: usize,
    exposure: f32,
    display: Input<Display>,
    pixels: Output<u16>,
    length: usize,
}

/// The pixels of a row: column, coverage and normal.
pub(crate) trait Row<F: Format>: Iterator<Item = (usize, u8, F::Normal)> {}
impl<F: Format, I: Iterator<Item = (usize, u8, F::Normal)>> Row<F> for I {}

/// An object: its width and height, and the pixels of one row.
pub(crate) struct Shape<I> {
    pub(crate) size: [usize; 2],
    pub(crate) row: I,
}

/// The row of a disc.
pub(crate) fn disc<F: Format>(diameter: usize, row: usize) -> Result<Shape<impl Row<F>>, Status> {
    let row = Disc::new(diameter).map_err(|_| Status::Diameter)?.row(row);
    let row = row.map(|pixel| (pixel.column(), u8::MAX, F::of_disc(pixel)));
    Ok(Shape { size: [diameter; 2], row })
}

/// The row of a normal map, and where its codes lie.
pub(crate) fn normal_map<F: Format>(
    map: &NormalMap,
    row: usize,
) -> Result<(Shape<impl Row<F>>, Place), Status> {
    // SAFETY: C promises `length` bytes.
    let codes = unsafe { map.codes.array(map.length) }?;
    let found = eigenshade::NormalMap::new(map.width, map.height, codes);
    let row = found.map_err(|_| Status::NormalMap)?.row(row);
    let row = row.map(|pixel| (pixel.column(), pixel.coverage(), F::of_normal_map(pixel)));
    Ok((Shape { size: [map.width, map.height], row }, Place::of(codes)))
}

/// What shades and exposes a normal.
#[inline]
pub(crate) fn exposing<F: Format>(
    picture: &Opened<impl Shade<F>>,
    exposure: f32,
) -> Result<impl Fn(F::Normal) -> Result<Rgb<Linear>, Status>, Status> {
    let exposure = |exponent| F::exposure(exposure, exponent);
    let [r, g, b] = picture.exponents;
    let [of_r, of_g, of_b] = [exposure(r)?, exposure(g)?, exposure(b)?];
    Ok(move |normal| {
        let [r, g, b] = (picture.shade)(normal)?;
        Ok(Rgb::new(F::exposed(r, of_r), F::exposed(g, of_g), F::exposed(b, of_b)))
    })
}

/// Draws a row of an object, once everything is checked.
fn draw<F: Format>(
    shape: Shape<impl Row<F>>,
    picture: &Opened<impl Shade<F>>,
    target: &Target,
    read: &[Place],
) -> Result<(), Status> {
    let [width, height] = shape.size;
    if target.row >= height || target.length < width {
        return Err(Status::Row);
    }
    let exposed = exposing::<F>(picture, target.exposure)?;
    let display = target.display.value()?;
    let written = [target.pixels.place_of_array(target.length)?];
    disjoint(&written, read)?;
    disjoint(&written, &picture.places)?;
    disjoint(&written, &[Place::of(display)])?;
    // SAFETY: C promises `length` pixels, which overlap no other.
    let pixels = unsafe { target.pixels.array(target.length) }?;
    for (column, coverage, normal) in shape.row {
        let color = exposed(normal)?;
        if let Some(pixel) = pixels.get_mut(column) {
            *pixel = blend565(*pixel, display.rgb565(color), coverage);
        }
    }
    Ok(())
}

pub(crate) fn color_disc_row<F: Format>(
    picture: Input<impl Picture<F>>,
    diameter: usize,
    row: usize,
    exposure: f32,
    display: Input<Display>,
    pixels: Output<u16>,
    length: usize,
) -> Result<(), Status> {
    let target = Target { row, exposure, display, pixels, length };
    let picture = picture.value()?.open()?;
    draw::<F>(disc::<F>(diameter, row)?, &picture, &target, &[])
}

pub(crate) fn color_normal_map_row<F: Format>(
    picture: Input<impl Picture<F>>,
    map: Input<NormalMap>,
    row: usize,
    exposure: f32,
    display: Input<Display>,
    pixels: Output<u16>,
    length: usize,
) -> Result<(), Status> {
    let target = Target { row, exposure, display, pixels, length };
    let (picture, map) = (picture.value()?.open()?, map.value()?);
    let (shape, of_codes) = normal_map::<F>(map, row)?;
    draw::<F>(shape, &picture, &target, &[Place::of(map), of_codes])
}
