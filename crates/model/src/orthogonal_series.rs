//! Slant profiles as series in polynomials that are orthogonal over the nodes of a table.
//!
//! A profile is u = sin^|m| α h(z). At a high |m|, h is orders of magnitude larger near the pole than
//! at the rim, where the sum of its Chebyshev series loses as many digits. Polynomials p_j for which
//! p_j sin^|m| are orthogonal under the density of the normals are nowhere larger than the profile.

use eigenshade_table::{Profile, Table};

/// h of one profile.
#[derive(Clone, Debug)]
pub(crate) struct OrthogonalSeries {
    /// The a and b of p_j+1 = (2t - a) p_j - b p_j-1, with t = 2z - 1.
    recurrence: Vec<[f64; 2]>,
    terms: Vec<f64>,
}

impl OrthogonalSeries {
    /// As many terms as the longest profile of its |m| has. Domain: a table with more nodes than
    /// terms.
    pub(crate) fn new(table: &Table, profile: &Profile) -> Self {
        let of_azimuth = table.profiles.iter().filter(|one| one.azimuth == profile.azimuth);
        let length = of_azimuth.map(|one| one.chebyshev.len()).max().unwrap_or(0);
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let arguments: Vec<f64> = table.gram.nodes.iter().map(|z| 2.0 * z - 1.0).collect();
        let weight = |(z, root): (&f64, &f64)| {
            root * ((1.0 - z) * (1.0 + z)).powf(0.5 * profile.azimuth as f64)
        };
        // √w sin^|m| p_j at the nodes, by Stieltjes' procedure.
        let mut element: Vec<f64> =
            table.gram.nodes.iter().zip(&table.gram.root_weights).map(weight).collect();
        let mut before = vec![0.0; element.len()];
        let mut square_before = f64::INFINITY;
        let (mut recurrence, mut elements) = (Vec::new(), Vec::new());
        for _ in 0..length {
            let square = product(&element, &element);
            let moments = element.iter().zip(&arguments).map(|(value, t)| 2.0 * t * value * value);
            let (a, b) = (moments.sum::<f64>() / square, square / square_before);
            let next = element.iter().zip(&before).zip(&arguments);
            let next = next.map(|((value, before), t)| (2.0 * t - a) * value - b * before);
            let next: Vec<f64> = next.collect();
            recurrence.push([a, b]);
            elements.push((element.clone(), square));
            (before, element) = (element, next);
            square_before = square;
        }
        let mut terms = vec![0.0; elements.len()];
        let mut rest = profile.node_values.clone();
        // The second pass removes the rounding errors of the first.
        for _ in 0..2 {
            for (term, (element, square)) in terms.iter_mut().zip(&elements) {
                let more = product(element, &rest) / square;
                *term += more;
                rest.iter_mut().zip(element).for_each(|(rest, value)| *rest -= more * value);
            }
        }
        Self { recurrence, terms }
    }

    /// h(z).
    pub(crate) fn height(&self, z: f64) -> f64 {
        let t = 2.0 * z - 1.0;
        let (mut sum, mut element, mut before) = (0.0, 1.0, 0.0);
        for (term, [a, b]) in self.terms.iter().zip(&self.recurrence) {
            sum += term * element;
            (element, before) = ((2.0 * t - a) * element - b * before, element);
        }
        sum
    }
}
