//! A table in integers as Rust source: typed statics, a basis whose shape and bounds
//! are checked when they are compiled, and functions with every size a constant.

use crate::quantise::{Format, Place, QuantisedParts};
use eigenshade_index::pair;
use std::fmt::Write;

/// The module's text. `command` is what made it, for the first line.
#[must_use]
pub fn module(parts: &QuantisedParts, command: &str) -> String {
    let format = name(parts.format);
    let degrees = parts.degree + 1;
    let transfer: usize =
        parts.profiles.iter().map(|place| degrees - usize::from(place.azimuth)).sum();
    let lengths = parts.lengths.iter().map(|&length| usize::from(length));
    let scene = 2 * lengths.sum::<usize>() - usize::from(parts.lengths[0]);
    let mut text = format!("// {command}\n// {} bytes of tables\n", bytes(parts));
    for (name, what, value) in [
        ("DEGREE", "Largest degree l of the light.", parts.degree),
        ("ORDER", "Largest order o of the BRDF.", parts.order),
        ("COMPONENTS", "Number of components K.", parts.components),
        (
            "WORKSPACE",
            "Wide numbers that folding needs room for.",
            degrees * (pair::count(parts.order) + 3),
        ),
        ("TRANSFER", "Numbers in a transfer.", transfer),
        ("PROFILES", "Number of slant profiles.", parts.profiles.len()),
        ("SCENE", "Numbers in a scene.", scene),
    ] {
        put(&mut text, format_args!("/// {what}\npub const {name}: usize = {value};"));
    }
    numbers(&mut text, "POLAR", format, &parts.polar);
    array(&mut text, "POLAR_EXPONENTS", "i8", &parts.polar_exponents);
    numbers(&mut text, "FACTORS", format, &parts.factors);
    array(&mut text, "FACTOR_EXPONENTS", "i8", &parts.factor_exponents);
    numbers(&mut text, "TERMS", format, &parts.terms);
    array(&mut text, "LENGTHS", "u8", &parts.lengths);
    let profiles: Vec<String> = parts.profiles.iter().map(profile).collect();
    array(&mut text, "PLACES", "eigenshade::quantised::Profile", &profiles);
    put(&mut text, format_args!("{}", basis(format)));
    text.push_str(&types(format));
    text.push_str(&shade(parts, format));
    text
}

/// The statics of a material folded into such a table, as `transfer` gives it.
#[must_use]
pub fn transfer(format: Format, mantissas: &[i32], exponents: &[i16]) -> String {
    let format = name(format);
    let mut text = String::new();
    numbers(&mut text, "FOLDED", format, mantissas);
    array(&mut text, "FOLDED_EXPONENTS", "i16", exponents);
    put(
        &mut text,
        format_args!(
            "/// The folded material.\npub static MATERIAL: eigenshade::quantised::Transfer<'static, \
             eigenshade::{format}> =\n    eigenshade::quantised::Transfer::new(&FOLDED, \
             &FOLDED_EXPONENTS);"
        ),
    );
    text
}

const fn name(format: Format) -> &'static str {
    match format {
        Format::Q15 => "Q15",
        Format::Q31 => "Q31",
    }
}

/// Bytes of all statics: mantissas, exponents and lengths, 10 a profile.
#[must_use]
pub fn bytes(parts: &QuantisedParts) -> usize {
    let mantissas = parts.polar.len() + parts.factors.len() + parts.terms.len();
    let small = parts.polar_exponents.len() + parts.factor_exponents.len() + parts.lengths.len();
    let each = if parts.format == Format::Q15 { 2 } else { 4 };
    each * mantissas + small + 10 * parts.profiles.len()
}

fn profile(place: &Place) -> String {
    let Place { azimuth, exponent, plus, minus, size, step } = place;
    format!(
        "eigenshade::quantised::Profile::new({azimuth}, {exponent}, [{plus}, {minus}], [{size}, {step}])"
    )
}

fn numbers(text: &mut String, name: &str, format: &str, values: &[i32]) {
    let values: Vec<String> = values.iter().map(|value| format!("q({value})")).collect();
    let inner = if format == "Q15" { "i16" } else { "i32" };
    put(
        text,
        format_args!(
            "static {name}: [eigenshade::{format}; {}] = {{ const fn q(mantissa: {inner}) -> \
             eigenshade::{format} {{ eigenshade::{format}(mantissa) }} [{}] }};",
            values.len(),
            values.join(", ")
        ),
    );
}

fn array(text: &mut String, name: &str, kind: &str, values: &[impl ToString]) {
    let values: Vec<String> = values.iter().map(ToString::to_string).collect();
    put(text, format_args!("static {name}: [{kind}; {}] = [{}];", values.len(), values.join(", ")));
}

fn basis(format: &str) -> String {
    format!(
        "/// The basis; its shape and its bounds were checked when it was compiled.
pub static BASIS: eigenshade::quantised::Basis<'static, eigenshade::{format}> =
    match eigenshade::quantised::Basis::<eigenshade::{format}>::new(eigenshade::quantised::Parts {{
        degree: DEGREE,
        order: ORDER,
        components: COMPONENTS,
        profiles: &PLACES,
        lengths: &LENGTHS,
        polar: &POLAR,
        polar_exponents: &POLAR_EXPONENTS,
        factors: &FACTORS,
        factor_exponents: &FACTOR_EXPONENTS,
        terms: &TERMS,
    }}) {{
        Ok(basis) => basis,
        Err(_) => panic!(\"the table's parts do not fit together\"),
    }};"
    )
}

fn types(format: &str) -> String {
    format!(
        "/// The coefficients d of one image.
pub type Coefficients = eigenshade::quantised::Coefficients<COMPONENTS>;
/// One material, folded into the basis.
pub type Transfer = eigenshade::quantised::TransferBuffer<eigenshade::{format}, TRANSFER, PROFILES>;
/// One image, ready to be shaded.
pub type Scene = eigenshade::quantised::Scene<'static, eigenshade::{format}, eigenshade::quantised::SceneBuffer<SCENE>>;
/// Folds a material into the basis: see [`eigenshade::quantised::Basis::fold`].
///
/// # Errors
///
/// As there, but capacities cannot be too small.
pub fn fold(
    material: &eigenshade::quantised::Material<'_, eigenshade::{format}>,
) -> Result<Transfer, eigenshade::Error> {{
    BASIS.fold::<WORKSPACE, TRANSFER, PROFILES>(material)
}}
/// A new light on a folded material: see [`eigenshade::quantised::Basis::relight`].
///
/// # Errors
///
/// As there, but capacities cannot be too small.
pub fn relight(
    transfer: &eigenshade::quantised::Transfer<'_, eigenshade::{format}>,
    light: &eigenshade::quantised::Light<'_, eigenshade::{format}>,
) -> Result<Coefficients, eigenshade::Error> {{
    BASIS.relight::<COMPONENTS>(transfer, light)
}}
/// Sums the components of each azimuth: see [`eigenshade::quantised::Basis::collapse`].
///
/// # Errors
///
/// As there, but capacities cannot be too small.
pub fn collapse(coefficients: &Coefficients) -> Result<Scene, eigenshade::Error> {{
    BASIS.collapse::<SCENE>(coefficients.mantissas(), coefficients.exponent())
}}
"
    )
}

/// The pixel, unrolled.
fn shade(parts: &QuantisedParts, format: &str) -> String {
    let mut text = format!(
        "/// The irradiance of one normal, times 2 to the power of the scene's negative
/// exponent: [`eigenshade::quantised::Scene::shade`] with every length a constant, bit
/// for bit.
#[inline]
#[must_use]
pub fn shade<B: AsRef<[i32]>>(
    scene: &eigenshade::quantised::Scene<'_, eigenshade::{format}, B>,
    normal: eigenshade::quantised::Normal<eigenshade::{format}>,
) -> i32 {{
    let Some(terms) = scene.terms().first_chunk::<SCENE>() else {{ return 0 }};
    eigenshade::quantised::kernels::Pixel::new::<{}, SCENE>(terms, normal)
",
        parts.lengths[0]
    );
    let mut start = usize::from(parts.lengths[0]);
    let last = parts.lengths.iter().rposition(|&length| length > 0).unwrap_or(0);
    for (azimuth, &length) in parts.lengths.iter().enumerate().take(last + 1).skip(1) {
        if azimuth > 1 {
            put(&mut text, format_args!("        .turned()"));
        }
        put(&mut text, format_args!("        .azimuth::<{start}, {length}, SCENE>(terms)"));
        start += 2 * usize::from(length);
    }
    text.push_str("        .irradiance()\n}\n");
    text
}

fn put(text: &mut String, line: std::fmt::Arguments<'_>) {
    writeln!(text, "{line}").expect("a string takes everything");
}
