//! Errors for results outside the range of a number format.

use crate::database::Named;
use crate::error::{Error, Result};
use std::fmt::Display;

/// If the largest coefficient is below this, f32 and integers lose it in whole or in part.
const LEAST: f64 = 1e-36;

/// Rejects results of one channel that are not finite, and inputs that f32 loses.
///
/// # Errors
///
/// [`fault`] if a number is not finite; otherwise as [`lost`].
pub fn check<S: Copy + Into<f64>>(numbers: &[S], light: &[f64], material: &[f64]) -> Result<()> {
    if size_of::<S>() == size_of::<f32>() {
        lost(std::any::type_name::<S>(), light, material)?;
    }
    if numbers.iter().all(|&number| number.into().is_finite()) {
        return Ok(());
    }
    Err(fault(std::any::type_name::<S>(), light, material))
}

/// The numbers that [`check`] accepts.
///
/// # Errors
///
/// As [`check`].
pub fn checked<S: Copy + Into<f64>>(
    numbers: Vec<S>,
    light: &[f64],
    material: &[f64],
) -> Result<Vec<S>> {
    check(&numbers, light, material)?;
    Ok(numbers)
}

/// The error for a light and a material whose result exceeds a format. The remedy says how to scale
/// them.
#[must_use]
pub fn fault(format: impl Display, light: &[f64], material: &[f64]) -> Error {
    Error::new(format!("the result exceeds the range of {format}"), scale(light, material))
}

/// Rejects a light and a material so dark that a format loses their product.
///
/// # Errors
///
/// If the product is lost; never if the light or the material is black.
pub fn lost(format: impl Display, light: &[f64], material: &[f64]) -> Result<()> {
    let [of_light, of_material] = [light, material].map(largest);
    let product = of_light * of_material;
    if of_light == 0.0 || of_material == 0.0 || product.min(of_light).min(of_material) >= LEAST {
        return Ok(());
    }
    Err(Error::new(format!("the result is below the range of {format}"), scale(light, material)))
}

/// The remedy: how to scale both.
fn scale(light: &[f64], material: &[f64]) -> String {
    let [light, material] = [light, material].map(largest);
    format!(
        "scale both toward 1: the light's largest coefficient is {light:.2e}, the material's \
         {material:.2e}"
    )
}

fn largest(numbers: &[f64]) -> f64 {
    numbers.iter().fold(0.0, |most, one| most.max(one.abs()))
}

/// The names of a light and a material, for an error message.
#[must_use]
pub fn pair(light: &Named, material: &Named) -> String {
    format!("light `{}` on material `{}`", light.name, material.name)
}
