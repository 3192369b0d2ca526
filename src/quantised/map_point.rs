//! The paraboloid map in integers.

use super::Normal;
use crate::format::Q15;
use crate::paraboloid::MapPoint;

impl MapPoint<Q15> {
    /// Where a normal stands. No division; within 1.3 units of 2^-15 of the quotient.
    ///
    /// 1 / (1 + z) by one step of Newton's method from the cubic that is 1 at z = 0 and has
    /// the smallest largest relative error on \[0, 1\], 1/462.
    #[inline]
    #[must_use]
    pub fn of_quantised(normal: Normal<Q15>) -> Self {
        let [x, y, z] = normal.components();
        // It is none below zero.
        let z = u32::from(z.0.cast_unsigned());
        // Q15 throughout: products stay below 2^31.
        let cubic = CUBIC[1] - ((CUBIC[0] * z) >> 15);
        let cubic = CUBIC[2] - ((cubic * z) >> 15);
        let guess = CUBIC[3] - ((cubic * z) >> 15);
        // 2 - (1 + z) guess in Q30, then Q16: 1 to within 1/462. Newton's step is too small
        // by up to the square of that, half of which is added beside half a unit.
        let correction = ((1 << 31) + (1 << 13) + 2_512 - ((1 << 15) + z) * guess) >> 14;
        #[expect(clippy::cast_possible_wrap, reason = "at most 2^16")]
        let scale = ((correction * guess) >> 15) as i32;
        // Rounded, and moved by 2^15 and back: a look-up moves it again, and neither is left.
        let place = |component: Q15| {
            let product = (i32::from(component.0) * scale).cast_unsigned();
            let [_, _, low, high] = product.wrapping_add(0x8000_8000).to_le_bytes();
            Q15((u16::from_le_bytes([low, high]) ^ 0x8000).cast_signed())
        };
        Self { u: place(x), v: place(y) }
    }
}

/// 1 - 0.95650 z + 0.69251 z² - 0.23709 z³, which times 1 + z is 1 less a Chebyshev
/// polynomial whose first root is z = 0: sizes of its coefficients in Q15.
const CUBIC: [u32; 4] = [7_769, 22_692, 31_343, 1 << 15];
