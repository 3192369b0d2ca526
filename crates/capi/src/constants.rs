//! The constants of `include/eigenshade_table.h`: the sizes of the table, and what follows from
//! them.

use crate::table::{self, q15};
use eigenshade::object::ObjectCoefficients;
use eigenshade::screen::{LinearPalette, Nodes, Palette};
use eigenshade::{Highlights, Rgb};
use eigenshade_table::{highlights, light, material};

/// The order of glTF materials.
pub(crate) const METALLIC_ROUGHNESS_ORDER: usize = 7;
/// The largest order of a material in memory of the caller.
const LARGEST_ORDER: usize =
    if table::ORDER > METALLIC_ROUGHNESS_ORDER { table::ORDER } else { METALLIC_ROUGHNESS_ORDER };
/// Coefficients of such a material.
pub(crate) const MATERIAL_BUFFER: usize = material::count(LARGEST_ORDER);
/// Exponents of such a material.
pub(crate) const MATERIAL_EXPONENTS: usize = LARGEST_ORDER + 1;
/// The most sources of a picture.
pub(crate) const SOURCES: usize = highlights::SHIPPED_SOURCES;

/// The size of a picture in words of 64 bits, on machines with addresses of 64 bits. On others it
/// is smaller, but C has one header.
const fn words(scene: usize, without: usize, with_two: usize) -> usize {
    let state = 8;
    let addresses = 2 * (8 - size_of::<usize>());
    let lobe = (with_two - without) / 2;
    (state + scene + 4).div_ceil(8) + (without + addresses + SOURCES * lobe).div_ceil(8)
}

/// Highlights beside a function.
type OfFloats<const N: usize> = Option<(fn(), Highlights<N>)>;
type OfIntegers<const N: usize> = Option<(fn(), eigenshade::q15::Highlights<Rgb<i32>, N>)>;

/// Words of a picture in float.
pub(crate) const PICTURE_F32: usize =
    words(12 * table::SCENE, size_of::<OfFloats<0>>(), size_of::<OfFloats<2>>());
/// Words of a picture in integers.
pub(crate) const PICTURE_Q15: usize =
    words(12 * q15::SCENE + 12, size_of::<OfIntegers<0>>(), size_of::<OfIntegers<2>>());

/// Words of the nodes of a palette, of palettes and of coefficients, with their marks.
pub(crate) const NODES: usize = 1 + size_of::<Nodes>() / 8;
pub(crate) const PALETTE: usize = 1 + size_of::<Palette>() / 4;
pub(crate) const LINEAR_PALETTE: usize = 1 + size_of::<LinearPalette>() / 4;
pub(crate) const OBJECT_COEFFICIENTS: usize = 1 + size_of::<Rgb<ObjectCoefficients>>() / 4;

/// Name, description and value.
pub(crate) const CONSTANTS: [(&str, &str, usize); 19] = [
    ("DEGREE", "Largest degree l of a light.", table::DEGREE),
    ("ORDER", "Largest order o of a material.", table::ORDER),
    ("LIGHT", "Coefficients of a light of that degree.", light::count(table::DEGREE)),
    ("MATERIAL", "Coefficients of a material of that order.", material::count(table::ORDER)),
    ("MATERIAL_BUFFER", "Coefficients that memory for a material has.", MATERIAL_BUFFER),
    ("MATERIAL_EXPONENTS", "Exponents that memory for a material has.", MATERIAL_EXPONENTS),
    ("COMPONENTS", "Components d of an image.", table::COMPONENTS),
    ("PROFILES", "Profiles of a table in integers.", q15::PROFILES),
    ("TRANSFER_F32", "Numbers of a channel of a transfer in float.", table::TRANSFER),
    ("TRANSFER_Q15", "Numbers of a channel of a transfer in integers.", q15::TRANSFER),
    ("WORKSPACE_F32", "Numbers in the workspace of projections in float.", table::WORKSPACE),
    ("WORKSPACE_Q15", "Numbers in the workspace of projections in integers.", q15::WORKSPACE),
    ("SOURCES", "The most sources of a picture.", SOURCES),
    ("PICTURE_F32", "Words of 64 bits in a picture in float.", PICTURE_F32),
    ("PICTURE_Q15", "Words of 64 bits in a picture in integers.", PICTURE_Q15),
    ("NODES", "Words of 64 bits in the nodes of an object.", NODES),
    ("PALETTE", "Words of 32 bits in a palette.", PALETTE),
    ("LINEAR_PALETTE", "Words of 32 bits in a linear palette.", LINEAR_PALETTE),
    (
        "OBJECT_COEFFICIENTS",
        "Words of 32 bits in the coefficients of an object with shadows.",
        OBJECT_COEFFICIENTS,
    ),
];

/// A checksum of the sizes, FNV-1a. Tables of the same sizes have the same one.
#[expect(clippy::indexing_slicing, reason = "a constant function has no iterators")]
pub(crate) const TABLE: u32 = {
    let (mut sum, mut index) = (2_166_136_261_u32, 0);
    while index < CONSTANTS.len() {
        sum = (sum ^ CONSTANTS[index].2 as u32).wrapping_mul(16_777_619);
        index += 1;
    }
    sum
};
