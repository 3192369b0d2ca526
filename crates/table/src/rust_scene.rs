//! Collapsing and shading of one table as Rust source: calls of the kernels in
//! `eigenshade::specialized`, every size and place a constant.

use crate::parts::Parts;
use crate::rust_kernels::put;

/// The functions `collapse` and `collapse_into` of a sphere's module.
pub(crate) fn collapse(parts: &Parts) -> String {
    // A mean image is one summand more, and orthogonal polynomials have recurrences: the general
    // way takes both.
    let general = !parts.mean.is_empty() || !parts.recurrences.is_empty();
    let sums = if general { String::new() } else { sums(parts) };
    let blank = match parts.recurrences.is_empty() {
        true => "Scene(eigenshade::specialized::blank_scene(&LENGTHS))",
        false => "Scene(BASIS.collapse::<SCENE>(&[])?)",
    };
    format!(
        "/// Sums the components of each azimuth: see [`eigenshade::Basis::collapse`].
///
/// # Errors
///
/// The same, except that no capacity can be too small.
pub fn collapse(coefficients: &Coefficients) -> Result<Scene, eigenshade::Error> {{
    let mut scene = {blank};
    collapse_into(coefficients, &mut scene)?;
    Ok(scene)
}}
/// [`collapse`] into an existing scene, without moving it.
///
/// # Errors
///
/// The same; `scene` is then unchanged.
pub fn collapse_into(
    coefficients: &Coefficients,
    scene: &mut Scene,
) -> Result<(), eigenshade::Error> {{
{sums}    collapse_generally(coefficients, scene)
}}
#[cold]
#[inline(never)]
fn collapse_generally(
    coefficients: &Coefficients,
    scene: &mut Scene,
) -> Result<(), eigenshade::Error> {{
    *scene = Scene(BASIS.collapse::<SCENE>(coefficients)?);
    Ok(())
}}
"
    )
}

/// One call for each azimuth.
fn sums(parts: &Parts) -> String {
    let (components, terms) = (parts.components, parts.terms.len());
    let mut text = String::from(
        "    if let (Ok(d), Some(numbers)) =
        (coefficients.as_slice().try_into(), eigenshade::specialized::scene_mut(&mut scene.0, &LENGTHS))
    {
",
    );
    let (mut start, mut to, mut azimuth) = (0, 0, 0);
    for profiles in parts.profiles.chunk_by(|a, b| a.azimuth == b.azimuth) {
        while azimuth < usize::from(profiles[0].azimuth) {
            to += usize::from(parts.lengths[azimuth]) * if azimuth == 0 { 1 } else { 2 };
            azimuth += 1;
        }
        let (count, length) = (profiles.len(), parts.lengths[azimuth]);
        let of_profile = profiles.iter().map(|place| match azimuth {
            0 => format!("[{}]", place.plus),
            _ => format!("[{}, {}]", place.plus, place.minus),
        });
        let signs = if azimuth == 0 { 1 } else { 2 };
        let of_profiles: Vec<String> = of_profile.collect();
        put(
            &mut text,
            format_args!(
                "        eigenshade::specialized::collapse::<f32, {start}, {to}, {count}, {signs}, {length}, {terms}, {components}, SCENE>(&TERMS, &[{}], d, numbers);",
                of_profiles.join(", ")
            ),
        );
        start += count * usize::from(length);
    }
    text.push_str("        return Ok(());\n    }\n");
    text
}

/// The function `shade`, which serves the scenes of any table, and its half for those of
/// this one; where azimuths have recurrences there is no such half.
pub(crate) fn shade(parts: &Parts) -> String {
    if !parts.recurrences.is_empty() {
        return String::from(
            "/// [`eigenshade::Scene::shade`].
#[inline]
#[must_use]
pub fn shade<B: AsRef<[f32]>>(
    scene: &eigenshade::Scene<'_, B>,
    normal: eigenshade::Normal<f32>,
) -> f32 {
    scene.shade(normal)
}
",
        );
    }
    let nine_terms = has_nine_terms(&parts.lengths);
    let (terms, asked_for) = if nine_terms {
        ("eigenshade::NineTerms<f32>", "scene.nine_terms()")
    } else {
        ("&'s [f32; SCENE]", "eigenshade::specialized::scene::<f32, _, SCENE>(scene, &LENGTHS)")
    };
    let by_terms = terms.replace("'s ", "");
    let (lifetime, of_scene) = if nine_terms { ("", "") } else { ("'s, ", "'s ") };
    let mut text = format!(
        "impl Scene {{
    /// The irradiance of one normal: see [`eigenshade::Scene::shade`], with every
    /// length a constant.
    #[inline]
    #[must_use]
    pub fn shade(&self, normal: eigenshade::Normal<f32>) -> f32 {{
        shade(&self.0, normal)
    }}
}}
/// [`Scene::shade`] for a scene in a buffer of any type, of any basis.
#[doc(hidden)]
#[inline]
#[must_use]
pub fn shade<B: AsRef<[f32]>>(
    scene: &eigenshade::Scene<'_, B>,
    normal: eigenshade::Normal<f32>,
) -> f32 {{
    match terms(scene) {{
        Some(terms) => shade_terms(terms, normal),
        None => eigenshade::specialized::shade(scene, normal),
    }}
}}
/// The polynomials of a scene, for [`shade_terms`]; `None` for a scene of another basis. A loop
/// over pixels asks once instead of at each pixel.
#[doc(hidden)]
#[inline]
#[must_use]
pub fn terms<{lifetime}B: AsRef<[f32]>>(
    scene: &{of_scene}eigenshade::Scene<'_, B>,
) -> Option<{terms}> {{
    {asked_for}
}}
/// The irradiance of one normal from the [`terms`] of a scene: bit for bit that of [`shade`].
#[doc(hidden)]
#[inline]
#[must_use]
pub fn shade_terms(terms: {by_terms}, normal: eigenshade::Normal<f32>) -> f32 {{
",
    );
    if nine_terms {
        text.push_str("    terms.shade(normal)\n}\n");
        return text;
    }
    let lengths: Vec<usize> = parts.lengths.iter().map(|&length| length.into()).collect();
    let (first, others) =
        lengths.split_first().map_or((0, &[][..]), |(&first, rest)| (first, rest));
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
                "    let sum = eigenshade::specialized::{kernel}::<f32, {shape}>(terms, normal{above});"
            ),
        );
        kernel = "azimuth";
    }
    let above = if kernel == "highest" { "[0.0; 2]" } else { "sum" };
    put(
        &mut text,
        format_args!(
            "    eigenshade::specialized::pole::<f32, {first}, SCENE>(terms, normal, {above})\n}}"
        ),
    );
    text
}

/// Whether a scene of polynomials of these lengths is one of at most nine terms of the normal,
/// and of more than azimuth 0.
fn has_nine_terms(lengths: &[u16]) -> bool {
    let last = lengths.iter().rposition(|&length| length > 0).unwrap_or(0);
    matches!(lengths[..=last], [..=3, ..=2] | [..=3, ..=2, ..=1])
}
