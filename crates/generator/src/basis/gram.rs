//! The Gram matrix M of (23) for the normals of a sphere, as the factor A of [`GramFactor`].

use eigenshade_model::irradiance::{slant_radials, slant_rotation};
use eigenshade_model::polar_integral::{PolarIntegrals, gain};
use eigenshade_model::special::quadrature::gauss_legendre;
use eigenshade_table::{GramFactor, material, pair};

/// Computes the factor of M for the visible normals of a sphere, whose density over the hemisphere
/// is cos(α)/π.
///
/// The nodes are Gauss-Legendre nodes in z = cos α on \[0, 1\]. There are enough of them that M is
/// exact to rounding for profiles of [`crate::basis::profile::terms`] terms. Since the azimuth
/// functions are orthonormal, the weight of a node is 2 z times the weight of the rule.
#[must_use]
pub fn of_sphere(degree: usize, order: usize) -> GramFactor {
    let count = crate::basis::profile::terms(degree, order, 0) + degree + 1;
    let (nodes, weights): (Vec<f64>, Vec<f64>) =
        gauss_legendre(count, 0.0, 1.0).into_iter().unzip();
    let slants: Vec<f64> = nodes.iter().map(|z| slant(*z)).collect();
    let radials: Vec<Vec<f64>> = slants.iter().map(|&alpha| slant_radials(order, alpha)).collect();
    GramFactor {
        degree,
        order,
        root_weights: nodes.iter().zip(&weights).map(|(z, w)| (2.0 * z * w).sqrt()).collect(),
        gains: material::indices(order).map(|(o, p, q)| gain(o, p, q)).collect(),
        polar_integrals: PolarIntegrals::new(degree, order).rows().to_vec(),
        radials: (0..pair::count(order))
            .flat_map(|pair| radials.iter().map(move |of_node| of_node[pair]))
            .collect(),
        rotations: rotations(degree, order, &slants),
        nodes,
    }
}

/// α from cos α, by a formula that keeps its accuracy near 0.
fn slant(z: f64) -> f64 {
    ((1.0 - z) * (1.0 + z)).sqrt().atan2(z)
}

/// D_l^mq / Φ_m for each |m|, each l >= |m|, each q <= min(l, order) and each slant.
fn rotations(degree: usize, order: usize, slants: &[f64]) -> Vec<f64> {
    let mut values = Vec::new();
    for azimuth in 0..=degree {
        // by_frequency[q][node][l - max(|m|, q)]
        let by_frequency: Vec<Vec<Vec<f64>>> = (0..=order.min(degree))
            .map(|q| {
                let m = azimuth.cast_signed();
                slants.iter().map(|&alpha| slant_rotation(degree, m, q, alpha)).collect()
            })
            .collect();
        for l in azimuth..=degree {
            for (q, by_node) in by_frequency.iter().enumerate().take(l.min(order) + 1) {
                values.extend(by_node.iter().map(|by_degree| by_degree[l - azimuth.max(q)]));
            }
        }
    }
    values
}
