//! The energy that a table's polynomials omit from its profiles.

use crate::basis::profile::evaluate;
use eigenshade_table::Table;

/// Number of terms of a collapsed scene, with both signs of m included.
pub(super) fn terms(table: &Table) -> usize {
    let azimuths = table.profiles.iter().map(|one| (one.azimuth, one.chebyshev.len()));
    let mean = table.mean.iter().map(|mean| (0, mean.chebyshev.len()));
    let mut longest = vec![0; table.gram.degree + 1];
    for (azimuth, length) in azimuths.chain(mean) {
        longest[azimuth] = length.max(longest[azimuth]);
    }
    longest.iter().enumerate().map(|(m, length)| length * if m == 0 { 1 } else { 2 }).sum()
}

/// Mean energy of the database's images that the polynomials omit. The coefficients of components
/// are uncorrelated, so each profile's squared error at the nodes is weighted by the eigenvalues of
/// its components. The mean image's error counts once; its weighted node values are `mean`.
pub(super) fn left_out(table: &Table, mean: Option<&[f64]>) -> f64 {
    let gram = &table.gram;
    let apart = |azimuth: usize, series: &[f64], values: &[f64]| -> f64 {
        let nodes = gram.nodes.iter().zip(&gram.root_weights).zip(values);
        let squares = nodes.map(|((&z, root), value)| {
            let sine = ((1.0 - z) * (1.0 + z)).sqrt().powi(azimuth as i32);
            (root * sine * evaluate(series, z) - value).powi(2)
        });
        squares.sum()
    };
    let of_mean =
        table.mean.iter().zip(mean).map(|(mean, values)| apart(0, &mean.chebyshev, values));
    let mut lost: f64 = of_mean.sum();
    for (k, profile) in table.profiles.iter().enumerate() {
        let of_profile = table.components.iter().filter(|component| component.profile == k);
        let variance: f64 = of_profile.filter_map(|component| component.eigenvalue).sum();
        lost += variance * apart(profile.azimuth, &profile.chebyshev, &profile.node_values);
    }
    lost
}
