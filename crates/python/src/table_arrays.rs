//! The numbers of a table over all modes, as arrays. Modes are sorted by m from -degree to degree,
//! and within one m in the order of [`mode`].

use crate::arrays::raised;
use eigenshade_model::error::Error;
use eigenshade_table::{Profile, Table, mode};
use numpy::ndarray::Array2;
use pyo3::prelude::*;

/// l, m, o, p and q of each mode.
pub fn modes(table: &Table) -> Array2<i64> {
    let (degree, order) = (table.gram.degree, table.gram.order);
    let rows: Vec<i64> = orders(table)
        .flat_map(|m| {
            let of_m = mode::indices(degree, order, azimuth(m));
            of_m.flat_map(move |(l, o, p, q)| [l as i64, m, o as i64, p as i64, q as i64])
        })
        .collect();
    Array2::from_shape_vec((rows.len() / 5, 5), rows).expect("five indices")
}

/// The mean of each mode over the normals.
pub fn mode_means(table: &Table) -> Vec<f64> {
    let gram = &table.gram;
    let of_m = |m| match m {
        0 => gram.mode_means(),
        _ => vec![0.0; mode::count(gram.degree, gram.order, azimuth(m))],
    };
    orders(table).flat_map(of_m).collect()
}

/// A over nodes and modes.
pub fn gram_factor(table: &Table) -> Array2<f64> {
    let gram = &table.gram;
    let columns: Vec<Vec<f64>> = orders(table)
        .flat_map(|m| {
            let columns = gram.columns(azimuth(m));
            columns.into_iter().map(move |column| column.iter().map(|one| sign(m) * one).collect())
        })
        .collect();
    Array2::from_shape_fn((gram.nodes.len(), columns.len()), |(k, s)| columns[s][k])
}

/// UᵀM: a row for each component.
pub fn projection(table: &Table) -> PyResult<Array2<f64>> {
    if !table.has_projection() {
        return Err(missing("UᵀM"));
    }
    Ok(rows(table, |profile| table.gram_row(profile)))
}

/// U over modes: a column for each component.
pub fn mode_coefficients(table: &Table) -> PyResult<Array2<f64>> {
    if !table.has_modes() {
        return Err(missing("U over modes"));
    }
    Ok(rows(table, |profile| profile.modes.clone()).reversed_axes())
}

/// Numbers of each component's profile as columns; shorter ones end in zeros.
pub fn by_component(table: &Table, of: impl Fn(&Profile) -> &Vec<f64>) -> Array2<f64> {
    let columns: Vec<&Vec<f64>> =
        table.components.iter().map(|one| of(&table.profiles[one.profile])).collect();
    let longest = columns.iter().map(|column| column.len()).max().unwrap_or(0);
    let number = |(k, i): (usize, usize)| columns[i].get(k).copied().unwrap_or(0.0);
    Array2::from_shape_fn((longest, columns.len()), number)
}

fn missing(what: &str) -> PyErr {
    let what = format!("the table does not have {what}");
    raised(Error::new(what, "make it with store = \"modes\""))
}

fn orders(table: &Table) -> impl Iterator<Item = i64> + use<> {
    let degree = table.gram.degree as i64;
    -degree..=degree
}

fn azimuth(m: i64) -> usize {
    m.unsigned_abs() as usize
}

/// The sign of what +m and -m share: (-1)^m for -m.
fn sign(m: i64) -> f64 {
    if m < 0 && m % 2 != 0 { -1.0 } else { 1.0 }
}

/// A row over all modes for each component, from the numbers of its own |m|.
fn rows(table: &Table, of_profile: impl Fn(&Profile) -> Vec<f64>) -> Array2<f64> {
    let (degree, order) = (table.gram.degree, table.gram.order);
    let total = mode::total(degree, order);
    let numbers: Vec<Vec<f64>> = table.profiles.iter().map(of_profile).collect();
    let mut rows = Array2::zeros((table.components.len(), total));
    for (mut row, component) in rows.outer_iter_mut().zip(&table.components) {
        let own = i64::from(component.order);
        let before = orders(table).take_while(|&m| m < own);
        let start: usize = before.map(|m| mode::count(degree, order, azimuth(m))).sum();
        for (s, number) in numbers[component.profile].iter().enumerate() {
            row[start + s] = sign(own) * number;
        }
    }
    rows
}
