//! Converts normals and rotations from and to the plain types of the crate `mint`, through which
//! glam, nalgebra, cgmath and others exchange them.

use crate::bake::MapPoint;
use crate::error::Error;
use crate::normal::Normal;
use crate::rotation::Rotation;

/// Converts by [`Normal::new`].
impl TryFrom<mint::Vector3<f32>> for Normal {
    type Error = Error;
    fn try_from(along: mint::Vector3<f32>) -> Result<Self, Error> {
        Self::new(along.x, along.y, along.z)
    }
}

/// Gives the unit vector.
impl From<Normal> for mint::Vector3<f32> {
    fn from(normal: Normal) -> Self {
        Self::from(normal.components())
    }
}

/// Takes (u, v).
impl From<mint::Vector2<f32>> for MapPoint {
    fn from(point: mint::Vector2<f32>) -> Self {
        Self::new(point.x, point.y)
    }
}

/// Gives (u, v).
impl From<MapPoint> for mint::Vector2<f32> {
    fn from(point: MapPoint) -> Self {
        Self::from(point.coordinates())
    }
}

/// Converts by [`Rotation::from_quaternion`]; `s` is w.
impl TryFrom<mint::Quaternion<f32>> for Rotation {
    type Error = Error;
    fn try_from(quaternion: mint::Quaternion<f32>) -> Result<Self, Error> {
        let mint::Quaternion { v, s } = quaternion;
        Self::from_quaternion([v.x, v.y, v.z, s])
    }
}

/// Converts by [`Rotation::from_matrix`].
impl TryFrom<mint::RowMatrix3<f32>> for Rotation {
    type Error = Error;
    fn try_from(matrix: mint::RowMatrix3<f32>) -> Result<Self, Error> {
        Self::from_matrix(matrix.into())
    }
}

/// Converts by [`Rotation::from_matrix`].
impl TryFrom<mint::ColumnMatrix3<f32>> for Rotation {
    type Error = Error;
    fn try_from(matrix: mint::ColumnMatrix3<f32>) -> Result<Self, Error> {
        Self::try_from(mint::RowMatrix3::from(matrix))
    }
}

/// Gives the matrix, row by row.
impl From<Rotation> for mint::RowMatrix3<f32> {
    fn from(rotation: Rotation) -> Self {
        Self::from(rotation.matrix())
    }
}
