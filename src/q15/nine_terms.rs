//! The nine-term formula in fixed point: see [`crate::NineTerms`].

use super::arithmetic::{BITS, TERM_BITS, times, whole};
use super::{Normal, Scene};
use crate::invariant::split;
use crate::nine_terms::filled;

/// Irradiance as a polynomial of degree 2 in the normal, with nine multiplications.
///
/// Nothing wraps: the coefficients have as many bits as their sums allow.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct NineTerms {
    /// The coefficient of 1, scaled like a product with a mantissa, plus a half to round the sum.
    constant: i32,
    coefficients: [i32; 8],
    exponent: i32,
}

impl NineTerms {
    /// The polynomial with these coefficients of 1, x, y, z, x² - y², xy, xz, yz and z², times
    /// 2^exponent.
    #[must_use]
    pub fn new(coefficients: [i32; 9], exponent: i32) -> Self {
        let coefficients = coefficients.map(i64::from);
        let largest: u64 = coefficients.iter().map(|one| one.unsigned_abs()).sum();
        Self::within(coefficients, exponent, bits(largest))
    }

    /// The polynomial with coefficients whose sum is below 2^`bits_of_sum` for every normal.
    fn within(coefficients: [i64; 9], exponent: i32, bits_of_sum: u32) -> Self {
        let [constant, of_x, of_y, of_z, squares, xy, xz, yz, zz] = coefficients;
        let size = i64::unsigned_abs;
        let largest = coefficients.iter().copied().map(size).fold(0, u64::max);
        let inner = (size(squares) + size(xy)).max(size(xz) + size(yz) + size(zz));
        // The number of bits of a factor of a mantissa, and how many bits of a number exceed a
        // limit.
        let factor = 31 - BITS;
        let beyond = |bits: u32, most: u32| bits.saturating_sub(most);
        let by = beyond(bits_of_sum.max(bits(inner)), factor).max(beyond(bits(largest), 31));
        let half = (1_i64 << by) >> 1;
        let [nearest, up, down] =
            [half, (1 << by) - 1, 0].map(|added| move |one: i64| ((one + added) >> by) as i32);
        let constant = nearest(constant) << BITS;
        let to_round = 1 << (BITS - 1);
        Self {
            constant: constant.wrapping_add(to_round),
            // The sums that are added to these coefficients are rounded down, and so is the sum
            // that is subtracted from the coefficient of y, by half a unit on average.
            coefficients: [
                up(of_x),
                down(of_y),
                up(of_z),
                nearest(squares),
                nearest(xy),
                nearest(xz),
                nearest(yz),
                nearest(zz),
            ],
            exponent: exponent.saturating_add(by.cast_signed()),
        }
    }

    /// Shades one normal. The irradiance is the result times 2 to the [`exponent`](Self::exponent).
    #[inline(always)]
    #[must_use]
    pub fn shade(&self, normal: Normal) -> i32 {
        let Normal { x, y, z } = normal;
        let [c1, c2, c3, c4, c5, c6, c7, c8] = self.coefficients;
        let of_x = times(x, c4).wrapping_add(times(y, c5));
        let of_y = times(y, c4);
        let of_z = times(x, c6).wrapping_add(times(y, c7)).wrapping_add(times(z, c8));
        let of_x = times(x, c1.wrapping_add(whole(of_x)));
        let of_y = times(y, c2.wrapping_sub(whole(of_y)));
        let of_z = times(z, c3.wrapping_add(whole(of_z)));
        whole(self.constant.wrapping_add(of_x).wrapping_add(of_y).wrapping_add(of_z))
    }

    /// The exponent of every irradiance.
    #[must_use]
    pub const fn exponent(&self) -> i32 {
        self.exponent
    }
}

impl<B: AsRef<[i32]>> Scene<'_, B> {
    /// The scene as the nine-term formula, which shades it fastest and has an exponent of its own.
    /// `None` if the scene has more terms.
    #[must_use]
    pub fn nine_terms(&self) -> Option<NineTerms> {
        let last = self.lengths.iter().rposition(|&length| length > 0)?;
        let mut rest = self.terms();
        let mut polynomial = |azimuth: usize| {
            let length = *self.lengths.get(azimuth).filter(|_| azimuth <= last).unwrap_or(&0);
            let (terms, after) = split(rest, length.into());
            rest = after;
            terms
        };
        let [square, linear, constant]: [i64; 3] = filled(polynomial(0))?;
        let [[of_xz, of_x], [of_yz, of_y]]: [[i64; 2]; 2] =
            [filled(polynomial(1))?, filled(polynomial(1))?];
        let [[plus], [minus]]: [[i64; 1]; 2] = [filled(polynomial(2))?, filled(polynomial(2))?];
        let coefficients = [
            constant - linear + square,
            of_x - of_xz,
            of_y - of_yz,
            2 * linear - 4 * square,
            plus,
            2 * minus,
            2 * of_xz,
            2 * of_yz,
            4 * square,
        ];
        // In t = 2z - 1 the coefficients have as many bits as the scene states.
        (last <= 2).then(|| NineTerms::within(coefficients, self.exponent, TERM_BITS))
    }
}

fn bits(number: u64) -> u32 {
    u64::BITS - number.leading_zeros()
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test may panic")]
mod tests {
    use super::*;
    use crate::q15::Q15;

    /// Compares scenes of every shape of nine terms or fewer, with the largest allowed terms, with
    /// [`Scene::shade`]. The results agree within the rounding errors of both.
    fn compare(normals: &[Normal], most: f64) {
        let lengths: [&[u8]; 8] =
            [&[3, 2, 1], &[3, 2], &[1, 1], &[2, 1, 1], &[0, 2, 1], &[3, 0, 1], &[3], &[1]];
        for lengths in lengths {
            for seed in 0..200u32 {
                let mut scene = Scene::<[i32; 9]> { lengths, ..Scene::default() };
                let mut state = seed;
                for term in &mut scene.buffer {
                    state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                    // There are at most nine terms, so they sum to no more than a scene allows.
                    *term = (state.cast_signed() >> (31 - TERM_BITS)) / 9;
                }
                let formula = scene.nine_terms().unwrap();
                for &normal in normals {
                    let scale = libm::exp2(f64::from(formula.exponent()));
                    let found = f64::from(formula.shade(normal)) * scale;
                    let off = (found - f64::from(scene.shade(normal))).abs();
                    assert!(off <= most, "{lengths:?} {seed} at {normal:?}: {off}");
                }
            }
        }
    }

    #[test]
    fn scenes_are_the_same_by_the_formula() {
        let fifths = [[0, 0, 5], [3, 0, 4], [0, -4, 3], [-3, 4, 0], [0, 3, 4], [5, 0, 0]];
        const FIFTH: i32 = i32::MAX / 5;
        let q15 = fifths.map(|axes| {
            let [x, y, z] = axes.map(|count| Q15(((count * FIFTH) >> 16) as i16));
            Normal::from_unit(x, y, z).unwrap()
        });
        compare(&q15, 8.0);
    }

    #[test]
    fn scenes_of_more_terms_are_not_nine() {
        let shapes: [&[u8]; 6] =
            [&[4, 2, 1], &[3, 3], &[3, 1, 2], &[1, 1, 1, 1], &[0, 0, 0, 1], &[]];
        for lengths in shapes {
            let scene = Scene::<[i32; 11]> { lengths, ..Scene::default() };
            assert_eq!(scene.nine_terms(), None, "{lengths:?}");
        }
    }
}
