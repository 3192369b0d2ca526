//! A basis at degree 32 and order 32.

use super::{Case, Figure};
use crate::tolerances;
use eigenshade::Scalar;
use eigenshade_generator::basis;
use eigenshade_generator::scene_file::Loaded;
use eigenshade_index::mode;
use eigenshade_model::special::spherical_harmonic;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_table::Table;
use eigenshade_table::scene::Store;
use eigenshade_testing::{fixtures, glossy, largest};

/// Error of profiles of some 30 terms in powers, relative to their largest value: the coefficients
/// of the powers are up to (1 + √2)^30 = 3e11 times those of the series and are rounded at 1e-16;
/// this is a tenth of the product.
const NAIVE_POWERS: f64 = 1e-6;

pub const CASE: Case = Case {
    name: "degree 32, order 32: 1.7 million modes, GGX of roughness 0.1 to 1",
    naively: "M has 3e12 numbers, A over modes 90 million; profiles as powers cancel, (1 + √2)^n to one, \
              and u / sin^|m| in any form is far larger near the pole than at the rim",
    here: "blocks of |m|; A as products of one-dimensional tables; a space of 33 to 65 polynomials for each; \
           profiles of high |m| are series in polynomials orthogonal under sin^2|m|",
    measure,
};

fn measure() -> Vec<Figure> {
    let mut loaded = fixtures::scene(fixtures::captured(32), glossy::materials(32));
    loaded.scene.basis.components = Some(100);
    let table = fixtures::table(&loaded);
    let mut figures = vec![
        Figure::exactly("modes", mode::total(32, 32), 1_741_497),
        Figure::exactly("components", table.components.len(), 100),
        Figure::most(
            "|UᵀMU - I| of the first 100",
            basis::orthonormality(&table, 100),
            tolerances::ORTHONORMAL_HIGH,
        ),
        Figure::least("a profile by powers, of its largest value", by_powers(&table), NAIVE_POWERS),
    ];
    for degree in [16, 24, 32] {
        let mut loaded = fixtures::scene(fixtures::captured(degree), glossy::materials(degree));
        loaded.scene.basis.store = Store::Projection;
        let table = fixtures::table(&loaded);
        let name =
            |format: &str| format!("light to pixel in {format}, degree {degree}, of the peak");
        let [double, single] = [shaded::<f64>(&loaded, &table), shaded::<f32>(&loaded, &table)];
        figures.push(Figure::most(name("f64"), double, tolerances::HIGH_PIXELS));
        figures.push(Figure::most(name("f32"), single, tolerances::HIGH_PIXELS_F32));
    }
    figures
}

/// The largest error of the runtime's images, from a transfer to its pixels, at the nodes in a few
/// tilts. There the eigenimages are known without any polynomial, and d is in f64.
fn shaded<S: Scalar + Into<f64>>(loaded: &Loaded, table: &Table) -> f64 {
    let (double, owned) = (OwnedBasis::<f64>::new(table), OwnedBasis::<S>::new(table));
    let (double, basis) = (double.basis().expect("a basis"), owned.basis().expect("a basis"));
    let (degree, order) = (table.gram.degree, table.gram.order);
    let mut workspace = vec![0.0; double.workspace_len()];
    let mut exact = vec![0.0; double.components()];
    let mut room = vec![S::ZERO; basis.workspace_len()];
    let mut transfer = vec![S::ZERO; basis.transfer_len()];
    let mut d = vec![S::ZERO; basis.components()];
    let mut worst: f64 = 0.0;
    for (light, on) in loaded.lights.entries.iter().zip(&loaded.materials.entries) {
        let (light, on) = (light.luminance(), on.luminance());
        let rounded = |numbers: &[f64]| numbers.iter().map(|&x| S::from_f64(x)).collect::<Vec<S>>();
        let (light_in, on_in) = (rounded(&light), rounded(&on));
        let light = eigenshade::Light::new(degree, &light).expect("coefficients");
        let on = eigenshade::Material::new(order, &on).expect("coefficients");
        double.project_into(&light, &on, &mut workspace, &mut exact).expect("sizes");
        let light = eigenshade::Light::new(degree, &light_in).expect("coefficients");
        let on = eigenshade::Material::new(order, &on_in).expect("coefficients");
        basis.transfer_into(&on, &mut room, &mut transfer).expect("sizes");
        basis.relight_into(&transfer, &light, &mut d).expect("sizes");
        let scene = basis.collapse_into(&d, vec![S::ZERO; basis.scene_len()]).expect("sizes");
        let (mut error, mut peak) = (0.0, 0.0);
        for (k, (z, root)) in table.gram.nodes.iter().zip(&table.gram.root_weights).enumerate() {
            for tilt in [0.1, 1.7, 4.0] {
                let image = |(component, d): (&eigenshade_table::Component, &f64)| {
                    let u = table.profiles[component.profile].node_values[k] / root;
                    let m = component.order as isize;
                    d * u * spherical_harmonic::azimuth(m, tilt)
                };
                let expected: f64 = table.components.iter().zip(&exact).map(image).sum();
                let sine = ((1.0 - z) * (1.0 + z)).sqrt();
                let [x, y, z] = [sine * tilt.cos(), sine * tilt.sin(), *z].map(S::from_f64);
                let normal = eigenshade::Normal::new(x, y, z).expect("visible");
                error = largest([error, scene.shade(normal).into() - expected]);
                peak = largest([peak, expected]);
            }
        }
        worst = largest([worst, error / peak]);
    }
    worst
}

/// The largest error of a profile at the nodes if its series is converted to powers of t = 2z - 1,
/// relative to the largest value of the profile.
fn by_powers(table: &Table) -> f64 {
    let error = |profile: &eigenshade_table::Profile| {
        let series = &profile.chebyshev;
        // T_0 = 1, T_1 = t, T_k+1 = 2t T_k - T_k-1.
        let mut powers = vec![0.0; series.len()];
        let (mut before, mut current) = (vec![0.0; series.len()], vec![0.0; series.len()]);
        current[0] = 1.0;
        for (k, coefficient) in series.iter().enumerate() {
            powers.iter_mut().zip(&current).for_each(|(power, term)| *power += coefficient * term);
            let factor = if k == 0 { 1.0 } else { 2.0 };
            let shifted = std::iter::once(0.0).chain(current.iter().copied());
            let next = shifted.zip(&before).map(|(shifted, before)| factor * shifted - before);
            let next: Vec<f64> = next.collect();
            before = std::mem::replace(&mut current, next);
        }
        let nodes = table.gram.nodes.iter().zip(&table.gram.root_weights);
        let (mut error, mut most) = (0.0, 0.0);
        for ((z, root), value) in nodes.zip(&profile.node_values) {
            let expected = value / root;
            let t = 2.0 * z - 1.0;
            let h = powers.iter().rev().fold(0.0, |sum, power| sum * t + power);
            let sine = ((1.0 - z) * (1.0 + z)).sqrt();
            error = largest([error, sine.powi(profile.azimuth as i32) * h - expected]);
            most = largest([most, expected]);
        }
        error / most
    };
    largest(table.profiles.iter().map(error))
}
