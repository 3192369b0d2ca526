//! Converts normals and rotations from and to the plain types of the crate `mint`, through which
//! glam, nalgebra, cgmath and others exchange them.

use crate::bake::MapPoint;
use crate::error::Error;
use crate::normal::Normal;
use crate::rotation::Rotation;
use crate::scalar::Scalar;

/// Converts by [`Normal::new`].
impl<S: Scalar> TryFrom<mint::Vector3<S>> for Normal<S> {
    type Error = Error;
    fn try_from(along: mint::Vector3<S>) -> Result<Self, Error> {
        Self::new(along.x, along.y, along.z)
    }
}

/// Gives the unit vector.
impl<S: Scalar> From<Normal<S>> for mint::Vector3<S> {
    fn from(normal: Normal<S>) -> Self {
        Self::from(normal.components())
    }
}

/// Takes (u, v).
impl<S> From<mint::Vector2<S>> for MapPoint<S> {
    fn from(point: mint::Vector2<S>) -> Self {
        Self::new(point.x, point.y)
    }
}

/// Gives (u, v).
impl<S> From<MapPoint<S>> for mint::Vector2<S> {
    fn from(point: MapPoint<S>) -> Self {
        Self::from(point.coordinates())
    }
}

/// Converts by [`Rotation::from_quaternion`]; `s` is w.
impl<S: Scalar> TryFrom<mint::Quaternion<S>> for Rotation<S> {
    type Error = Error;
    fn try_from(quaternion: mint::Quaternion<S>) -> Result<Self, Error> {
        let mint::Quaternion { v, s } = quaternion;
        Self::from_quaternion([v.x, v.y, v.z, s])
    }
}

/// Converts by [`Rotation::from_matrix`].
impl<S: Scalar> TryFrom<mint::RowMatrix3<S>> for Rotation<S> {
    type Error = Error;
    fn try_from(matrix: mint::RowMatrix3<S>) -> Result<Self, Error> {
        Self::from_matrix(matrix.into())
    }
}

/// Converts by [`Rotation::from_matrix`].
impl<S: Scalar> TryFrom<mint::ColumnMatrix3<S>> for Rotation<S> {
    type Error = Error;
    fn try_from(matrix: mint::ColumnMatrix3<S>) -> Result<Self, Error> {
        Self::try_from(mint::RowMatrix3::from(matrix))
    }
}

/// Gives the matrix, row by row.
impl<S: Scalar> From<Rotation<S>> for mint::RowMatrix3<S> {
    fn from(rotation: Rotation<S>) -> Self {
        Self::from(rotation.matrix())
    }
}
