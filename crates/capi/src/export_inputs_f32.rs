//! The functions that change lights and materials, in float, as C sees them.
#![expect(unsafe_code, reason = "exported symbols")]

use crate::boundary::{Input, Output};
use crate::packed_object::PackedObject;
use crate::records_f32::{ColorLightF32, ColorMaterialF32, LightBufferF32, MaterialBufferF32};
use crate::sources::Source;
use crate::status::Status;
use crate::{effects, packed_object, steps};

/// A light, of degree 12 at most, turned by the rotation of a quaternion (x, y, z, w):
/// L'(R v) = L(v) for every direction v.
///
/// The turned light is in `buffer`, and `to` points there. Uses 6 KB of stack. On an error neither
/// may be used.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_turn_f32(
    from: *const ColorLightF32,
    quaternion: *const f32,
    buffer: *mut LightBufferF32,
    to: *mut ColorLightF32,
) -> Status {
    steps::turn::<f32>(&Input(from), &Input(quaternion), &Output(buffer), &Output(to)).into()
}

/// A light turned about the view axis, from x toward y, by an angle, given by its cosine and sine:
/// much cheaper than any other axis. The squares of cosine and sine sum to 1 to within 2 %; both
/// are scaled.
///
/// The turned light is in `buffer`, and `to` points there. On an error neither may be used.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_turn_about_view_f32(
    from: *const ColorLightF32,
    cosine_and_sine: *const f32,
    buffer: *mut LightBufferF32,
    to: *mut ColorLightF32,
) -> Status {
    steps::turn_about_view::<f32>(
        &Input(from),
        &Input(cosine_and_sine),
        &Output(buffer),
        &Output(to),
    )
    .into()
}

/// A light without `count` sources, at most EIGENSHADE_SOURCES.
///
/// The light is in `buffer`, and `to` points there. On an error neither may be used.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_residual_f32(
    from: *const ColorLightF32,
    sources: *const Source,
    count: usize,
    buffer: *mut LightBufferF32,
    to: *mut ColorLightF32,
) -> Status {
    steps::residual::<f32>(&Input(from), &Input(sources), count, &Output(buffer), &Output(to))
        .into()
}

/// A light with only its coefficients of an effect, which is one of `eigenshade_effect`; the others
/// are zero. Mask the material for the same effect.
///
/// The light is in `buffer`, and `to` points there. On an error neither may be used.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_mask_light_f32(
    from: *const ColorLightF32,
    effect: i32,
    buffer: *mut LightBufferF32,
    to: *mut ColorLightF32,
) -> Status {
    effects::mask_light::<f32>(&Input(from), effect, &Output(buffer), &Output(to)).into()
}

/// A material with only its coefficients of an effect, which is one of `eigenshade_effect`; the
/// others are zero. Mask the light for the same effect.
///
/// The material is in `buffer`, and `to` points there. On an error neither may be used.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_mask_material_f32(
    from: *const ColorMaterialF32,
    effect: i32,
    buffer: *mut MaterialBufferF32,
    to: *mut ColorMaterialF32,
) -> Status {
    effects::mask_material::<f32>(&Input(from), effect, &Output(buffer), &Output(to)).into()
}

/// A glTF material from its linear base color, metallic and roughness, all from 0 to 1.
///
/// A roughness below 0.2 is drawn as 0.2. The table's order has to be 7 or more. The material is in
/// `buffer`, and `to` points there. On an error neither may be used.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_metallic_roughness_f32(
    base_color: *const f32,
    metallic: f32,
    roughness: f32,
    buffer: *mut MaterialBufferF32,
    to: *mut ColorMaterialF32,
) -> Status {
    steps::metallic_roughness::<f32>(
        &Input(base_color),
        metallic,
        roughness,
        &Output(buffer),
        &Output(to),
    )
    .into()
}

/// The two materials of a region of a textured object: the irradiance of a pixel is its base color
/// times the irradiance of the tinted part, plus that of the plain part. Both are gray.
///
/// The table's order has to be 7 or more. Both are in `buffer`, and `tinted` and `plain` point there.
/// On an error none of them may be used.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_region_materials_f32(
    object: *const PackedObject,
    region: usize,
    buffer: *mut MaterialBufferF32,
    tinted: *mut ColorMaterialF32,
    plain: *mut ColorMaterialF32,
) -> Status {
    packed_object::materials::<f32>(
        &Input(object),
        region,
        &Output(buffer),
        &Output(tinted),
        &Output(plain),
    )
    .into()
}
