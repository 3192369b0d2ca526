//! The functions in integers, as C sees them.
#![expect(unsafe_code, reason = "exported symbols")]

use crate::boundary::{Input, Output};
use crate::draw::{Display, draw};
use crate::linear_palette::{self, LinearPalette};
use crate::meter::{self, Meter};
use crate::nodes::Nodes;
use crate::object::{NormalMap, disc, normal_map};
use crate::packed_object::PackedObject;
use crate::palette::{self, Palette};
use crate::records_f32::{ColorLightF32, ColorMaterialF32, PictureF32};
use crate::records_q15::{
    BakedQ15, CoefficientsQ15, ColorLightQ15, ColorMaterialQ15, IrradianceQ15, LightBufferQ15,
    LightQ15, MaterialBufferQ15, MaterialQ15, PictureQ15, TransferQ15, WorkspaceQ15,
};
use crate::shadowed_object::{self, ObjectCoefficients, ShadowedObject};
use crate::sources::{Gloss, Source};
use crate::status::Status;
use crate::target::Target;
use crate::{baked, integers, picture, quantize, steps};
use eigenshade::Q15;

/// `eigenshade_project_f32` in Q15.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_project_q15(
    light: *const LightQ15,
    material: *const MaterialQ15,
    workspace: *mut WorkspaceQ15,
    coefficients: *mut CoefficientsQ15,
) -> Status {
    integers::project(&Input(light), &Input(material), &Output(workspace), &Output(coefficients))
        .into()
}

/// `eigenshade_transfer_f32` in Q15.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_transfer_q15(
    material: *const ColorMaterialQ15,
    transfer: *mut TransferQ15,
) -> Status {
    steps::transfer::<Q15>(&Input(material), &Output(transfer)).into()
}

/// `eigenshade_picture_begin_f32` in Q15. Uses 3 KB of stack.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_picture_begin_q15(
    light: *const ColorLightQ15,
    material: *const ColorMaterialQ15,
    picture: *mut PictureQ15,
) -> Status {
    picture::begin::<Q15>(&Input(light), &Input(material), &Output(picture)).into()
}

/// `eigenshade_picture_begin_glossy_f32` in Q15, partly computed in floats. Uses 9 KB of stack.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_picture_begin_glossy_q15(
    light: *const ColorLightQ15,
    material: *const ColorMaterialQ15,
    gloss: *const Gloss,
    sources: *const Source,
    count: usize,
    picture: *mut PictureQ15,
) -> Status {
    picture::begin_glossy::<Q15>(
        &Input(light),
        &Input(material),
        &Input(gloss),
        &Input(sources),
        count,
        &Output(picture),
    )
    .into()
}

/// `eigenshade_picture_relight_f32` in Q15. If the transfer is refused, the picture is as if never
/// begun.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_picture_relight_q15(
    transfer: *const TransferQ15,
    light: *const ColorLightQ15,
    picture: *mut PictureQ15,
) -> Status {
    picture::relight::<Q15>(&Input(transfer), &Input(light), &Output(picture)).into()
}

/// `eigenshade_picture_highlights_f32` in Q15, computed in floats.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_picture_highlights_q15(
    gloss: *const Gloss,
    sources: *const Source,
    count: usize,
    picture: *mut PictureQ15,
) -> Status {
    picture::highlights::<Q15>(&Input(gloss), &Input(sources), count, &Output(picture)).into()
}

/// `eigenshade_region_highlights_f32` in Q15, computed in floats.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_region_highlights_q15(
    object: *const PackedObject,
    region: usize,
    sources: *const Source,
    count: usize,
    tinted: *mut PictureQ15,
    plain: *mut PictureQ15,
) -> Status {
    picture::region_highlights::<Q15>(
        &Input(object),
        region,
        &Input(sources),
        count,
        &Output(tinted),
        &Output(plain),
    )
    .into()
}

/// `eigenshade_picture_shade_f32` in Q15: (x, y, z) has length 1, in fractions of 2^15 (1 as 2^15 -
/// 1).
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_picture_shade_q15(
    picture: *const PictureQ15,
    x: Q15,
    y: Q15,
    z: Q15,
    irradiance: *mut IrradianceQ15,
) -> Status {
    picture::open::<Q15>(&Input(picture))
        .and_then(|picture| picture::shade(picture, x, y, z, &Output(irradiance)))
        .into()
}

/// `eigenshade_picture_draw_disc_f32` in Q15. The bits of `exposure` are read in integers.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_picture_draw_disc_q15(
    picture: *const PictureQ15,
    diameter: usize,
    exposure: f32,
    display: *const Display,
    target: *const Target,
) -> Status {
    draw::<Q15>(picture::open::<Q15>(&Input(picture)), disc(diameter), exposure, display, target)
        .into()
}

/// `eigenshade_picture_draw_normal_map_f32` in Q15.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_picture_draw_normal_map_q15(
    picture: *const PictureQ15,
    map: *const NormalMap,
    exposure: f32,
    display: *const Display,
    target: *const Target,
) -> Status {
    draw::<Q15>(
        picture::open::<Q15>(&Input(picture)),
        normal_map(&Input(map)),
        exposure,
        display,
        target,
    )
    .into()
}

/// `eigenshade_palette_fill_f32` in Q15. The bits of `exposure` are read in integers.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_palette_fill_q15(
    picture: *const PictureQ15,
    exposure: f32,
    display: *const Display,
    nodes: *const Nodes,
    palette: *mut Palette,
) -> Status {
    palette::fill::<Q15>(
        &Input(picture),
        exposure,
        &Input(display),
        &Input(nodes),
        &Output(palette),
    )
    .into()
}

/// `eigenshade_linear_palette_fill_f32` in Q15. The bits of `exposure` are read in integers.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_linear_palette_fill_q15(
    tinted: *const PictureQ15,
    plain: *const PictureQ15,
    exposure: f32,
    nodes: *const Nodes,
    palette: *mut LinearPalette,
) -> Status {
    linear_palette::fill::<Q15>(
        &Input(tinted),
        &Input(plain),
        exposure,
        &Input(nodes),
        &Output(palette),
    )
    .into()
}

/// `eigenshade_shadowed_object_coefficients_f32` in Q15. Uses 3 KB of stack.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_shadowed_object_coefficients_q15(
    object: *const ShadowedObject,
    light: *const ColorLightQ15,
    coefficients: *mut ObjectCoefficients,
) -> Status {
    shadowed_object::coefficients::<Q15>(&Input(object), &Input(light), &Output(coefficients))
        .into()
}

/// `eigenshade_picture_meter_disc_row_f32` in Q15.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_picture_meter_disc_row_q15(
    picture: *const PictureQ15,
    diameter: usize,
    row: usize,
    meter: *mut Meter,
) -> Status {
    meter::count::<Q15>(picture::open::<Q15>(&Input(picture)), disc(diameter), row, &Output(meter))
        .into()
}

/// `eigenshade_picture_meter_normal_map_row_f32` in Q15.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_picture_meter_normal_map_row_q15(
    picture: *const PictureQ15,
    map: *const NormalMap,
    row: usize,
    meter: *mut Meter,
) -> Status {
    meter::count::<Q15>(
        picture::open::<Q15>(&Input(picture)),
        normal_map(&Input(map)),
        row,
        &Output(meter),
    )
    .into()
}

/// `eigenshade_picture_bake_f32` in Q15, from a picture in float.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_picture_bake_q15(
    picture: *const PictureF32,
    size: usize,
    texels: *mut i16,
    length: usize,
    baked: *mut BakedQ15,
) -> Status {
    baked::bake::<Q15>(&Input(picture), size, &Output(texels), length, &Output(baked)).into()
}

/// `eigenshade_picture_shade_q15` from a baked picture.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_baked_shade_q15(
    baked: *const BakedQ15,
    x: Q15,
    y: Q15,
    z: Q15,
    irradiance: *mut IrradianceQ15,
) -> Status {
    baked::open::<Q15>(&Input(baked))
        .and_then(|baked| picture::shade(baked, x, y, z, &Output(irradiance)))
        .into()
}

/// `eigenshade_picture_draw_disc_q15` from a baked picture.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_baked_draw_disc_q15(
    baked: *const BakedQ15,
    diameter: usize,
    exposure: f32,
    display: *const Display,
    target: *const Target,
) -> Status {
    draw::<Q15>(baked::open::<Q15>(&Input(baked)), disc(diameter), exposure, display, target).into()
}

/// `eigenshade_picture_draw_normal_map_q15` from a baked picture.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_baked_draw_normal_map_q15(
    baked: *const BakedQ15,
    map: *const NormalMap,
    exposure: f32,
    display: *const Display,
    target: *const Target,
) -> Status {
    draw::<Q15>(
        baked::open::<Q15>(&Input(baked)),
        normal_map(&Input(map)),
        exposure,
        display,
        target,
    )
    .into()
}

/// A light in Q15 from one in float, in integer arithmetic throughout.
///
/// The light is in `buffer`, and `to` points there. On an error neither may be used.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_quantize_light_q15(
    from: *const ColorLightF32,
    buffer: *mut LightBufferQ15,
    to: *mut ColorLightQ15,
) -> Status {
    quantize::quantize_light(&Input(from), &Output(buffer), &Output(to)).into()
}

/// A material in Q15 from one in float, in integer arithmetic throughout.
///
/// The material is in `buffer`, and `to` points there. On an error neither may be used.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_quantize_material_q15(
    from: *const ColorMaterialF32,
    buffer: *mut MaterialBufferQ15,
    to: *mut ColorMaterialQ15,
) -> Status {
    quantize::quantize_material(&Input(from), &Output(buffer), &Output(to)).into()
}

/// The unit normal along a vector of three integers of any scale, as three mantissas, x, y and z.
/// For a normal map of 8 bits, pass 2c - 255 for each channel c.
///
/// A vector that points away by no more than 1/8 is laid on the rim. Cost: a root and three
/// divisions in 64 bits. On an error `normal` is unchanged.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_normalize_q15(vector: *const i32, normal: *mut Q15) -> Status {
    quantize::normalize(&Input(vector), &Output(normal)).into()
}
