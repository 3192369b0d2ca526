//! A basis at degree 32 and order 32, of GGX materials of roughness 0.1 to 1.

use super::{Figure, exactly, least, most};
use crate::tolerances;
use eigenshade::{Light, Material, Normal, Scalar};
use eigenshade_generator::basis;
use eigenshade_generator::scene_file::Loaded;
use eigenshade_index::mode;
use eigenshade_model::special::spherical_harmonic;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::Shader;
use eigenshade_table::scene::Store;
use eigenshade_table::{Component, Profile, Table};
use eigenshade_testing::{fixtures, glossy, largest};

pub(super) fn measure() -> Vec<Figure> {
    let scene = |degree| fixtures::scene(fixtures::captured(degree), glossy::materials(degree));
    let mut loaded = scene(32);
    loaded.scene.basis.components = Some(100);
    let table = fixtures::table(&loaded);
    let off = basis::orthonormality(&table, 100);
    let mut figures = vec![
        exactly("modes", mode::total(32, 32), 1_741_497),
        exactly("components", table.components.len(), 100),
        most("|UᵀMU - I| of the first 100", off, tolerances::ORTHONORMAL_HIGH),
        // Powers of some 30 terms have coefficients (1 + √2)^30 = 3e11 times those of the series,
        // rounded at 1e-16; a tenth of the product is required.
        least("a profile by powers, of its largest value", by_powers(&table), 1e-6),
    ];
    for degree in [16, 24, 32] {
        let mut loaded = scene(degree);
        loaded.scene.basis.store = Store::Projection;
        let table = fixtures::table(&loaded);
        for (format, found, bound) in [
            ("f64", shaded::<f64>(&loaded, &table), tolerances::HIGH_PIXELS),
            ("f32", shaded::<f32>(&loaded, &table), tolerances::HIGH_PIXELS_F32),
        ] {
            let what = format!("light to pixel in {format}, degree {degree}, of the peak");
            figures.push(most(what, found, bound));
        }
    }
    figures
}

/// The largest error of the runtime's images, from a transfer to its pixels, at the nodes in a few
/// tilts. There the eigenimages are known without any polynomial, and d is in f64.
fn shaded<S: Scalar + Into<f64>>(loaded: &Loaded, table: &Table) -> f64 {
    let (double, owned) = (OwnedBasis::<f64>::new(table), OwnedBasis::<S>::new(table));
    let mut exact = Shader::new(double.basis().expect("a basis"), usize::MAX);
    let basis = owned.basis().expect("a basis");
    let (degree, order) = (table.gram.degree, table.gram.order);
    let mut room = vec![S::ZERO; basis.workspace_len()];
    let mut transfer = vec![S::ZERO; basis.transfer_len()];
    let mut d = vec![S::ZERO; basis.components()];
    let mut worst: f64 = 0.0;
    for (light, on) in loaded.lights.entries.iter().zip(&loaded.materials.entries) {
        let (light, on) = (light.luminance(), on.luminance());
        let exact = exact.project((degree, &light), (order, &on)).expect("coefficients");
        let [light, on] =
            [light, on].map(|numbers| numbers.iter().map(|&x| S::from_f64(x)).collect::<Vec<S>>());
        let light = Light::new(&light).expect("coefficients");
        let on = Material::new(&on).expect("coefficients");
        basis.transfer_into(&on, &mut room, &mut transfer).expect("sizes");
        basis.relight_into(&transfer, &light, &mut d).expect("sizes");
        let scene = basis.collapse_into(&d, vec![S::ZERO; basis.scene_len()]).expect("sizes");
        let (mut error, mut peak) = (0.0, 0.0);
        for (k, (z, root)) in table.gram.nodes.iter().zip(&table.gram.root_weights).enumerate() {
            for tilt in [0.1, 1.7, 4.0] {
                let image = |(component, d): (&Component, &f64)| {
                    let u = table.profiles[component.profile].node_values[k] / root;
                    d * u * spherical_harmonic::azimuth(component.order as isize, tilt)
                };
                let expected: f64 = table.components.iter().zip(exact).map(image).sum();
                let sine = ((1.0 - z) * (1.0 + z)).sqrt();
                let [x, y, z] = [sine * tilt.cos(), sine * tilt.sin(), *z].map(S::from_f64);
                let normal = Normal::new(x, y, z).expect("visible");
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
    let error = |profile: &Profile| {
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
