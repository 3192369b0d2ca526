//! The principal components of one azimuth, from singular values in node space.
//!
//! (28) and (33) require the eigenvectors of M^(1/2) V M^(1/2). With M = AᵀA and V = FFᵀ these are,
//! up to a rotation, the left singular vectors W of AF, so the root of the singular M is not needed
//! and nothing is squared. Then U = A⁺W, by the pseudo-inverse with a cut-off.

use crate::basis::moments::Deviation;
use crate::basis::profile::ProfileSpace;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::task::checkpoint;
use eigenshade_table::{GramFactor, material, mode};
use faer::{Mat, MatRef};

/// Modes that are processed at once.
const CHUNK: usize = 4096;

/// The matrix A of one azimuth, in the coordinates of its profile space.
#[derive(Clone, Debug)]
pub struct Block {
    /// |m|.
    pub azimuth: usize,
    /// The space of the profiles.
    pub space: ProfileSpace,
    /// Coordinates of each mode's profile, one column for each mode of [`eigenshade_table::mode`].
    /// Columns of modes that are not kept are zero.
    pub factor: Mat<f64>,
    /// Left singular vectors of `factor`.
    left: Mat<f64>,
    /// Singular values of `factor`, falling.
    pub singular_values: Vec<f64>,
    /// Right singular vectors of `factor`, for U over modes.
    right: Option<Mat<f64>>,
}

impl Block {
    /// The block of `azimuth`; `keeps` selects the modes (l, o, p, q).
    ///
    /// # Errors
    ///
    /// If the singular values do not converge, which means that a number is not finite.
    pub fn new(
        gram: &GramFactor,
        azimuth: usize,
        keeps: &dyn Fn(usize, usize, usize, usize) -> bool,
    ) -> Result<Self> {
        let (space, factor) = factor(gram, azimuth, keeps);
        let svd = factor.thin_svd().map_err(|_| not_converged(azimuth))?;
        Ok(Self {
            azimuth,
            space,
            left: svd.U().to_owned(),
            singular_values: diagonal(svd.S().column_vector()),
            right: Some(svd.V().to_owned()),
            factor,
        })
    }

    /// Like [`new`](Self::new), without what U over modes needs, which is most of the work: a block
    /// has a thousand times as many modes as profiles.
    ///
    /// # Errors
    ///
    /// Those of [`new`](Self::new).
    pub fn without_modes(
        gram: &GramFactor,
        azimuth: usize,
        keeps: &dyn Fn(usize, usize, usize, usize) -> bool,
    ) -> Result<Self> {
        let (space, factor) = factor(gram, azimuth, keeps);
        // Aᵀ = Q R, so A has the left singular vectors and the values of Rᵀ. Only R is computed:
        // the factors of some modes at a time, under that of those before.
        let mut triangle = Mat::zeros(0, factor.nrows());
        for first in (0..factor.ncols()).step_by(CHUNK) {
            checkpoint();
            let part = factor.get(.., first..(first + CHUNK).min(factor.ncols())).transpose();
            let rows = concat(triangle.as_ref(), part);
            triangle = rows.qr().thin_R().to_owned();
        }
        let Principal { coordinates: left, singular_values } =
            decompose(triangle.transpose(), azimuth)?;
        Ok(Self { azimuth, space, left, singular_values, right: None, factor })
    }

    /// Numerical rank: the number of singular values above `threshold`.
    #[must_use]
    pub fn rank(&self, threshold: f64) -> usize {
        self.singular_values.iter().filter(|value| **value > threshold).count()
    }

    /// U = A⁺W: mode coefficients of the eigenimages with these coordinates, one column each.
    /// Singular values up to `threshold` count as zero. Without rows for a block without modes.
    #[must_use]
    pub fn mode_coefficients(&self, coordinates: &Mat<f64>, threshold: f64) -> Mat<f64> {
        let Some(right) = &self.right else { return Mat::zeros(0, coordinates.ncols()) };
        let rank = self.rank(threshold);
        let projected = self.left.get(.., ..rank).transpose() * coordinates;
        let scaled = Mat::from_fn(rank, coordinates.ncols(), |i, j| {
            projected[(i, j)] / self.singular_values[i]
        });
        right.get(.., ..rank) * scaled
    }

    /// AF, the coordinates of the images of these deviations.
    #[must_use]
    pub fn images(&self, gram: &GramFactor, deviations: &[Deviation]) -> Mat<f64> {
        let mut images = Mat::zeros(self.space.dimension(), deviations.len());
        let modes: Vec<_> = mode::indices(gram.degree, gram.order, self.azimuth).collect();
        for l in self.azimuth..=gram.degree {
            checkpoint();
            let Some(first) = modes.iter().position(|mode| mode.0 == l) else { continue };
            let count = modes.iter().filter(|mode| mode.0 == l).count();
            let of_degree: Vec<usize> =
                (0..deviations.len()).filter(|&t| deviations[t].degree == l).collect();
            let materials = Mat::from_fn(count, of_degree.len(), |s, t| {
                let (_, o, p, q) = modes[first + s];
                deviations[of_degree[t]].material[material::position(o, p, q)]
            });
            let product = self.factor.get(.., first..first + count) * materials;
            for (t, &column) in of_degree.iter().enumerate() {
                images.col_mut(column).copy_from(product.col(t));
            }
        }
        images
    }
}

/// The space of an azimuth's profiles, and A in its coordinates, see [`Block::factor`].
pub(crate) fn factor(
    gram: &GramFactor,
    azimuth: usize,
    keeps: &dyn Fn(usize, usize, usize, usize) -> bool,
) -> (ProfileSpace, Mat<f64>) {
    let space = ProfileSpace::new(gram, azimuth);
    let modes: Vec<_> = mode::indices(gram.degree, gram.order, azimuth).collect();
    let mut factor = Mat::zeros(space.dimension(), modes.len());
    for (chunk, modes) in modes.chunks(CHUNK).enumerate() {
        checkpoint();
        let mut nodes = Mat::zeros(gram.nodes.len(), modes.len());
        for (s, &(l, o, p, q)) in modes.iter().enumerate() {
            if keeps(l, o, p, q) {
                let column = nodes.col_mut(s).iter_mut();
                column.zip(gram.column(azimuth, l, o, p, q)).for_each(|(to, value)| *to = value);
            }
        }
        let first = chunk * CHUNK;
        let part = space.coordinates(&nodes);
        factor.get_mut(.., first..first + modes.len()).copy_from(&part);
    }
    (space, factor)
}

/// The rows of two matrices, one after the other.
fn concat(above: MatRef<'_, f64>, below: MatRef<'_, f64>) -> Mat<f64> {
    let mut rows = Mat::zeros(above.nrows() + below.nrows(), below.ncols());
    rows.get_mut(..above.nrows(), ..).copy_from(above);
    rows.get_mut(above.nrows().., ..).copy_from(below);
    rows
}

/// The principal components of a set of images.
#[derive(Clone, Debug)]
pub struct Principal {
    /// Coordinates of the eigenimages' profiles, as orthonormal columns.
    pub coordinates: Mat<f64>,
    /// Singular values, falling; their squares are the eigenvalues.
    pub singular_values: Vec<f64>,
}

/// The left singular vectors of `images`, orthogonal to the unit vector `constant` if one is given
/// (the constant image, (31)).
///
/// # Errors
///
/// If the singular values do not converge.
pub fn principal(images: &Mat<f64>, constant: Option<&[f64]>, azimuth: usize) -> Result<Principal> {
    let Some(constant) = constant else { return decompose(images.as_ref(), azimuth) };
    // Reflect `constant` onto the first axis. The images without that axis are then exactly
    // orthogonal to it, however small they are.
    let mut normal: Vec<f64> = constant.to_vec();
    normal[0] += if constant[0] < 0.0 { -1.0 } else { 1.0 };
    let scale = 2.0 / normal.iter().map(|x| x * x).sum::<f64>();
    let reflect = |matrix: &Mat<f64>| {
        let along: Vec<f64> = (0..matrix.ncols())
            .map(|j| scale * (0..matrix.nrows()).map(|i| normal[i] * matrix[(i, j)]).sum::<f64>())
            .collect();
        Mat::from_fn(matrix.nrows(), matrix.ncols(), |i, j| matrix[(i, j)] - normal[i] * along[j])
    };
    let reflected = reflect(images);
    let inner = decompose(reflected.get(1.., ..), azimuth)?;
    let embedded = Mat::from_fn(images.nrows(), inner.coordinates.ncols(), |i, j| {
        if i == 0 { 0.0 } else { inner.coordinates[(i - 1, j)] }
    });
    Ok(Principal { coordinates: reflect(&embedded), ..inner })
}

fn decompose(images: MatRef<'_, f64>, azimuth: usize) -> Result<Principal> {
    let svd = images.thin_svd().map_err(|_| not_converged(azimuth))?;
    Ok(Principal {
        coordinates: svd.U().to_owned(),
        singular_values: diagonal(svd.S().column_vector()),
    })
}

fn diagonal(values: faer::ColRef<'_, f64>) -> Vec<f64> {
    values.iter().copied().collect()
}

fn not_converged(azimuth: usize) -> Error {
    Error::new(
        format!("the singular values of azimuth {azimuth} do not converge"),
        "look for numbers that are not finite, or far out of range, in lights and materials",
    )
}
