//! Warns about materials that reflect more light than they receive, or a negative amount.

use eigenshade_model::database::Materials;
use eigenshade_model::scattering;

/// Tolerance for the error of truncated series coefficients.
const SLACK: f64 = 1e-3;

/// A warning line if there are such materials. It gives the albedo of the worst one under uniform
/// light.
#[must_use]
pub fn warning(materials: &Materials) -> Option<String> {
    let beyond = |albedo: f64| (albedo - 1.0).max(-albedo);
    let of = |rgb: &[Vec<f64>; 3]| {
        let albedos = rgb.iter().map(|channel| scattering::albedo(channel));
        albedos.max_by(|a, b| beyond(*a).total_cmp(&beyond(*b))).unwrap_or(0.0)
    };
    let found: Vec<(&str, f64)> = materials
        .entries
        .iter()
        .map(|entry| (entry.name.as_str(), of(&entry.rgb)))
        .filter(|(_, albedo)| beyond(*albedo) > SLACK)
        .collect();
    let (name, albedo) = found.iter().max_by(|a, b| beyond(a.1).total_cmp(&beyond(b.1)))?;
    let (count, all) = (found.len(), materials.entries.len());
    let fault = if *albedo > 1.0 { "more than it gets" } else { "less than none" };
    Some(format!(
        "warning: material `{name}` has albedo {albedo:.4}: it reflects {fault} ({count} of {all} \
         materials are beyond 0 to 1); check its unit, 1/sr, and scale it"
    ))
}
