//! Roots and angles in f32 alone, without f64 or division: [`SinglePrecision`], which has no
//! tables, and [`Tabled`].
//!
//! Both use the same steps: roots by Newton's method, from an initial value of the reciprocal, and
//! angles split into parts of a quarter turn.

use super::Mathematics;

/// Roots and angles entirely in f32, without f64, division or tables.
///
/// Roots and their reciprocals have a relative error within 2e-7 if x is a normal number. Sines and
/// cosines are within 1e-7 for angles to 1,000 rad.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SinglePrecision;

/// Polynomials in x², highest term first, that equal (sin x - x) / x³ and (cos x - 1 + x²/2) / x⁴
/// at three Chebyshev nodes of [0, (π/4)²].
const SINE: [f32; 3] = [-1.958_789e-4, 8.332_748e-3, -1.666_666_7e-1];
const COSINE: [f32; 3] = [2.454_794_2e-5, -1.388_830_3e-3, 4.166_666_5e-2];

impl Mathematics<f32> for SinglePrecision {
    #[inline]
    fn square_root(x: f32) -> f32 {
        root_by_newton(x, Self::inverse_root(x))
    }

    /// Newton's method, starting from half the exponent.
    #[inline]
    fn inverse_root(x: f32) -> f32 {
        let first = f32::from_bits(0x5f37_5a86_u32.wrapping_sub(x.to_bits() >> 1));
        inverse_by_newton::<3>(x, first)
    }

    #[inline]
    fn sine_and_cosine(angle: f32) -> (f32, f32) {
        let (number, rest) = nearest::<1>(angle);
        let square = rest * rest;
        let polynomial = |terms: [f32; 3]| terms.iter().fold(0.0, |sum, term| sum * square + term);
        let sine = rest + rest * (square * polynomial(SINE));
        let cosine = 1.0 - (0.5 * square - square * square * polynomial(COSINE));
        plus_quarters(number, (sine, cosine))
    }
}

/// Roots and angles from two small tables, 388 bytes in all, without f64 or division.
///
/// Roots and their reciprocals start from a table of the mantissa and take two steps of Newton's
/// method. Sines and cosines are Taylor series of three terms around the nearest of 33 knots in a
/// quarter turn, whose derivatives come from the same table. Roots have a relative error within
/// 1.1e-7 if x is a normal number. Sines and cosines are within 8e-8 for angles to 1,000 rad.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Tabled;

/// Intervals per quarter turn.
const INTERVALS: u8 = 32;

impl Mathematics<f32> for Tabled {
    #[inline]
    fn square_root(x: f32) -> f32 {
        root_by_newton(x, Self::inverse_root(x))
    }

    #[inline]
    fn inverse_root(x: f32) -> f32 {
        let bits = x.to_bits();
        // The last bit of the exponent and the first five of the mantissa.
        let place = (bits >> 18) as usize & 63;
        let of_mantissa = INVERSE_ROOTS.get(place).copied().unwrap_or(1.0);
        let of_exponent = f32::from_bits((190 - ((bits >> 24) & 127)) << 23);
        inverse_by_newton::<2>(x, of_mantissa * of_exponent)
    }

    #[inline]
    fn sine_and_cosine(angle: f32) -> (f32, f32) {
        let (knot, rest) = nearest::<INTERVALS>(angle);
        let place = (knot & 31) as usize;
        let value = |place: usize| SINES.get(place).copied().unwrap_or(0.0);
        let (sine, cosine) = (value(place), value(32 - place));
        let third = rest * (1.0 / 3.0);
        let half = 0.5 * rest;
        let turned = (
            sine + rest * (cosine - half * (sine + third * cosine)),
            cosine - rest * (sine + half * (cosine - third * sine)),
        );
        plus_quarters(knot >> 5, turned)
    }
}

/// sin(k π/64) for k = 0 to 32; read backward, these are the cosines.
#[rustfmt::skip]
const SINES: [f32; 33] = [
    0.0, 0.049_067_676, 0.098_017_14, 0.146_730_47, 0.195_090_32, 0.242_980_18, 0.290_284_66,
    0.336_889_86, 0.382_683_43, 0.427_555_08, 0.471_396_74, 0.514_102_76, 0.555_570_24, 0.595_699_3,
    0.634_393_3, 0.671_559, 0.707_106_77, 0.740_951_1, 0.773_010_43, 0.803_207_5, 0.831_469_6,
    0.857_728_6, 0.881_921_3, 0.903_989_3, 0.923_879_5, 0.941_544_06, 0.956_940_35, 0.970_031_26,
    0.980_785_25, 0.989_176_5, 0.995_184_7, 0.998_795_45, 1.0,
];

/// 1/√m of mantissas m, midway between the values at both ends of an interval: for 32 intervals of
/// m in [2, 4), doubled, then for 32 intervals of m in [1, 2).
#[rustfmt::skip]
const INVERSE_ROOTS: [f32; 64] = [
    1.403_334_4, 1.382_228, 1.362_046_2, 1.342_723_5, 1.324_200_5, 1.306_423_5, 1.289_344,
    1.272_917_2, 1.257_102_7, 1.241_863_4, 1.227_165_2, 1.212_976_9, 1.199_269_7, 1.186_016_8,
    1.173_193_9, 1.160_778, 1.148_748_3, 1.137_085, 1.125_769_9, 1.114_785_9, 1.104_117_4,
    1.093_749_4, 1.083_668_1, 1.073_860_5, 1.064_314_6, 1.055_018_8, 1.045_962_2, 1.037_135_1,
    1.028_527_7, 1.020_131_1, 1.011_936_9, 1.003_937_1, 0.992_307_25, 0.977_382_8, 0.963_112_1,
    0.949_448_9, 0.936_351_1, 0.923_781, 0.911_703_8, 0.900_088_37, 0.888_905_8, 0.878_13,
    0.867_736_8, 0.857_704_2, 0.848_011_7, 0.838_640_5, 0.829_573_33, 0.820_794_05, 0.812_287_75,
    0.804_040_5, 0.796_039_5, 0.788_272_74, 0.780_728_94, 0.773_397_6, 0.766_269_1, 0.759_334_1,
    0.752_584_04, 0.746_010_9, 0.739_607_04, 0.733_365_3, 0.727_278_95, 0.721_341_67, 0.715_547_5,
    0.709_890_7,
];

/// 1/√x after `STEPS` steps from `first`. Each step turns a relative error e into 3/2 e².
#[inline]
fn inverse_by_newton<const STEPS: usize>(x: f32, first: f32) -> f32 {
    let mut inverse = first;
    for _ in 0..STEPS {
        inverse += 0.5 * inverse * (1.0 - x * inverse * inverse);
    }
    inverse
}

/// √x from 1/√x, with one more step.
#[inline]
fn root_by_newton(x: f32, inverse: f32) -> f32 {
    let root = x * inverse;
    root + 0.5 * inverse * (x - root * root)
}

/// π/2 as a sum of three parts. The first two have so few bits that their products with a small
/// whole number are exact.
const QUARTER: [f32; 3] = [1.570_312_5, 4.837_513e-4, 7.549_79e-8];

/// The number of the nearest multiple of a quarter turn / `PARTS`, and the angle less that
/// multiple. `PARTS` is a power of two.
#[inline]
fn nearest<const PARTS: u8>(angle: f32) -> (i32, f32) {
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
    use super::{INVERSE_ROOTS, SINES};
    use core::f64::consts::PI;

    #[test]
    fn tables_are_rounded_once() {
        let near = |found: f32, expected: f64| (f64::from(found) - expected).abs() <= 6e-8;
        for (k, &sine) in SINES.iter().enumerate() {
            assert!(near(sine, libm::sin(k as f64 * PI / 64.0)), "{k}");
        }
        for (k, &inverse) in INVERSE_ROOTS.iter().enumerate() {
            let (octave, start) = (1 - k / 32, 1.0 + (k % 32) as f64 / 32.0);
            let root = |m: f64| libm::sqrt(m * if octave == 1 { 2.0 } else { 1.0 });
            let middle = 2.0 / (root(start) + root(start + 1.0 / 32.0));
            let expected = if octave == 1 { 2.0 * middle } else { middle };
            assert!(near(inverse, expected), "{k}: {inverse} for {expected}");
        }
    }
}
