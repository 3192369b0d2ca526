//! Part of a sphere's image, and the shipped scene cut small.

use super::oracle::Numbers;
use super::{COUNT, NOISE};
use eigenshade::Normal;
use eigenshade_generator::basis;
use eigenshade_generator::basis::light_statistics::LightStatistics;
use eigenshade_generator::basis::moments::{MaterialMoments, equal};
use eigenshade_generator::reading::observation::{EigenimageValues, Observation, Observer};
use eigenshade_generator::reading::prior::Prior;
use eigenshade_generator::reading::transfer::Transfers;
use eigenshade_generator::scene_file::{self, Loaded};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_table::Table;
use eigenshade_table::scene::Criterion;
use nalgebra::{DMatrix, DVector};
use std::path::Path;

/// The shipped databases, cut to a degree and an order, and their table.
pub fn small(criterion: Criterion, components: usize) -> (Loaded, Table) {
    let mut loaded = scene_file::load(Path::new("tables/sphere.toml")).expect("a scene");
    loaded.lights = loaded.lights.truncated(4);
    loaded.materials = loaded.materials.truncated(3);
    let scene = &mut loaded.scene;
    (scene.light.degree, scene.material.order) = (4, 3);
    scene.basis.criterion = criterion;
    scene.basis.components = Some(components);
    scene.basis.profile_tolerance = 1e-13;
    let table = basis::build(&loaded.scene, &loaded.lights, &loaded.materials).expect("a table");
    (loaded, table)
}

/// Pixels of half a sphere, seen twice as well above as below.
pub struct Pixels {
    pub normals: Vec<[f64; 3]>,
    pub image: Vec<f64>,
    pub weights: Vec<f64>,
}

pub fn pixels(loaded: &Loaded, seed: u64) -> Pixels {
    let mut numbers = Numbers(seed);
    let reference = eigenshade_model::reference::DirectSum::new(4, 3);
    let light = loaded.lights.entries[4].luminance();
    let coefficients = loaded.materials.entries[6].luminance();
    let mut pixels = Pixels { normals: vec![], image: vec![], weights: vec![] };
    while pixels.normals.len() < COUNT {
        let normal @ [x, y, _] = numbers.normal();
        if x < -0.2 {
            continue;
        }
        let modes = reference.at(normal);
        let value = modes.irradiance(&light, &modes.scatter(&coefficients));
        pixels.normals.push(normal);
        pixels.image.push(value + NOISE * numbers.next());
        pixels.weights.push(if y > 0.0 { 2.0 } else { 0.5 });
    }
    pixels
}

pub fn observe(table: &Table, pixels: &Pixels) -> Observation {
    let values = EigenimageValues::new(table, table.components.len());
    let mut observer = Observer::new(values, 1);
    for ((normal, value), weight) in pixels.normals.iter().zip(&pixels.image).zip(&pixels.weights) {
        observer.see(*normal, &[*value], *weight);
    }
    observer.finish()
}

/// √W E, √W m and √W I, by the runtime.
pub fn dense(table: &Table, pixels: &Pixels) -> (DMatrix<f64>, DVector<f64>, DVector<f64>) {
    let owned = OwnedBasis::<f64>::new(table);
    let basis = owned.basis().expect("a basis");
    let components = table.components.len();
    let value = |d: &[f64], pixel: usize| {
        let [x, y, z] = pixels.normals[pixel];
        let normal = Normal::new(x, y, z).expect("a visible normal");
        pixels.weights[pixel].sqrt() * basis.reconstruct(d, normal).expect("an image")
    };
    let mean = DVector::from_fn(COUNT, |pixel, _| value(&vec![0.0; components], pixel));
    let design = DMatrix::from_fn(COUNT, components, |pixel, component| {
        let mut unit = vec![0.0; components];
        unit[component] = 1.0;
        value(&unit, pixel) - mean[pixel]
    });
    let image =
        DVector::from_fn(COUNT, |pixel, _| pixels.weights[pixel].sqrt() * pixels.image[pixel]);
    (design, mean, image)
}

pub fn prior(loaded: &Loaded, table: &Table) -> (Transfers, Prior) {
    let transfers = Transfers::new(table, table.components.len());
    let light = &loaded.scene.light;
    let weights = equal(loaded.lights.entries.len());
    let light = LightStatistics::new(&loaded.lights, light.normalize, light.rotation, &weights)
        .expect("statistics");
    let prior = Prior::new(table, &transfers, &light, MaterialMoments::new(&loaded.materials))
        .expect("a prior");
    (transfers, prior)
}
