//! A table in integers as Rust source: typed statics for the runtime.

use crate::quantize::{self, Format};
use crate::rust_record::{Constants, array};
use crate::rust_source::{line, words};
use eigenshade_index::pair;
use eigenshade_index::record::integers::{OwnedParts, Parts, Profile, Q15, Q31};

/// The body of a module with the table's numbers, and the lines that name its shape; it names the
/// runtime as `eigenshade`. `command` is what made it, for the first line.
#[must_use]
pub fn module(parts: &OwnedParts<i32>, format: Format, command: &str) -> String {
    let (mut constants, number) = (Constants::default(), format!("eigenshade::{}", name(format)));
    let path = Parts::<Q15>::PATH;
    constants.add("PARTS", path, &number, |to| quantize::visit(parts, format, to));
    let Constants { text, bytes, .. } = constants;
    let mut text = format!("// {command}\n// {bytes} bytes of tables\n{text}");
    let format = name(format);
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
    let mut text = match format {
        Format::Q15 => {
            let mantissas: Vec<Q15> = mantissas.iter().map(|&one| Q15(one as i16)).collect();
            array("TRANSFER_NUMBERS", &mantissas)
        }
        Format::Q31 => {
            let mantissas: Vec<Q31> = mantissas.iter().map(|&one| Q31(one)).collect();
            array("TRANSFER_NUMBERS", &mantissas)
        }
    };
    text += &array("TRANSFER_EXPONENTS", exponents);
    let format = name(format);
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

/// The pairs (p, q) of a material, each with the orders o that are summed, and the azimuths of its
/// transfer.
fn transfer_of(parts: &OwnedParts<i32>) -> String {
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
fn relight(parts: &OwnedParts<i32>) -> String {
    format!("relight {}", azimuths_of(parts))
}

/// The azimuths that have profiles.
fn azimuths_of(parts: &OwnedParts<i32>) -> String {
    words(azimuths(parts).map(|profiles| profiles[0].azimuth))
}

/// The profiles of each azimuth that has some.
fn azimuths(parts: &OwnedParts<i32>) -> impl Iterator<Item = &[Profile]> {
    parts.profiles.chunk_by(|a, b| a.azimuth == b.azimuth)
}

/// The azimuths of a scene and their profiles. Where the sums of the sizes may not fit 32 bits, the
/// basis takes them.
fn collapse(parts: &OwnedParts<i32>) -> String {
    let sum = |stated: fn(&Profile) -> u16, profiles: &[Profile]| {
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
fn shade(parts: &OwnedParts<i32>) -> String {
    let last = parts.lengths.iter().rposition(|&length| length > 0).unwrap_or(0);
    format!("shade {}", words(1..=last))
}
