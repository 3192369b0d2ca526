//! Recovers the coefficients c of the irradiance modes from components.

use super::posterior::Estimate;
use super::posterior::Prior;
use super::transfer::{Transfers, sign};
use eigenshade_table::scene::Criterion;
use eigenshade_table::{Table, light, material};
use faer::{Col, Mat};

/// c of every mode, with one row for each light coefficient (l, m) and one column for each material
/// coefficient (o, p, q). Entries with q > l are zero: those modes do not exist.
#[derive(Clone, Debug)]
pub struct ModeCoefficients {
    /// Largest degree l.
    pub degree: usize,
    /// Largest order o.
    pub order: usize,
    /// The coefficients.
    pub values: Mat<f64>,
}

impl ModeCoefficients {
    /// All zero.
    #[must_use]
    pub fn zeros(degree: usize, order: usize) -> Self {
        let values = Mat::zeros(light::count(degree), material::count(order));
        Self { degree, order, values }
    }

    /// Whether the mode at a row and column exists: q <= l.
    pub fn exists(&self) -> impl Fn(usize, usize) -> bool + use<> {
        let degrees: Vec<usize> = light::indices(self.degree).map(|(l, _)| l).collect();
        let frequencies: Vec<usize> = material::indices(self.order).map(|(_, _, q)| q).collect();
        move |row, column| frequencies[column] <= degrees[row]
    }
}

/// c = U d, (42): the c of least norm among all whose image is Σ d_i U_i, up to the table's rank
/// cut-off.
#[must_use]
pub fn least_norm(table: &Table, d: &[f64]) -> ModeCoefficients {
    let (degree, order) = (table.gram.degree, table.gram.order);
    let mut c = ModeCoefficients::zeros(degree, order);
    for (component, d) in table.components.iter().zip(d) {
        let profile = &table.profiles[component.profile];
        let modes = eigenshade_table::mode::indices(degree, order, profile.azimuth);
        for ((l, o, p, q), u) in modes.zip(&profile.modes) {
            let row = light::position(l, component.order as isize);
            c.values[(row, material::position(o, p, q))] += sign(component.order) * d * u;
        }
    }
    c
}

/// The posterior mean of c: s c̄ + s Σ_c M U x, where V_d x is the posterior of d, c̄ and Σ_c are
/// the mean and covariance of c, and s is the estimate's exposure. For image-centered PCA, which
/// subtracts no mean image, it is s V_c M U x.
///
/// Each material of the database contributes with the light that the image makes likely for it.
/// Where the pixels carry no information, the result follows the statistics. Components beyond
/// those of the observation are treated as noise.
#[must_use]
pub fn posterior_mean(
    transfers: &Transfers,
    prior: &Prior,
    estimate: &Estimate,
) -> ModeCoefficients {
    let mut c = ModeCoefficients::zeros(transfers.degree(), transfers.order());
    let mut add = |light: &Col<f64>, material: &[f64], share: f64| {
        for (column, b) in material.iter().enumerate().take(c.values.ncols()) {
            for (row, light) in light.iter().enumerate() {
                c.values[(row, column)] += share * light * b;
            }
        }
    };
    let (light, materials) = (&prior.light, &prior.materials);
    let vectors = light.vectors(prior.criterion);
    let x = prior.dual(&estimate.coordinates);
    let mean_along = transfers.of(&materials.mean).transpose() * &x;
    for (vector, root) in materials.rooted() {
        let share = estimate.exposure * root * root;
        let along = transfers.of(vector).transpose() * &x;
        add(&(vectors * (vectors.transpose() * &along)), vector, share);
        if prior.criterion == Criterion::Standard {
            let deviation: Vec<f64> =
                vector.iter().zip(&materials.mean).map(|(b, m)| b - m).collect();
            let likely = light.mean.transpose() * (along - &mean_along);
            add(&light.mean, &deviation, share * likely);
        }
    }
    if prior.criterion == Criterion::Standard {
        add(&light.mean, &materials.mean, estimate.exposure);
    }
    let exists = c.exists();
    for column in 0..c.values.ncols() {
        for row in 0..c.values.nrows() {
            if !exists(row, column) {
                c.values[(row, column)] = 0.0;
            }
        }
    }
    c
}
