//! Steps that several implementations share: roots by Newton's method, from an initial value of the
//! reciprocal and without division, and angles split into parts of a quarter turn.

/// 1/√x after `STEPS` steps from `first`. Each step turns a relative error e into 3/2 e².
#[inline]
pub(super) fn inverse_root<const STEPS: usize>(x: f32, first: f32) -> f32 {
    let mut inverse = first;
    for _ in 0..STEPS {
        inverse += 0.5 * inverse * (1.0 - x * inverse * inverse);
    }
    inverse
}

/// √x from 1/√x, with one more step.
#[inline]
pub(super) fn square_root(x: f32, inverse: f32) -> f32 {
    let root = x * inverse;
    root + 0.5 * inverse * (x - root * root)
}

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
