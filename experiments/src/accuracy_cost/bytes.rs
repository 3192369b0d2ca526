//! Bytes of a setting: its table in flash, and the data in RAM for one channel of an image whose
//! light may change.

use super::setting::{Format, Setting, Way};
use eigenshade::{Q15, Q31, Scene};
use eigenshade_model::error::{Error, Result};
use eigenshade_shading::integer_shader::{Integer, OwnedQuantized};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::fault;
use eigenshade_table::{Parts, Table, quantize, wire};

/// The table, as `eigenshade pack` writes it; and the transferred material, d, and the data that a
/// pixel reads: the scene, the samples or the texels.
///
/// # Errors
///
/// If the table cannot be represented in the setting's number format.
pub fn bytes(setting: &Setting, table: &Table) -> Result<[usize; 2]> {
    let packed = |format| {
        wire::encode(table, format, wire::Endian::Little)
            .map(|bytes| bytes.len())
            .map_err(|error| Error::new(error.to_string(), "take another format"))
    };
    let integer = |format| packed(wire::Format::Integer(format));
    match (setting.format, setting.way) {
        // Nine coefficients.
        (_, Way::NineTerms) => return Ok([0, 9 * size_of::<f32>()]),
        (Format::Q31, _) => {
            return Ok([integer(quantize::Format::Q31)?, of_integers::<Q31>(table)?]);
        }
        (Format::Q15, Way::Polynomial) => {
            return Ok([integer(quantize::Format::Q15)?, of_integers::<Q15>(table)?]);
        }
        _ => {}
    }
    let parts = Parts::new(table);
    let numbers = parts.polar.len() + parts.factors.len() + parts.terms.len();
    let number = if setting.format == Format::F64 { 8 } else { 4 };
    let basis = OwnedBasis::<f32>::new(table);
    let basis = basis.basis().map_err(fault)?;
    let held = basis.transfer_len() + basis.components();
    let of_pixel = match setting.way {
        Way::Eigen | Way::NineTerms => 0,
        Way::Polynomial | Way::Within(_) => number * basis.scene_len(),
        Way::Linear(knots) | Way::Cubic(knots) => {
            let buffer = vec![0.0f32; basis.scene_len()];
            let scene: Scene<'_, Vec<f32>> = basis.collapse_into(&[], buffer).map_err(fault)?;
            number * scene.sampled_len::<f32>(knots)
        }
        Way::Bilinear(size) | Way::Nearest(size) => {
            let texel = if setting.format == Format::Q15 { 2 } else { number };
            texel * size * size
        }
    };
    // A wire file has no f64: its numbers would take four bytes more each.
    Ok([packed(wire::Format::F32)? + (number - 4) * numbers, number * held + of_pixel])
}

fn of_integers<Q: Integer>(table: &Table) -> Result<usize> {
    let basis = OwnedQuantized::<Q>::new(table, Q::FORMAT.tolerance())
        .map_err(|error| Error::new(error.to_string(), "take another format"))?;
    let view = basis.view().map_err(fault)?;
    let exponents = size_of::<i16>() * view.profiles();
    let words = size_of::<i32>() * (view.components() + view.scene_len());
    Ok(size_of::<Q>() * view.transfer_len() + exponents + words)
}
