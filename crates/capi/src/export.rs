//! The functions that both formats share, as C sees them.
#![expect(unsafe_code, reason = "exported symbols")]

use crate::boundary::{Input, Output};
use crate::constants::TABLE;
use crate::draw::Display;
use crate::linear_palette::{self, LinearPalette};
use crate::meter::{self, Meter};
use crate::nodes::{self, Nodes};
use crate::object::{self, NormalMap};
use crate::packed_object::{self, ObjectHeader, PackedObject};
use crate::palette::{self, Palette};
use crate::shadowed_object::{self, ObjectCoefficients, ShadowedObject, ShadowedObjectHeader};
use crate::sources::{self, Gloss, Source};
use crate::status::{Status, message};
use crate::target::Target;
use core::ffi::{c_char, c_void};

/// The library's version, a static string: compare it with EIGENSHADE_VERSION of the header.
/// Never fails.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_version() -> *const c_char {
    concat!(env!("CARGO_PKG_VERSION"), "\0").as_ptr().cast()
}

/// A checksum of the sizes of the library's table. If the checksum is not `EIGENSHADE_TABLE`, the
/// headers belong to another library: do not call this one. Tables of the same sizes have the same
/// checksum.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_table() -> u32 {
    TABLE
}

/// The message of a status, with the remedy: a static string in English without a line end.
///
/// Never fails: an unknown status has a message too.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_message(status: i32) -> *const c_char {
    message(status).as_ptr()
}

/// A source turned by the rotation of a quaternion (x, y, z, w), as the light is that it was taken
/// out of.
///
/// On an error `to` is unchanged.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_source_turn_f32(
    from: *const Source,
    quaternion: *const f32,
    to: *mut Source,
) -> Status {
    sources::source_turn(&Input(from), &Input(quaternion), &Output(to)).into()
}

/// The gloss of a glTF material from its linear base color, metallic and roughness, all from 0 to
/// 1.
///
/// On an error `gloss` is unchanged.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_gloss_metallic_roughness_f32(
    base_color: *const f32,
    metallic: f32,
    roughness: f32,
    gloss: *mut Gloss,
) -> Status {
    sources::gloss_metallic_roughness(&Input(base_color), metallic, roughness, &Output(gloss))
        .into()
}

/// The fewest of a light's first sources with which pictures of a gloss are within `tolerance`, a
/// share of white: 0 from a roughness of 0.6 on, and `length` if all exceed it. `errors` is such as
/// `eigenshade_source_errors_lobby_f32[0]`, and `length` its number of rows, of six numbers each.
///
/// On an error `count` is unchanged.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_gloss_fewest_sources_f32(
    gloss: *const Gloss,
    errors: *const f32,
    length: usize,
    tolerance: f32,
    count: *mut usize,
) -> Status {
    let errors = Input(errors.cast());
    sources::gloss_fewest_sources(&Input(gloss), &errors, length, tolerance, &Output(count)).into()
}

/// The exposure of the pixels that a meter has counted, in either format, to within 7 %.
///
/// One pixel in a hundred is brighter than white. If the median pixel is then darker than 0.12 of
/// white, the exposure rises until the median has 0.12 or one pixel in ten is brighter than white.
/// On an error `exposure` is unchanged.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_meter_exposure_f32(meter: *const Meter, exposure: *mut f32) -> Status {
    meter::exposure(&Input(meter), &Output(exposure)).into()
}

/// Writes the codes of the normal map of a sphere of `diameter` x `diameter` pixels, 1 to 4096.
/// `length` is 2 * diameter * diameter bytes. Cost: a root and divisions of 64 bits for a quarter
/// of the pixels, once.
///
/// On an error `codes` is unchanged.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_normal_map_sphere(
    diameter: usize,
    codes: *mut u8,
    length: usize,
) -> Status {
    object::sphere(diameter, &Output(codes), length).into()
}

/// Finds the nodes of a palette that the object of a normal map needs, once for a map: fewer than
/// all of them.
///
/// On an error `nodes` is unchanged.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_nodes_of_normal_map(
    map: *const NormalMap,
    nodes: *mut Nodes,
) -> Status {
    nodes::of_normal_map(&Input(map), &Output(nodes)).into()
}

/// Draws the object of a normal map from a palette, which `eigenshade_palette_fill_f32` or `_q15`
/// filled for the nodes of the object.
///
/// On an error no pixel is changed.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_palette_draw(
    palette: *const Palette,
    map: *const NormalMap,
    target: *const Target,
) -> Status {
    palette::draw::<false>(&Input(palette), &Input(map), &Input(target)).into()
}

/// `eigenshade_palette_draw` with ordered dithering of RGB565, which hides its steps.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_palette_draw_dithered(
    palette: *const Palette,
    map: *const NormalMap,
    target: *const Target,
) -> Status {
    palette::draw::<true>(&Input(palette), &Input(map), &Input(target)).into()
}

/// The size of a textured object, and its number of regions. All bytes are checked: some
/// instructions for each row and each run.
///
/// On an error `header` is unchanged.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_object_header(
    object: *const PackedObject,
    header: *mut ObjectHeader,
) -> Status {
    packed_object::header(&Input(object), &Output(header)).into()
}

/// Finds the nodes of a linear palette that a region of a textured object needs, once for an object.
///
/// On an error `nodes` is unchanged.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_nodes_of_region(
    object: *const PackedObject,
    region: usize,
    nodes: *mut Nodes,
) -> Status {
    nodes::of_region(&Input(object), region, &Output(nodes)).into()
}

/// Draws a textured object from `count` linear palettes, one for each region in their order, which
/// `eigenshade_linear_palette_fill_f32` or `_q15` filled for the nodes of the region.
///
/// The bytes of the rows that the target has are checked. On an error no pixel is changed.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_object_draw(
    object: *const PackedObject,
    palettes: *const LinearPalette,
    count: usize,
    display: *const Display,
    target: *const Target,
) -> Status {
    let (object, palettes) = (Input(object), Input(palettes));
    linear_palette::draw(&object, &palettes, count, &Input(display), &Input(target), false).into()
}

/// `eigenshade_object_draw` with ordered dithering of RGB565, which hides its steps.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_object_draw_dithered(
    object: *const PackedObject,
    palettes: *const LinearPalette,
    count: usize,
    display: *const Display,
    target: *const Target,
) -> Status {
    let (object, palettes) = (Input(object), Input(palettes));
    linear_palette::draw(&object, &palettes, count, &Input(display), &Input(target), true).into()
}

/// The size of an object with shadows, its number of codes and the degree of its light. All bytes are
/// checked, here and in the functions below: some instructions for each row, each run and each cluster.
///
/// On an error `header` is unchanged.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_shadowed_object_header(
    object: *const ShadowedObject,
    header: *mut ShadowedObjectHeader,
) -> Status {
    shadowed_object::header(&Input(object), &Output(header)).into()
}

/// Writes the colors of the codes of an object with shadows, from coefficients that
/// `eigenshade_shadowed_object_coefficients_f32` or `_q15` found for this object. `encoding` is one of
/// `eigenshade_encoding`, and `length` is the number of bytes: one pixel for each code.
///
/// On an error `colors` is unchanged.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_shadowed_object_colors(
    object: *const ShadowedObject,
    coefficients: *const ObjectCoefficients,
    exposure: f32,
    display: *const Display,
    encoding: i32,
    colors: *mut c_void,
    length: usize,
) -> Status {
    shadowed_object::colors(
        &Input(object),
        &Input(coefficients),
        exposure,
        &Input(display),
        encoding,
        &Output(colors),
        length,
    )
    .into()
}

/// Draws an object with shadows in the colors of its codes, in the encoding of the target. `length` is
/// the number of bytes of the colors.
///
/// On an error no pixel is changed.
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_shadowed_object_draw(
    object: *const ShadowedObject,
    colors: *const c_void,
    length: usize,
    target: *const Target,
) -> Status {
    shadowed_object::draw(&Input(object), colors, length, &Input(target)).into()
}
