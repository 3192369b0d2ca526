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
use eigenshade_table::{General, Profile, Table, mode};

/// The allowed difference, relative to the largest number of its kind.
pub const ALLOWED: f64 = 1e-9;

/// The allowed difference of images drawn by a general table, in units of its profile tolerance:
/// the sum of the truncation errors of some hundred profiles.
const DRAWN: f64 = 100.0;

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
    if fresh.general.is_some() {
        let of_images =
            |what, of: fn(&General) -> &Vec<f64>| compared(what, &|one| projected(one, of));
        let allowed = DRAWN * fresh.scene.basis.profile_tolerance;
        let mut differences = vec![
            Difference { allowed, ..compared("eigenimages drawn", &drawn) },
            of_images("d of the eigenimages", |general| &general.synthesis),
            eigenvalues,
            spectrum,
            mode_means(),
            compared("rows of U^T M", &general_rows),
            mean,
        ];
        if fresh.has_modes() {
            differences.push(of_images("d of their modes", |general| &general.modes));
        }
        return Ok(differences);
    }
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
    if table.count() != fresh.count() || table.general.is_some() != fresh.general.is_some() {
        let (found, expected) = (table.count(), fresh.count());
        return Err(format!("it has {found} components instead of {expected}"));
    }
    // Rounding decides where the span of a general table ends, so the span is not compared.
    let determined = fresh.general.is_none();
    if determined && (orders(table) != orders(fresh) || azimuths(table) != azimuths(fresh)) {
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

/// Rows of UᵀM of a general table, for each eigenimage and each m of the span, computed from its
/// projection. Rounding affects where the profiles of the span end, but not these rows.
fn general_rows(table: &Table) -> Vec<f64> {
    let Some(general) = &table.general else { return Vec::new() };
    let of_profiles = table.profiles.iter().map(|profile| table.gram_row(profile)).collect();
    let length = |azimuth| mode::count(table.gram.degree, table.gram.order, azimuth);
    let functions = table.components.len().max(1);
    spanned(table, general.projection.chunks(functions), length, of_profiles)
}

/// Weighted sums of what belongs to the profiles of the span, for each row of weights and each m;
/// `length` numbers for an azimuth.
fn spanned<'w>(
    table: &Table,
    weights: impl Iterator<Item = &'w [f64]>,
    length: impl Fn(usize) -> usize,
    of_profiles: Vec<Vec<f64>>,
) -> Vec<f64> {
    let degree = table.gram.degree as i32;
    let mut values = Vec::new();
    for weights in weights {
        for order in -degree..=degree {
            let mut sums = vec![0.0; length(order.unsigned_abs() as usize)];
            for (component, weight) in table.components.iter().zip(weights) {
                if component.order == order {
                    for (sum, value) in sums.iter_mut().zip(&of_profiles[component.profile]) {
                        *sum += weight * value;
                    }
                }
            }
            values.extend(sums);
        }
    }
    values
}

/// d of the eigenimages that a general table gives in its span, row by row.
fn projected(table: &Table, of: fn(&General) -> &Vec<f64>) -> Vec<f64> {
    let Some(general) = &table.general else { return Vec::new() };
    let functions = table.components.len().max(1);
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let rows = general.projection.chunks(functions);
    rows.flat_map(|row| of(general).chunks(functions).map(move |image| dot(row, image))).collect()
}

/// The eigenimages and the mean image of a general table, drawn by the polynomials of its span, for
/// each order m on slants from the pole to the rim.
fn drawn(table: &Table) -> Vec<f64> {
    let Some(general) = &table.general else { return Vec::new() };
    let profiles = table.profiles.iter();
    let of_profiles =
        profiles.map(|profile| polynomial(profile.azimuth, &profile.chebyshev)).collect();
    let functions = table.components.len().max(1);
    let weights = general.synthesis.chunks(functions).chain(general.mean.chunks(functions));
    spanned(table, weights, |_| ARGUMENTS as usize + 1, of_profiles)
}

fn component_eigenvalues(table: &Table) -> Vec<f64> {
    if let Some(general) = &table.general {
        return general.eigenvalues.iter().map(|value| value.unwrap_or(0.0)).collect();
    }
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
    match &table.general {
        Some(general) => general.mean_coefficients.clone(),
        None => table.mean.as_ref().map_or_else(Vec::new, |mean| mean.coefficients.clone()),
    }
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
