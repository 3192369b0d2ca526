//! The eigenbasis of any normals under any statistics of the light, where neither M
//! nor V_c falls apart into azimuths.
//!
//! Images are taken in the coordinates of the sphere's [`Span`]: with φ its functions
//! and RᵀR = Σ_k w_k φ(n_k) φ(n_k)ᵀ the energy of an image over the object's normals
//! is |R a|². From R = P S Qᵀ, cut off where S is rounding, y = S Qᵀ a are coordinates
//! in which energies are lengths. The eigenimages W are the left singular vectors of
//! the database's images in y, U their pseudo-inverse, and a = Q S⁻¹ W the image of least
//! norm that shows them.

use crate::database::{Lights, Materials};
use crate::eigenimages;
use crate::error::{Error, Result};
use crate::geometry::Geometry;
use crate::light_statistics::LightStatistics;
use crate::moments::MaterialMoments;
use crate::pca::principal;
use crate::settle::{Functions, settle};
use crate::span::{Folded, Function, Span};
use crate::{database, gram, peak, selection};
use eigenshade_table::scene::Criterion;
use eigenshade_table::{Component, General, GramFactor, Profile, Scene, Summary, Table};
use faer::Mat;

/// Components whose orthonormality is reported.
const REPORTED: usize = 100;

/// Singular values below this, relative to the root of the database's energy, are
/// rounding.
const ROUNDING: f64 = 1e-14;

/// The span and the object's normals in it.
struct Observed {
    gram: GramFactor,
    span: Span,
    /// Q, a column a coordinate that the object shows.
    directions: Mat<f64>,
    /// S, falling.
    gains: Vec<f64>,
}

/// Makes the table of a scene whose normals or light have no symmetry to use.
///
/// # Errors
///
/// As [`basis::build`](crate::basis::build).
pub fn build(
    scene: &Scene,
    geometry: &Geometry,
    lights: &Lights,
    materials: &Materials,
) -> Result<Table> {
    let (lights, materials) = crate::basis::fitted(scene, lights, materials)?;
    let light = {
        let weights = database::weights(&lights.entries, &scene.light.weights)?;
        let (normalise, rotation) = (scene.light.normalise, scene.light.rotation);
        LightStatistics::new(&lights, normalise, rotation, &weights)?
    };
    let material = {
        let weights = database::weights(&materials.entries, &scene.material.weights)?;
        MaterialMoments::weighted(&materials, weights)
    };
    let gram = gram::of_sphere(scene.light.degree, scene.material.order);
    let kept = selection::highest(&gram, scene.basis.modes);
    let span = Span::new(&gram, &kept)?;
    let cutoff = scene.basis.rank_cutoff;
    let (directions, gains) = observed(&span, geometry, cutoff)?;
    let observed = Observed { gram, span, directions, gains };

    let criterion = scene.basis.criterion;
    let images = observed.shown(&observed.deviations(&light, &material, criterion));
    let constant: Vec<f64> = {
        let coordinates = observed.span.constant(&observed.gram);
        let column = Mat::from_fn(coordinates.len(), 1, |k, _| coordinates[k]);
        let shown = observed.shown(&column);
        let norm = shown.norm_l2();
        shown.col(0).iter().map(|value| value / norm).collect()
    };
    let centred = criterion == Criterion::ImageCentered;
    let found = principal(&images, centred.then_some(constant.as_slice()), 0)?;
    let strongest = found.singular_values.first().copied().unwrap_or(0.0);
    let weakest = (ROUNDING * images.norm_l2()).max(cutoff * strongest);
    let count = found.singular_values.iter().filter(|value| **value > weakest).count();

    let mut eigenvalues: Vec<Option<f64>> = vec![None; usize::from(centred)];
    eigenvalues.extend(found.singular_values[..count].iter().map(|value| Some(value * value)));
    let mut shown = Mat::zeros(images.nrows(), eigenvalues.len());
    for (column, _) in eigenvalues.iter().enumerate() {
        let number = column.checked_sub(usize::from(centred));
        for row in 0..shown.nrows() {
            shown[(row, column)] =
                number.map_or(constant[row], |number| found.coordinates[(row, number)]);
        }
    }
    observed.settle(&mut shown, &eigenvalues);

    let ranks = observed.span.azimuths.iter().map(|of| of.block.rank(cutoff * observed.largest()));
    let energy: f64 = found.singular_values.iter().rev().map(|value| value * value).sum();
    let mut table = Table {
        summary: Summary {
            ranks: ranks.collect(),
            largest_singular_value: observed.largest(),
            lights: lights.entries.len(),
            materials: materials.entries.len(),
            energy,
            energy_kept: 1.0,
            orthonormality: 0.0,
        },
        scene: scene.clone(),
        selection: kept,
        components: observed.components(),
        profiles: observed.profiles(scene.basis.profile_tolerance),
        mean: None,
        spectrum: eigenvalues.iter().map(|value| (None, *value)).collect(),
        general: None,
        gram: observed.gram.clone(),
    };
    let wanted = match (scene.basis.components, scene.basis.tolerance) {
        (Some(components), _) => components,
        (None, None) => eigenvalues.len(),
        (None, Some(tolerance)) => peak::components_for(&table, &lights, &materials, tolerance)?,
    };
    let kept = wanted.min(eigenvalues.len());
    let shown = shown.get(.., ..kept).to_owned();
    eigenvalues.truncate(kept);
    let (modes, rank, orthonormality) = observed.modes(&shown, cutoff)?;
    let projection = observed.projection(&shown);
    let (mean, mean_coefficients) = match criterion {
        Criterion::ImageCentered => (Vec::new(), Vec::new()),
        Criterion::Standard => {
            let mean = observed.image(&observed.fold(&material.mean), &light.mean);
            let column = Mat::from_fn(mean.len(), 1, |k, _| mean[k]);
            let coefficients = &projection * column;
            (mean, coefficients.col(0).iter().copied().collect())
        }
    };
    table.summary.orthonormality = orthonormality;
    if energy > 0.0 {
        table.summary.energy_kept = (1.0 - table.energy_left(kept) / energy).max(0.0);
    }
    table.general = Some(General {
        normals: match geometry {
            Geometry::Sphere => 0,
            Geometry::Listed(listed) => listed.normals().len(),
        },
        rank,
        eigenvalues,
        projection: rows(&projection),
        synthesis: rows(&observed.synthesis(&shown)),
        modes: rows(&modes),
        mean,
        mean_coefficients,
    });
    Ok(table)
}

/// Q and S of the object's normals: S falls, and ends where it is below `cutoff`
/// times its largest.
fn observed(span: &Span, geometry: &Geometry, cutoff: f64) -> Result<(Mat<f64>, Vec<f64>)> {
    let Geometry::Listed(listed) = geometry else {
        // The span is orthonormal over the sphere.
        let dimension = span.dimension();
        return Ok((Mat::identity(dimension, dimension), vec![1.0; dimension]));
    };
    let svd = listed.factor(span).thin_svd().map_err(|_| {
        Error::new(
            "the singular values of the normals do not converge",
            "look for numbers that are not finite",
        )
    })?;
    let gains: Vec<f64> = svd.S().column_vector().iter().copied().collect();
    let largest = gains.first().copied().unwrap_or(0.0);
    let rank = gains.iter().filter(|gain| **gain > cutoff * largest).count();
    Ok((svd.V().get(.., ..rank).to_owned(), gains[..rank].to_vec()))
}

impl Observed {
    fn largest(&self) -> f64 {
        let of = self.span.azimuths.iter().filter_map(|of| of.block.singular_values.first());
        of.copied().fold(0.0, f64::max)
    }

    /// y = S Qᵀ a, column by column.
    fn shown(&self, coordinates: &Mat<f64>) -> Mat<f64> {
        let along = self.directions.transpose() * coordinates;
        Mat::from_fn(along.nrows(), along.ncols(), |i, j| self.gains[i] * along[(i, j)])
    }

    fn fold(&self, material: &[f64]) -> Folded {
        self.span.fold(&self.gram, material)
    }

    fn image(&self, folded: &Folded, light: &[f64]) -> Vec<f64> {
        self.span.image(folded, light)
    }

    /// Coordinates in the span of the images of the factor of V_c
    /// ([`Criterion::ImageCentered`]) or of Σ_c ([`Criterion::Standard`]): light and
    /// material are independent, so
    /// Σ_c = Cov(L) (x) E{bbᵀ} + E{L}E{L}ᵀ (x) Cov(b).
    fn deviations(
        &self,
        light: &LightStatistics,
        materials: &MaterialMoments,
        criterion: Criterion,
    ) -> Mat<f64> {
        let mut columns = Vec::new();
        for (material, root) in materials.rooted() {
            let scaled: Vec<f64> = material.iter().map(|b| root * b).collect();
            let folded = self.fold(&scaled);
            let vectors = match criterion {
                Criterion::ImageCentered => &light.second,
                Criterion::Standard => &light.centred,
            };
            columns.extend(vectors.iter().map(|vector| self.image(&folded, vector)));
            if criterion == Criterion::Standard {
                let apart = material.iter().zip(&materials.mean);
                let apart: Vec<f64> = apart.map(|(b, mean)| root * (b - mean)).collect();
                columns.push(self.image(&self.fold(&apart), &light.mean));
            }
        }
        Mat::from_fn(self.span.dimension(), columns.len(), |k, t| columns[t][k])
    }

    /// Coordinates in the span of the image of least norm that shows W: Q S⁻¹ W.
    fn synthesis(&self, shown: &Mat<f64>) -> Mat<f64> {
        let scaled =
            Mat::from_fn(shown.nrows(), shown.ncols(), |i, j| shown[(i, j)] / self.gains[i]);
        (&self.directions * scaled).transpose().to_owned()
    }

    /// d from coordinates in the span: Wᵀ S Qᵀ.
    fn projection(&self, shown: &Mat<f64>) -> Mat<f64> {
        let scaled =
            Mat::from_fn(shown.nrows(), shown.ncols(), |i, j| shown[(i, j)] * self.gains[i]);
        scaled.transpose() * self.directions.transpose()
    }

    /// U over the span's U, the rank of A, and |UᵀMU - I|.
    ///
    /// The span's coordinates of the modes are diag(s) Vᵀ, V orthonormal, so A⁺ is V
    /// times the pseudo-inverse of H = S Qᵀ diag(s), and the span's own U is V / s.
    fn modes(&self, shown: &Mat<f64>, cutoff: f64) -> Result<(Mat<f64>, usize, f64)> {
        let singular: Vec<f64> = self
            .span
            .functions()
            .map(|Function { order, profile }| {
                self.span.azimuths[order.unsigned_abs() as usize].singular_values[profile]
            })
            .collect();
        let along = self.directions.transpose();
        let factor = Mat::from_fn(along.nrows(), along.ncols(), |i, k| {
            self.gains[i] * along[(i, k)] * singular[k]
        });
        let svd = factor.thin_svd().map_err(|_| {
            Error::new("the singular values of the modes do not converge", "check the databases")
        })?;
        let values: Vec<f64> = svd.S().column_vector().iter().copied().collect();
        let threshold = cutoff * values.first().copied().unwrap_or(0.0);
        let rank = values.iter().filter(|value| **value > threshold).count();
        let projected = svd.U().get(.., ..rank).transpose() * shown;
        let scaled = Mat::from_fn(rank, shown.ncols(), |i, j| projected[(i, j)] / values[i]);
        let solution = svd.V().get(.., ..rank) * scaled;
        let image = &factor * solution.get(.., ..solution.ncols().min(REPORTED));
        let products = image.transpose() * &image;
        let mut worst: f64 = 0.0;
        for i in 0..products.nrows() {
            for j in 0..products.ncols() {
                let unit = f64::from(u8::from(i == j));
                worst = worst.max((products[(i, j)] - unit).abs());
            }
        }
        let modes =
            Mat::from_fn(shown.ncols(), singular.len(), |i, k| singular[k] * solution[(k, i)]);
        Ok((modes, rank, worst))
    }

    /// Puts the eigenimages into their one order and sign.
    fn settle(&self, shown: &mut Mat<f64>, eigenvalues: &[Option<f64>]) {
        let mut coordinates = self.synthesis(shown).transpose().to_owned();
        let pole = |function: Function| -> f64 {
            let of = &self.span.azimuths[function.order.unsigned_abs() as usize];
            of.chebyshev.col(function.profile).iter().sum()
        };
        let functions = Functions {
            orders: self.span.functions().map(|function| function.order).collect(),
            poles: self.span.functions().map(pole).collect(),
        };
        settle(shown, &mut coordinates, eigenvalues, &functions);
    }

    fn components(&self) -> Vec<Component> {
        let first: Vec<usize> = self
            .span
            .azimuths
            .iter()
            .scan(0, |start, of| {
                let first = *start;
                *start += of.profiles.ncols();
                Some(first)
            })
            .collect();
        self.span
            .functions()
            .map(|Function { order, profile }| Component {
                order,
                profile: first[order.unsigned_abs() as usize] + profile,
                eigenvalue: None,
            })
            .collect()
    }

    fn profiles(&self, tolerance: f64) -> Vec<Profile> {
        let mut profiles = Vec::new();
        for of in &self.span.azimuths {
            for profile in 0..of.profiles.ncols() {
                let coordinates = of.profiles.get(.., profile..profile + 1).to_owned();
                let image = eigenimages::image(&self.gram, &of.block, &coordinates, tolerance);
                // The span's own U: V / s, where `modes` is s V.
                let square = of.singular_values[profile].powi(2);
                let modes = of.modes.row(profile).iter().map(|mode| mode / square).collect();
                profiles.push(Profile { modes, ..image });
            }
        }
        profiles
    }
}

/// Row by row.
fn rows(matrix: &Mat<f64>) -> Vec<f64> {
    (0..matrix.nrows()).flat_map(|i| (0..matrix.ncols()).map(move |j| matrix[(i, j)])).collect()
}
