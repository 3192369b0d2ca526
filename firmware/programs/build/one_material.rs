//! A table in Q15 with the transfer of one material.

use crate::Result;
use eigenshade::Q15;
use eigenshade::q15::{Basis, Material};
use eigenshade_table::quantize::{self, TOLERANCE};
use eigenshade_table::record::integers::OwnedParts;
use eigenshade_table::{Table, source, statics};

/// The first line of each generated module.
const COMMAND: &str = "build.rs";

/// A table in Q15 with the transfer of one material as `MATERIAL`, and without the statics that
/// only a transfer uses.
pub fn one_material(table: &Table, exponents: &[i8], mantissas: &[Q15]) -> Result<String> {
    let parts = quantize::integers(table, TOLERANCE);
    let mut parts = parts.map_err(|error| error.to_string())?;
    let (numbers, of_profiles) =
        transfer(&parts, exponents, mantissas).map_err(|error| error.to_string())?;
    for numbers in [&mut parts.polar, &mut parts.factors] {
        numbers.clear();
    }
    for exponents in [&mut parts.polar_exponents, &mut parts.factor_exponents] {
        exponents.clear();
    }
    Ok(statics::integers(&parts, COMMAND) + &source::integers::transfer(&numbers, &of_profiles))
}

/// Numbers and exponents of the transfer of a material.
fn transfer(
    parts: &OwnedParts<Q15>,
    exponents: &[i8],
    mantissas: &[Q15],
) -> std::result::Result<(Vec<Q15>, Vec<i16>), eigenshade::Error> {
    let basis = Basis::new(parts.borrow())?;
    let material = Material::new(exponents, mantissas)?;
    let mut numbers = vec![Q15(0); basis.transfer_len()];
    let mut of_profiles = vec![0; basis.profiles()];
    let mut workspace = vec![0; basis.workspace_len()];
    basis.transfer_into(&material, &mut workspace, &mut numbers, &mut of_profiles)?;
    Ok((numbers, of_profiles))
}
