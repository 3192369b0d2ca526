//! Splits an angle into a whole number of parts of a quarter turn and a remainder.

/// π/2 as a sum of three parts. The first two have so few bits that their products with a small
/// whole number are exact.
const QUARTER: [f32; 3] = [1.570_312_5, 4.837_513e-4, 7.549_79e-8];

/// The number of the nearest multiple of a quarter turn / `PARTS`, and the angle less that
/// multiple. `PARTS` is a power of two.
#[inline]
pub(super) fn nearest<const PARTS: u8>(angle: f32) -> (i32, f32) {
    let parts = f32::from(PARTS);
    let turns = angle * (core::f32::consts::FRAC_2_PI * parts);
    #[expect(clippy::cast_possible_truncation, reason = "whole parts of a turn are wanted")]
    let number = (turns + if turns < 0.0 { -0.5 } else { 0.5 }) as i32;
    #[expect(clippy::cast_precision_loss, reason = "few turns are meant")]
    let whole = number as f32 * parts.recip();
    (number, QUARTER.iter().fold(angle, |rest, part| rest - whole * part))
}

/// (sin, cos) of an angle plus `quarters` quarter turns, from the (sin, cos) of the angle.
#[inline]
pub(super) fn turned(quarters: i32, (sine, cosine): (f32, f32)) -> (f32, f32) {
    match quarters & 3 {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}
