//! Roots and angles for setup, in f32 alone: many microcontrollers compute f64 in software, and the
//! crate `libm` takes roots by integer loops and sines in f64. So roots are taken by Newton's
//! method, and angles are split into quarter turns.

/// √x, for x = 0 and normal numbers x > 0: within 2e-7 of itself. Too small for subnormal numbers,
/// and not a number for infinity.
#[inline]
pub(crate) fn square_root(x: f32) -> f32 {
    let inverse = inverse_root(x);
    let root = x * inverse;
    root + 0.5 * inverse * (x - root * root)
}

/// 1/√x, for normal numbers x > 0: within 2e-7 of itself. Newton's method, starting from half the
/// exponent.
#[inline]
pub(crate) fn inverse_root(x: f32) -> f32 {
    let first = f32::from_bits(0x5f37_5a86_u32.wrapping_sub(x.to_bits() >> 1));
    // Each step turns a relative error e into 3/2 e².
    (0..3).fold(first, |inverse, _| inverse + 0.5 * inverse * (1.0 - x * inverse * inverse))
}

/// (sin a, cos a) of an angle a in radians: within 1e-7 for angles to 1,000 rad. To 1e9 rad, of an
/// angle that differs from a by a rounding or two.
#[inline]
pub(crate) fn sine_and_cosine(angle: f32) -> (f32, f32) {
    let (number, rest) = nearest(angle);
    // What is left of many turns is rounded as the angle is, and may be more than half a quarter.
    let (more, rest) = nearest(rest);
    let square = rest * rest;
    let polynomial = |terms: [f32; 3]| terms.iter().fold(0.0, |sum, term| sum * square + term);
    let sine = rest + rest * (square * polynomial(SINE));
    let cosine = 1.0 - (0.5 * square - square * square * polynomial(COSINE));
    plus_quarters(number.wrapping_add(more), (sine, cosine))
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

#[cfg(test)]
mod tests {
    use super::{inverse_root, sine_and_cosine, square_root};

    /// Roots by Newton's method, relative: a few roundings.
    const ROOT: f64 = 2e-7;

    /// Sines and cosines to 1,000 rad: roundings of a polynomial and of the angle's rest.
    const ANGLE: f64 = 1e-7;

    #[test]
    fn roots_are_as_close_as_stated() {
        // All of two octaves, a few of all others.
        let bits =
            (0x3f80_0000..0x4080_0000).step_by(7).chain((0x0080_0000..0x7f80_0000).step_by(4_999));
        for x in bits.map(f32::from_bits) {
            let root = libm::sqrt(f64::from(x));
            for found in [f64::from(square_root(x)) / root, f64::from(inverse_root(x)) * root] {
                assert!((found - 1.0).abs() <= ROOT, "{x}: {found}");
            }
        }
        assert_eq!(square_root(0.0), 0.0);
    }

    #[test]
    fn angles_are_as_close_as_stated() {
        for most in [0.1, 1_000.0] {
            for k in -500_000..=500_000 {
                let angle = most * k as f32 / 500_000.0;
                let (sine, cosine) = sine_and_cosine(angle);
                let expected = libm::sincos(f64::from(angle));
                assert!((f64::from(sine) - expected.0).abs() <= ANGLE, "{angle}: {sine}");
                assert!((f64::from(cosine) - expected.1).abs() <= ANGLE, "{angle}: {cosine}");
            }
        }
        assert_eq!(sine_and_cosine(0.0), (0.0, 1.0));
        for k in 0..10_000 {
            let angle = 1_000.0 * libm::powf(1e6, k as f32 / 10_000.0);
            let (sine, cosine) = sine_and_cosine(angle);
            let one = f64::from(sine) * f64::from(sine) + f64::from(cosine) * f64::from(cosine);
            assert!((one - 1.0).abs() <= 4.0 * ANGLE, "{angle}: {sine}, {cosine}");
            let turned = libm::atan2(sine.into(), cosine.into());
            let apart = libm::remainder(f64::from(angle) - turned, core::f64::consts::TAU).abs();
            assert!(apart <= 2.5e-7 * f64::from(angle), "{angle}: {apart}");
        }
        for none in [f32::NAN, f32::INFINITY, -f32::INFINITY] {
            let (sine, cosine) = sine_and_cosine(none);
            assert!(!sine.is_finite() && !cosine.is_finite(), "{none}: {sine}, {cosine}");
        }
    }
}
