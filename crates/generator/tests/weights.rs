//! Weights of a database: twice the weight is being there twice, none is not being
//! there.

use crate::tolerances;
use eigenshade_generator::basis;
use eigenshade_generator::basis::general;
use eigenshade_generator::object::geometry::Geometry;
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::inputs::coefficient_csv::{read_lights, read_materials};
use eigenshade_table::Table;
use eigenshade_table::scene::{Criterion, LightRotation, Normalize, Scene};
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
    let text = std::fs::read_to_string(Path::new(FOLDER).join("sphere.toml")).expect("a scene");
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
