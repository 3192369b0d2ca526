//! Eigenimages that are not products of one profile and one azimuth.
//!
//! A table has this part if its normals are not those of a sphere or its light does not rotate
//! freely.

use serde::{Deserialize, Serialize};

/// Eigenimages as sums of the span's functions. These functions are the table's components and
/// profiles, without eigenvalues of their own.
///
/// Matrices are row-major: one row per eigenimage, one column per function of the span in the order
/// of [`Table::components`](crate::Table::components).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct General {
    /// Number of normals from which the eigenimages were computed.
    pub normals: usize,
    /// Numerical rank of the modes' images over those normals, at the scene's cut-off.
    pub rank: usize,
    /// The variance of each eigenimage; `None` for the constant of
    /// [`Criterion::ImageCentered`](crate::scene::Criterion).
    pub eigenvalues: Vec<Option<f64>>,
    /// Maps an image's coordinates in the span to d.
    pub projection: Vec<f64>,
    /// Coordinates of each eigenimage in the span: the image of least norm that equals it on the
    /// object's normals.
    pub synthesis: Vec<f64>,
    /// U in terms of the span's own U: the mode coefficients of an eigenimage are its row times the
    /// mode coefficients of the span's components. Empty unless
    /// [`Table::has_modes`](crate::Table::has_modes).
    pub modes: Vec<f64>,
    /// Coordinates of the mean image in the span, or empty.
    pub mean: Vec<f64>,
    /// Coefficient of the mean image in each eigenimage, or empty.
    pub mean_coefficients: Vec<f64>,
}
