//! Bytes of a setting: its table in flash, and the data in RAM for one channel of an image whose
//! light may change.

use super::setting::{Format, Setting, Way};
use eigenshade::{Q15, Q31, Scene};
use eigenshade_model::error::{Error, Result};
use eigenshade_shading::integer_shader::{Integer, OwnedQuantised};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::fault;
use eigenshade_table::quantize;
use eigenshade_table::{Parts, Table, wire};

/// Bytes of a setting.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bytes {
    /// The table, as `eigenshade pack` writes it.
    pub table: usize,
    /// The transferred material, d, and the data that a pixel reads: the scene, the samples or the
    /// texels.
    pub state: usize,
}

/// Nine coefficients.
const NINE: Bytes = Bytes { table: 0, state: 9 * size_of::<f32>() };

/// Counts the bytes.
///
/// # Errors
///
/// If the table cannot be represented in the setting's number format.
pub fn bytes(setting: &Setting, table: &Table) -> Result<Bytes> {
    if setting.way == Way::NineTerms {
        return Ok(NINE);
    }
    let packed = |format| {
        wire::encode(table, format, wire::Endian::Little)
            .map(|bytes| bytes.len())
            .map_err(|error| Error::new(error.to_string(), "take another format"))
    };
    match (setting.format, setting.way) {
        (Format::Q31, _) => {
            let table_bytes = packed(wire::Format::Integer(quantize::Format::Q31))?;
            Ok(Bytes { table: table_bytes, state: of_integers::<Q31>(table)? })
        }
        (Format::Q15, Way::Polynomial) => {
            let table_bytes = packed(wire::Format::Integer(quantize::Format::Q15))?;
            Ok(Bytes { table: table_bytes, state: of_integers::<Q15>(table)? })
        }
        (format, way) => {
            let single = packed(wire::Format::F32)?;
            let parts = Parts::new(table);
            let numbers = parts.polar.len() + parts.factors.len() + parts.terms.len();
            let wider = if format == Format::F64 { 4 * numbers } else { 0 };
            let number = if format == Format::F64 { 8 } else { 4 };
            let basis = OwnedBasis::<f32>::new(table);
            let basis = basis.basis().map_err(fault)?;
            let held = basis.transfer_len() + basis.components();
            let of_pixel = match way {
                Way::Eigen | Way::NineTerms => 0,
                Way::Polynomial | Way::Within(_) => number * basis.scene_len(),
                Way::Linear(knots) | Way::Cubic(knots) => {
                    let buffer = vec![0.0f32; basis.scene_len()];
                    let scene: Scene<'_, Vec<f32>> =
                        basis.collapse_into(&[], buffer).map_err(fault)?;
                    number * scene.lookup_len::<f32>(knots)
                }
                Way::Bilinear(size) | Way::Nearest(size) => {
                    let texel = if format == Format::Q15 { 2 } else { number };
                    texel * size * size
                }
            };
            Ok(Bytes { table: single + wider, state: number * held + of_pixel })
        }
    }
}

fn of_integers<Q: Integer>(table: &Table) -> Result<usize> {
    let basis = OwnedQuantised::<Q>::new(table, Q::FORMAT.tolerance())
        .map_err(|error| Error::new(error.to_string(), "take another format"))?;
    let view = basis.view().map_err(fault)?;
    let exponents = size_of::<i16>() * view.profiles();
    let words = size_of::<i32>() * (view.components() + view.scene_len());
    Ok(size_of::<Q>() * view.transfer_len() + exponents + words)
}
