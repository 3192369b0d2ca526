//! Numbers as text, exactly or rounded to fewer digits for smaller files.

use crate::database::Lights;

/// Significant digits of the shipped light files: two more than the 32-bit texels of any map.
pub const LIGHT_DIGITS: usize = 9;

/// The same lights with every coefficient rounded to `digits` significant decimal digits.
///
/// A coefficient changes by at most half a unit in the last digit: 5e-9 of its value for
/// [`LIGHT_DIGITS`].
#[must_use]
pub fn rounded(lights: &Lights, digits: usize) -> Lights {
    let mut lights = lights.clone();
    let channels = lights.entries.iter_mut().flat_map(|entry| &mut entry.rgb);
    for value in channels.flatten() {
        *value = significant(*value, digits);
    }
    lights
}

/// Rounds to this many significant decimal digits. The result comes from parsing decimal text, so
/// writing and reading it back does not change it.
fn significant(value: f64, digits: usize) -> f64 {
    format!("{value:.*e}", digits.saturating_sub(1)).parse().unwrap_or(value)
}

/// The shortest decimal text that reads back as the same number, to the last bit.
///
/// A number that was converted from f32 reads back correctly both as f32 and as f64.
#[must_use]
pub fn exact(number: f64) -> String {
    let (plain, scientific) = (format!("{number}"), format!("{number:e}"));
    if scientific.len() < plain.len() { scientific } else { plain }
}
