//! A table in integers as Rust source: typed statics for the runtime.

use crate::quantize::{Format, Place, QuantizedParts};
use crate::rust_source::{array, effects, line, words};
use eigenshade_index::pair;

/// The body of a module with the table's numbers, and the lines that name its shape; it names the
/// runtime as `eigenshade`. `command` is what made it, for the first line.
#[must_use]
pub fn module(parts: &QuantizedParts, command: &str) -> String {
    let format = name(parts.format);
    let mut text = format!("// {command}\n// {} bytes of tables\n", bytes(parts));
    numbers(&mut text, "POLAR", format, &parts.polar);
    array(&mut text, "POLAR_EXPONENTS", "i8", parts.polar_exponents.iter().map(i8::to_string));
    numbers(&mut text, "FACTORS", format, &parts.factors);
    array(&mut text, "FACTOR_EXPONENTS", "i8", parts.factor_exponents.iter().map(i8::to_string));
    numbers(&mut text, "TERMS", format, &parts.terms);
    array(&mut text, "LENGTHS", "u8", parts.lengths.iter().map(u8::to_string));
    let profile = "eigenshade::quantized::Profile";
    array(&mut text, "PLACES", profile, parts.profiles.iter().map(place));
    text.push_str(&record(parts));
    line(&mut text, format_args!("eigenshade::integer_table!({format});"));
    for functions in [transfer_of(parts), relight(parts), collapse(parts), shade(parts)] {
        line(&mut text, format_args!("eigenshade::integer_table!({format} {functions});"));
    }
    text
}

/// The statics of the transfer of a material, as `transfer` gives it, for a place where the `BASIS`
/// of its table is in scope. Its bounds are checked when it is compiled.
#[must_use]
pub fn transfer(format: Format, mantissas: &[i32], exponents: &[i16]) -> String {
    let format = name(format);
    let mut text = String::new();
    numbers(&mut text, "TRANSFER_NUMBERS", format, mantissas);
    array(&mut text, "TRANSFER_EXPONENTS", "i16", exponents.iter().map(i16::to_string));
    line(
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

fn place(place: &Place) -> String {
    let Place { azimuth, exponent, plus, minus, size, step } = place;
    format!(
        "eigenshade::quantized::Profile::new({azimuth}, {exponent}, [{plus}, {minus}], [{size}, {step}])"
    )
}

/// A static array of mantissas.
fn numbers(text: &mut String, name: &str, format: &str, values: &[i32]) {
    let kind = format!("eigenshade::{format}");
    let values = values.iter().map(|value| format!("{kind}({value})"));
    array(text, name, &kind, values);
}

/// The record of the parts.
fn record(parts: &QuantizedParts) -> String {
    let QuantizedParts { degree, order, components, .. } = parts;
    let (format, effects) = (name(parts.format), effects(parts.effects));
    format!(
        "const PARTS: eigenshade::quantized::Parts<'static, eigenshade::{format}> =
    eigenshade::quantized::Parts {{
        degree: {degree},
        order: {order},
        effects: {effects},
        components: {components},
        profiles: &PLACES,
        lengths: &LENGTHS,
        polar: &POLAR,
        polar_exponents: &POLAR_EXPONENTS,
        factors: &FACTORS,
        factor_exponents: &FACTOR_EXPONENTS,
        terms: &TERMS,
    }};
"
    )
}

/// The pairs (p, q) of a material, each with the orders o that are summed, and the azimuths of its
/// transfer.
fn transfer_of(parts: &QuantizedParts) -> String {
    if parts.polar.is_empty() {
        return "transfer by basis".into();
    }
    let pairs = pair::indices(parts.order).map(|(p, q)| {
        let coupled = |o: &usize| parts.effects.factored(p.max(*o));
        let orders = (q..=parts.order).step_by(2).filter(coupled);
        format!("[{p} {q} {}]", words(orders))
    });
    format!("transfer scatter {} azimuths {}", words(pairs), azimuths_of(parts))
}

/// The azimuths of a transfer.
fn relight(parts: &QuantizedParts) -> String {
    format!("relight {}", azimuths_of(parts))
}

/// The azimuths that have profiles.
fn azimuths_of(parts: &QuantizedParts) -> String {
    words(azimuths(parts).map(|profiles| profiles[0].azimuth))
}

/// The profiles of each azimuth that has some.
fn azimuths(parts: &QuantizedParts) -> impl Iterator<Item = &[Place]> {
    parts.profiles.chunk_by(|a, b| a.azimuth == b.azimuth)
}

/// The azimuths of a scene and their profiles. Where the sums of the sizes may not fit 32 bits, the
/// basis takes them.
fn collapse(parts: &QuantizedParts) -> String {
    let sum = |stated: fn(&Place) -> u16, profiles: &[Place]| {
        profiles.iter().map(|place| u32::from(stated(place))).sum::<u32>()
    };
    let steps = azimuths(parts).map(|profiles| sum(|place| place.step, profiles));
    let largest = steps.chain([2 * sum(|place| place.size, &parts.profiles)]).max();
    // Times 2^15, and what may be missing.
    if largest.unwrap_or(0) >= 1 << 16 {
        return "collapse by basis".into();
    }
    let azimuths = azimuths(parts);
    let azimuths = azimuths.map(|profiles| format!("[{} {}]", profiles[0].azimuth, profiles.len()));
    format!("collapse {}", words(azimuths))
}

/// The azimuths of a pixel.
fn shade(parts: &QuantizedParts) -> String {
    let last = parts.lengths.iter().rposition(|&length| length > 0).unwrap_or(0);
    format!("shade {}", words(1..=last))
}
