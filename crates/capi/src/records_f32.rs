//! The structures of C in float.
#![expect(unsafe_code, reason = "memory of C")]

use crate::boundary::Plain;
use crate::constants::{MATERIAL_BUFFER, PICTURE_F32};
use crate::table::{COMPONENTS, LIGHT, TRANSFER as TRANSFER_F32, WORKSPACE as WORKSPACE_F32};

/// One channel of distant light: spherical harmonic coefficients L_l^m in radiance, l from 0, m
/// from -l to l, each at l*l + l + m.
///
/// The harmonics carry the Condon-Shortley phase, x points to the right, y up, z to the
/// camera.
#[repr(C)]
pub struct LightF32 {
    /// Largest l, at most EIGENSHADE_DEGREE; above it the light is zero.
    pub degree: usize,
    /// Number of coefficients: (degree + 1)^2.
    pub length: usize,
    /// The coefficients; the caller's.
    pub coefficients: *const f32,
}

/// Distant light in three channels.
#[repr(C)]
pub struct ColorLightF32 {
    /// Red.
    pub r: LightF32,
    /// Green.
    pub g: LightF32,
    /// Blue.
    pub b: LightF32,
}

/// One channel of an isotropic material: Koenderink-van Doorn coefficients b_op^q of its
/// BRDF in 1/sr, by o, then p, then q: 000, 111, 200, 220, 222, 311, ... White matte is
/// the one coefficient 2.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct MaterialF32 {
    /// Largest o, at most EIGENSHADE_ORDER; above it the material is zero.
    pub order: usize,
    /// Number of coefficients: 1, 2, 5, 8, 14, 20, 30, 40 for orders 0 to 7.
    pub length: usize,
    /// The coefficients; the caller's.
    pub coefficients: *const f32,
}

/// An isotropic material in three channels. The channels of a gray material point to the same
/// numbers.
#[repr(C)]
pub struct ColorMaterialF32 {
    /// Red.
    pub r: MaterialF32,
    /// Green.
    pub g: MaterialF32,
    /// Blue.
    pub b: MaterialF32,
}

/// Scratch memory; holds nothing between two calls.
#[repr(C)]
pub struct WorkspaceF32 {
    /// Scratch.
    pub numbers: [f32; WORKSPACE_F32],
}

/// The coefficients d of one image, component by component.
#[repr(C)]
pub struct CoefficientsF32 {
    /// d.
    pub numbers: [f32; COMPONENTS],
}

/// The transfer of a material in three channels. May be kept in flash.
#[repr(C)]
pub struct TransferF32 {
    /// The numbers of red, green and blue.
    pub numbers: [[f32; TRANSFER_F32]; 3],
}

/// A picture, once it was begun. A picture has no pointers, so it may be moved.
#[repr(C)]
pub struct PictureF32 {
    /// Private to the library.
    pub words: [u64; PICTURE_F32],
}

/// The irradiance of a normal, in the light's radiance times sr times the material's 1/sr.
#[repr(C)]
pub struct IrradianceF32 {
    /// Red.
    pub r: f32,
    /// Green.
    pub g: f32,
    /// Blue.
    pub b: f32,
}

/// Memory for a turned or masked light, or for one without its sources.
#[repr(C)]
pub struct LightBufferF32 {
    /// Coefficients of the three channels.
    pub numbers: [[f32; LIGHT]; 3],
}

/// Memory for a computed or masked material.
#[repr(C)]
pub struct MaterialBufferF32 {
    /// Coefficients of the three channels.
    pub numbers: [[f32; MATERIAL_BUFFER]; 3],
}

/// A picture baked into three square maps, one for each channel. May be kept in flash.
#[repr(C)]
pub struct BakedF32 {
    /// Texels a side, 2 to 4096.
    pub size: usize,
    /// Number of texels: 3 * size * size.
    pub length: usize,
    /// The texels of red, then of green, then of blue; the caller's.
    pub texels: *const f32,
}

macro_rules! plain {
    ($($record:ident)*) => {$(
        // SAFETY: all of its fields are plain.
        unsafe impl Plain for $record {}
    )*};
}
plain! {
    LightF32 ColorLightF32 MaterialF32 ColorMaterialF32 WorkspaceF32 CoefficientsF32 TransferF32
    PictureF32 IrradianceF32 LightBufferF32 MaterialBufferF32 BakedF32
}
