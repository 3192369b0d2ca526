//! The paraboloid map: the normal n maps to the point (n_x, n_y) / (1 + n_z).
//!
//! The visible hemisphere fills the unit disc, and the normal toward the camera is its center. The
//! map is conformal and its scale varies by no more than a factor of two, so texels are used
//! evenly. In (n_x, n_y) itself they crowd at the center and are missing at the rim.

use crate::normal::Normal;
use crate::scalar::Scalar;

/// A normal in map coordinates: u to the right, v up. Visible normals lie in the unit disc. In
/// `f32` and `f64` the coordinates are plain numbers, in [`Q15`](crate::Q15) fractions of 2^15.
///
/// A buffer of normals can store map points instead: they take two numbers instead of three, and a
/// look-up then needs no division.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MapPoint<S> {
    pub(crate) u: S,
    pub(crate) v: S,
}

impl<S> MapPoint<S> {
    /// The point (u, v). It is not checked: a point outside the disc looks up a meaningless texel.
    #[inline]
    #[must_use]
    pub const fn new(u: S, v: S) -> Self {
        Self { u, v }
    }

    /// The coordinates u and v.
    #[inline]
    #[must_use]
    pub fn coordinates(self) -> [S; 2] {
        [self.u, self.v]
    }
}

impl<S: Scalar> MapPoint<S> {
    /// The map point of a normal. Costs one division.
    #[inline]
    #[must_use]
    pub fn of(normal: Normal<S>) -> Self {
        let scale = (S::ONE + normal.z).reciprocal();
        Self { u: normal.x * scale, v: normal.y * scale }
    }

    /// The unit vector at this point, (2u, 2v, 1 - r²) / (1 + r²) with r² = u² + v²: a visible
    /// normal inside the unit disc, a hidden one outside. Costs one division.
    #[must_use]
    pub fn direction(self) -> [S; 3] {
        let square = self.u * self.u + self.v * self.v;
        let scale = (S::ONE + square).reciprocal();
        let twice = scale + scale;
        [twice * self.u, twice * self.v, (S::ONE - square) * scale]
    }
}
