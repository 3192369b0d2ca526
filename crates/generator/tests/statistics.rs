//! Statistics of a database: weights, where twice the weight is being there twice and none is not
//! being there.

use crate::tolerances;
use eigenshade_generator::basis;
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::inputs::coefficient_csv::{read_lights, read_materials};
use eigenshade_table::Table;
use eigenshade_table::scene::{Criterion, MaterialNormalize, Normalize, Scene};
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

fn scene(criterion: Criterion) -> Scene {
    let text = std::fs::read_to_string(Path::new(FOLDER).join("curet.toml")).expect("a scene");
    let mut scene: Scene = toml::from_str(&text).expect("a scene");
    (scene.light.degree, scene.material.order) = (4, 3);
    scene.basis.criterion = criterion;
    scene
}

fn table(scene: &Scene, lights: &Lights, materials: &Materials) -> Table {
    basis::build(scene, lights, materials).expect("a basis")
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
        let mut scene = scene(criterion);
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
        assert!(apart(&repeated) < tolerances::MOMENTS, "{criterion:?}");
        // The peak of a tolerance is of the same statistics.
        let mut tolerant = scene.clone();
        (tolerant.basis.components, tolerant.basis.tolerance) = (None, Some(1e-2));
        let mut loud = lights.clone();
        loud.entries[2].rgb.iter_mut().flatten().for_each(|value| *value *= 1e3);
        tolerant.light.normalize = Normalize::None;
        let counts = [&lights, &loud].map(|lights| kept(&tolerant, lights, &materials));
        assert_eq!(counts[0], counts[1], "a light of weight 0 counts");
        assert!(apart(&plain) > tolerances::NO_ACCIDENT, "weights change nothing: {criterion:?}");
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
    let as_they_are = scene(Criterion::ImageCentered);
    let mut equal = as_they_are.clone();
    equal.material.normalize = MaterialNormalize::EqualVariance;
    // The variance of one material is the sum of the eigenvalues of a table of it alone.
    let deviations: Vec<f64> = materials
        .entries
        .iter()
        .map(|entry| Materials { entries: vec![entry.clone()], ..materials.clone() })
        .map(|one| sum(&eigenvalues(&as_they_are, &lights, &one)).sqrt())
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
            assert!(apart.abs() < tolerances::MOMENTS, "{apart:e}");
        }
    }
    let plain = eigenvalues(&as_they_are, &lights, &scaled(&brighter));
    let apart = plain[0] / sum(&plain) - expected[0] / sum(&expected);
    assert!(apart.abs() > tolerances::NO_ACCIDENT, "{apart:e}");
    // All black: weights stay what they are, and the table is refused as before.
    let mut one_of = scene(Criterion::ImageCentered);
    let black = scaled(&vec![0.0; materials.entries.len()]);
    let errors = [MaterialNormalize::EqualVariance, MaterialNormalize::None].map(|normalize| {
        one_of.material.normalize = normalize;
        basis::build(&one_of, &lights, &black).map(|table| table.count()).map_err(|e| e.to_string())
    });
    assert_eq!(errors[0], errors[1]);
}
