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
use eigenshade_index::mode;
use eigenshade_table::{General, Profile, Table};

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

/// The differences between a table and the expected one.
///
/// # Errors
///
/// If the tables do not match in scene, degree, rank or number of components.
pub fn differences(table: &Table, fresh: &Table) -> Result<Vec<Difference>, String> {
    same_shape(table, fresh)?;
    let both = [table, fresh];
    let [old_values, new_values] = both.map(component_eigenvalues);
    let [old_spectrum, new_spectrum] = both.map(|table| spectrum(table, longest_spectrum(both)));
    let of_profiles = |table: &Table, f: &dyn Fn(&Profile) -> Vec<f64>| -> Vec<f64> {
        table.profiles.iter().flat_map(f).collect()
    };
    let compared = |what, f: &dyn Fn(&Profile) -> Vec<f64>| {
        difference(what, &of_profiles(table, f), &of_profiles(fresh, f))
    };
    let [old_series, new_series, alone] = polynomials(table, fresh);
    // Each is within the tolerance of the whole series.
    let alone = Difference {
        what: "terms of one table only",
        found: alone.iter().fold(0.0, |most: f64, value| most.max(value.abs())),
        allowed: 2.0 * fresh.scene.basis.profile_tolerance,
    };
    let [old_mean, new_mean] = both.map(mean_coefficients);
    if fresh.general.is_some() {
        let [old_rows, new_rows] = both.map(general_rows);
        let [old_images, new_images] = both.map(|table| projected(table, |one| &one.synthesis));
        let [old_drawn, new_drawn] = both.map(drawn);
        let mut differences = vec![
            Difference {
                allowed: DRAWN * fresh.scene.basis.profile_tolerance,
                ..difference("eigenimages drawn", &old_drawn, &new_drawn)
            },
            difference("d of the eigenimages", &old_images, &new_images),
            difference("components' eigenvalues", &old_values, &new_values),
            difference("spectrum", &old_spectrum, &new_spectrum),
            difference("mode means e", &table.gram.mode_means(), &fresh.gram.mode_means()),
            difference("rows of U^T M", &old_rows, &new_rows),
            difference("coefficients of the mean", &old_mean, &new_mean),
        ];
        if fresh.has_modes() {
            let [old_modes, new_modes] = both.map(|table| projected(table, |one| &one.modes));
            differences.push(difference("d of their modes", &old_modes, &new_modes));
        }
        return Ok(differences);
    }
    let mut differences = vec![
        difference("components' eigenvalues", &old_values, &new_values),
        difference("spectrum", &old_spectrum, &new_spectrum),
        compared("profiles at the nodes", &|profile| profile.node_values.clone()),
        difference("polynomials", &old_series, &new_series),
        alone,
        difference("coefficients of the mean", &old_mean, &new_mean),
    ];
    if fresh.has_projection() {
        let [old_means, new_means] = both.map(|table| table.gram.mode_means());
        differences.push(difference("mode means e", &old_means, &new_means));
        let [old, new] = both.map(|table| of_profiles(table, &|one| table.gram_row(one)));
        differences.push(difference("rows of U^T M", &old, &new));
    } else {
        let [old, new] = both.map(transfers);
        differences.push(difference("transfers", &old, &new));
    }
    if fresh.has_modes() {
        let columns: Vec<_> =
            (0..=fresh.gram.degree).map(|azimuth| fresh.gram.columns(azimuth)).collect();
        let image = |profile: &Profile| image(&columns[profile.azimuth], profile);
        let [old, new] = both.map(|table| of_profiles(table, &image));
        differences.push(difference("images A U", &old, &new));
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

fn longest_spectrum(tables: [&Table; 2]) -> usize {
    tables.map(|table| table.spectrum.len()).into_iter().max().unwrap_or(0)
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
    let slants =
        (0..=ARGUMENTS).map(|k| std::f64::consts::FRAC_PI_2 * f64::from(k) / f64::from(ARGUMENTS));
    slants
        .map(|alpha| {
            let (sine, z) = alpha.sin_cos();
            sine.powi(azimuth as i32) * evaluate(chebyshev, z)
        })
        .collect()
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
