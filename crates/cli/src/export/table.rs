//! A table as arrays: M's factor, the means e, U over modes, eigenvalues, profiles, and eigenimages
//! at normals.

use super::array::Array;
use super::shown::Shown;
use eigenshade_index::mode;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::evaluation::Evaluator;
use eigenshade_table::{General, Profile, Table};

/// Bytes of a number, as it is and as text, with what is allocated beside it.
pub(super) const BYTES: u64 = 48;

/// The bytes that an export of a table takes at most: the arrays, and the text of a file.
#[must_use]
pub fn size(table: &Table, normals: usize) -> u64 {
    let modes = mode::total(table.gram.degree, table.gram.order);
    let by_mode = modes * (table.gram.nodes.len() + 2 * table.components.len() + 7);
    BYTES * (by_mode + normals * (table.count() + 7)) as u64
}

/// The arrays of a table. Modes are sorted by m from -degree to degree, and within one m in the
/// order of [`mode`]. For an object other than the sphere, the arrays over components describe the
/// span, and those of [`General`] the eigenimages over it. Fails if the table stores only
/// transfers.
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
        scalar(("degree", "largest degree l of the light", "1"), vec![degree as i64]),
        scalar(("order", "largest order o of the BRDF", "1"), vec![order as i64]),
        scalar(
            ("criterion", "image-centered (18) or standard (17)", "1"),
            vec![table.scene.basis.criterion.name().to_owned()],
        ),
        scalar(
            ("energy", "mean energy of the database's images about their mean", "irradiance^2"),
            vec![table.summary.energy],
        ),
        Array::new(
            ("modes", "l, m, o, p and q of each irradiance mode E_lop^mq", "1"),
            [("mode", total), ("l m o p q", 5)],
            modes.collect::<Vec<_>>(),
        ),
        Array::new(
            ("kept", "1 if the table includes the mode", "1"),
            [("mode", total)],
            kept.collect::<Vec<_>>(),
        ),
        Array::new(
            ("nodes", "z = cos alpha of each node", "1"),
            [("node", nodes)],
            gram.nodes.clone(),
        ),
        Array::new(
            ("root_weights", "square root of each node's weight; the weights sum to 1", "1"),
            [("node", nodes)],
            gram.root_weights.clone(),
        ),
        Array::new(
            ("gram_factor", "A with M = A^T A between modes of one m; 0 between others", "sr^1/2"),
            [("node", nodes), ("mode", total)],
            factor(table),
        ),
        Array::new(
            ("mode_means", "e, the mean of each mode over the normals", "sr"),
            [("mode", total)],
            means.collect::<Vec<_>>(),
        ),
        Array::new(
            ("component_m", "m of each component", "1"),
            [("component", components)],
            table.components.iter().map(|one| i64::from(one.order)).collect::<Vec<_>>(),
        ),
        Array::new(
            ("profiles", "square root of weight times the component's profile u", "1"),
            [("node", nodes), ("component", components)],
            by_component(table, nodes, |profile, k| profile.node_values[k]),
        ),
        series(table),
        Array::new(
            ("projection", "U^T M", "sr"),
            [("component", components), ("mode", total)],
            rows(table, |profile| table.gram_row(profile)),
        ),
    ];
    if table.has_modes() {
        let rows = rows(table, |profile| profile.modes.clone());
        let columns = (0..total).flat_map(|s| (0..components).map(move |i| (i, s)));
        arrays.push(Array::new(
            ("mode_coefficients", "U over modes, a column for each component", "1/sr"),
            [("mode", total), ("component", components)],
            columns.map(|(i, s)| rows[i * total + s]).collect::<Vec<_>>(),
        ));
    }
    arrays.extend(statistics(table));
    table.general.iter().for_each(|general| arrays.extend(of_object(general, components)));
    if let Some(shown) = shown {
        arrays.extend(images(table, shown));
        arrays.extend(shown.arrays());
    }
    Ok(arrays)
}

fn scalar(
    text: (&'static str, &'static str, &'static str),
    value: impl Into<super::array::Values>,
) -> Array {
    Array::new(text, [], value)
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
        ("series", "Chebyshev coefficients in 2z - 1 of h with u = sin^|m|(alpha) h(z)", "1"),
        [("term", longest), ("component", table.components.len())],
        by_component(table, longest, |profile, k| profile.chebyshev.get(k).copied().unwrap_or(0.0)),
    )
}

fn statistics(table: &Table) -> Vec<Array> {
    let of_components = || table.components.iter().map(|one| one.eigenvalue).collect();
    let values: Vec<Option<f64>> =
        table.general.as_ref().map_or_else(of_components, |general| general.eigenvalues.clone());
    let number = |value: Option<f64>| value.unwrap_or(f64::NAN);
    let spectrum = &table.spectrum;
    let mut arrays = vec![
        Array::new(
            ("eigenvalues", "variance of each eigenimage; none for the constant", "irradiance^2"),
            [("eigenimage", values.len())],
            values.into_iter().map(number).collect::<Vec<_>>(),
        ),
        Array::new(
            ("spectrum", "eigenvalues of all components, kept or not", "irradiance^2"),
            [("index", spectrum.len())],
            spectrum.iter().map(|(_, value)| number(*value)).collect::<Vec<_>>(),
        ),
    ];
    if let Some(mean) = &table.mean {
        arrays.push(Array::new(
            ("mean_series", "Chebyshev coefficients in 2z - 1 of the mean image", "irradiance"),
            [("term", mean.chebyshev.len())],
            mean.chebyshev.clone(),
        ));
        arrays.push(Array::new(
            ("mean_coefficients", "the mean image in the components", "irradiance"),
            [("component", mean.coefficients.len())],
            mean.coefficients.clone(),
        ));
    }
    arrays
}

fn of_object(general: &General, components: usize) -> Vec<Array> {
    let count = general.eigenvalues.len();
    let matrices = [
        ("object_projection", "maps an image's coordinates in the span to d", &general.projection),
        ("object_synthesis", "coordinates of each eigenimage in the span", &general.synthesis),
        ("object_modes", "U of each eigenimage in terms of U of the span", &general.modes),
    ];
    let kept = matrices.into_iter().filter(|(_, _, values)| !values.is_empty());
    let axes = [("eigenimage", count), ("component", components)];
    kept.map(|(name, meaning, values)| Array::new((name, meaning, "1"), axes, values.clone()))
        .collect()
}

/// Each eigenimage at the normals, and the mean image if there is one.
fn images(table: &Table, shown: &Shown) -> Vec<Array> {
    let (count, length) = (table.count(), shown.normals.len());
    let eigenimages = Evaluator::new(table).eigenimages(&shown.normals);
    let values = (0..count).flat_map(|component| eigenimages.eigenimage(component));
    let mean = eigenimages.mean().to_vec();
    let has_mean = mean.iter().any(|&value| value != 0.0);
    let mut arrays = vec![Array::new(
        ("eigenimages", "U_i at each normal", "1"),
        [("eigenimage", count), ("normal", length)],
        values.collect::<Vec<_>>(),
    )];
    if has_mean {
        arrays.push(Array::new(
            ("mean_image", "the image of d = 0 at each normal", "irradiance"),
            [("normal", length)],
            mean,
        ));
    }
    arrays
}
