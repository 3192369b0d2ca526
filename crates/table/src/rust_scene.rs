//! Collapsing and shading of one table as Rust source: calls of the kernels in
//! `eigenshade::fixed`, every size and place a constant.

use crate::parts::{NONE, Parts};
use crate::rust_kernels::put;

/// The function `collapse` of a sphere's module.
pub(crate) fn collapse(parts: &Parts) -> String {
    let mut text = String::from(
        "/// Sums the components of each azimuth: see [`eigenshade::Basis::collapse`].
///
/// # Errors
///
/// As there, but capacities cannot be too small.
#[inline]
pub fn collapse(coefficients: &Coefficients) -> Result<Scene, eigenshade::Error> {
",
    );
    // A mean image is one summand more; the general way takes it.
    if parts.mean.is_empty() {
        text.push_str(&sums(parts));
    }
    text.push_str("    BASIS.collapse::<SCENE>(coefficients)\n}\n");
    text
}

/// One call for each azimuth.
fn sums(parts: &Parts) -> String {
    let (components, terms) = (parts.components, parts.terms.len());
    let mut text = format!(
        "    if let Ok(d) = coefficients.as_slice().try_into() {{
        let d: &[f32; {components}] = d;
        let mut numbers = [0.0; SCENE];
"
    );
    let weight = |component: u16, sign: &str| match component {
        NONE => "0.0".into(),
        _ => format!("{sign}d[{component}]"),
    };
    let (mut start, mut to, mut azimuth) = (0, 0, 0);
    for profiles in parts.profiles.chunk_by(|a, b| a.azimuth == b.azimuth) {
        while azimuth < usize::from(profiles[0].azimuth) {
            to += usize::from(parts.lengths[azimuth]) * if azimuth == 0 { 1 } else { 2 };
            azimuth += 1;
        }
        let (count, length) = (profiles.len(), parts.lengths[azimuth]);
        let weights = profiles.iter().map(|place| match azimuth {
            0 => format!("[{}]", weight(place.plus, "")),
            // Φ_-m = √2 sin(-mβ) = -√2 Im (n_x + i n_y)^m / sin^m.
            _ => format!("[{}, {}]", weight(place.plus, ""), weight(place.minus, "-")),
        });
        let signs = if azimuth == 0 { 1 } else { 2 };
        let weights: Vec<String> = weights.collect();
        put(
            &mut text,
            format_args!(
                "        eigenshade::fixed::collapse::<f32, {start}, {to}, {count}, {signs}, {length}, {terms}, SCENE>(&TERMS, &[{}], &mut numbers);",
                weights.join(", ")
            ),
        );
        start += count * usize::from(length);
    }
    put(
        &mut text,
        format_args!("        return Ok(eigenshade::fixed::collapsed(&LENGTHS, numbers));\n    }}"),
    );
    text
}

/// The function `shade`, which serves the scenes of any table.
pub(crate) fn shade(parts: &Parts) -> String {
    let mut text = String::from(
        "/// The irradiance of one normal: see [`eigenshade::Scene::shade`].
#[inline]
#[must_use]
pub fn shade(scene: &Scene, normal: eigenshade::Normal<f32>) -> f32 {
    let Some(terms) = eigenshade::fixed::scene::<f32, _, SCENE>(scene, &LENGTHS) else {
        return eigenshade::fixed::shade(scene, normal);
    };
",
    );
    let lengths: Vec<usize> = parts.lengths.iter().map(|&length| length.into()).collect();
    let (first, others) = lengths.split_first().map_or((0, &[][..]), |(&first, rest)| (first, rest));
    let mut start = first + 2 * others.iter().sum::<usize>();
    let mut kernel = "highest";
    // Azimuths above the highest that any profile has need nothing.
    for &length in others.iter().rev().skip_while(|&&length| length == 0) {
        start -= 2 * length;
        let shape = format!("{start}, {length}, SCENE");
        let above = if kernel == "highest" { "" } else { ", sum" };
        put(
            &mut text,
            format_args!(
                "    let sum = eigenshade::fixed::{kernel}::<f32, {shape}>(terms, normal{above});"
            ),
        );
        kernel = "azimuth";
    }
    let above = if kernel == "highest" { "[0.0; 2]" } else { "sum" };
    put(
        &mut text,
        format_args!("    eigenshade::fixed::pole::<f32, {first}, SCENE>(terms, normal, {above})\n}}"),
    );
    text
}
