//! The span of the images of all modes: a few profiles for each azimuth, orthonormal over the
//! normals of a sphere.
//!
//! Each image of an object is the image of a sphere evaluated at the object's normals. So whatever
//! its normals, it is a sum of functions of this span.

use crate::basis::eigenimages::{self, constant_coordinates, signed_left};
use crate::basis::pca::Block;
use crate::basis::profile::chebyshev_values;
use crate::object::geometry::WeightedNormals;
use eigenshade_model::error::Result;
use eigenshade_model::selection::Kept;
use eigenshade_model::special::spherical_harmonic::azimuth as phi;
use eigenshade_table::{Component, GramFactor, Profile, light, material, mode};
use faer::Mat;

/// Singular values of the mode images below this fraction of the largest over all azimuths are
/// rounding.
pub const ROUNDING: f64 = 1e-13;

/// Number of normals processed at once.
const CHUNK: usize = 4096;

/// The profiles of one azimuth.
#[derive(Clone, Debug)]
pub struct Azimuth {
    /// The images of the modes.
    pub block: Block,
    /// Coordinates of the profiles in the block's space, as orthonormal columns.
    pub profiles: Mat<f64>,
    /// Polynomials h of the profiles: one column of Chebyshev coefficients in 2z - 1 for each.
    pub chebyshev: Mat<f64>,
    /// Coordinates of each mode's image in the profiles, one column for each mode.
    pub modes: Mat<f64>,
    /// Singular values of the profiles.
    pub singular_values: Vec<f64>,
}

/// The span: for each |m| and each profile, the function u(α) Φ_m(β) and, if m is not 0, also u(α)
/// Φ_-m(β).
#[derive(Clone, Debug)]
pub struct Span {
    degree: usize,
    /// Profiles by |m|.
    pub azimuths: Vec<Azimuth>,
}

/// One function of the span.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Function {
    /// m, signed.
    pub order: i32,
    /// Index of the profile within |m|.
    pub profile: usize,
}

/// A material's images under every harmonic: profiles for each |m|, indexed by l from |m|.
#[derive(Clone, Debug)]
pub struct SpanTransfer(Vec<Mat<f64>>);

impl Span {
    /// The span of the kept modes of `gram`.
    ///
    /// # Errors
    ///
    /// If the singular values do not converge.
    pub fn new(gram: &GramFactor, kept: &Kept) -> Result<Self> {
        let blocks: Vec<Block> = (0..=gram.degree)
            .map(|azimuth| {
                let keeps = |l, o, p, q| kept.keeps(gram, azimuth, (l, o, p, q));
                Block::without_modes(gram, azimuth, &keeps)
            })
            .collect::<Result<_>>()?;
        let largest =
            blocks.iter().flat_map(|block| &block.singular_values).copied().fold(0.0, f64::max);
        let azimuths = blocks
            .into_iter()
            .map(|block| {
                let rank = block.rank(ROUNDING * largest);
                let profiles = signed_left(&block, rank);
                Azimuth {
                    chebyshev: block.space.chebyshev(&profiles),
                    modes: profiles.transpose() * &block.factor,
                    singular_values: block.singular_values[..rank].to_vec(),
                    profiles,
                    block,
                }
            })
            .collect();
        Ok(Self { degree: gram.degree, azimuths })
    }

    /// The functions in order.
    pub fn functions(&self) -> impl Iterator<Item = Function> + '_ {
        self.azimuths.iter().enumerate().flat_map(|(azimuth, of)| {
            (0..of.profiles.ncols()).flat_map(move |profile| {
                let m = azimuth as i32;
                let both = [m, -m].into_iter().take(if m == 0 { 1 } else { 2 });
                both.map(move |order| Function { order, profile })
            })
        })
    }

    /// The largest singular value over all azimuths.
    #[must_use]
    pub fn largest(&self) -> f64 {
        let first = self.azimuths.iter().filter_map(|of| of.block.singular_values.first());
        first.copied().fold(0.0, f64::max)
    }

    /// Number of functions.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.functions().count()
    }

    /// Values of all functions at unit normals with z >= 0, one row for each normal.
    #[must_use]
    pub fn values(&self, normals: &[[f64; 3]]) -> Mat<f64> {
        let most = self.azimuths.iter().map(|of| of.chebyshev.nrows()).max().unwrap_or(0);
        let polynomials: Vec<Vec<f64>> =
            normals.iter().map(|n| chebyshev_values(most, n[2])).collect();
        let mut values = Mat::zeros(normals.len(), self.dimension());
        let mut column = 0;
        for (azimuth, of) in self.azimuths.iter().enumerate() {
            let series =
                Mat::from_fn(normals.len(), of.chebyshev.nrows(), |k, j| polynomials[k][j]);
            let profiles = series * &of.chebyshev;
            let m = azimuth.cast_signed();
            // sin^|m|(α) Φ_±m(β).
            let around = |order: isize| -> Vec<f64> {
                let at = |&[x, y, _]: &[f64; 3]| {
                    x.hypot(y).powi(azimuth as i32) * phi(order, y.atan2(x))
                };
                normals.iter().map(at).collect()
            };
            let signs: Vec<Vec<f64>> =
                if m == 0 { vec![around(0)] } else { vec![around(m), around(-m)] };
            for profile in 0..profiles.ncols() {
                for around in &signs {
                    for (k, around) in around.iter().enumerate() {
                        values[(k, column)] = profiles[(k, profile)] * around;
                    }
                    column += 1;
                }
            }
        }
        values
    }

    /// R with RᵀR = Σ_k w_k φ(n_k) φ(n_k)ᵀ for the functions φ of the span and these normals.
    ///
    /// Uses only orthogonal factorizations. Nothing is squared, so weights that range over many
    /// decades and normals that are nearly equal lose no accuracy.
    #[must_use]
    pub fn factor(&self, listed: &WeightedNormals) -> Mat<f64> {
        let dimension = self.dimension();
        let mut factor: Mat<f64> = Mat::zeros(0, dimension);
        for (normals, weights) in listed.normals().chunks(CHUNK).zip(listed.weights().chunks(CHUNK))
        {
            let values = self.values(normals);
            let above = factor.nrows();
            let stacked = Mat::from_fn(above + normals.len(), dimension, |k, j| {
                if k < above {
                    factor[(k, j)]
                } else {
                    weights[k - above].sqrt() * values[(k - above, j)]
                }
            });
            factor = stacked.qr().thin_R().to_owned();
        }
        factor
    }

    /// The images of a material with coefficients b in the order of [`material`].
    #[must_use]
    pub fn transfer(&self, gram: &GramFactor, coefficients: &[f64]) -> SpanTransfer {
        let of_azimuth = |(azimuth, of): (usize, &Azimuth)| {
            let modes = mode::indices(gram.degree, gram.order, azimuth);
            let mut transfer = Mat::zeros(of.profiles.ncols(), gram.degree + 1 - azimuth);
            for (s, (l, o, p, q)) in modes.enumerate() {
                let b = coefficients[material::position(o, p, q)];
                for k in 0..transfer.nrows() {
                    transfer[(k, l - azimuth)] += b * of.modes[(k, s)];
                }
            }
            transfer
        };
        SpanTransfer(self.azimuths.iter().enumerate().map(of_azimuth).collect())
    }

    /// Coordinates of the image of a light on a transferred material. The light has the span's
    /// degree.
    #[must_use]
    pub fn image(&self, transfer: &SpanTransfer, light: &[f64]) -> Vec<f64> {
        self.functions()
            .map(|Function { order, profile }| {
                let azimuth = order.unsigned_abs() as usize;
                let sign = if order < 0 && order % 2 != 0 { -1.0 } else { 1.0 };
                let of_azimuth = &transfer.0[azimuth];
                let sum: f64 = (azimuth..=self.degree)
                    .map(|l| {
                        of_azimuth[(profile, l - azimuth)]
                            * light[light::position(l, order as isize)]
                    })
                    .sum();
                sign * sum
            })
            .collect()
    }

    /// Coordinates of the image that is 1 everywhere.
    #[must_use]
    pub fn constant(&self, gram: &GramFactor) -> Vec<f64> {
        let zonal = &self.azimuths[0];
        let one = constant_coordinates(gram, &zonal.block.space);
        let profiles = zonal.profiles.ncols();
        let along = |k: usize| (0..one.len()).map(|i| zonal.profiles[(i, k)] * one[i]).sum();
        let mut coordinates: Vec<f64> = (0..profiles).map(along).collect();
        coordinates.resize(self.dimension(), 0.0);
        coordinates
    }

    /// The functions of the span as components, without eigenvalues.
    pub(crate) fn components(&self) -> Vec<Component> {
        let mut first = Vec::new();
        let mut start = 0;
        for of in &self.azimuths {
            first.push(start);
            start += of.profiles.ncols();
        }
        self.functions()
            .map(|Function { order, profile }| Component {
                order,
                profile: first[order.unsigned_abs() as usize] + profile,
                eigenvalue: None,
            })
            .collect()
    }

    /// The profiles of the span for the given images, as columns of coordinates, and a mean image,
    /// which may be empty.
    ///
    /// The polynomial error of a profile is at most `tolerance` divided by the largest coordinate
    /// of any image in that profile, so its contribution to an image stays within `tolerance`.
    pub(crate) fn table_profiles(
        &self,
        gram: &GramFactor,
        tolerance: f64,
        images: &Mat<f64>,
        mean: &[f64],
    ) -> Vec<Profile> {
        let largest = |function: usize| -> f64 {
            let of_images = (0..images.ncols()).map(|image| images[(function, image)]);
            let of_mean = mean.get(function).copied();
            of_images.chain(of_mean).fold(0.0, |most, value| most.max(value.abs()))
        };
        let mut profiles = Vec::new();
        let mut functions = 0..;
        for (azimuth, of) in self.azimuths.iter().enumerate() {
            for (profile, singular) in of.singular_values.iter().enumerate() {
                let signs = if azimuth == 0 { 1 } else { 2 };
                let weight = functions.by_ref().take(signs).map(largest).fold(0.0, f64::max);
                let coordinates = of.profiles.get(.., profile..profile + 1).to_owned();
                let tolerance = (tolerance / weight).min(1.0);
                let image = eigenimages::image(gram, &of.block, &coordinates, tolerance);
                // The span's own U is V / s; `modes` is s V.
                let modes = of.modes.row(profile).iter();
                let modes = modes.map(|mode| mode / singular.powi(2)).collect();
                profiles.push(Profile { modes, ..image });
            }
        }
        profiles
    }
}
