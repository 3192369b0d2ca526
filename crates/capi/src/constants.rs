//! The constants of `include/eigenshade_table.h`: the sizes of the table.

use crate::table::{self, q15};
use eigenshade_table::{light, material};

/// Name, description and value.
pub(crate) const CONSTANTS: [(&str, &str, usize); 12] = [
    ("DEGREE", "Largest degree l of a light.", table::DEGREE),
    ("ORDER", "Largest order o of a material.", table::ORDER),
    ("LIGHT", "Coefficients of a light of that degree.", light::count(table::DEGREE)),
    ("MATERIAL", "Coefficients of a material of that order.", material::count(table::ORDER)),
    ("COMPONENTS", "Components d of an image.", table::COMPONENTS),
    ("PROFILES", "Profiles of a table in integers.", q15::PROFILES),
    ("TRANSFER_F32", "Numbers in a transfer in float.", table::TRANSFER),
    ("TRANSFER", "Numbers in a transfer in integers.", q15::TRANSFER),
    ("SCENE_F32", "Numbers of a scene in float.", table::SCENE),
    ("SCENE_Q15", "Numbers of a scene in Q15.", q15::SCENE),
    (
        "WORKSPACE_F32",
        "Numbers in the workspace of transfers and projections in float.",
        table::WORKSPACE,
    ),
    ("WORKSPACE", "Numbers in the workspace of transfers in integers.", q15::WORKSPACE),
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
