//! A normal as a point of the paraboloid map, in fixed point.

use super::{Normal, Q15};

/// A normal in the coordinates of a [`BakedMap`](super::BakedMap), fractions of 2^15: u to the
/// right, v up. Visible normals lie in the unit disc.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MapPoint {
    pub(crate) u: Q15,
    pub(crate) v: Q15,
}

impl MapPoint {
    /// The point (u, v), unchecked: a point outside the disc looks up a meaningless texel.
    #[inline]
    #[must_use]
    pub const fn new(u: Q15, v: Q15) -> Self {
        Self { u, v }
    }

    /// The coordinates u and v.
    #[inline]
    #[must_use]
    pub const fn coordinates(self) -> [Q15; 2] {
        [self.u, self.v]
    }

    /// The map point of a normal, without division: within 1.25 units of 2^-15 of the exact
    /// quotient.
    ///
    /// 1 / (1 + z) comes from one step of Newton's method. The initial guess is the cubic that is 1
    /// at z = 0 and has the smallest maximum relative error on \[0, 1\], 1/462.
    #[inline]
    #[must_use]
    pub fn of(normal: Normal) -> Self {
        let [x, y, z] = normal.components();
        // z is never negative.
        let z = u32::from(z.0.cast_unsigned());
        // All numbers are in Q15, so products stay below 2^31.
        let cubic = CUBIC[1] - ((CUBIC[0] * z) >> 15);
        let cubic = CUBIC[2] - ((cubic * z) >> 15);
        let guess = CUBIC[3] - ((cubic * z) >> 15);
        // 2 - (1 + z) guess in Q30, then in Q16: 1 to within 1/462. The result of Newton's step is
        // too small by up to the square of that; half of the square is added, as well as half a
        // unit for rounding.
        let correction = ((1 << 31) + (1 << 13) + 2_512 - ((1 << 15) + z) * guess) >> 14;
        #[expect(clippy::cast_possible_wrap, reason = "at most 2^16")]
        let scale = ((correction * guess) >> 15) as i32;
        // Rounds, and adds and removes an offset of 2^15. A look-up adds the offset again, and the
        // compiler removes both.
        let place = |component: Q15| {
            let product = (i32::from(component.0) * scale).cast_unsigned();
            let [_, _, low, high] = product.wrapping_add(0x8000_8000).to_le_bytes();
            Q15((u16::from_le_bytes([low, high]) ^ 0x8000).cast_signed())
        };
        Self { u: place(x), v: place(y) }
    }
}

/// Coefficients, in absolute value and in Q15, of 1 - 0.95650 z + 0.69251 z² - 0.23709 z³. This
/// cubic times 1 + z is 1 minus a Chebyshev polynomial whose first root is z = 0.
const CUBIC: [u32; 4] = [7_769, 22_692, 31_343, 1 << 15];
