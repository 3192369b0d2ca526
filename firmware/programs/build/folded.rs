//! A table in Q15 for the one material that its scene names: folded in here, so that neither
//! the factors nor what folds is in a program.

use eigenshade::Q15;
use eigenshade::quantized::{Basis, Material, Parts, Profile};
use eigenshade_table::quantize::{self, Format, QuantizedParts};
use eigenshade_table::{Table, rust_quantized};
use std::fs;

/// The statics of a table's module, with `MATERIAL`, of the material at `database`.
pub fn module(table: &Table, database: &str, command: &str) -> Result<String, String> {
    let mut parts = QuantizedParts::new(table, Format::Q15, Format::Q15.tolerance())
        .map_err(|error| error.to_string())?;
    let coefficients = coefficients(table, database)?;
    let (numbers, exponents) =
        transfer(&parts, &coefficients).map_err(|error| error.to_string())?;
    for numbers in [&mut parts.polar, &mut parts.factors] {
        numbers.clear();
    }
    for exponents in [&mut parts.polar_exponents, &mut parts.factor_exponents] {
        exponents.clear();
    }
    let numbers: Vec<i32> = numbers.into_iter().map(|Q15(number)| number.into()).collect();
    Ok(rust_quantized::module(&parts, command)
        + &rust_quantized::transfer(Format::Q15, &numbers, &exponents))
}

/// The scene's material, whose rows stand in storage order: the one that it names, or the
/// first.
fn coefficients(table: &Table, database: &str) -> Result<Vec<f64>, String> {
    println!("cargo::rerun-if-changed={database}");
    let text = fs::read_to_string(database).map_err(|error| format!("{database}: {error}"))?;
    let rows = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    let mut rows = rows.filter_map(|row| row.split_once(',')).peekable();
    let first = rows.peek().map(|(name, _)| (*name).to_owned());
    let name = table.scene.material.names.first().cloned().or(first).unwrap_or_default();
    let values = rows.filter(|(found, _)| *found == name);
    let value = |(_, row): (&str, &str)| row.rsplit(',').next().and_then(|one| one.parse().ok());
    let count = eigenshade::index::material::count(table.gram.order);
    let values: Option<Vec<f64>> = values.take(count).map(value).collect();
    let values = values.filter(|values| values.len() == count);
    values.ok_or_else(|| format!("{database}: `{name}` has no {count} values"))
}

/// Numbers and exponents of the transfer.
fn transfer(
    parts: &QuantizedParts,
    material: &[f64],
) -> Result<(Vec<Q15>, Vec<i16>), eigenshade::Error> {
    let own = |numbers: &[i32]| -> Vec<Q15> {
        numbers.iter().map(|&number| Q15(number as i16)).collect()
    };
    let places = parts.profiles.iter();
    let profiles: Vec<Profile> = places
        .map(|place| {
            let (components, sizes) = ([place.plus, place.minus], [place.size, place.step]);
            Profile::new(place.azimuth, place.exponent, components, sizes)
        })
        .collect();
    let [polar, factors, terms] = [&parts.polar, &parts.factors, &parts.terms].map(|one| own(one));
    let basis = Basis::<Q15>::new(Parts {
        degree: parts.degree,
        order: parts.order,
        effects: parts.effects,
        components: parts.components,
        profiles: &profiles,
        lengths: &parts.lengths,
        polar: &polar,
        polar_exponents: &parts.polar_exponents,
        factors: &factors,
        factor_exponents: &parts.factor_exponents,
        terms: &terms,
    })?;
    let (mantissas, exponents) = quantize::material(parts.order, material, Format::Q15);
    let mantissas = own(&mantissas);
    let material = Material::new(&exponents, &mantissas)?;
    let mut numbers = vec![Q15(0); basis.transfer_len()];
    let mut of_profiles = vec![0; basis.profiles()];
    let mut workspace = vec![0; basis.workspace_len()];
    basis.transfer_into(&material, &mut workspace, &mut numbers, &mut of_profiles)?;
    Ok((numbers, of_profiles))
}
