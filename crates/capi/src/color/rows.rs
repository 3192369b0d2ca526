//! Rows of RGB565 pixels: a program needs memory for one of them.
#![expect(unsafe_code, reason = "memory of C")]

use super::format::{Channels, Format};
use crate::boundary::{Input, Output, Place, Plain, disjoint};
use crate::export::records;
use crate::status::Status;
use eigenshade::{Disc, Display, Rgb, blend565};

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
trait Row<F: Format>: Iterator<Item = (usize, u8, F::Normal)> {}
impl<F: Format, I: Iterator<Item = (usize, u8, F::Normal)>> Row<F> for I {}

/// An object: its width and height, and the pixels of one row.
struct Shape<I> {
    size: [usize; 2],
    row: I,
}

/// The row of a disc.
fn disc<F: Format>(diameter: usize, row: usize) -> Result<Shape<impl Row<F>>, Status> {
    if !(1..=Disc::MOST).contains(&diameter) {
        return Err(Status::Diameter);
    }
    let row = Disc::new(diameter).row(row);
    let row = row.map(|pixel| (pixel.column(), u8::MAX, F::of_disc(pixel)));
    Ok(Shape { size: [diameter; 2], row })
}

/// The row of a normal map, and where its codes lie.
fn normal_map<F: Format>(
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

/// Draws a row of an object in the light that `shade` says, once everything is checked.
fn draw<F: Format>(
    shape: Shape<impl Row<F>>,
    shade: impl Fn(F::Normal) -> Result<[F::Irradiance; 3], Status>,
    [r, g, b]: [i32; 3],
    target: &Target,
    read: &[Place],
) -> Result<(), Status> {
    let [width, height] = shape.size;
    if target.row >= height || target.length < width {
        return Err(Status::Row);
    }
    let exposure = |exponent| F::exposure(target.exposure, exponent);
    let [of_r, of_g, of_b] = [exposure(r)?, exposure(g)?, exposure(b)?];
    let display = target.display.value()?;
    let written = [target.pixels.place_of_array(target.length)?];
    disjoint(&written, read)?;
    disjoint(&written, &[Place::of(display)])?;
    // SAFETY: C promises `length` pixels, which overlap no other.
    let pixels = unsafe { target.pixels.array(target.length) }?;
    for (column, coverage, normal) in shape.row {
        let [r, g, b] = shade(normal)?;
        let color = Rgb::new(F::exposed(r, of_r), F::exposed(g, of_g), F::exposed(b, of_b));
        if let Some(pixel) = pixels.get_mut(column) {
            *pixel = blend565(*pixel, display.rgb565(color), coverage);
        }
    }
    Ok(())
}

/// The irradiance of a normal in each channel of a scene.
fn shading<F: Format>(
    Channels([r, g, b]): &Channels<F::Scene>,
) -> impl Fn(F::Normal) -> Result<[F::Irradiance; 3], Status> {
    |normal| Ok([F::shade(r, normal)?, F::shade(g, normal)?, F::shade(b, normal)?])
}

pub(crate) fn color_disc_row<F: Format>(
    scene: Input<Channels<F::Scene>>,
    diameter: usize,
    row: usize,
    exposure: f32,
    display: Input<Display>,
    pixels: Output<u16>,
    length: usize,
) -> Result<(), Status> {
    let scene = scene.value()?;
    let target = Target { row, exposure, display, pixels, length };
    let exponents = F::exponents(&scene.0);
    draw::<F>(
        disc::<F>(diameter, row)?,
        shading::<F>(scene),
        exponents,
        &target,
        &[Place::of(scene)],
    )
}

pub(crate) fn color_normal_map_row<F: Format>(
    scene: Input<Channels<F::Scene>>,
    map: Input<NormalMap>,
    row: usize,
    exposure: f32,
    display: Input<Display>,
    pixels: Output<u16>,
    length: usize,
) -> Result<(), Status> {
    let (scene, map) = (scene.value()?, map.value()?);
    let (shape, of_codes) = normal_map::<F>(map, row)?;
    let target = Target { row, exposure, display, pixels, length };
    let exponents = F::exponents(&scene.0);
    draw::<F>(
        shape,
        shading::<F>(scene),
        exponents,
        &target,
        &[Place::of(scene), Place::of(map), of_codes],
    )
}

pub(crate) fn color_baked_disc_row<F: Format>(
    baked: Input<F::Baked>,
    diameter: usize,
    row: usize,
    exposure: f32,
    display: Input<Display>,
    pixels: Output<u16>,
    length: usize,
) -> Result<(), Status> {
    let baked = baked.value()?;
    let (maps, of_texels) = F::maps(baked)?;
    let target = Target { row, exposure, display, pixels, length };
    let shade = |normal| Ok(F::look_up(&maps, normal));
    let exponents = F::exponents_of_baked(baked);
    draw::<F>(disc::<F>(diameter, row)?, shade, exponents, &target, &[Place::of(baked), of_texels])
}

pub(crate) fn color_baked_normal_map_row<F: Format>(
    baked: Input<F::Baked>,
    map: Input<NormalMap>,
    row: usize,
    exposure: f32,
    display: Input<Display>,
    pixels: Output<u16>,
    length: usize,
) -> Result<(), Status> {
    let (baked, map) = (baked.value()?, map.value()?);
    let (maps, of_texels) = F::maps(baked)?;
    let (shape, of_codes) = normal_map::<F>(map, row)?;
    let target = Target { row, exposure, display, pixels, length };
    let shade = |normal| Ok(F::look_up(&maps, normal));
    let exponents = F::exponents_of_baked(baked);
    draw::<F>(
        shape,
        shade,
        exponents,
        &target,
        &[Place::of(baked), of_texels, Place::of(map), of_codes],
    )
}
