//! A table as arrays: M's factor, the means e, U over modes, eigenvalues, profiles, and eigenimages
//! at normals.

use super::array::Array;
use super::shown::Shown;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::evaluation::Evaluator;
use eigenshade_table::{Profile, Table, mode};

/// The most numbers in the arrays of a table.
#[must_use]
pub fn size(table: &Table, normals: usize) -> usize {
    let modes = mode::total(table.gram.degree, table.gram.order);
    let by_mode = modes * (table.gram.nodes.len() + 2 * table.components.len() + 7);
    by_mode + normals * (table.count() + 7)
}

/// The arrays of a table. Modes are sorted by m from -degree to degree, and within one m in the
/// order of [`mode`]. Fails if the table stores only transfers.
pub fn arrays(table: &Table, shown: Option<&Shown>) -> Result<Vec<Array>> {
    if !table.has_projection() {
        let remedy = "make it with store = \"modes\"";
        return Err(Error::new("the table has only transfers, not M and U", remedy));
    }
    let gram = &table.gram;
    let (degree, order, nodes) = (gram.degree, gram.order, gram.nodes.len());
    let components = table.components.len();
    let signed = || -(degree as i64)..=degree as i64;
    let total = mode::total(degree, order);
    let modes = signed().flat_map(|m| {
        let of_m = mode::indices(degree, order, m.unsigned_abs() as usize);
        of_m.flat_map(move |(l, o, p, q)| [l as i64, m, o as i64, p as i64, q as i64])
    });
    let kept = signed().flat_map(|m| {
        let azimuth = m.unsigned_abs() as usize;
        let of_m = mode::indices(degree, order, azimuth);
        of_m.map(move |(l, o, p, q)| i64::from(table.keeps(azimuth, l, o, p, q)))
    });
    let means = gram.mode_means();
    let means = signed().flat_map(|m| {
        let of_m = mode::count(degree, order, m.unsigned_abs() as usize);
        if m == 0 { means.clone() } else { vec![0.0; of_m] }
    });
    let mut arrays = vec![
        scalar("degree", vec![degree as i64]),
        scalar("order", vec![order as i64]),
        scalar("criterion", vec![table.scene.basis.criterion.name().to_owned()]),
        scalar("energy", vec![table.summary.energy]),
        Array::new("modes", [total, 5], modes.collect::<Vec<_>>()),
        Array::new("kept", [total], kept.collect::<Vec<_>>()),
        Array::new("nodes", [nodes], gram.nodes.clone()),
        Array::new("root_weights", [nodes], gram.root_weights.clone()),
        Array::new("gram_factor", [nodes, total], factor(table)),
        Array::new("mode_means", [total], means.collect::<Vec<_>>()),
        Array::new(
            "component_m",
            [components],
            table.components.iter().map(|one| i64::from(one.order)).collect::<Vec<_>>(),
        ),
        Array::new(
            "profiles",
            [nodes, components],
            by_component(table, nodes, |profile, k| profile.node_values[k]),
        ),
        series(table),
        Array::new(
            "projection",
            [components, total],
            rows(table, |profile| table.gram_row(profile)),
        ),
    ];
    if table.has_modes() {
        let rows = rows(table, |profile| profile.modes.clone());
        let columns = (0..total).flat_map(|s| (0..components).map(move |i| (i, s)));
        arrays.push(Array::new(
            "mode_coefficients",
            [total, components],
            columns.map(|(i, s)| rows[i * total + s]).collect::<Vec<_>>(),
        ));
    }
    arrays.extend(statistics(table));
    if let Some(shown) = shown {
        arrays.extend(images(table, shown));
        arrays.extend(shown.arrays());
    }
    Ok(arrays)
}

fn scalar(name: &'static str, value: impl Into<super::array::Values>) -> Array {
    Array::new(name, [], value)
}

/// The sign of what +m and -m share: (-1)^m for -m.
fn sign(m: i64) -> f64 {
    if m < 0 && m % 2 != 0 { -1.0 } else { 1.0 }
}

/// A over nodes and modes.
fn factor(table: &Table) -> Vec<f64> {
    let gram = &table.gram;
    let degree = gram.degree as i64;
    let columns: Vec<Vec<Vec<f64>>> = (0..=gram.degree).map(|m| gram.columns(m)).collect();
    let at = |k: usize| {
        let columns = &columns;
        (-degree..=degree).flat_map(move |m| {
            columns[m.unsigned_abs() as usize].iter().map(move |column| sign(m) * column[k])
        })
    };
    (0..gram.nodes.len()).flat_map(at).collect()
}

/// A row over all modes for each component, from the numbers of its own |m|.
fn rows(table: &Table, of_profile: impl Fn(&Profile) -> Vec<f64>) -> Vec<f64> {
    let (degree, order) = (table.gram.degree, table.gram.order);
    let numbers: Vec<Vec<f64>> = table.profiles.iter().map(of_profile).collect();
    let mut rows = Vec::with_capacity(table.components.len() * mode::total(degree, order));
    for component in &table.components {
        for m in -(degree as i64)..=degree as i64 {
            if m == i64::from(component.order) {
                rows.extend(numbers[component.profile].iter().map(|value| sign(m) * value));
            } else {
                let zeros = mode::count(degree, order, m.unsigned_abs() as usize);
                rows.extend(std::iter::repeat_n(0.0, zeros));
            }
        }
    }
    rows
}

/// Numbers of each component's profile: `length` rows, a column for each component.
fn by_component(table: &Table, length: usize, of: impl Fn(&Profile, usize) -> f64) -> Vec<f64> {
    let row = |k| table.components.iter().map(move |one| (&table.profiles[one.profile], k));
    (0..length).flat_map(row).map(|(profile, k)| of(profile, k)).collect()
}

fn series(table: &Table) -> Array {
    let longest = table.profiles.iter().map(|profile| profile.chebyshev.len()).max().unwrap_or(0);
    Array::new(
        "series",
        [longest, table.components.len()],
        by_component(table, longest, |profile, k| profile.chebyshev.get(k).copied().unwrap_or(0.0)),
    )
}

fn statistics(table: &Table) -> Vec<Array> {
    let number = |value: Option<f64>| value.unwrap_or(f64::NAN);
    let (components, spectrum) = (&table.components, &table.spectrum);
    let mut arrays = vec![
        Array::new(
            "eigenvalues",
            [components.len()],
            components.iter().map(|one| number(one.eigenvalue)).collect::<Vec<_>>(),
        ),
        Array::new(
            "spectrum",
            [spectrum.len()],
            spectrum.iter().map(|(_, value)| number(*value)).collect::<Vec<_>>(),
        ),
    ];
    if let Some(mean) = &table.mean {
        arrays.push(Array::new("mean_series", [mean.chebyshev.len()], mean.chebyshev.clone()));
        arrays.push(Array::new(
            "mean_coefficients",
            [mean.coefficients.len()],
            mean.coefficients.clone(),
        ));
    }
    arrays
}

/// Each eigenimage at the normals, and the mean image if there is one.
fn images(table: &Table, shown: &Shown) -> Vec<Array> {
    let (count, length) = (table.count(), shown.normals.len());
    let eigenimages = Evaluator::new(table).eigenimages(&shown.normals);
    let values = (0..count).flat_map(|component| eigenimages.eigenimage(component));
    let mean = eigenimages.mean().to_vec();
    let has_mean = mean.iter().any(|&value| value != 0.0);
    let mut arrays = vec![Array::new("eigenimages", [count, length], values.collect::<Vec<_>>())];
    if has_mean {
        arrays.push(Array::new("mean_image", [length], mean));
    }
    arrays
}
