//! Light and material as the page writes them, and the sizes of all buffers.

use crate::shared::Shared;
use crate::table::{COMPONENTS, DEGREE, ORDER};
use eigenshade::index;

/// Coefficients of the largest light.
pub const LIGHT_COUNT: usize = index::light::count(DEGREE);
/// Coefficients of the largest material.
pub const MATERIAL_COUNT: usize = index::material::count(ORDER);
/// Normals that one call shades at most.
pub const NORMALS: usize = 1024;

/// The light of the next call.
#[unsafe(export_name = "light")]
pub static LIGHT: Shared<[f32; LIGHT_COUNT]> = Shared::new([0.0; LIGHT_COUNT]);
/// The material of the next call.
#[unsafe(export_name = "material")]
pub static MATERIAL: Shared<[f32; MATERIAL_COUNT]> = Shared::new([0.0; MATERIAL_COUNT]);
/// Degree, order, components, normals of a call.
#[unsafe(export_name = "shape")]
pub static SHAPE: [u32; 4] = [DEGREE as u32, ORDER as u32, COMPONENTS as u32, NORMALS as u32];
