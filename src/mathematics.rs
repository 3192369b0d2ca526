//! Roots and angles for setup, in f32: roots by the crate `libm`, to the last bit. Its sines are
//! computed in f64, which most microcontrollers do in software, so angles are split into quarter
//! turns here.

/// √x, for x >= 0.
#[inline]
pub(crate) fn square_root(x: f32) -> f32 {
    libm::sqrtf(x)
}

/// 1/√x, for x > 0.
#[inline]
pub(crate) fn inverse_root(x: f32) -> f32 {
    1.0 / libm::sqrtf(x)
}

/// (sin a, cos a) of an angle a in radians: within 1e-7 for angles to 1,000 rad.
#[inline]
pub(crate) fn sine_and_cosine(angle: f32) -> (f32, f32) {
    let (number, rest) = nearest(angle);
    let square = rest * rest;
    let polynomial = |terms: [f32; 3]| terms.iter().fold(0.0, |sum, term| sum * square + term);
    let sine = rest + rest * (square * polynomial(SINE));
    let cosine = 1.0 - (0.5 * square - square * square * polynomial(COSINE));
    plus_quarters(number, (sine, cosine))
}

/// Polynomials in x², highest term first, that equal (sin x - x) / x³ and (cos x - 1 + x²/2) / x⁴
/// at three Chebyshev nodes of [0, (π/4)²].
const SINE: [f32; 3] = [-1.958_789e-4, 8.332_748e-3, -1.666_666_7e-1];
const COSINE: [f32; 3] = [2.454_794_2e-5, -1.388_830_3e-3, 4.166_666_5e-2];

/// π/2 as a sum of three parts. The first two have so few bits that their products with a small
/// whole number are exact.
const QUARTER: [f32; 3] = [1.570_312_5, 4.837_513e-4, 7.549_79e-8];

/// The number of the nearest multiple of a quarter turn, and the angle less that multiple.
#[inline]
fn nearest(angle: f32) -> (i32, f32) {
    let turns = angle * core::f32::consts::FRAC_2_PI;
    #[expect(clippy::cast_possible_truncation, reason = "whole quarter turns are wanted")]
    let number = (turns + if turns < 0.0 { -0.5 } else { 0.5 }) as i32;
    #[expect(clippy::cast_precision_loss, reason = "few turns are meant")]
    let whole = number as f32;
    (number, QUARTER.iter().fold(angle, |rest, part| rest - whole * part))
}

/// (sin, cos) of an angle plus `quarters` quarter turns, from the (sin, cos) of the angle.
#[inline]
fn plus_quarters(quarters: i32, (sine, cosine): (f32, f32)) -> (f32, f32) {
    match quarters & 3 {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}
