//! A table in Q15 with the transfer of one material.

use crate::Result;
use eigenshade::Q15;
use eigenshade::index::record::integers::OwnedParts;
use eigenshade::index::source;
use eigenshade::quantized::{Basis, Material};
use eigenshade_table::quantize::{self, IntegerFormat};
use eigenshade_table::{Table, statics};

/// The first line of each generated module.
const COMMAND: &str = "build.rs";

/// A table in Q15 with the transfer of one material as `MATERIAL`, and without the statics that
/// only a transfer uses.
pub fn one_material(table: &Table, exponents: &[i8], mantissas: &[i32]) -> Result<String> {
    let format = IntegerFormat::Q15;
    let parts = quantize::integers(table, format, format.tolerance());
    let mut parts = parts.map_err(|error| error.to_string())?;
    let (numbers, of_profiles) =
        transfer(&parts, exponents, mantissas).map_err(|error| error.to_string())?;
    for numbers in [&mut parts.polar, &mut parts.factors] {
        numbers.clear();
    }
    for exponents in [&mut parts.polar_exponents, &mut parts.factor_exponents] {
        exponents.clear();
    }
    Ok(statics::integers(&parts, format, COMMAND)
        + &source::integers::transfer(&numbers, &of_profiles))
}

/// Numbers and exponents of the transfer of a material.
fn transfer(
    parts: &OwnedParts<i32>,
    exponents: &[i8],
    mantissas: &[i32],
) -> std::result::Result<(Vec<Q15>, Vec<i16>), eigenshade::Error> {
    let parts = quantize::in_q15(parts);
    let basis = Basis::<Q15>::new(parts.borrow())?;
    let mantissas: Vec<Q15> = mantissas.iter().map(|&number| Q15(number as i16)).collect();
    let material = Material::new(exponents, &mantissas)?;
    let mut numbers = vec![Q15(0); basis.transfer_len()];
    let mut of_profiles = vec![0; basis.profiles()];
    let mut workspace = vec![0; basis.workspace_len()];
    basis.transfer_into(&material, &mut workspace, &mut numbers, &mut of_profiles)?;
    Ok((numbers, of_profiles))
}
