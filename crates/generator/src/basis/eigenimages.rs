//! Selects the eigenimages of a table, computes their entries, and checks that they are
//! orthonormal.

use crate::basis::canonical;
use crate::basis::canonical::Ranked;
use crate::basis::pca::{Block, Principal};
use crate::basis::profile;
use crate::basis::profile::ProfileSpace;
use eigenshade_model::parallel;
use eigenshade_table::{Component, GramFactor, Profile, Table, pair};
use faer::Mat;

/// Number of components whose orthonormality is reported.
pub(crate) const REPORTED: usize = 100;

/// The block and the principal components of one azimuth.
pub(crate) struct Azimuth {
    /// The matrix A, factored.
    pub(crate) block: Block,
    /// Its principal components.
    pub(crate) principal: Principal,
}

/// The components that a table keeps, and the profiles that they use.
pub(crate) struct Selected {
    components: Vec<Component>,
    profiles: Vec<Ranked>,
}

impl Selected {
    /// Selects the first `count` components of `ranked`.
    pub(crate) fn new(azimuths: &[Azimuth], ranked: &[Ranked], count: usize) -> Self {
        let mut profiles = Vec::new();
        let mut taken: Vec<(Ranked, i32)> = Vec::new();
        for profile in ranked {
            if taken.len() >= count {
                break;
            }
            profiles.push(*profile);
            let orders = canonical::orders(profile.azimuth).iter();
            taken.extend(
                orders
                    .take(count - taken.len())
                    .map(|sign| (*profile, sign * profile.azimuth as i32)),
            );
        }
        // The sort is stable, so profiles of one azimuth stay in canonical order.
        profiles.sort_by_key(|profile| profile.azimuth);
        debug_assert!(profiles.iter().all(|profile| profile.azimuth < azimuths.len()));
        let place = |wanted: &Ranked| {
            profiles.iter().position(|profile| profile == wanted).expect("it was pushed above")
        };
        let components = taken
            .iter()
            .map(|(profile, order)| Component {
                order: *order,
                profile: place(profile),
                eigenvalue: profile.eigenvalue,
            })
            .collect();
        Self { components, profiles }
    }

    /// Writes components and profiles into the table. Each polynomial is within `tolerance` times
    /// its profile's largest value.
    pub(crate) fn write(
        self,
        table: &mut Table,
        azimuths: &[Azimuth],
        threshold: f64,
        tolerance: f64,
    ) {
        table.components = self.components;
        table.profiles = parallel::map(self.profiles.len(), &(), |k| {
            let ranked = &self.profiles[k];
            let azimuth = &azimuths[ranked.azimuth];
            let coordinates = coordinates(&table.gram, azimuth, ranked);
            profile(&table.gram, &azimuth.block, &coordinates, tolerance, threshold)
        });
    }
}

/// The coordinates of one ranked profile, as a column with canonical sign.
fn coordinates(gram: &GramFactor, azimuth: &Azimuth, ranked: &Ranked) -> Mat<f64> {
    let vector: Vec<f64> = match ranked.eigenvalue {
        None => constant_coordinates(gram, &azimuth.block.space),
        Some(_) => azimuth.principal.coordinates.col(ranked.number).iter().copied().collect(),
    };
    let column = Mat::from_fn(vector.len(), 1, |i, _| vector[i]);
    let series = azimuth.block.space.chebyshev(&column);
    let sign = canonical::sign(&series.col(0).iter().copied().collect::<Vec<_>>());
    Mat::from_fn(vector.len(), 1, |i, _| sign * vector[i])
}

/// A profile from its coordinates, given as a column.
fn profile(
    gram: &GramFactor,
    block: &Block,
    coordinates: &Mat<f64>,
    tolerance: f64,
    threshold: f64,
) -> Profile {
    let modes = block.mode_coefficients(coordinates, threshold);
    let first = |matrix: Mat<f64>| matrix.col(0).iter().copied().collect::<Vec<f64>>();
    let mut chebyshev = first(block.space.chebyshev(coordinates));
    chebyshev.truncate(profile::trimmed_length(&chebyshev, block.azimuth, tolerance));
    let node_values = first(block.space.node_values(coordinates));
    Profile {
        azimuth: block.azimuth,
        factors: factors(gram, block.azimuth, &node_values),
        modes: modes.col(0).iter().copied().collect(),
        chebyshev,
        node_values,
    }
}

/// The factored form of UᵀM for one profile, see [`Profile::factors`].
fn factors(gram: &GramFactor, azimuth: usize, node_values: &[f64]) -> Vec<f64> {
    let weighted: Vec<f64> =
        node_values.iter().zip(&gram.root_weights).map(|(value, root)| value * root).collect();
    let mut factors = Vec::new();
    for l in azimuth..=gram.degree {
        for (p, q) in pair::indices(gram.order) {
            let kept = q <= l;
            factors.push(if kept { factor(gram, azimuth, &weighted, l, [p, q]) } else { 0.0 });
        }
    }
    factors
}

/// (-1)^q √(p+1) Σ_k √w_k W_k R_p^q D_l^mq.
fn factor(
    gram: &GramFactor,
    azimuth: usize,
    weighted: &[f64],
    l: usize,
    [p, q]: [usize; 2],
) -> f64 {
    let nodes = weighted.len();
    let pair = pair::position(p, q);
    let radials = &gram.radials[pair * nodes..(pair + 1) * nodes];
    let rotation = gram.rotation(azimuth, l, q);
    let sum: f64 = weighted.iter().zip(radials).zip(rotation).map(|((w, r), d)| w * r * d).sum();
    let sign = if q % 2 == 0 { 1.0 } else { -1.0 };
    sign * ((p + 1) as f64).sqrt() * sum
}

/// Coordinates of the image that is 1 everywhere, as a unit vector.
pub(crate) fn constant_coordinates(gram: &GramFactor, space: &ProfileSpace) -> Vec<f64> {
    let ones = Mat::from_fn(gram.nodes.len(), 1, |k, _| gram.root_weights[k]);
    space.coordinates(&ones).col(0).iter().copied().collect()
}

/// Largest |UᵀMU - I| over the first `count` components, computed from AU without forming M, or, if
/// the table has no U over modes, from its profiles.
#[must_use]
pub fn orthonormality(table: &Table, count: usize) -> f64 {
    let mut worst: f64 = 0.0;
    for azimuth in 0..=table.gram.degree {
        let wanted: Vec<usize> = (0..table.profiles.len())
            .filter(|&k| {
                let first = table.components.iter().position(|component| component.profile == k);
                table.profiles[k].azimuth == azimuth && first.is_some_and(|first| first < count)
            })
            .collect();
        let has_modes = wanted.iter().any(|&k| !table.profiles[k].modes.is_empty());
        let columns = if has_modes { table.gram.columns(azimuth) } else { Vec::new() };
        let image = |&k: &usize| {
            let Profile { modes, node_values: values, .. } = &table.profiles[k];
            if has_modes { node_values(&columns, modes) } else { values.clone() }
        };
        let images: Vec<Vec<f64>> = wanted.iter().map(image).collect();
        for (i, a) in images.iter().enumerate() {
            for (j, b) in images.iter().enumerate().take(i + 1) {
                let product: f64 = a.iter().zip(b).map(|(a, b)| a * b).sum();
                worst = worst.max((product - f64::from(u8::from(i == j))).abs());
            }
        }
    }
    worst
}

/// A times mode coefficients, which gives weighted node values.
fn node_values(columns: &[Vec<f64>], modes: &[f64]) -> Vec<f64> {
    let mut image = vec![0.0; columns.first().map_or(0, Vec::len)];
    for (column, coefficient) in columns.iter().zip(modes) {
        for (pixel, value) in image.iter_mut().zip(column) {
            *pixel += coefficient * value;
        }
    }
    image
}
