//! The functions that change lights and materials, in integers, as C sees them.
#![expect(unsafe_code, reason = "exported symbols")]

use crate::boundary::{Input, Output};
use crate::packed_object::PackedObject;
use crate::records_q15::{ColorLightQ15, ColorMaterialQ15, LightBufferQ15, MaterialBufferQ15};
use crate::sources::Source;
use crate::status::Status;
use crate::{effects, packed_object, steps};
use eigenshade::Q15;

/// `eigenshade_turn_f32` in Q15. The quaternion may have any scale. Uses 3 KB of stack.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_turn_q15(
    from: *const ColorLightQ15,
    quaternion: *const i32,
    buffer: *mut LightBufferQ15,
    to: *mut ColorLightQ15,
) -> Status {
    steps::turn::<Q15>(&Input(from), &Input(quaternion), &Output(buffer), &Output(to)).into()
}

/// `eigenshade_turn_about_view_f32` in Q15. Cosine and sine may have any scale.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_turn_about_view_q15(
    from: *const ColorLightQ15,
    cosine_and_sine: *const i32,
    buffer: *mut LightBufferQ15,
    to: *mut ColorLightQ15,
) -> Status {
    steps::turn_about_view::<Q15>(
        &Input(from),
        &Input(cosine_and_sine),
        &Output(buffer),
        &Output(to),
    )
    .into()
}

/// `eigenshade_residual_f32` in Q15, computed in floats.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_residual_q15(
    from: *const ColorLightQ15,
    sources: *const Source,
    count: usize,
    buffer: *mut LightBufferQ15,
    to: *mut ColorLightQ15,
) -> Status {
    steps::residual::<Q15>(&Input(from), &Input(sources), count, &Output(buffer), &Output(to))
        .into()
}

/// `eigenshade_mask_light_f32` in Q15.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_mask_light_q15(
    from: *const ColorLightQ15,
    effect: i32,
    buffer: *mut LightBufferQ15,
    to: *mut ColorLightQ15,
) -> Status {
    effects::mask_light::<Q15>(&Input(from), effect, &Output(buffer), &Output(to)).into()
}

/// `eigenshade_mask_material_f32` in Q15.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_mask_material_q15(
    from: *const ColorMaterialQ15,
    effect: i32,
    buffer: *mut MaterialBufferQ15,
    to: *mut ColorMaterialQ15,
) -> Status {
    effects::mask_material::<Q15>(&Input(from), effect, &Output(buffer), &Output(to)).into()
}

/// `eigenshade_metallic_roughness_f32` in Q15, in which 1 is 32767.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_metallic_roughness_q15(
    base_color: *const Q15,
    metallic: Q15,
    roughness: Q15,
    buffer: *mut MaterialBufferQ15,
    to: *mut ColorMaterialQ15,
) -> Status {
    steps::metallic_roughness::<Q15>(
        &Input(base_color),
        metallic,
        roughness,
        &Output(buffer),
        &Output(to),
    )
    .into()
}

/// `eigenshade_region_materials_f32` in Q15.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_region_materials_q15(
    object: *const PackedObject,
    region: usize,
    buffer: *mut MaterialBufferQ15,
    tinted: *mut ColorMaterialQ15,
    plain: *mut ColorMaterialQ15,
) -> Status {
    packed_object::materials::<Q15>(
        &Input(object),
        region,
        &Output(buffer),
        &Output(tinted),
        &Output(plain),
    )
    .into()
}
