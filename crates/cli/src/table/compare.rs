//! Compares two tables.
//!
//! The comparison covers what a scene determines: eigenvalues, profiles, mode means, rows of UᵀM
//! and the mean image. Of U it compares only the images AU, because a singular M leaves freedom in
//! the mode coefficients themselves.
//!
//! Rounding can end a polynomial one term earlier or later. Polynomials are therefore compared over
//! the terms that both tables have. Terms that only one table has may be as large as the polynomial
//! error that the scene allows.

use eigenshade_generator::basis::profile::evaluate;
use eigenshade_table::{Profile, Table};

/// The allowed difference, relative to the largest number of its kind.
pub const ALLOWED: f64 = 1e-9;

/// The number of arguments at which polynomials are compared.
const ARGUMENTS: u32 = 64;

/// The difference between two tables in one respect.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// What was compared.
    pub what: &'static str,
    /// The largest difference, relative to the largest of these numbers.
    pub found: f64,
    /// The allowed difference.
    pub allowed: f64,
}

impl Difference {
    /// Whether the difference is larger than allowed; true for NaN.
    #[must_use]
    pub fn is_over(&self) -> bool {
        self.found.is_nan() || self.found > self.allowed
    }
}

/// The differences between a table and the expected one. Fails if the tables do not match in scene,
/// degree, rank or number of components.
pub fn differences(table: &Table, fresh: &Table) -> Result<Vec<Difference>, String> {
    same_shape(table, fresh)?;
    let compared = |what, of: &dyn Fn(&Table) -> Vec<f64>| difference(what, &of(table), &of(fresh));
    let of_profiles = |what, of: &dyn Fn(&Table, &Profile) -> Vec<f64>| {
        compared(what, &|one| one.profiles.iter().flat_map(|profile| of(one, profile)).collect())
    };
    let mode_means = || compared("mode means e", &|one| one.gram.mode_means());
    let longest = table.spectrum.len().max(fresh.spectrum.len());
    let eigenvalues = compared("components' eigenvalues", &component_eigenvalues);
    let spectrum = compared("spectrum", &|one| spectrum(one, longest));
    let mean = compared("coefficients of the mean", &mean_coefficients);
    let [old_series, new_series, alone] = polynomials(table, fresh);
    // Each is within the tolerance of the whole series.
    let alone = Difference {
        what: "terms of one table only",
        found: alone.iter().fold(0.0, |most: f64, value| most.max(value.abs())),
        allowed: 2.0 * fresh.scene.basis.profile_tolerance,
    };
    let mut differences = vec![
        eigenvalues,
        spectrum,
        of_profiles("profiles at the nodes", &|_, profile| profile.node_values.clone()),
        difference("polynomials", &old_series, &new_series),
        alone,
        mean,
    ];
    if fresh.has_projection() {
        differences.push(mode_means());
        differences.push(of_profiles("rows of U^T M", &|one, profile| one.gram_row(profile)));
    } else {
        differences.push(compared("transfers", &transfers));
    }
    if fresh.has_modes() {
        let columns: Vec<_> =
            (0..=fresh.gram.degree).map(|azimuth| fresh.gram.columns(azimuth)).collect();
        let image = |_: &Table, profile: &Profile| image(&columns[profile.azimuth], profile);
        differences.push(of_profiles("images A U", &image));
    }
    Ok(differences)
}

/// An image AU: weighted values at the nodes.
fn image(columns: &[Vec<f64>], profile: &Profile) -> Vec<f64> {
    let mut image = vec![0.0; profile.node_values.len()];
    for (column, coefficient) in columns.iter().zip(&profile.modes) {
        for (pixel, value) in image.iter_mut().zip(column) {
            *pixel += coefficient * value;
        }
    }
    image
}

fn transfers(table: &Table) -> Vec<f64> {
    table.transfers.iter().flat_map(|one| one.numbers.iter().copied()).collect()
}

fn same_shape(table: &Table, fresh: &Table) -> Result<(), String> {
    let orders = |table: &Table| {
        table.components.iter().map(|one| (one.order, one.profile)).collect::<Vec<_>>()
    };
    let azimuths = |table: &Table| {
        let lengths = table.profiles.iter().map(|one| (one.azimuth, one.node_values.len()));
        lengths.collect::<Vec<_>>()
    };
    if table.scene != fresh.scene {
        return Err("it was made for another scene".into());
    }
    if table.count() != fresh.count() {
        let (found, expected) = (table.count(), fresh.count());
        return Err(format!("it has {found} components instead of {expected}"));
    }
    if orders(table) != orders(fresh) || azimuths(table) != azimuths(fresh) {
        return Err("its components have other azimuths".into());
    }
    if table.selection != fresh.selection {
        return Err("it keeps other modes".into());
    }
    if table.summary.ranks != fresh.summary.ranks {
        return Err("the ranks of its blocks differ".into());
    }
    Ok(())
}

fn component_eigenvalues(table: &Table) -> Vec<f64> {
    table.components.iter().map(|one| one.eigenvalue.unwrap_or(0.0)).collect()
}

/// The spectrum, padded with zeros because rounding decides where it ends.
fn spectrum(table: &Table, length: usize) -> Vec<f64> {
    let mut values: Vec<f64> =
        table.spectrum.iter().map(|(_, value)| value.unwrap_or(0.0)).collect();
    values.resize(length, 0.0);
    values
}

/// Values u(α) of each profile and of the mean image at the slants: for both tables over their
/// common terms, and for the terms that only one of them has. All values are relative to the
/// largest |u| of that profile.
fn polynomials(table: &Table, fresh: &Table) -> [Vec<f64>; 3] {
    let series = |table: &Table| -> Vec<(usize, Vec<f64>)> {
        let profiles = table.profiles.iter().map(|one| (one.azimuth, one.chebyshev.clone()));
        let mean = table.mean.iter().map(|mean| (0, mean.chebyshev.clone()));
        profiles.chain(mean).collect()
    };
    let mut values = [const { Vec::new() }; 3];
    for ((azimuth, old), (_, new)) in series(table).into_iter().zip(series(fresh)) {
        let longer = if old.len() > new.len() { &old } else { &new };
        let both = old.len().min(new.len());
        let mut alone = longer.clone();
        alone.iter_mut().take(both).for_each(|term| *term = 0.0);
        let largest = polynomial(azimuth, longer)
            .iter()
            .fold(f64::MIN_POSITIVE, |most, value| most.max(value.abs()));
        for (values, series) in values.iter_mut().zip([&old[..both], &new[..both], &alone]) {
            values.extend(polynomial(azimuth, series).iter().map(|u| u / largest));
        }
    }
    values
}

/// Values u(α) on slants from the pole to the rim.
fn polynomial(azimuth: usize, chebyshev: &[f64]) -> Vec<f64> {
    let value = |k: u32| {
        let alpha = std::f64::consts::FRAC_PI_2 * f64::from(k) / f64::from(ARGUMENTS);
        let (sine, z) = alpha.sin_cos();
        sine.powi(azimuth as i32) * evaluate(chebyshev, z)
    };
    (0..=ARGUMENTS).map(value).collect()
}

fn mean_coefficients(table: &Table) -> Vec<f64> {
    table.mean.as_ref().map_or_else(Vec::new, |mean| mean.coefficients.clone())
}

fn difference(what: &'static str, found: &[f64], expected: &[f64]) -> Difference {
    let largest = expected.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    let worst = if found.len() == expected.len() {
        found.iter().zip(expected).fold(0.0, |most: f64, (a, b)| {
            let difference = (a - b).abs();
            if difference > most || difference.is_nan() { difference } else { most }
        })
    } else {
        f64::INFINITY
    };
    let found = if worst == 0.0 { 0.0 } else { worst / largest };
    Difference { what, found, allowed: ALLOWED }
}
