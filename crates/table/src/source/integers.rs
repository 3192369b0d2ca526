//! A record of integers as Rust source.

use super::{Constants, array, line, words};
use crate::pair;
use crate::record::integers::{Parts, Profile, Q15};
use alloc::format;
use alloc::string::String;

/// The body of a module with the numbers of a table. `command` is what made it, for the first line.
#[must_use]
pub fn module(parts: &Parts<'_, Q15>, command: &str) -> String {
    let mut constants = Constants::default();
    constants.add("PARTS", Parts::<Q15>::PATH, |to| parts.visit(to));
    let mut text = constants.headed(command);
    line(&mut text, format_args!("eigenshade::integer_table!(basis);"));
    for functions in [transfer_of(parts), relight(parts), collapse(parts), shade(parts)] {
        line(&mut text, format_args!("eigenshade::integer_table!({functions});"));
    }
    text
}

/// The statics of the transfer of a material, as `transfer` gives it, for a place where the `BASIS`
/// of its table is in scope. The compiler checks the bounds of the transfer.
#[must_use]
pub fn transfer(mantissas: &[Q15], exponents: &[i16]) -> String {
    let mut text = array("TRANSFER_NUMBERS", mantissas) + &array("TRANSFER_EXPONENTS", exponents);
    text += "/// The transfer of the material.
pub static MATERIAL: eigenshade::q15::Transfer<'static> =
    match BASIS.checked_transfer(&TRANSFER_NUMBERS, &TRANSFER_EXPONENTS) {
        Ok(transfer) => transfer,
        Err(_) => panic!(\"the transfer is not of this basis\"),
    };
";
    text
}

/// The pairs (p, q) of a material, each with the orders o that are summed, and the azimuths of its
/// transfer.
fn transfer_of(parts: &Parts<'_, Q15>) -> String {
    if parts.polar.is_empty() {
        return "transfer by basis".into();
    }
    let pairs = pair::indices(parts.order)
        .map(|(p, q)| format!("[{p} {q} {}]", words((q..=parts.order).step_by(2))));
    format!("transfer scatter {} azimuths {}", words(pairs), azimuths_of(parts))
}

/// The azimuths of a transfer.
fn relight(parts: &Parts<'_, Q15>) -> String {
    format!("relight {}", azimuths_of(parts))
}

/// The azimuths that have profiles.
fn azimuths_of(parts: &Parts<'_, Q15>) -> String {
    words(azimuths(parts).map(|profiles| profiles[0].azimuth))
}

/// The profiles of each azimuth that has some.
fn azimuths<'a>(parts: &Parts<'a, Q15>) -> impl Iterator<Item = &'a [Profile]> + use<'a> {
    parts.profiles.chunk_by(|a, b| a.azimuth == b.azimuth)
}

/// The azimuths of a scene and their profiles. Where the sums of the sizes may not fit 32 bits, the
/// basis takes them.
fn collapse(parts: &Parts<'_, Q15>) -> String {
    let sum = |stated: fn(&Profile) -> u16, profiles: &[Profile]| {
        profiles.iter().map(|place| u32::from(stated(place))).sum::<u32>()
    };
    let steps = azimuths(parts).map(|profiles| sum(|place| place.step, profiles));
    let largest = steps.chain([2 * sum(|place| place.size, parts.profiles)]).max();
    // Times 2^15, and what may be missing.
    if largest.unwrap_or(0) >= 1 << 16 {
        return "collapse by basis".into();
    }
    let azimuths = azimuths(parts);
    let azimuths = azimuths.map(|profiles| format!("[{} {}]", profiles[0].azimuth, profiles.len()));
    format!("collapse {}", words(azimuths))
}

/// The azimuths of a pixel.
fn shade(parts: &Parts<'_, Q15>) -> String {
    let last = parts.lengths.iter().rposition(|&length| length > 0).unwrap_or(0);
    format!("shade {}", words(1..=last))
}
