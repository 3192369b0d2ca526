//! Statistics of a database: weights, where twice the weight is being there twice and none is not
//! being there, and the moments of lights that turn about the vertical axis. With the normals of
//! the sphere as those of an object, the basis is the one of the sphere.

use crate::tolerances;
use eigenshade_generator::basis::moments::{LightStatistics, equal};
use eigenshade_generator::basis::{self, general};
use eigenshade_generator::object::density;
use eigenshade_generator::object::geometry::{Geometry, WeightedNormals};
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::inputs::coefficient_csv::{read_lights, read_materials};
use eigenshade_model::special::quadrature::gauss_legendre;
use eigenshade_model::special::spherical_harmonic;
use eigenshade_table::Table;
use eigenshade_table::scene::{Criterion, LightRotation, MaterialNormalize, Normalize, Scene};
use eigenshade_testing::fixtures::Projector;
use eigenshade_testing::{largest, largest_difference};
use std::path::Path;

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tables");

fn databases() -> (Lights, Materials) {
    let file = |name: &str| Path::new(FOLDER).join("inputs").join(name);
    let mut lights = read_lights(file("lights.csv"), Some(4)).expect("lights");
    let mut materials = read_materials(file("materials.csv"), Some(3)).expect("materials");
    lights.entries.truncate(5);
    materials.entries.truncate(6);
    (lights, materials)
}

fn scene(criterion: Criterion, rotation: LightRotation) -> Scene {
    let text = std::fs::read_to_string(Path::new(FOLDER).join("curet.toml")).expect("a scene");
    let mut scene: Scene = toml::from_str(&text).expect("a scene");
    (scene.light.degree, scene.material.order) = (4, 3);
    (scene.basis.criterion, scene.light.rotation) = (criterion, rotation);
    scene
}

fn table(scene: &Scene, lights: &Lights, materials: &Materials) -> Table {
    let table = match scene.light.rotation {
        LightRotation::Any => basis::build(scene, lights, materials),
        _ => general::build(scene, &Geometry::Sphere, lights, materials),
    };
    table.expect("a basis")
}

fn kept(scene: &Scene, lights: &Lights, materials: &Materials) -> usize {
    table(scene, lights, materials).count()
}

fn eigenvalues(scene: &Scene, lights: &Lights, materials: &Materials) -> Vec<f64> {
    table(scene, lights, materials).spectrum.iter().filter_map(|(_, value)| *value).collect()
}

/// The second entry once more under another name, the third taken out.
fn changed(entries: &[Named]) -> Vec<Named> {
    let mut changed = entries.to_vec();
    let again = Named { name: "again".to_owned(), ..entries[1].clone() };
    changed.push(again);
    changed.remove(2);
    changed
}

#[test]
fn weights_are_repetitions() {
    let (lights, materials) = databases();
    for criterion in [Criterion::ImageCentered, Criterion::Standard] {
        for rotation in [LightRotation::Any, LightRotation::Vertical, LightRotation::None] {
            let mut scene = scene(criterion, rotation);
            let plain = eigenvalues(&scene, &lights, &materials);
            let repeated = {
                let entries = changed(&lights.entries);
                let lights = Lights { entries, ..lights.clone() };
                let entries = changed(&materials.entries);
                eigenvalues(&scene, &lights, &Materials { entries, ..materials.clone() })
            };
            for (weights, entries) in [
                (&mut scene.light.weights, &lights.entries),
                (&mut scene.material.weights, &materials.entries),
            ] {
                weights.insert(entries[1].name.clone(), 2.0);
                weights.insert(entries[2].name.clone(), 0.0);
            }
            let weighted = eigenvalues(&scene, &lights, &materials);
            let apart = |other: &[f64]| {
                let pairs = weighted.iter().zip(other);
                pairs.fold(0.0, |most: f64, (a, b)| most.max((a - b).abs())) / weighted[0]
            };
            assert!(apart(&repeated) < tolerances::MOMENTS, "{criterion:?} {rotation:?}");
            // The peak of a tolerance is of the same statistics.
            let mut tolerant = scene.clone();
            (tolerant.basis.components, tolerant.basis.tolerance) = (None, Some(1e-2));
            let mut loud = lights.clone();
            loud.entries[2].rgb.iter_mut().flatten().for_each(|value| *value *= 1e3);
            tolerant.light.normalize = Normalize::None;
            let counts = [&lights, &loud].map(|lights| kept(&tolerant, lights, &materials));
            assert_eq!(counts[0], counts[1], "a light of weight 0 counts");
            assert!(
                apart(&plain) > tolerances::NO_ACCIDENT,
                "weights change nothing: {criterion:?} {rotation:?}"
            );
        }
    }
}

/// Materials of equal variance are those scaled by hand to equal variance; how bright each was
/// does not matter, and a black one is not there.
#[test]
fn equal_variance_is_scaling() {
    let (lights, materials) = databases();
    let scaled = |factors: &[f64]| {
        let mut materials = materials.clone();
        for (entry, factor) in materials.entries.iter_mut().zip(factors) {
            entry.rgb.iter_mut().flatten().for_each(|value| *value *= factor);
        }
        materials
    };
    let sum = |values: &[f64]| values.iter().sum::<f64>();
    for rotation in [LightRotation::Any, LightRotation::Vertical] {
        let as_they_are = scene(Criterion::ImageCentered, rotation);
        let mut equal = as_they_are.clone();
        equal.material.normalize = MaterialNormalize::EqualVariance;
        // The variance of one material is the sum of the eigenvalues of a table of it alone.
        let alone = scene(Criterion::ImageCentered, LightRotation::Any);
        let deviations: Vec<f64> = materials
            .entries
            .iter()
            .map(|entry| Materials { entries: vec![entry.clone()], ..materials.clone() })
            .map(|one| sum(&eigenvalues(&alone, &lights, &one)).sqrt())
            .collect();
        let inverse: Vec<f64> = deviations.iter().map(|deviation| 1.0 / deviation).collect();
        let expected = eigenvalues(&as_they_are, &lights, &scaled(&inverse));
        let brighter: Vec<f64> = (0..inverse.len()).map(|k| 10f64.powi(k as i32 - 2)).collect();
        let mut with_black = materials.clone();
        let black = vec![0.0; materials.entries[0].rgb[0].len()];
        with_black
            .entries
            .push(Named { name: "black".to_owned(), rgb: [(); 3].map(|()| black.clone()) });
        for materials in [&materials, &scaled(&brighter), &with_black] {
            let found = eigenvalues(&equal, &lights, materials);
            assert_eq!(found.len(), expected.len());
            // The weights sum to 1, so only ratios count.
            let [total, expected_total] = [sum(&found), sum(&expected)];
            for (found, expected) in found.iter().zip(&expected) {
                let apart = found / total - expected / expected_total;
                assert!(apart.abs() < tolerances::MOMENTS, "{rotation:?}: {apart:e}");
            }
        }
        let plain = eigenvalues(&as_they_are, &lights, &scaled(&brighter));
        let apart = plain[0] / sum(&plain) - expected[0] / sum(&expected);
        assert!(apart.abs() > tolerances::NO_ACCIDENT, "{rotation:?}: {apart:e}");
    }
    // All black: weights stay what they are, and the table is refused as before.
    let mut one_of = scene(Criterion::ImageCentered, LightRotation::Any);
    let black = scaled(&vec![0.0; materials.entries.len()]);
    let errors = [MaterialNormalize::EqualVariance, MaterialNormalize::None].map(|normalize| {
        one_of.material.normalize = normalize;
        basis::build(&one_of, &lights, &black).map(|table| table.count()).map_err(|e| e.to_string())
    });
    assert_eq!(errors[0], errors[1]);
}

/// Turning about the vertical axis: the light's second moments, by turning each light
/// through more angles than needed and other ones.
#[test]
fn vertical_statistics_are_those_of_turned_lights() {
    let lights = read_lights(Path::new(FOLDER).join("inputs/lights.csv"), Some(4)).expect("lights");
    let statistics = LightStatistics::new(
        &lights,
        Normalize::None,
        LightRotation::Vertical,
        &equal(lights.entries.len()),
    )
    .expect("statistics");
    let count = 25;
    let angles = 31;
    let mut samples = Vec::new();
    for entry in &lights.entries {
        let light = entry.luminance();
        for k in 0..angles {
            let angle = std::f64::consts::TAU * (f64::from(k) + 0.3) / f64::from(angles);
            samples.push(turned_about_y(&light, 4, angle));
        }
    }
    let of = |i: usize, j: usize| {
        samples.iter().map(|light| light[i] * light[j]).sum::<f64>() / samples.len() as f64
    };
    let largest = (0..count).map(|i| of(i, i)).fold(0.0, f64::max);
    for i in 0..count {
        let mean = samples.iter().map(|light| light[i]).sum::<f64>() / samples.len() as f64;
        assert!((mean - statistics.mean[i]).abs() < tolerances::MOMENTS * largest.sqrt());
        for j in 0..count {
            let found: f64 = statistics.second.iter().map(|v| v[i] * v[j]).sum();
            let apart = (found - of(i, j)).abs() / largest;
            assert!(apart < tolerances::MOMENTS, "{i} {j}: {apart:e}");
            let found: f64 = statistics.centered.iter().map(|v| v[i] * v[j]).sum();
            let expected = of(i, j) - statistics.mean[i] * statistics.mean[j];
            assert!((found - expected).abs() / largest < tolerances::MOMENTS, "{i} {j}");
        }
    }
}

/// The coefficients of a light turned about y, by evaluating it in turned directions: a
/// quadrature that is exact for harmonics up to the degree.
fn turned_about_y(light: &[f64], degree: usize, angle: f64) -> Vec<f64> {
    let mut turned = vec![0.0; light.len()];
    let (sine, cosine) = angle.sin_cos();
    let tilts = 2 * degree + 2;
    for (z, weight) in gauss_legendre(degree + 1, -1.0, 1.0) {
        for k in 0..tilts {
            let (y, x) = (std::f64::consts::TAU * k as f64 / tilts as f64).sin_cos();
            let radius = (1.0 - z * z).sqrt();
            let to = [radius * x, radius * y, z];
            // R takes z toward x: light comes to ω from R⁻¹ω.
            let from = [cosine * to[0] - sine * to[2], to[1], sine * to[0] + cosine * to[2]];
            let harmonics = spherical_harmonic::all(degree, from);
            let value: f64 = harmonics.iter().zip(light).map(|(y, l)| y * l).sum();
            let area = weight * std::f64::consts::TAU / tilts as f64;
            for (sum, y) in turned.iter_mut().zip(spherical_harmonic::all(degree, to)) {
                *sum += area * value * y;
            }
        }
    }
    turned
}

/// Normals of a sphere by quadrature.
fn sphere(degree: usize) -> WeightedNormals {
    let pairs = density::read("cos(a)", Path::new(""), degree).expect("a formula");
    WeightedNormals::new(pairs).expect("normals")
}

#[test]
fn the_sphere_by_quadrature_is_the_sphere() {
    let file = |name: &str| Path::new(FOLDER).join("inputs").join(name);
    let lights = read_lights(file("lights.csv"), Some(9)).expect("lights");
    let materials = read_materials(file("materials.csv"), Some(7)).expect("materials");
    for criterion in [Criterion::ImageCentered, Criterion::Standard] {
        let mut scene = scene(criterion, LightRotation::Any);
        (scene.light.degree, scene.material.order) = (9, 7);
        // Whole polynomials: what is compared is the basis, not how it is rounded.
        scene.basis.profile_tolerance = 1e-15;
        let own = basis::build(&scene, &lights, &materials).expect("a basis");
        let listed = Geometry::Listed(sphere(9));
        let general = general::build(&scene, &listed, &lights, &materials).expect("a basis");
        assert_eq!(own.count(), general.count());
        let most = largest(own.spectrum.iter().filter_map(|(_, value)| *value));
        for ((_, own), (_, general)) in own.spectrum.iter().zip(&general.spectrum) {
            let apart = (own.unwrap_or(0.0) - general.unwrap_or(0.0)).abs();
            assert!(apart <= tolerances::GENERAL_SPHERE * most, "{own:?} {general:?}");
        }
        let normals: Vec<[f64; 3]> = sphere(3).normals().to_vec();
        let both = [&own, &general].map(Projector::new);
        let worst = largest((0..own.count()).map(|i| {
            let [a, b] = both.each_ref().map(|basis| basis.eigenimage(i, &normals));
            largest_difference(&a, &b)
        }));
        println!("{criterion:?}: eigenimages {worst:.1e}");
        assert!(worst <= tolerances::GENERAL_SPHERE, "{worst:e}");
    }
}
