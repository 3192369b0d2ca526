//! Scenes, lights, materials and normals shared by several tests.

use crate::largest;
use crate::oracle::Numbers;
use eigenshade_generator::basis;
use eigenshade_generator::scene_file::{self, Loaded};
use eigenshade_index::{light, material};
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::inputs::coefficient_csv::read_lights;
use eigenshade_model::truth::Truth;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_table::Table;
use eigenshade_table::scene::Criterion;
use std::f64::consts::{FRAC_PI_2, PI};
use std::path::Path;

/// The root of the repository.
pub const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// The shipped scene with every available component.
pub fn shipped() -> Loaded {
    let path = Path::new(ROOT).join("tables/sphere.toml");
    let mut loaded = scene_file::load(&path).expect("the shipped scene");
    loaded.scene.basis.components = Some(usize::MAX);
    loaded
}

/// A scene of these lights and materials at their degree and order, with every component and with
/// polynomials that are accurate to the last bits.
pub fn scene(lights: Lights, materials: Materials) -> Loaded {
    let mut loaded = shipped();
    loaded.scene.light.degree = lights.degree;
    loaded.scene.material.order = materials.order;
    loaded.scene.basis.profile_tolerance = 1e-13;
    Loaded { lights, materials, ..loaded }
}

/// The table of a scene.
pub fn table(loaded: &Loaded) -> Table {
    basis::build(&loaded.scene, &loaded.lights, &loaded.materials).expect("a table")
}

/// The captured lights up to this degree.
pub fn captured(degree: usize) -> Lights {
    let path = Path::new(ROOT).join("tables/inputs/lights.csv");
    read_lights(path, Some(degree)).expect("the shipped lights")
}

/// Gray coefficients with a name.
pub fn named(name: impl Into<String>, coefficients: Vec<f64>) -> Named {
    Named { name: name.into(), rgb: [coefficients.clone(), coefficients.clone(), coefficients] }
}

/// Lights with random coefficients that decrease with the degree, around a positive mean.
pub fn lights(degree: usize, count: usize, numbers: &mut Numbers) -> Lights {
    let mut one = |k: usize| {
        let coefficients = light::indices(degree)
            .map(|(l, _)| if l == 0 { 3.0 + numbers.next() } else { numbers.next() / l as f64 });
        named(format!("light-{k}"), coefficients.collect())
    };
    Lights { degree, entries: (0..count).map(&mut one).collect() }
}

/// Materials with random coefficients that decrease with the order, around a matte material.
pub fn materials(order: usize, count: usize, numbers: &mut Numbers) -> Materials {
    let mut one = |k: usize| {
        let coefficients = material::indices(order).map(|(o, p, q)| {
            if o == 0 { 1.5 + 0.5 * numbers.next() } else { numbers.next() / (o + p + q) as f64 }
        });
        named(format!("material-{k}"), coefficients.collect())
    };
    Materials { order, entries: (0..count).map(&mut one).collect() }
}

/// Slants that cover the edge cases.
pub const SLANTS: [f64; 7] = [0.0, 1e-9, 1e-5, 0.7, 1.3, FRAC_PI_2 - 1e-9, FRAC_PI_2];

/// Normals of each slant at `tilts` tilts.
pub fn normals(slants: &[f64], tilts: usize) -> Vec<[f64; 3]> {
    let tilt = |k: usize| 2.0 * PI * (k as f64 + 0.3) / tilts as f64;
    let at = |alpha: f64, beta: f64| {
        let z = if alpha == FRAC_PI_2 { 0.0 } else { alpha.cos() };
        [alpha.sin() * beta.cos(), alpha.sin() * beta.sin(), z]
    };
    slants.iter().flat_map(|&alpha| (0..tilts).map(move |k| at(alpha, tilt(k)))).collect()
}

/// The largest error of the whole basis in f64 against the direct sum, over the scene's lights and
/// materials. Each error is relative to the image's peak.
pub fn reconstruction_error(loaded: &Loaded, table: &Table) -> f64 {
    let owned = OwnedBasis::<f64>::new(table);
    let basis = owned.basis().expect("a basis");
    let (degree, order) = (loaded.lights.degree, loaded.materials.order);
    let truth = Truth::new(degree, order);
    let normals = normals(&SLANTS, 12);
    let modes: Vec<_> = normals.iter().map(|&normal| truth.at(normal)).collect();
    let mut workspace = vec![0.0; basis.workspace_len()];
    let mut d = vec![0.0; basis.components()];
    let mut worst: f64 = 0.0;
    for material in &loaded.materials.entries {
        let b = material.luminance();
        let scattered: Vec<_> = modes.iter().map(|modes| modes.scatter(&b)).collect();
        for light in &loaded.lights.entries {
            let l = light.luminance();
            let expected: Vec<f64> =
                modes.iter().zip(&scattered).map(|(at, of)| at.irradiance(&l, of)).collect();
            let given = eigenshade::Light::new(degree, &l).expect("coefficients");
            let on = eigenshade::Material::new(order, &b).expect("coefficients");
            basis.project_into(&given, &on, &mut workspace, &mut d).expect("sizes");
            let scene = basis.collapse_into(&d, vec![0.0; basis.scene_len()]).expect("sizes");
            let peak = largest(expected.iter().copied());
            let errors = normals.iter().zip(&expected).map(|(&[x, y, z], expected)| {
                let normal = eigenshade::Normal::new(x, y, z).expect("visible");
                let error = (scene.shade(normal) - expected).abs();
                // A black image must stay black.
                if peak > 0.0 { error / peak } else { error }
            });
            worst = largest([worst, largest(errors)]);
        }
    }
    worst
}

/// A scene with the standard criterion.
pub fn standard(mut loaded: Loaded) -> Loaded {
    loaded.scene.basis.criterion = Criterion::Standard;
    loaded
}
