//! A table in integers as Rust source: typed statics, a basis whose shape and bounds
//! are checked when they are compiled, and functions with every size a constant.

use crate::quantize::{Format, Place, QuantizedParts};
use crate::rust_quantized_functions as functions;
use crate::rust_source;
use eigenshade_index::pair;
use std::fmt::Write;

/// The module's text. `command` is what made it, for the first line.
#[must_use]
pub fn module(parts: &QuantizedParts, command: &str) -> String {
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
            "Wide numbers in the workspace of a transfer.",
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
    array(&mut text, "PLACES", "eigenshade::quantized::Profile", &profiles);
    put(&mut text, format_args!("{}", basis(format, &rust_source::effects(parts.effects))));
    text.push_str(&types(format));
    text.push_str(&functions::transfer(parts, format));
    text.push_str(&functions::relight(parts, format));
    text.push_str(&functions::collapse(parts, format));
    text.push_str(&functions::shade(parts, format));
    text
}

/// The statics of the transfer of a material, as `transfer` gives it, for a place where the `BASIS`
/// of its table is in scope. Its bounds are checked when it is compiled.
#[must_use]
pub fn transfer(format: Format, mantissas: &[i32], exponents: &[i16]) -> String {
    let format = name(format);
    let mut text = String::new();
    numbers(&mut text, "TRANSFER_NUMBERS", format, mantissas);
    array(&mut text, "TRANSFER_EXPONENTS", "i16", exponents);
    put(
        &mut text,
        format_args!(
            "/// The transfer of the material.
pub static MATERIAL: eigenshade::quantized::Transfer<'static, eigenshade::{format}> =
    match BASIS.checked_transfer(&TRANSFER_NUMBERS, &TRANSFER_EXPONENTS) {{
        Ok(transfer) => transfer,
        Err(_) => panic!(\"the transfer is not of this basis\"),
    }};"
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
pub fn bytes(parts: &QuantizedParts) -> usize {
    let mantissas = parts.polar.len() + parts.factors.len() + parts.terms.len();
    let small = parts.polar_exponents.len() + parts.factor_exponents.len() + parts.lengths.len();
    let each = if parts.format == Format::Q15 { 2 } else { 4 };
    each * mantissas + small + 10 * parts.profiles.len()
}

fn profile(place: &Place) -> String {
    let Place { azimuth, exponent, plus, minus, size, step } = place;
    format!(
        "eigenshade::quantized::Profile::new({azimuth}, {exponent}, [{plus}, {minus}], [{size}, {step}])"
    )
}

fn numbers(text: &mut String, name: &str, format: &str, values: &[i32]) {
    let count = values.len();
    if values.is_empty() {
        put(text, format_args!("static {name}: [eigenshade::{format}; 0] = [];"));
        return;
    }
    let values: Vec<String> = values.iter().map(|value| format!("q({value})")).collect();
    let inner = if format == "Q15" { "i16" } else { "i32" };
    put(
        text,
        format_args!(
            "static {name}: [eigenshade::{format}; {count}] = {{ const fn q(mantissa: {inner}) -> \
             eigenshade::{format} {{ eigenshade::{format}(mantissa) }} [{}] }};",
            values.join(", ")
        ),
    );
}

fn array(text: &mut String, name: &str, kind: &str, values: &[impl ToString]) {
    let values: Vec<String> = values.iter().map(ToString::to_string).collect();
    put(text, format_args!("static {name}: [{kind}; {}] = [{}];", values.len(), values.join(", ")));
}

fn basis(format: &str, effects: &str) -> String {
    format!(
        "/// The basis; its shape and its bounds were checked when it was compiled.
pub static BASIS: eigenshade::quantized::Basis<'static, eigenshade::{format}> =
    match eigenshade::quantized::Basis::<eigenshade::{format}>::new(eigenshade::quantized::Parts {{
        degree: DEGREE,
        order: ORDER,
        effects: {effects},
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
pub type Coefficients = eigenshade::quantized::Coefficients<COMPONENTS>;
/// The transfer of one material.
pub type Transfer = eigenshade::quantized::TransferBuffer<eigenshade::{format}, TRANSFER, PROFILES>;
/// A scene of this table's size.
type Collapsed = eigenshade::quantized::Scene<'static, eigenshade::{format}, eigenshade::quantized::SceneBuffer<SCENE>>;
/// One image, ready to be shaded. It dereferences to an [`eigenshade::quantized::Scene`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scene(Collapsed);
impl core::ops::Deref for Scene {{
    type Target = Collapsed;
    #[inline]
    fn deref(&self) -> &Collapsed {{
        &self.0
    }}
}}
/// An estimate of the coefficients d from pixels.
pub type Estimate = eigenshade::quantized::Estimate<'static, eigenshade::{format}, COMPONENTS>;
/// Starts an estimate from pixels: see [`eigenshade::quantized::Basis::estimate`].
///
/// # Errors
///
/// Never: the capacity is that of this table.
pub fn estimate() -> Result<Estimate, eigenshade::Error> {{
    BASIS.estimate()
}}
"
    )
}

/// A line of text.
pub(crate) fn put(text: &mut String, line: std::fmt::Arguments<'_>) {
    writeln!(text, "{line}").expect("a string takes everything");
}
