//! The paraboloid map: a normal n stands at (n_x, n_y) / (1 + n_z).
//!
//! The visible hemisphere is the unit disc, the normal toward the camera its centre.
//! The map is conformal and its scale changes by no more than a factor of two, so
//! texels are used evenly; in (n_x, n_y) itself they crowd at the centre and are
//! missing at the rim.

use crate::format::Q15;
use crate::normal::Normal;
use crate::quantised;
use crate::scalar::Scalar;

/// A normal in map coordinates: u to the right, v up, the visible ones in the unit
/// disc. In `f32` or `f64` as it is, in [`Q15`] as a fraction of 2^15.
///
/// A buffer of normals may as well hold these: they are two numbers instead of three,
/// and looking them up takes no division.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MapPoint<S> {
    pub(crate) u: S,
    pub(crate) v: S,
}

impl<S> MapPoint<S> {
    /// The point (u, v). It is taken as it is: one outside the disc looks up a meaningless
    /// texel.
    #[inline]
    #[must_use]
    pub const fn new(u: S, v: S) -> Self {
        Self { u, v }
    }

    /// u and v.
    #[inline]
    #[must_use]
    pub fn coordinates(self) -> [S; 2] {
        [self.u, self.v]
    }
}

impl<S: Scalar> MapPoint<S> {
    /// Where a normal stands. One division.
    #[inline]
    #[must_use]
    pub fn of(normal: Normal<S>) -> Self {
        let scale = (S::ONE + normal.z).reciprocal();
        Self { u: normal.x * scale, v: normal.y * scale }
    }

    /// The unit vector that stands here, (2u, 2v, 1 - r²) / (1 + r²) with r² = u² + v²: a normal inside
    /// the unit disc, a hidden one outside. One division.
    #[must_use]
    pub fn direction(self) -> [S; 3] {
        let square = self.u * self.u + self.v * self.v;
        let scale = (S::ONE + square).reciprocal();
        let twice = scale + scale;
        [twice * self.u, twice * self.v, (S::ONE - square) * scale]
    }
}

impl MapPoint<Q15> {
    /// Where a normal stands. No division; within 1.3 units of 2^-15 of the quotient.
    ///
    /// 1 / (1 + z) by one step of Newton's method from the cubic that is 1 at z = 0 and has
    /// the smallest largest relative error on \[0, 1\], 1/462.
    #[inline]
    #[must_use]
    pub fn of_quantised(normal: quantised::Normal<Q15>) -> Self {
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
