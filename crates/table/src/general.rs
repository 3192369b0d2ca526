//! What a table holds beside its span where the eigenimages are no products of one
//! profile and one azimuth: other normals than the sphere's, or light that does not
//! turn freely.

use serde::{Deserialize, Serialize};

/// Eigenimages as sums of the span's functions, which are the table's components
/// and profiles, without eigenvalues of their own.
///
/// Matrices are row by row, a row an eigenimage, a column a function of the span in
/// the order of [`Table::components`](crate::Table::components).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct General {
    /// Number of normals that made it.
    pub normals: usize,
    /// Numerical rank of the modes' images over those normals, at the scene's cut-off.
    pub rank: usize,
    /// The variance that each eigenimage carries; none for the constant of
    /// [`Criterion::ImageCentered`](crate::scene::Criterion).
    pub eigenvalues: Vec<Option<f64>>,
    /// d from an image's coordinates in the span.
    pub projection: Vec<f64>,
    /// An eigenimage's coordinates in the span: the image of least norm that shows it.
    pub synthesis: Vec<f64>,
    /// U over the span's own U: an eigenimage's mode coefficients are this row times the
    /// mode coefficients of the span's components. Empty unless
    /// [`Table::has_modes`](crate::Table::has_modes).
    pub modes: Vec<f64>,
    /// Coordinates of the mean image in the span, or empty.
    pub mean: Vec<f64>,
    /// The mean image's coefficient in each eigenimage, or empty.
    pub mean_coefficients: Vec<f64>,
}
