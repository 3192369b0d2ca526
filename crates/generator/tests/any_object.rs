//! Bases of any object: against the sphere's own way, and against principal
//! components of the pictures themselves, pixel by pixel.

use crate::tolerances;
use eigenshade_generator::basis;
use eigenshade_generator::basis::general;
use eigenshade_generator::basis::profile::evaluate;
use eigenshade_generator::object::density;
use eigenshade_generator::object::geometry::{Geometry, WeightedNormals};
use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::inputs::coefficient_csv::{read_lights, read_materials};
use eigenshade_model::reference::DirectSum;
use eigenshade_model::special::spherical_harmonic::azimuth;
use eigenshade_table::Table;
use eigenshade_table::scene::{Criterion, LightRotation, Scene};
use faer::Mat;
use std::path::Path;

/// Singular values of an object's pictures, of the largest: two ways of summing the same
/// modes.
const GENERAL_EIGENVALUES: f64 = 2e-13;

/// Eigenimages over an object's normals, times the weaker one's share in a picture: modes whose
/// images are below 1e-13 of the largest are left out of them.
const GENERAL_ORTHONORMAL: f64 = 1e-13;

/// Components that show in pictures, as singular values of the largest: well above the roundings of
/// [`GENERAL_EIGENVALUES`].
const GENERAL_SEEN: f64 = 1e-9;

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

/// The images of every pair of the database at these normals, by the direct sum: a
/// column a pair, a row a normal, each times the root of its weight and over the root
/// of the number of pairs.
fn pictures(lights: &Lights, materials: &Materials, listed: &WeightedNormals) -> Mat<f64> {
    let reference = DirectSum::new(lights.degree, materials.order);
    let lights: Vec<Vec<f64>> = lights
        .entries
        .iter()
        .map(|entry| {
            let light = entry.luminance();
            light.iter().map(|value| value / light[0]).collect()
        })
        .collect();
    let materials: Vec<Vec<f64>> =
        materials.entries.iter().map(eigenshade_model::database::Named::luminance).collect();
    let count = lights.len() * materials.len();
    let mut pictures = Mat::zeros(listed.normals().len(), count);
    for (k, (normal, weight)) in listed.normals().iter().zip(listed.weights()).enumerate() {
        let modes = reference.at(*normal);
        let scale = (weight / count as f64).sqrt();
        for (j, material) in materials.iter().enumerate() {
            let scattered = modes.scatter(material);
            for (i, light) in lights.iter().enumerate() {
                pictures[(k, j * lights.len() + i)] = scale * modes.irradiance(light, &scattered);
            }
        }
    }
    pictures
}

/// Each column less its mean over the normals, where the weights' roots are `roots`.
fn centered(pictures: &Mat<f64>, roots: &[f64]) -> Mat<f64> {
    let means: Vec<f64> = (0..pictures.ncols())
        .map(|j| (0..pictures.nrows()).map(|k| roots[k] * pictures[(k, j)]).sum())
        .collect();
    Mat::from_fn(pictures.nrows(), pictures.ncols(), |k, j| pictures[(k, j)] - roots[k] * means[j])
}

/// Each row less its mean over the pairs.
fn less_mean_image(pictures: &Mat<f64>) -> Mat<f64> {
    let count = pictures.ncols() as f64;
    let means: Vec<f64> = (0..pictures.nrows())
        .map(|k| (0..pictures.ncols()).map(|j| pictures[(k, j)]).sum::<f64>() / count)
        .collect();
    Mat::from_fn(pictures.nrows(), pictures.ncols(), |k, j| pictures[(k, j)] - means[k])
}

/// Objects of many kinds.
fn objects() -> Vec<(&'static str, WeightedNormals)> {
    let listed = |pairs: Vec<([f64; 3], f64)>| WeightedNormals::new(pairs).expect("normals");
    let whole = sphere(3);
    let half = whole.normals().iter().zip(whole.weights());
    let half = half.filter(|(normal, _)| normal[0] > 0.0).map(|(n, w)| (*n, *w)).collect();
    let around = |k: u32| std::f64::consts::TAU * f64::from(k) / 60.0;
    let cylinder = (0..60).map(|k| {
        let (sine, cosine) = (around(k) / 4.0).sin_cos();
        ([sine, 0.0, cosine], cosine)
    });
    let cone = (0..60).map(|k| {
        let (sine, cosine) = around(k).sin_cos();
        ([0.6 * sine, 0.6 * cosine, 0.8], 1.0)
    });
    // A height field of a few bumps, like a face: normals along (-h_x, -h_y, 1).
    let face = (0..30 * 30).map(|k| {
        let (x, y) = (f64::from(k % 30) / 10.0 - 1.5, f64::from(k / 30) / 10.0 - 1.5);
        let bump = |cx: f64, cy: f64, height: f64, width: f64| {
            let (dx, dy) = ((x - cx) / width, (y - cy) / width);
            let value = height * (-0.5 * (dx * dx + dy * dy)).exp();
            [value * dx / width, value * dy / width]
        };
        let bumps = [
            bump(0.0, 0.0, 1.5, 1.2),
            bump(0.0, -0.1, 0.4, 0.2),
            bump(-0.5, 0.4, -0.2, 0.25),
            bump(0.5, 0.4, -0.2, 0.25),
        ];
        let sum = |axis: usize| bumps.iter().map(|bump| bump[axis]).sum::<f64>();
        ([sum(0), sum(1), 1.0], 1.0)
    });
    vec![
        ("half a sphere", listed(half)),
        ("a cylinder", listed(cylinder.collect())),
        ("a cone", listed(cone.collect())),
        ("a face", listed(face.collect())),
    ]
}

/// The general way against principal components of the pictures.
#[test]
fn any_object_has_the_components_of_its_pictures() {
    let (lights, mut materials) = databases(5, 4);
    materials.entries.truncate(20);
    for (name, listed) in objects() {
        let pictures = pictures(&lights, &materials, &listed);
        let roots: Vec<f64> = listed.weights().iter().map(|weight| weight.sqrt()).collect();
        for criterion in [Criterion::ImageCentered, Criterion::Standard] {
            let mut scene = scene(5, 4, criterion, LightRotation::None);
            scene.basis.components = Some(usize::MAX);
            scene.basis.rank_cutoff = 1e-12;
            let geometry = Geometry::Listed(listed.clone());
            let table = general::build(&scene, &geometry, &lights, &materials).expect("a basis");
            let images = match criterion {
                Criterion::ImageCentered => centered(&pictures, &roots),
                Criterion::Standard => less_mean_image(&pictures),
            };
            let svd = images.thin_svd().expect("an SVD");
            let expected: Vec<f64> = svd.S().column_vector().iter().copied().collect();
            let found: Vec<f64> =
                table.spectrum.iter().filter_map(|(_, value)| value.map(f64::sqrt)).collect();
            let seen = expected.iter().filter(|value| **value > GENERAL_SEEN * expected[0]).count();
            assert!(found.len() >= seen, "{name}: {} of {seen} components", found.len());
            let eigenvalues = expected
                .iter()
                .zip(&found)
                .fold(0.0, |most: f64, (a, b)| most.max((a - b).abs() / expected[0]));
            // Orthonormal over the object's normals, as far as it shows in a picture: weak
            // eigenimages lack the modes that are cut off.
            let values = eigenimages(&table, listed.normals());
            let weighted =
                Mat::from_fn(values.nrows(), values.ncols(), |k, i| roots[k] * values[(k, i)]);
            let products = weighted.transpose() * &weighted;
            let sizes: Vec<f64> = table
                .spectrum
                .iter()
                .map(|(_, value)| value.map_or(1.0, |value| value.sqrt() / expected[0]))
                .collect();
            let mut orthonormal: f64 = 0.0;
            for i in 0..products.nrows() {
                for j in 0..products.ncols() {
                    let unit = f64::from(u8::from(i == j));
                    let apart = (products[(i, j)] - unit).abs();
                    orthonormal = orthonormal.max(apart * sizes[i].min(sizes[j]));
                }
            }
            println!(
                "{name}, {criterion:?}: {} of {}: eigenvalues {eigenvalues:.1e}, \
                 orthonormal {orthonormal:.1e}",
                found.len(),
                expected.len()
            );
            assert!(eigenvalues <= GENERAL_EIGENVALUES, "{name}: {eigenvalues:e}");
            assert!(orthonormal <= GENERAL_ORTHONORMAL, "{name}: {orthonormal:e}");
        }
    }
}
