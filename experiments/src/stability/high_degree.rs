//! A basis at degree 32 and order 32, of GGX materials of roughness 0.1 to 1.

use super::images::coefficients;
use super::{Figure, exactly, least, most, tight};
use crate::tolerances;
use eigenshade::{Normal, Scalar};
use eigenshade_generator::basis;
use eigenshade_generator::scene_file::Loaded;
use eigenshade_index::mode;
use eigenshade_model::special::spherical_harmonic;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::Shader;
use eigenshade_table::scene::Store;
use eigenshade_table::{Component, Table};
use eigenshade_testing::{fixtures, glossy, largest, relative_error};
use nalgebra::DVector;

pub(super) fn measure() -> Vec<Figure> {
    let scene = |degree| fixtures::scene(fixtures::captured(degree), glossy::materials(degree));
    let mut loaded = scene(32);
    loaded.scene.basis.components = Some(100);
    let table = fixtures::table(&loaded);
    let off = basis::orthonormality(&table, 100);
    let mut figures = vec![
        exactly("modes", mode::total(32, 32), 1_741_497),
        exactly("components", table.components.len(), 100),
        tight("|UᵀMU - I| of the first 100", off, tolerances::ORTHONORMAL_HIGH),
        // Powers of some 30 terms have coefficients (1 + √2)^30 = 3e11 times those of the series,
        // rounded at 1e-16; a tenth of the product is required.
        least("a profile by powers, of its largest value", by_powers(&table), 1e-6),
    ];
    for degree in [16, 24, 32] {
        let mut loaded = scene(degree);
        loaded.scene.basis.store = Store::Projection;
        let table = fixtures::table(&loaded);
        // The error grows with the degree.
        let bounded = if degree == 32 { tight } else { most };
        for (format, found, bound) in [
            ("f64", error::<f64>(&loaded, &table), tolerances::HIGH_PIXELS),
            ("f32", error::<f32>(&loaded, &table), tolerances::HIGH_PIXELS_F32),
        ] {
            let what = format!("light to pixel in {format}, degree {degree}, of the peak");
            figures.push(bounded(what, found, bound));
        }
    }
    figures
}

/// The largest error of the runtime's images, from a transfer to its pixels, at the nodes in a few
/// tilts. There the eigenimages are known without any polynomial, and d is in f64.
fn error<S: Scalar + Into<f64>>(loaded: &Loaded, table: &Table) -> f64 {
    let (double, owned) = (OwnedBasis::<f64>::new(table), OwnedBasis::<S>::new(table));
    let mut exact = Shader::new(double.basis().expect("a basis"), usize::MAX);
    let basis = owned.basis().expect("a basis");
    let (degree, order) = (table.gram.degree, table.gram.order);
    largest(loaded.lights.entries.iter().zip(&loaded.materials.entries).map(|(light, on)| {
        let (light, on) = (light.luminance(), on.luminance());
        let exact = exact.project((degree, &light), (order, &on)).expect("coefficients");
        let [_, d] = coefficients(&basis, &light, &on);
        let scene = basis.collapse_into(&d, vec![S::ZERO; basis.scene_len()]).expect("sizes");
        let (mut found, mut expected) = (Vec::new(), Vec::new());
        for (k, (&z, root)) in table.gram.nodes.iter().zip(&table.gram.root_weights).enumerate() {
            for tilt in [0.1, 1.7, 4.0] {
                let image = |(component, d): (&Component, &f64)| {
                    let u = table.profiles[component.profile].node_values[k] / root;
                    d * u * spherical_harmonic::azimuth(component.order as isize, tilt)
                };
                expected.push(table.components.iter().zip(exact).map(image).sum::<f64>());
                let [x, y, z] = [sine(z) * tilt.cos(), sine(z) * tilt.sin(), z].map(S::from_f64);
                found.push(scene.shade(Normal::new(x, y, z).expect("visible")).into());
            }
        }
        relative_error(&found, &expected)
    }))
}

fn sine(z: f64) -> f64 {
    ((1.0 - z) * (1.0 + z)).sqrt()
}

/// The largest error of a profile at the nodes if its series is converted to powers of t = 2z - 1,
/// relative to the largest value of the profile.
fn by_powers(table: &Table) -> f64 {
    largest(table.profiles.iter().map(|profile| {
        let length = profile.chebyshev.len();
        // T_0 = 1, T_1 = t, T_k+1 = 2t T_k - T_k-1.
        let (mut before, mut current) = (DVector::zeros(length), DVector::zeros(length));
        current[0] = 1.0;
        let mut powers = DVector::zeros(length);
        for (k, coefficient) in profile.chebyshev.iter().enumerate() {
            powers += *coefficient * &current;
            let factor = if k == 0 { 1.0 } else { 2.0 };
            let shifted = current.clone().remove_row(length - 1).insert_row(0, 0.0);
            before = std::mem::replace(&mut current, factor * shifted - before);
        }
        let at = |&z: &f64| {
            let h = powers.iter().rev().fold(0.0, |sum, power| sum * (2.0 * z - 1.0) + power);
            sine(z).powi(profile.azimuth as i32) * h
        };
        let found: Vec<f64> = table.gram.nodes.iter().map(at).collect();
        let values = profile.node_values.iter().zip(&table.gram.root_weights);
        relative_error(&found, &values.map(|(value, root)| value / root).collect::<Vec<_>>())
    }))
}
