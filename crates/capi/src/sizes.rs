//! Sizes of the shipped table as literals, for the header.

use eigenshade::index::{light, material};
use eigenshade::sphere;

/// Largest degree l of a light.
pub const EIGENSHADE_DEGREE: usize = 9;
/// Largest order o of a material.
pub const EIGENSHADE_ORDER: usize = 7;
/// Coefficients of a light of that degree.
pub const EIGENSHADE_LIGHT: usize = 100;
/// Coefficients of a material of that order.
pub const EIGENSHADE_MATERIAL: usize = 40;
/// Components d of an image.
pub const EIGENSHADE_COMPONENTS: usize = 50;
/// Profiles of a table in integers.
pub const EIGENSHADE_PROFILES: usize = 28;
/// Numbers in a transfer in float.
pub const EIGENSHADE_TRANSFER_F32: usize = 568;
/// Numbers in a transfer in integers.
pub const EIGENSHADE_TRANSFER: usize = 218;
/// Numbers of a scene in float.
pub const EIGENSHADE_SCENE_F32: usize = 166;
/// Numbers of a scene in Q15.
pub const EIGENSHADE_SCENE_Q15: usize = 126;
/// Numbers of a scene in Q31.
pub const EIGENSHADE_SCENE_Q31: usize = 160;
/// Numbers in the workspace of transfers and projections in float.
pub const EIGENSHADE_WORKSPACE_F32: usize = 460;
/// Numbers in the workspace of transfers in integers.
pub const EIGENSHADE_WORKSPACE: usize = 230;

/// Each size as stated here and as in the table.
const SIZES: [[usize; 2]; 17] = [
    [EIGENSHADE_DEGREE, sphere::DEGREE],
    [EIGENSHADE_DEGREE, sphere::q15::DEGREE],
    [EIGENSHADE_DEGREE, sphere::q31::DEGREE],
    [EIGENSHADE_ORDER, sphere::ORDER],
    [EIGENSHADE_LIGHT, light::count(sphere::DEGREE)],
    [EIGENSHADE_MATERIAL, material::count(sphere::ORDER)],
    [EIGENSHADE_COMPONENTS, sphere::COMPONENTS],
    [EIGENSHADE_PROFILES, sphere::q15::PROFILES],
    [EIGENSHADE_PROFILES, sphere::q31::PROFILES],
    [EIGENSHADE_TRANSFER_F32, sphere::TRANSFER],
    [EIGENSHADE_TRANSFER, sphere::q15::TRANSFER],
    [EIGENSHADE_TRANSFER, sphere::q31::TRANSFER],
    [EIGENSHADE_SCENE_F32, sphere::SCENE],
    [EIGENSHADE_SCENE_Q15, sphere::q15::SCENE],
    [EIGENSHADE_SCENE_Q31, sphere::q31::SCENE],
    [EIGENSHADE_WORKSPACE_F32, sphere::WORKSPACE],
    [EIGENSHADE_WORKSPACE, sphere::q31::WORKSPACE],
];

// cbindgen needs literals, so a change of the table has to be copied to the sizes above.
const _: () = {
    let mut rest = SIZES.as_slice();
    while let [[stated, found], tail @ ..] = rest {
        assert!(*stated == *found, "a size in crates/capi/src/sizes.rs differs from the table");
        rest = tail;
    }
};
