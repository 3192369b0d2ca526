//! The nine-term formula in fixed point: see [`crate::NineTerms`].

use super::Normal;
use super::arithmetic::{BITS, times, whole};

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
        let sum: u64 = coefficients.iter().map(|one| one.unsigned_abs()).sum();
        let [constant, of_x, of_y, of_z, squares, xy, xz, yz, zz] = coefficients;
        let size = i64::unsigned_abs;
        let largest = coefficients.iter().copied().map(size).fold(0, u64::max);
        // The number of bits of a factor of a mantissa, and how many bits of a number exceed a
        // limit.
        let factor = 31 - BITS;
        let beyond = |bits: u32, most: u32| bits.saturating_sub(most);
        let by = beyond(bits(sum), factor).max(beyond(bits(largest), 31));
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

fn bits(number: u64) -> u32 {
    u64::BITS - number.leading_zeros()
}
