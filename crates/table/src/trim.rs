//! Shorter polynomials for images with a given tolerance.
//!
//! The tolerance of the profiles treats weak components like strong ones. Trimming uses the
//! expected error of an image instead. Components are uncorrelated, so their truncation errors add
//! up, each weighted with its eigenvalue. For each azimuth the functions p_j sin^|m| are
//! orthonormal under the density of the normals. By Parseval, truncating a series in them loses the
//! squares of the dropped coefficients, and no polynomial of the shorter length is closer.

use crate::chebyshev::{clenshaw, times_argument};
use crate::table::Table;

/// Shortens the polynomials so that a collapsed scene has the fewest terms while the root mean
/// square error over the database and the normals is at most `tolerance` times the images' root
/// mean square deviation from their means. Returns the error.
///
/// All polynomials of an azimuth share the length that the longest of them needs. Domain: a
/// sphere's table that [projects](Table::has_projection).
pub fn trim(table: &mut Table, tolerance: f64) -> f64 {
    let azimuths: Vec<Azimuth> =
        (0..=table.gram.degree).map(|azimuth| Azimuth::new(table, azimuth)).collect();
    let whole = table.summary.energy;
    let allowed = tolerance * tolerance * whole;
    let mut lengths: Vec<usize> =
        azimuths.iter().map(|one| usize::from(!one.series.is_empty())).collect();
    let left = |lengths: &[usize]| -> f64 {
        azimuths.iter().zip(lengths).map(|(one, &length)| one.left(length)).sum()
    };
    while left(&lengths) > allowed {
        // The term that reduces the error most per polynomial: a nonzero azimuth has one for +m and
        // one for -m.
        let gain = |azimuth: usize| {
            let (one, length) = (&azimuths[azimuth], lengths[azimuth]);
            (one.left(length) - one.left(length + 1)) / if azimuth == 0 { 1.0 } else { 2.0 }
        };
        let best = (0..lengths.len()).max_by(|&a, &b| gain(a).total_cmp(&gain(b)));
        let Some(best) = best.filter(|&best| gain(best) > 0.0) else { break };
        lengths[best] += 1;
    }
    for (one, &length) in azimuths.iter().zip(&lengths) {
        for (place, coefficients) in &one.series {
            let chebyshev = one.chebyshev(&coefficients[..length.min(coefficients.len())]);
            match place {
                Place::Profile(k) => table.profiles[*k].chebyshev = chebyshev,
                Place::Mean => {
                    table.mean.iter_mut().for_each(|mean| mean.chebyshev.clone_from(&chebyshev));
                }
            }
        }
    }
    (left(&lengths) / whole).sqrt()
}

/// The owner of a polynomial.
enum Place {
    Profile(usize),
    Mean,
}

/// The polynomials of one |m| as series in orthonormal polynomials.
struct Azimuth {
    /// Chebyshev series of p_0, p_1, ...
    orthonormal: Vec<Vec<f64>>,
    series: Vec<(Place, Vec<f64>)>,
    /// Expected energy of the coefficients of each p_j, over all profiles.
    energies: Vec<f64>,
}

impl Azimuth {
    fn new(table: &Table, azimuth: usize) -> Self {
        let of_azimuth = table.profiles.iter().enumerate().filter(|(_, p)| p.azimuth == azimuth);
        let mut places: Vec<(Place, &[f64], f64)> = of_azimuth
            .map(|(k, profile)| {
                let components = table.components.iter().filter(|one| one.profile == k);
                // The constant has no variance and only one term.
                let variance = components.filter_map(|one| one.eigenvalue).sum();
                (Place::Profile(k), profile.chebyshev.as_slice(), variance)
            })
            .collect();
        if azimuth == 0 {
            places.extend(table.mean.iter().map(|mean| (Place::Mean, &mean.chebyshev[..], 1.0)));
        }
        let length = places.iter().map(|(_, series, _)| series.len()).max().unwrap_or(0);
        let gram = &table.gram;
        let nodes: Vec<(f64, f64)> = gram
            .nodes
            .iter()
            .zip(&gram.root_weights)
            .map(|(&z, &root)| {
                let sine_square = (1.0 - z) * (1.0 + z);
                (2.0 * z - 1.0, root * root * sine_square.powi(azimuth as i32))
            })
            .collect();
        let (orthonormal, values) = orthonormal(&nodes, length);
        let mut energies = vec![0.0; length];
        let series = places
            .into_iter()
            .map(|(place, chebyshev, variance)| {
                let heights: Vec<f64> =
                    nodes.iter().map(|&(t, weight)| weight * clenshaw(chebyshev, t)).collect();
                let product =
                    |p: &Vec<f64>| p.iter().zip(&heights).map(|(p, h)| p * h).sum::<f64>();
                let coefficients: Vec<f64> = values.iter().map(product).collect();
                for (energy, coefficient) in energies.iter_mut().zip(&coefficients) {
                    *energy += variance * coefficient * coefficient;
                }
                (place, coefficients)
            })
            .collect();
        Self { orthonormal, series, energies }
    }

    /// Energy that the first `length` terms leave.
    fn left(&self, length: usize) -> f64 {
        self.energies.iter().skip(length).rev().sum()
    }

    /// The Chebyshev series of Σ c_j p_j.
    fn chebyshev(&self, coefficients: &[f64]) -> Vec<f64> {
        let mut sum = vec![0.0; coefficients.len()];
        for (coefficient, series) in coefficients.iter().zip(&self.orthonormal) {
            for (sum, term) in sum.iter_mut().zip(series) {
                *sum += coefficient * term;
            }
        }
        sum
    }
}

/// The first `count` polynomials in t that are orthonormal under the weights of these nodes, as
/// Chebyshev series and as values at the nodes. Each is t times the previous one, minus its
/// projections onto all earlier ones.
fn orthonormal(nodes: &[(f64, f64)], count: usize) -> (Vec<Vec<f64>>, Vec<Vec<f64>>) {
    let (mut all_series, mut all_values) = (Vec::<Vec<f64>>::new(), Vec::<Vec<f64>>::new());
    for _ in 0..count {
        let (mut series, mut values) = match (all_series.last(), all_values.last()) {
            (Some(series), Some(values)) => {
                let values = values.iter().zip(nodes).map(|(p, (t, _))| p * t).collect();
                (times_argument(series), values)
            }
            _ => (vec![1.0], vec![1.0; nodes.len()]),
        };
        let product = |a: &[f64], b: &[f64]| -> f64 {
            a.iter().zip(b).zip(nodes).map(|((a, b), (_, weight))| weight * a * b).sum()
        };
        // The second pass removes the rounding errors of the first.
        for _ in 0..2 {
            for (before, at_nodes) in all_series.iter().zip(&all_values) {
                let part = product(&values, at_nodes);
                series.iter_mut().zip(before).for_each(|(p, q)| *p -= part * q);
                values.iter_mut().zip(at_nodes).for_each(|(p, q)| *p -= part * q);
            }
        }
        let size = product(&values, &values).sqrt();
        series.iter_mut().for_each(|p| *p /= size);
        values.iter_mut().for_each(|p| *p /= size);
        all_series.push(series);
        all_values.push(values);
    }
    (all_series, all_values)
}

#[cfg(test)]
mod tests {
    use super::orthonormal;
    use crate::chebyshev::clenshaw;

    /// Checks only the definition, with weights on equidistant nodes.
    #[test]
    fn polynomials_are_orthonormal_and_match_their_series() {
        let nodes: Vec<(f64, f64)> =
            (0..40).map(|k| (f64::from(k) / 20.0 - 1.0, 0.01 * f64::from(1 + k % 3))).collect();
        let (series, values) = orthonormal(&nodes, 12);
        for (i, a) in values.iter().enumerate() {
            for (j, b) in values.iter().enumerate() {
                let product: f64 =
                    a.iter().zip(b).zip(&nodes).map(|((a, b), (_, weight))| weight * a * b).sum();
                assert!((product - f64::from(u8::from(i == j))).abs() < 1e-12, "{i} {j} {product}");
            }
            for (value, (t, _)) in a.iter().zip(&nodes) {
                assert!((value - clenshaw(&series[i], *t)).abs() < 1e-10 * (1.0 + value.abs()));
            }
        }
    }
}
