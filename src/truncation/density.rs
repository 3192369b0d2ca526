//! Polynomials in t = 2z - 1 that are orthogonal over a sphere's normals, azimuth by azimuth.
//!
//! The weight of the polynomials is the density 2z dz of the normals times sin^2m = (1 - z²)^m. For
//! m = 0 they are the Jacobi polynomials of (0, 1), whose recurrence is known. From m to m + 1 the
//! density gains the factor (1 - t)(3 + t) / 4. For each of the two linear factors the recurrence
//! takes one step: its Cholesky factors are multiplied in reverse order (Christoffel's
//! transformation). Both steps together reduce the number of known terms by one.

use crate::groups::multiply_add;
use crate::index::layout::{LANES, MAX_DEGREE, MAX_TERMS};
use crate::mathematics;
use crate::shade::{doubled, values};

/// Terms of the recurrence of m = 0. Azimuth m has m terms fewer.
const TERMS: usize = MAX_DEGREE + MAX_TERMS;

/// The orthogonal polynomials of one azimuth, p_k+1 = (2t - at_k) p_k - below_k p_k-1, p_0 = 1.
pub(super) struct Density {
    azimuth: usize,
    terms: usize,
    /// The coefficients at_k and below_k of the current azimuth.
    pub(super) recurrence: [[f32; 2]; TERMS],
}

impl Density {
    /// The density of m = 0, for polynomials of azimuth m with up to `terms` - m terms.
    pub(super) fn new(terms: usize) -> Self {
        let mut recurrence = [[0.0; 2]; TERMS];
        let two = 1.0 + 1.0;
        let (mut odd, mut left) = (1.0_f32, 1.0_f32);
        // 2 / (2k + 1)(2k + 3) and 4 k (k + 1) / (2k + 1)².
        for [at, below] in recurrence.iter_mut().take(terms) {
            odd += two;
            let right = odd.recip();
            (*at, *below) = (two * left * right, 1.0 - left * left);
            left = right;
        }
        Self { azimuth: 0, terms, recurrence }
    }

    /// The coefficients below_k of the current azimuth.
    pub(super) fn below(&self) -> impl Iterator<Item = f32> {
        self.recurrence.iter().map(|&[_, below]| below)
    }

    /// Advances to a higher azimuth: for each step, the density is multiplied by 2 - 2t, then by
    /// 2t + 6. The last known row needs part of an unknown one, so each step loses one row.
    pub(super) fn turn_to(&mut self, azimuth: usize) {
        let (two, six) = (2.0, 6.0);
        while self.azimuth < azimuth {
            let mut rows = self.recurrence.iter_mut().take(self.terms);
            let Some(mut before) = rows.next() else { return };
            // A pivot of the first factor, and the difference of a pivot of the second.
            let (mut pivot, mut lack) = (two - before[0], 0.0);
            for row in rows {
                let share = row[1] * pivot.recip();
                let second = two - pivot - share + six - lack;
                let below = lack * second;
                pivot = two - row[0] - share;
                lack = share * pivot * second.recip();
                *before = [second + lack - six, below];
                before = row;
            }
            self.azimuth += 1;
            self.terms -= 1;
        }
    }
}

/// The root mean squares of an azimuth's polynomials over a sphere, from their below_k.
pub(super) fn sizes(azimuth: usize, below: impl Iterator<Item = f32>) -> impl Iterator<Item = f32> {
    // The root mean square of sin^m cos mβ.
    let mut size =
        if azimuth == 0 { 1.0 } else { mathematics::inverse_root((2 * azimuth + 2) as f32) };
    below.enumerate().map(move |(k, below)| {
        if k > 0 {
            size *= mathematics::square_root(below);
        }
        size
    })
}

/// Gauss's rule for the density 2z dz of a sphere's normals: nodes t = 2z - 1, and weights that sum
/// to 1. It is exact for polynomials of twice as many terms.
pub(super) const NODES: [(f64, f64); 20] = [
    (-0.983_399_911_585_865_5, 0.000_230_763_814_351_370_58),
    (-0.944_713_893_294_873_8, 0.001_366_124_552_171_844),
    (-0.884_931_084_726_372_7, 0.004_022_915_227_928_156),
    (-0.805_391_743_586_907_4, 0.008_646_438_225_380_306),
    (-0.707_873_506_071_780_9, 0.015_455_335_860_102_926),
    (-0.594_555_016_673_189_4, 0.024_408_092_253_360_21),
    (-0.467_967_716_471_318_9, 0.035_194_133_758_412_03),
    (-0.330_939_397_811_027_3, 0.047_250_592_347_097_79),
    (-0.186_531_066_967_013, 0.059_803_483_685_258_03),
    (-0.037_968_577_407_147_46, 0.071_929_838_307_725_5),
    (0.111_429_426_073_977_68, 0.082_635_413_633_331_48),
    (0.258_325_638_831_206_2, 0.090_941_177_882_706_95),
    (0.399_438_646_328_099_7, 0.095_970_923_219_887_83),
    (0.531_616_227_372_815_6, 0.097_032_210_119_708_18),
    (0.651_905_774_728_915_7, 0.093_683_383_725_115_66),
    (0.757_620_265_352_647_9, 0.085_780_591_675_956_4),
    (0.846_398_325_820_756_1, 0.073_500_479_673_295_7),
    (0.916_257_137_764_469_6, 0.057_336_474_758_261_19),
    (0.965_637_563_709_488_6, 0.038_069_938_927_403_33),
    (0.993_447_786_661_899_8, 0.016_741_688_352_545_114),
];

/// The mean square of `scale` times sin^m (P cos mβ + Q sin mβ), for polynomials of equal length.
/// It is exact if m and this length are together at most the number of [`NODES`].
pub(super) fn mean_square(azimuth: usize, [plus, minus]: [&[f32]; 2], scale: f32) -> f32 {
    let [mut t, mut weights, mut squares] = [[0.0; NODES.len()]; 3];
    let places = t.iter_mut().zip(&mut weights).zip(&mut squares);
    for (((t, weight), square), node) in places.zip(NODES) {
        // sin² = 1 - z².
        let of_sine = 0.25 * (1.0 - node.0) * (3.0 + node.0);
        (*t, *weight, *square) = ((node.0) as f32, (node.1) as f32, (of_sine) as f32);
    }
    for _ in 0..azimuth {
        weights.iter_mut().zip(&squares).for_each(|(weight, &square)| *weight *= square);
    }
    let mut u = t;
    u.iter_mut().for_each(|u| *u = doubled(*u));
    let [plus, minus] = [plus, minus].map(|terms| values(terms, [&t, &u]));
    let mut sums = [0.0; LANES];
    let values = groups(&plus).iter().zip(groups(&minus));
    for (weights, (plus, minus)) in groups(&weights).iter().zip(values) {
        let [plus, minus] = [plus, minus].map(|[a, b, c, d]| {
            // Scaled so that no square is too small or too large.
            [*a * scale, *b * scale, *c * scale, *d * scale]
        });
        let squares = multiply_add(multiply_add([0.0; LANES], &plus, &plus), &minus, &minus);
        sums = multiply_add(sums, weights, &squares);
    }
    let sum = sums.into_iter().fold(0.0, |sum, part| sum + part);
    if azimuth == 0 { sum } else { 0.5 * sum }
}

fn groups(numbers: &[f32; NODES.len()]) -> &[[f32; LANES]] {
    numbers.as_chunks().0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The mean of z^k is 2 / (k + 2), and the mean of sin^2m is 1 / (m + 1), half of it with cos
    /// mβ.
    #[test]
    fn the_rule_is_exact() {
        for k in 0..2 * NODES.len() {
            let mean: f64 =
                NODES.iter().map(|(t, w)| w * libm::pow(0.5 * (1.0 + t), k as f64)).sum();
            assert!((mean - 2.0 / (k + 2) as f64).abs() < 1e-15, "z^{k}: {mean}");
        }
        for m in 1..NODES.len() {
            let mean = mean_square(m, [&[2.0], &[0.0]], 0.5);
            assert!((mean - 0.5 / (m + 1) as f32).abs() < 1e-7, "m = {m}: {mean}");
        }
    }
}
