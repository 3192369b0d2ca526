//! The structures of C in integers.
#![expect(unsafe_code, reason = "memory of C")]

use crate::boundary::Plain;
use crate::constants::{MATERIAL_BUFFER, MATERIAL_EXPONENTS, PICTURE_Q15};
use crate::table::q15::{PROFILES, TRANSFER as TRANSFER_Q15, WORKSPACE as WORKSPACE_Q15};
use crate::table::{COMPONENTS, LIGHT};
use eigenshade::Q15;

/// One channel of distant light: as `eigenshade_light_f32_t`, in mantissas times 2^exponent.
#[repr(C)]
pub struct LightQ15 {
    /// Largest l, at most EIGENSHADE_DEGREE; above it the light is zero.
    pub degree: usize,
    /// Number of mantissas: (degree + 1)^2.
    pub length: usize,
    /// The mantissas; the caller's. The more bits the largest has, the better.
    pub mantissas: *const Q15,
    /// The exponent of all mantissas, from -128 to 128.
    pub exponent: i32,
}

/// Distant light in three channels.
#[repr(C)]
pub struct ColorLightQ15 {
    /// Red.
    pub r: LightQ15,
    /// Green.
    pub g: LightQ15,
    /// Blue.
    pub b: LightQ15,
}

/// One channel of an isotropic material: as `eigenshade_material_f32_t`, in mantissas times
/// 2^exponent, an exponent for each o.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct MaterialQ15 {
    /// Largest o, at most EIGENSHADE_ORDER; above it the material is zero.
    pub order: usize,
    /// Number of mantissas: 1, 2, 5, 8, 14, 20, 30, 40 for orders 0 to 7.
    pub length: usize,
    /// The mantissas; the caller's. The more bits the largest of each o has, the better.
    pub mantissas: *const Q15,
    /// Number of exponents: order + 1.
    pub exponents_length: usize,
    /// For each o the exponent of its mantissas; the caller's.
    pub exponents: *const i8,
}

/// An isotropic material in three channels. The channels of a gray material point to the same
/// numbers.
#[repr(C)]
pub struct ColorMaterialQ15 {
    /// Red.
    pub r: MaterialQ15,
    /// Green.
    pub g: MaterialQ15,
    /// Blue.
    pub b: MaterialQ15,
}

/// Scratch memory; holds nothing between two calls.
#[repr(C)]
pub struct WorkspaceQ15 {
    /// Scratch.
    pub numbers: [i32; WORKSPACE_Q15],
    /// A channel of a transfer.
    pub transfer: [Q15; TRANSFER_Q15],
    /// The exponents of the transfer.
    pub exponents: [i16; PROFILES],
}

/// The coefficients d of one image, component by component: mantissas times 2^exponent.
#[repr(C)]
pub struct CoefficientsQ15 {
    /// Mantissas of at most 2^30.
    pub mantissas: [i32; COMPONENTS],
    /// The exponent of all mantissas.
    pub exponent: i32,
}

/// The transfer of a material in three channels. May be kept in flash.
#[repr(C)]
pub struct TransferQ15 {
    /// The mantissas of red, green and blue.
    pub numbers: [[Q15; TRANSFER_Q15]; 3],
    /// The exponents of red, green and blue.
    pub exponents: [[i16; PROFILES]; 3],
}

/// A picture, once it was begun. A picture has no pointers, so it may be moved.
#[repr(C)]
pub struct PictureQ15 {
    /// Private to the library.
    pub words: [u64; PICTURE_Q15],
}

/// The irradiance of a normal: mantissas times 2^exponent, in the light's radiance times sr times
/// the material's 1/sr.
#[repr(C)]
pub struct IrradianceQ15 {
    /// Red.
    pub r: i32,
    /// Green.
    pub g: i32,
    /// Blue.
    pub b: i32,
    /// The exponents of red, green and blue: the same for all normals of a picture.
    pub exponents: [i32; 3],
}

/// Memory for a turned, masked or quantized light, or for one without its sources.
#[repr(C)]
pub struct LightBufferQ15 {
    /// Mantissas of the three channels.
    pub mantissas: [[Q15; LIGHT]; 3],
}

/// Memory for a computed, masked or quantized material.
#[repr(C)]
pub struct MaterialBufferQ15 {
    /// Mantissas of the three channels.
    pub mantissas: [[Q15; MATERIAL_BUFFER]; 3],
    /// The exponents of red, green and blue.
    pub exponents: [[i8; MATERIAL_EXPONENTS]; 3],
}

/// A picture baked into three square maps, one for each channel. May be kept in flash.
#[repr(C)]
pub struct BakedQ15 {
    /// Texels a side, 2 to 4096.
    pub size: usize,
    /// Number of texels: 3 * size * size.
    pub length: usize,
    /// The texels of red, then of green, then of blue; the caller's.
    pub texels: *const i16,
    /// For each channel the exponent of its texels.
    pub exponents: [i32; 3],
}

macro_rules! plain {
    ($($record:ident)*) => {$(
        // SAFETY: all of its fields are plain.
        unsafe impl Plain for $record {}
    )*};
}
plain! {
    LightQ15 ColorLightQ15 MaterialQ15 ColorMaterialQ15 WorkspaceQ15 CoefficientsQ15 TransferQ15
    PictureQ15 IrradianceQ15 LightBufferQ15 MaterialBufferQ15 BakedQ15
}
