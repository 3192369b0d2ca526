//! Order and sign of the components where eigenvalues are equal, nearly equal or zero.

use super::{Case, Figure};
use crate::tolerances;
use eigenshade_generator::basis::gram;
use eigenshade_generator::basis::moments::Deviation;
use eigenshade_generator::basis::pca::{Block, principal};
use eigenshade_generator::basis::profile::evaluate;
use eigenshade_model::database::Named;
use eigenshade_table::{Table, encode};
use eigenshade_testing::oracle::Numbers;
use eigenshade_testing::{fixtures, largest};
use faer::Mat;
use faer::linalg::solvers::Solve;

/// Error of WᵀW by eigenvectors of squares: an image of 1e-9 has a square of 1e-18, far below the
/// rounding of the largest, 1e-16. Divided by its root, it is not orthogonal to the others.
const NAIVE_SQUARES: f64 = 1e-8;

/// The number of components whose order and sign are compared: some 240 have eigenvalues above
/// 1e-24 of the largest.
const LEAST_COMPARED: f64 = 200.0;

/// Least product of a component with the same component from another run, both of unit length; with
/// another component the product is near 0, with its negative near -1.
const SAME_COMPONENT: f64 = 0.5;

pub const SAME_ORDER: Case = Case {
    name: "order and sign of components, +m and -m equal, down to eigenvalues of 1e-24 of the largest",
    naively: "eigensolvers promise neither order nor sign; equal eigenvalues of ±m come mixed",
    here: "one list by |m| for both signs, sorted by eigenvalue, |m|, +m first; u / sin^|m| positive at the pole",
    measure: same_order,
};

pub const NEARLY_EQUAL: Case = Case {
    name: "eigenvalues that are nearly equal (1e-15 to 1e-3 apart) and zero",
    naively: "eigenvectors of squares mix over a gap of 1e-8 and lose orthogonality when divided by small roots",
    here: "left singular vectors: orthonormal whatever the gap; zero ones are no components",
    measure: nearly_equal,
};

/// Eigenvalues below this, relative to the largest, are ignored.
const FLOOR: f64 = 1e-24;

fn same_order() -> Vec<Figure> {
    let mut loaded = fixtures::shipped();
    loaded.scene.basis.rank_cutoff = 1e-13;
    let table = fixtures::table(&loaded);
    let again = encode(&fixtures::table(&loaded)) == encode(&table);
    // Perturbs every input number by up to an ulp, which is more than the effect of any other order
    // of summation or instruction set.
    let mut numbers = Numbers(5);
    let mut shaken = loaded.clone();
    let entries = shaken.lights.entries.iter_mut().chain(&mut shaken.materials.entries);
    for value in entries.flat_map(|entry: &mut Named| &mut entry.rgb).flatten() {
        *value *= 1.0 + f64::EPSILON * numbers.next().round();
    }
    let other = fixtures::table(&shaken);
    let most = largest(table.components.iter().filter_map(|one| one.eigenvalue));
    let above = |table: &Table| {
        let counts = |one: &&eigenshade_table::Component| {
            one.eigenvalue.is_none_or(|value| value > FLOOR * most)
        };
        table.components.iter().take_while(counts).count()
    };
    let count = above(&table).min(above(&other));
    let (mut moved, mut apart) = (0, 0.0);
    for (a, b) in table.components.iter().zip(&other.components).take(count) {
        let (u, v) = (&table.profiles[a.profile], &other.profiles[b.profile]);
        let product: f64 = u.node_values.iter().zip(&v.node_values).map(|(u, v)| u * v).sum();
        moved += usize::from(a.order != b.order || product < SAME_COMPONENT);
        let (Some(a), Some(b)) = (a.eigenvalue, b.eigenvalue) else { continue };
        apart = largest([apart, (a - b) / most]);
    }
    let signs = table.profiles.iter().filter(|one| evaluate(&one.chebyshev, 1.0) <= 0.0).count();
    vec![
        Figure::exactly("runs that differ in a byte", usize::from(!again), 0),
        Figure::least("components compared", count as f64, LEAST_COMPARED),
        Figure::exactly("components of another order or sign after an ulp", moved, 0),
        Figure::exactly("profiles not positive at the pole", signs, 0),
        Figure::most("eigenvalues after an ulp, of the largest", apart, tolerances::EIGENVALUE_ULP),
    ]
}

/// Uses images that are orthonormal up to known lengths as materials, which prescribes the
/// eigenvalues.
fn nearly_equal() -> Vec<Figure> {
    let (degree, azimuth) = (6, 0);
    let gram = gram::of_sphere(degree, 5);
    let block = Block::new(&gram, azimuth, |_, _, _, _| true).expect("finite");
    let count = eigenshade_index::material::count(5);
    let (mut orthogonality, mut values): (f64, f64) = (0.0, 0.0);
    let (mut squared, mut found) = (0.0f64, 0);
    for gap in [0.0, 1e-15, 1e-12, 1e-8, 1e-3] {
        let sizes = [1.0, 1.0 - gap, 1e-4, 1e-4 * (1.0 - gap), 1e-9];
        // Images of plain materials under one degree, orthonormalized.
        let plain: Vec<Deviation> = (0..sizes.len())
            .map(|k| {
                let mut material = vec![0.0; count];
                let (o, q) = [(0, 0), (2, 0), (4, 0), (1, 1), (3, 1)][k];
                material[eigenshade_index::material::position(o, q, q)] = 1.0;
                Deviation { degree: 2, material }
            })
            .collect();
        let images = block.images(&gram, &plain);
        let qr = images.qr();
        let inverse = qr.thin_R().to_owned().partial_piv_lu();
        let wanted =
            Mat::from_fn(sizes.len(), sizes.len(), |i, j| if i == j { sizes[j] } else { 0.0 });
        let mix = inverse.solve(&wanted);
        let deviations: Vec<Deviation> = (0..sizes.len())
            .map(|j| {
                let mut material = vec![0.0; count];
                for (k, one) in plain.iter().enumerate() {
                    material.iter_mut().zip(&one.material).for_each(|(m, b)| *m += mix[(k, j)] * b);
                }
                Deviation { degree: 2, material }
            })
            // A copy of another image, which gives an eigenvalue of zero.
            .chain([Deviation { degree: 2, material: vec![0.0; count] }])
            .collect();
        let images = block.images(&gram, &deviations);
        let ours = principal(&images, None, azimuth).expect("finite");
        let product = ours.coordinates.transpose() * &ours.coordinates;
        let off = |product: &Mat<f64>, count: usize| {
            largest((0..count).flat_map(|i| {
                (0..count).map(move |j| product[(i, j)] - f64::from(u8::from(i == j)))
            }))
        };
        orthogonality = orthogonality.max(off(&product, sizes.len()));
        let expected = sizes.iter().zip(&ours.singular_values);
        values = values.max(largest(expected.map(|(size, value)| size - value)));
        found = found.max(ours.singular_values.iter().filter(|value| **value > 1e-14).count());
        // The naive method: right vectors from the squares, and images divided by the roots.
        let square = images.transpose() * &images;
        let eigen = square.self_adjoint_eigen(faer::Side::Lower).expect("finite");
        let largest_five = Mat::from_fn(images.nrows(), sizes.len(), |i, j| {
            let column = images.ncols() - 1 - j;
            let along: f64 =
                (0..images.ncols()).map(|k| images[(i, k)] * eigen.U()[(k, column)]).sum();
            along / eigen.S().column_vector()[column].abs().sqrt()
        });
        squared = squared.max(off(&(largest_five.transpose() * &largest_five), sizes.len()));
    }
    vec![
        Figure::least("|WᵀW - I| from squares", squared, NAIVE_SQUARES),
        Figure::most("|WᵀW - I|", orthogonality, tolerances::ORTHONORMAL_NODES),
        Figure::most("singular values, of the largest", values, tolerances::SINGULAR_VALUE),
        Figure::exactly("singular values that are not zero", found, 5),
    ]
}
