//! Bases of any object against the sphere's own way. Against principal components of pictures, pixel by
//! pixel, `experiments stability` compares them, and the properties of the runtime's tests.

use crate::tolerances;
use eigenshade_generator::basis;
use eigenshade_generator::basis::general;
use eigenshade_generator::basis::profile::evaluate;
use eigenshade_generator::object::density;
use eigenshade_generator::object::geometry::{Geometry, WeightedNormals};
use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::inputs::coefficient_csv::{read_lights, read_materials};
use eigenshade_model::special::spherical_harmonic::azimuth;
use eigenshade_table::Table;
use eigenshade_table::scene::{Criterion, LightRotation, Scene};
use faer::Mat;
use std::path::Path;

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tables");

fn databases(degree: usize, order: usize) -> (Lights, Materials) {
    let file = |name: &str| Path::new(FOLDER).join("inputs").join(name);
    let lights = read_lights(file("lights.csv"), Some(degree)).expect("lights");
    let materials = read_materials(file("materials.csv"), Some(order)).expect("materials");
    (lights, materials)
}

fn scene(degree: usize, order: usize, criterion: Criterion, rotation: LightRotation) -> Scene {
    let text = std::fs::read_to_string(Path::new(FOLDER).join("sphere.toml")).expect("a scene");
    let mut scene: Scene = toml::from_str(&text).expect("a scene");
    (scene.light.degree, scene.material.order) = (degree, order);
    (scene.basis.criterion, scene.light.rotation) = (criterion, rotation);
    // Whole polynomials: what is compared is the basis, not how it is rounded.
    scene.basis.profile_tolerance = 1e-15;
    scene
}

/// The eigenimages at these normals: a row a normal.
fn eigenimages(table: &Table, normals: &[[f64; 3]]) -> Mat<f64> {
    let span = |[x, y, z]: [f64; 3]| -> Vec<f64> {
        let of = |component: &eigenshade_table::Component| {
            let profile = &table.profiles[component.profile];
            let sine = x.hypot(y).powi(profile.azimuth as i32);
            evaluate(&profile.chebyshev, z) * sine * azimuth(component.order as isize, y.atan2(x))
        };
        table.components.iter().map(of).collect()
    };
    let values: Vec<Vec<f64>> = normals.iter().map(|normal| span(*normal)).collect();
    let count = table.components.len();
    match &table.general {
        None => Mat::from_fn(normals.len(), count, |k, i| values[k][i]),
        Some(general) => Mat::from_fn(normals.len(), table.count(), |k, i| {
            let row = &general.synthesis[i * count..(i + 1) * count];
            row.iter().zip(&values[k]).map(|(a, b)| a * b).sum()
        }),
    }
}

/// Normals of a sphere by quadrature.
fn sphere(degree: usize) -> WeightedNormals {
    let pairs = density::read("cos(a)", Path::new(""), degree).expect("a formula");
    WeightedNormals::new(pairs).expect("normals")
}

#[test]
fn the_sphere_by_quadrature_is_the_sphere() {
    let (lights, materials) = databases(9, 7);
    for criterion in [Criterion::ImageCentered, Criterion::Standard] {
        let scene = scene(9, 7, criterion, LightRotation::Any);
        let own = basis::build(&scene, &lights, &materials).expect("a basis");
        let listed = Geometry::Listed(sphere(9));
        let general = general::build(&scene, &listed, &lights, &materials).expect("a basis");
        assert_eq!(own.count(), general.count());
        let largest = own.spectrum.iter().filter_map(|(_, value)| *value).fold(0.0, f64::max);
        for ((_, own), (_, general)) in own.spectrum.iter().zip(&general.spectrum) {
            let apart = (own.unwrap_or(0.0) - general.unwrap_or(0.0)).abs();
            assert!(apart <= tolerances::GENERAL_SPHERE * largest, "{own:?} {general:?}");
        }
        let normals: Vec<[f64; 3]> = sphere(3).normals().to_vec();
        let (a, b) = (eigenimages(&own, &normals), eigenimages(&general, &normals));
        let mut worst: f64 = 0.0;
        for i in 0..own.count() {
            for k in 0..normals.len() {
                worst = worst.max((a[(k, i)] - b[(k, i)]).abs());
            }
        }
        println!("{criterion:?}: eigenimages {worst:.1e}");
        assert!(worst <= tolerances::GENERAL_SPHERE, "{worst:e}");
    }
}
