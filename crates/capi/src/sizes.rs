//! The version of the library, the sizes of the shipped table as literals for the header, and its
//! bases without the factors of transfers.
//!
//! The functions that relight, collapse and shade use these bases, so that a program whose
//! transfers are computed beforehand links no factors.

use core::ffi::{CStr, c_char};
use eigenshade::index::{light, material};
use eigenshade::{Basis, Parts, Q15, Q31, quantized, sphere};

const VERSION: &CStr =
    match CStr::from_bytes_with_nul(concat!(env!("CARGO_PKG_VERSION"), "\0").as_bytes()) {
        Ok(version) => version,
        Err(_) => panic!("a version has no zero in it"),
    };

/// The library's version, a static string: compare it with EIGENSHADE_VERSION of the header.
/// Never fails.
#[expect(unsafe_code, reason = "an exported symbol")]
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_version() -> *const c_char {
    VERSION.as_ptr()
}

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

/// In float.
pub(crate) static BASIS_F32: Basis<'static, f32> = {
    let all = *sphere::BASIS.parts();
    match Basis::new(Parts { polar: &[], factors: &[], ..all }) {
        Ok(basis) => basis,
        Err(_) => panic!("the table's parts do not fit together"),
    }
};

/// In mantissas of 15 bits.
pub(crate) static BASIS_Q15: quantized::Basis<'static, Q15> = {
    let all = *sphere::q15::BASIS.parts();
    let (polar, polar_exponents) = (&[], &[]);
    let (factors, factor_exponents) = (&[], &[]);
    let parts = quantized::Parts { polar, polar_exponents, factors, factor_exponents, ..all };
    match quantized::Basis::<Q15>::new(parts) {
        Ok(basis) => basis,
        Err(_) => panic!("the table's parts do not fit together"),
    }
};

/// In mantissas of 31 bits.
pub(crate) static BASIS_Q31: quantized::Basis<'static, Q31> = {
    let all = *sphere::q31::BASIS.parts();
    let (polar, polar_exponents) = (&[], &[]);
    let (factors, factor_exponents) = (&[], &[]);
    let parts = quantized::Parts { polar, polar_exponents, factors, factor_exponents, ..all };
    match quantized::Basis::<Q31>::new(parts) {
        Ok(basis) => basis,
        Err(_) => panic!("the table's parts do not fit together"),
    }
};
