//! How many components a tolerance asks for.
//!
//! The tolerance is an rms error over a peak. The mean energy that K components
//! leave is known from the eigenvalues; the peak is the root of the mean square,
//! over the database's lights as captured and its materials, of each image's
//! largest |I|.

use crate::database::{Lights, Materials};
use crate::error::Result;
use crate::moments::exposure;
use crate::truth::Truth;
use eigenshade_table::Table;
use std::f64::consts::PI;

/// The least number of components whose mean residual is at most `tolerance`
/// times the database's peak.
///
/// # Errors
///
/// A light that cannot be normalised.
pub fn components_for(
    table: &Table,
    lights: &Lights,
    materials: &Materials,
    tolerance: f64,
) -> Result<usize> {
    let allowed = tolerance * tolerance * mean_square_peak(table, lights, materials)?;
    let all = table.spectrum.len();
    let first = usize::from(table.spectrum.first().is_some_and(|(_, value)| value.is_none()));
    Ok((first..all).find(|&count| table.energy_left(count) <= allowed).unwrap_or(all))
}

/// Mean over all pairs of the square of the largest |I|, on 24 slants by 48 tilts,
/// pole and rim included.
fn mean_square_peak(table: &Table, lights: &Lights, materials: &Materials) -> Result<f64> {
    let truth = Truth::new(lights.degree, materials.order);
    let mut scaled = Vec::new();
    for entry in &lights.entries {
        let mut light = entry.luminance();
        let scale = exposure(&entry.name, light[0], table.scene.light.normalise)?;
        light.iter_mut().for_each(|value| *value *= scale);
        scaled.push(light);
    }
    let materials: Vec<Vec<f64>> =
        materials.entries.iter().map(crate::database::Named::luminance).collect();
    let mut peaks = vec![0.0f64; scaled.len() * materials.len()];
    for slant in 0..24 {
        let (sine, z) = (0.5 * PI * f64::from(slant) / 23.0).sin_cos();
        for tilt in 0..48 {
            let (y, x) = (2.0 * PI * f64::from(tilt) / 48.0).sin_cos();
            let modes = truth.at([sine * x, sine * y, z.max(0.0)]);
            let mut peak = peaks.iter_mut();
            for material in &materials {
                let scattered = modes.scatter(material);
                for (light, peak) in scaled.iter().zip(&mut peak) {
                    *peak = peak.max(modes.irradiance(light, &scattered).abs());
                }
            }
        }
    }
    Ok(peaks.iter().map(|peak| peak * peak).sum::<f64>() / peaks.len() as f64)
}
