//! The functions in float, as C sees them.
#![expect(unsafe_code, reason = "exported symbols")]

use crate::boundary::{Input, Output};
use crate::draw::{Display, draw};
use crate::linear_palette::{self, LinearPalette};
use crate::meter::{self, Meter};
use crate::nodes::Nodes;
use crate::object::{NormalMap, disc, normal_map};
use crate::packed_object::PackedObject;
use crate::palette::{self, Palette};
use crate::records_f32::{
    BakedF32, CoefficientsF32, ColorLightF32, ColorMaterialF32, IrradianceF32, LightF32,
    MaterialF32, PictureF32, TransferF32, WorkspaceF32,
};
use crate::shadowed_object::{self, ObjectCoefficients, ShadowedObject};
use crate::sources::{Gloss, Source};
use crate::status::Status;
use crate::target::Target;
use crate::{baked, float, picture, steps};

/// The coefficients d of a light on a material in one channel, as numbers.
///
/// Cost: a multiplication for each of the table's factors. On an error `coefficients` is unchanged.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_project_f32(
    light: *const LightF32,
    material: *const MaterialF32,
    workspace: *mut WorkspaceF32,
    coefficients: *mut CoefficientsF32,
) -> Status {
    float::project(&Input(light), &Input(material), &Output(workspace), &Output(coefficients))
        .into()
}

/// The transfer of a material, for any number of lights. A gray material takes the computation of
/// one channel.
///
/// On an error `transfer` is unchanged.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_transfer_f32(
    material: *const ColorMaterialF32,
    transfer: *mut TransferF32,
) -> Status {
    steps::transfer::<f32>(&Input(material), &Output(transfer)).into()
}

/// Begins the picture of a material under a light: computes all that its pixels have in common.
///
/// Uses 5 KB of stack. On an error `picture` is unchanged.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_picture_begin_f32(
    light: *const ColorLightF32,
    material: *const ColorMaterialF32,
    picture: *mut PictureF32,
) -> Status {
    picture::begin::<f32>(&Input(light), &Input(material), &Output(picture)).into()
}

/// Begins the picture of a glossy material under a light with `count` small sources, at most
/// EIGENSHADE_SOURCES: they are taken out of the light, and become sharp highlights. If `count` is
/// 0, `sources` is not read.
///
/// Uses 8 KB of stack. On an error `picture` is unchanged.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_picture_begin_glossy_f32(
    light: *const ColorLightF32,
    material: *const ColorMaterialF32,
    gloss: *const Gloss,
    sources: *const Source,
    count: usize,
    picture: *mut PictureF32,
) -> Status {
    picture::begin_glossy::<f32>(
        &Input(light),
        &Input(material),
        &Input(gloss),
        &Input(sources),
        count,
        &Output(picture),
    )
    .into()
}

/// Begins the picture of a transferred material under a new light, without highlights.
///
/// On an error `picture` is unchanged.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_picture_relight_f32(
    transfer: *const TransferF32,
    light: *const ColorLightF32,
    picture: *mut PictureF32,
) -> Status {
    picture::relight::<f32>(&Input(transfer), &Input(light), &Output(picture)).into()
}

/// Gives a picture the highlights of `count` sources, at most EIGENSHADE_SOURCES, in place of any
/// earlier highlights. The picture's light has to be without these sources, as
/// `eigenshade_residual_f32` makes it. Where a light turns, turn the residual and the sources.
///
/// On an error `picture` has no highlights, or is unchanged.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_picture_highlights_f32(
    gloss: *const Gloss,
    sources: *const Source,
    count: usize,
    picture: *mut PictureF32,
) -> Status {
    picture::highlights::<f32>(&Input(gloss), &Input(sources), count, &Output(picture)).into()
}

/// Gives the pictures of both parts of a region the highlights of `count` sources, as
/// `eigenshade_picture_highlights_f32` does for a gloss.
///
/// On an error the pictures have no highlights, or are unchanged.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_region_highlights_f32(
    object: *const PackedObject,
    region: usize,
    sources: *const Source,
    count: usize,
    tinted: *mut PictureF32,
    plain: *mut PictureF32,
) -> Status {
    picture::region_highlights::<f32>(
        &Input(object),
        region,
        &Input(sources),
        count,
        &Output(tinted),
        &Output(plain),
    )
    .into()
}

/// The irradiance of the normal along (x, y, z).
///
/// The normal may have any length from 1e-9 to 1e9; it is scaled, which costs a root. A normal that
/// points away by no more than 1/8 is laid on the rim. On an error `irradiance` is unchanged.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_picture_shade_f32(
    picture: *const PictureF32,
    x: f32,
    y: f32,
    z: f32,
    irradiance: *mut IrradianceF32,
) -> Status {
    picture::open::<f32>(&Input(picture))
        .and_then(|picture| picture::shade(picture, x, y, z, &Output(irradiance)))
        .into()
}

/// Draws a sphere that fills a square of `diameter` x `diameter` pixels, 1 to 4096, every pixel
/// shaded. `exposure` is a number above 0 that multiplies the irradiance.
///
/// On an error no pixel is changed. To draw the same picture many times a second, fill a palette.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_picture_draw_disc_f32(
    picture: *const PictureF32,
    diameter: usize,
    exposure: f32,
    display: *const Display,
    target: *const Target,
) -> Status {
    draw::<f32>(picture::open::<f32>(&Input(picture)), disc(diameter), exposure, display, target)
        .into()
}

/// `eigenshade_picture_draw_disc_f32` of the object of a normal map.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_picture_draw_normal_map_f32(
    picture: *const PictureF32,
    map: *const NormalMap,
    exposure: f32,
    display: *const Display,
    target: *const Target,
) -> Status {
    draw::<f32>(
        picture::open::<f32>(&Input(picture)),
        normal_map(&Input(map)),
        exposure,
        display,
        target,
    )
    .into()
}

/// Shades a picture, with its highlights, at the nodes of a palette: at those of an object, or at
/// all 921 if `nodes` is NULL. Draw from it any number of objects by `eigenshade_palette_draw`.
///
/// The nodes of others stay as they are, and on an error all of them; in the first call they
/// become black. A picture drawn from it differs by CIEDE2000 0.36 in the median from one with every
/// pixel shaded, more in highlights narrower than 5.7 degrees.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_palette_fill_f32(
    picture: *const PictureF32,
    exposure: f32,
    display: *const Display,
    nodes: *const Nodes,
    palette: *mut Palette,
) -> Status {
    palette::fill::<f32>(
        &Input(picture),
        exposure,
        &Input(display),
        &Input(nodes),
        &Output(palette),
    )
    .into()
}

/// Shades the pictures of both parts of a region, with their highlights, at the nodes of a linear
/// palette: at those of the region, or at all 921 if `nodes` is NULL. Begin the pictures of the
/// materials that `eigenshade_region_materials_f32` writes.
///
/// The nodes of others stay as they are, and on an error all of them; in the first call they
/// become black.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_linear_palette_fill_f32(
    tinted: *const PictureF32,
    plain: *const PictureF32,
    exposure: f32,
    nodes: *const Nodes,
    palette: *mut LinearPalette,
) -> Status {
    linear_palette::fill::<f32>(
        &Input(tinted),
        &Input(plain),
        exposure,
        &Input(nodes),
        &Output(palette),
    )
    .into()
}

/// The coefficients of an object with shadows under a light, whose degree is at most that of the object.
///
/// On an error `coefficients` is unchanged.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_shadowed_object_coefficients_f32(
    object: *const ShadowedObject,
    light: *const ColorLightF32,
    coefficients: *mut ObjectCoefficients,
) -> Status {
    shadowed_object::coefficients::<f32>(&Input(object), &Input(light), &Output(coefficients))
        .into()
}

/// Counts the pixels of one row of a sphere, to meter the exposure of its picture. Row 0 is the
/// top. Every fourth row of a small sphere will do.
///
/// On an error `meter` is unchanged.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_picture_meter_disc_row_f32(
    picture: *const PictureF32,
    diameter: usize,
    row: usize,
    meter: *mut Meter,
) -> Status {
    meter::count::<f32>(picture::open::<f32>(&Input(picture)), disc(diameter), row, &Output(meter))
        .into()
}

/// `eigenshade_picture_meter_disc_row_f32` of the object of a normal map.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_picture_meter_normal_map_row_f32(
    picture: *const PictureF32,
    map: *const NormalMap,
    row: usize,
    meter: *mut Meter,
) -> Status {
    meter::count::<f32>(
        picture::open::<f32>(&Input(picture)),
        normal_map(&Input(map)),
        row,
        &Output(meter),
    )
    .into()
}

/// Bakes a picture without highlights into maps of `size` x `size` texels, 2 to 4096. `length` is
/// 3 * size * size.
///
/// A look-up costs less than a pixel of the picture and is less exact, as docs/method.md lists by
/// size. The texels are in `texels`, and `baked` points there. On an error neither may be used.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_picture_bake_f32(
    picture: *const PictureF32,
    size: usize,
    texels: *mut f32,
    length: usize,
    baked: *mut BakedF32,
) -> Status {
    baked::bake::<f32>(&Input(picture), size, &Output(texels), length, &Output(baked)).into()
}

/// `eigenshade_picture_shade_f32` from a baked picture.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_baked_shade_f32(
    baked: *const BakedF32,
    x: f32,
    y: f32,
    z: f32,
    irradiance: *mut IrradianceF32,
) -> Status {
    baked::open::<f32>(&Input(baked))
        .and_then(|baked| picture::shade(baked, x, y, z, &Output(irradiance)))
        .into()
}

/// `eigenshade_picture_draw_disc_f32` from a baked picture.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_baked_draw_disc_f32(
    baked: *const BakedF32,
    diameter: usize,
    exposure: f32,
    display: *const Display,
    target: *const Target,
) -> Status {
    draw::<f32>(baked::open::<f32>(&Input(baked)), disc(diameter), exposure, display, target).into()
}

/// `eigenshade_picture_draw_normal_map_f32` from a baked picture.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_baked_draw_normal_map_f32(
    baked: *const BakedF32,
    map: *const NormalMap,
    exposure: f32,
    display: *const Display,
    target: *const Target,
) -> Status {
    draw::<f32>(
        baked::open::<f32>(&Input(baked)),
        normal_map(&Input(map)),
        exposure,
        display,
        target,
    )
    .into()
}
