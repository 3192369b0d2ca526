//! The paraboloid map: a normal n stands at (n_x, n_y) / (1 + n_z).
//!
//! The visible hemisphere is the unit disc, the normal toward the camera its centre.
//! The map is conformal and its scale changes by no more than a factor of two, so
//! texels are used evenly; in (n_x, n_y) itself they crowd at the centre and are
//! missing at the rim.

use crate::normal::Normal;
use crate::scalar::Scalar;

/// A normal in map coordinates: u to the right, v up, the visible ones in the unit
/// disc. In `f32` or `f64` as it is, in [`Q15`](crate::Q15) as a fraction of 2^15.
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
