//! Back from components to the coefficients c of the irradiance modes.

use super::posterior::Estimate;
use super::prior::Prior;
use super::transfer::{Transfers, sign};
use eigenshade_index::{light, material};
use eigenshade_table::Table;
use faer::Mat;

/// c of every mode: a row a light coefficient (l, m), a column a material
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

    /// Whether the mode of a row and a column exists: q <= l.
    pub fn exists(&self) -> impl Fn(usize, usize) -> bool + use<> {
        let degrees: Vec<usize> = light::indices(self.degree).map(|(l, _)| l).collect();
        let frequencies: Vec<usize> = material::indices(self.order).map(|(_, _, q)| q).collect();
        move |row, column| frequencies[column] <= degrees[row]
    }
}

/// c = U d, (42): of all c whose image is Σ d_i U_i the one of least norm, up to the
/// table's rank cut-off.
#[must_use]
pub fn least_norm(table: &Table, d: &[f64]) -> ModeCoefficients {
    let (degree, order) = (table.gram.degree, table.gram.order);
    let mut c = ModeCoefficients::zeros(degree, order);
    for (component, d) in table.components.iter().zip(d) {
        let profile = &table.profiles[component.profile];
        let modes = eigenshade_index::mode::indices(degree, order, profile.azimuth);
        for ((l, o, p, q), u) in modes.zip(&profile.modes) {
            let row = light::position(l, component.order as isize);
            c.values[(row, material::position(o, p, q))] += sign(component.order) * d * u;
        }
    }
    c
}

/// The posterior mean of c under V_c: c = V_c M U x with V_d x the posterior of d.
///
/// Each material of the database takes part with the light that the image makes
/// likely for it; where pixels say nothing, the statistics speak. The components
/// beyond the observation's are taken for noise. For the standard criterion this is
/// the deviation from the mean of c, at the estimate's exposure.
#[must_use]
pub fn posterior_mean(
    transfers: &Transfers,
    prior: &Prior,
    estimate: &Estimate,
) -> ModeCoefficients {
    let order = transfers.order();
    let mut c = ModeCoefficients::zeros(transfers.degree(), order);
    let x = prior.dual(&estimate.coordinates);
    for (vector, root) in prior.materials.rooted() {
        let share = estimate.exposure * root * root;
        let along = transfers.of(vector).transpose() * &x;
        for (row, (l, _)) in light::indices(transfers.degree()).enumerate() {
            let power = prior.light.power.get(l).copied().unwrap_or(0.0);
            for (column, b) in vector.iter().enumerate().take(c.values.ncols()) {
                c.values[(row, column)] += share * power * along[row] * b;
            }
        }
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
