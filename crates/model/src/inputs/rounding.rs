//! Numbers as text: all of their digits, or fewer where a file need not hold more.

use crate::database::Lights;

/// Significant digits of the light files that the project ships: two more than
/// the 32-bit texels of any map have.
pub const LIGHT_DIGITS: usize = 9;

/// The same lights, every coefficient rounded to `digits` significant decimal
/// digits: changed by no more than half a unit of the last, 5e-9 of its value
/// for [`LIGHT_DIGITS`].
#[must_use]
pub fn rounded(lights: &Lights, digits: usize) -> Lights {
    let mut lights = lights.clone();
    let channels = lights.entries.iter_mut().flat_map(|entry| &mut entry.rgb);
    for value in channels.flatten() {
        *value = significant(*value, digits);
    }
    lights
}

/// The nearest number of so many decimal digits, by way of its text, so that
/// writing and reading it keep it.
fn significant(value: f64, digits: usize) -> f64 {
    format!("{value:.*e}", digits.saturating_sub(1)).parse().unwrap_or(value)
}

/// The shortest decimal text that reads back to the same number, to the last bit.
///
/// A number that was an f32 reads back to itself as f32 and as f64.
#[must_use]
pub fn exact(number: f64) -> String {
    let (plain, scientific) = (format!("{number}"), format!("{number:e}"));
    if scientific.len() < plain.len() { scientific } else { plain }
}
