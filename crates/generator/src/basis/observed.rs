//! An object's normals in the coordinates of a [`Span`].
//!
//! Let φ be the functions of the span and RᵀR = Σ_k w_k φ(n_k) φ(n_k)ᵀ. The energy of an image a
//! over the object is |R a|². With R = P S Qᵀ, y = S Qᵀ a are coordinates in which energies are
//! squared lengths. Modes c have the coordinates diag(s) Vᵀ c in the span, with V orthonormal, so A
//! is H Vᵀ with H = S Qᵀ diag(s).

use crate::basis::span::{Function, Span};
use crate::object::geometry::Geometry;
use eigenshade_model::error::{Error, Result};
use faer::Mat;

/// The part of a span that an object shows.
pub(crate) struct Observed {
    /// Q; each column is a coordinate that the object shows.
    directions: Mat<f64>,
    /// S, in falling order.
    gains: Vec<f64>,
    /// s, one for each function.
    singular: Vec<f64>,
    /// H.
    factor: Mat<f64>,
    /// Left singular vectors of H; `values` and `right` hold its singular values and right singular
    /// vectors.
    left: Mat<f64>,
    values: Vec<f64>,
    right: Mat<f64>,
}

impl Observed {
    /// Uses the normals of `geometry`; S ends where it falls below `cutoff` times its largest
    /// value.
    ///
    /// # Errors
    ///
    /// If the singular values do not converge.
    pub(crate) fn new(span: &Span, geometry: &Geometry, cutoff: f64) -> Result<Self> {
        let (directions, gains) = directions(span, geometry, cutoff)?;
        let of = |Function { order, profile }: Function| {
            span.azimuths[order.unsigned_abs() as usize].singular_values[profile]
        };
        let singular: Vec<f64> = span.functions().map(of).collect();
        let along = directions.transpose();
        let factor = Mat::from_fn(along.nrows(), along.ncols(), |i, k| {
            gains[i] * along[(i, k)] * singular[k]
        });
        let svd = factor.thin_svd().map_err(|_| not_converged("modes"))?;
        Ok(Self {
            left: svd.U().to_owned(),
            values: svd.S().column_vector().iter().copied().collect(),
            right: svd.V().to_owned(),
            directions,
            gains,
            singular,
            factor,
        })
    }

    /// y = S Qᵀ a, column by column.
    pub(crate) fn shown(&self, coordinates: &Mat<f64>) -> Mat<f64> {
        let along = self.directions.transpose() * coordinates;
        Mat::from_fn(along.nrows(), along.ncols(), |i, j| self.gains[i] * along[(i, j)])
    }

    /// The images a of least norm that show y, column by column: Q S⁻¹ y.
    ///
    /// Many images look alike on the object. In these the polynomials cancel least.
    pub(crate) fn images(&self, shown: &Mat<f64>) -> Mat<f64> {
        let scaled =
            Mat::from_fn(shown.nrows(), shown.ncols(), |i, j| shown[(i, j)] / self.gains[i]);
        &self.directions * scaled
    }

    /// The matrix Wᵀ S Qᵀ, which gives d from coordinates in the span.
    pub(crate) fn projection(&self, shown: &Mat<f64>) -> Mat<f64> {
        let scaled =
            Mat::from_fn(shown.nrows(), shown.ncols(), |i, j| shown[(i, j)] * self.gains[i]);
        scaled.transpose() * self.directions.transpose()
    }

    /// Rank of the modes over the object: the number of singular values above `cutoff` times the
    /// largest.
    pub(crate) fn rank(&self, cutoff: f64) -> usize {
        let threshold = cutoff * self.values.first().copied().unwrap_or(0.0);
        self.values.iter().filter(|value| **value > threshold).count()
    }

    /// U = A⁺W at this rank, relative to the span's own U; each column is an eigenimage.
    pub(crate) fn modes(&self, shown: &Mat<f64>, rank: usize) -> Mat<f64> {
        self.scaled(&self.solution(shown, rank))
    }

    /// Largest |UᵀMU - I| over the first `count` eigenimages, computed from A U.
    pub(crate) fn orthonormality(&self, shown: &Mat<f64>, rank: usize, count: usize) -> f64 {
        let first = shown.get(.., ..shown.ncols().min(count)).to_owned();
        let image = &self.factor * self.solution(&first, rank);
        let products = image.transpose() * &image;
        let mut worst: f64 = 0.0;
        for i in 0..products.nrows() {
            for j in 0..products.ncols() {
                let unit = f64::from(u8::from(i == j));
                worst = worst.max((products[(i, j)] - unit).abs());
            }
        }
        worst
    }

    /// H⁺ y, which is Vᵀ times the modes of least norm.
    fn solution(&self, shown: &Mat<f64>, rank: usize) -> Mat<f64> {
        let projected = self.left.get(.., ..rank).transpose() * shown;
        let scaled = Mat::from_fn(rank, shown.ncols(), |i, j| projected[(i, j)] / self.values[i]);
        self.right.get(.., ..rank) * scaled
    }

    /// Multiplies by diag(s). The result is the span coordinates of the modes Vᵀc. It is also those
    /// modes relative to the span's own U, which is V / s.
    fn scaled(&self, modes: &Mat<f64>) -> Mat<f64> {
        Mat::from_fn(modes.nrows(), modes.ncols(), |k, i| self.singular[k] * modes[(k, i)])
    }
}

/// The matrices Q and S.
fn directions(span: &Span, geometry: &Geometry, cutoff: f64) -> Result<(Mat<f64>, Vec<f64>)> {
    let Geometry::Listed(listed) = geometry else {
        // The span is already orthonormal over the sphere.
        let dimension = span.dimension();
        return Ok((Mat::identity(dimension, dimension), vec![1.0; dimension]));
    };
    let svd = span.factor(listed).thin_svd().map_err(|_| not_converged("normals"))?;
    let gains: Vec<f64> = svd.S().column_vector().iter().copied().collect();
    let largest = gains.first().copied().unwrap_or(0.0);
    let rank = gains.iter().filter(|gain| **gain > cutoff * largest).count();
    Ok((svd.V().get(.., ..rank).to_owned(), gains[..rank].to_vec()))
}

fn not_converged(of: &str) -> Error {
    Error::new(
        format!("the singular values of the {of} do not converge"),
        "look for numbers that are not finite, or far out of range",
    )
}
