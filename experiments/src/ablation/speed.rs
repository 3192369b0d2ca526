//! Times on this machine, relative to a pixel by the nine-term formula in the same run.

use super::scenes::{self, SCENES, Scene};
use crate::accuracy_cost::times::least;
use eigenshade::{Light, Material, NineTerms, Rotation, sphere};
use eigenshade_index::light;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader};
use eigenshade_testing::fixtures::disc;
use eigenshade_testing::images::single;
use std::hint::black_box;

/// Rounds, of which the fastest counts.
const ROUNDS: usize = 41;

/// Times relative to a pixel by the nine-term formula.
pub struct Times {
    /// Of a pixel of each scene, in all channels.
    pub scenes: Vec<f64>,
    /// With the shipped table: of a new light, a turned light and a new material, each up to the
    /// new scene, and of a pixel.
    pub changes: [f64; 4],
}

impl Times {
    /// Measures all.
    pub fn measured() -> Self {
        Self { scenes: SCENES.iter().map(of_scene).collect(), changes: of_changes() }
    }
}

/// The normals of a picture of 96 x 96 pixels.
fn normals() -> OwnedNormals<f32> {
    OwnedNormals::new(&disc(96))
}

/// The time of an operation relative to that of a nine-term pixel.
fn of_nine_terms(operation: impl FnMut()) -> f64 {
    let owned = normals();
    let normals = owned.view().expect("as many of each");
    let formula = NineTerms::new([0.7f32, -0.1, 0.1, 0.2, -0.03, 0.05, 0.04, 0.02, 0.1]);
    let mut irradiance = vec![0.0f32; normals.len()];
    let nine_terms = || {
        let (formula, normals) = black_box((&formula, normals));
        formula.shade_slice(normals, black_box(&mut irradiance)).expect("a place for each");
    };
    let times = least(vec![Box::new(operation), Box::new(nine_terms)], ROUNDS);
    times[0] / times[1] * normals.len() as f64
}

fn of_scene(scene: &Scene) -> f64 {
    let table = scene.whole_table();
    let (degree, order) = (table.gram.degree, table.gram.order);
    let (light, material) = (scene.light(degree), scenes::material(&table, order));
    let basis = OwnedBasis::<f32>::new(&table);
    let basis = basis.basis().expect("a basis");
    let mut shader = Shader::new(basis, table.count());
    let scenes: Vec<_> = light.entries[0]
        .rgb
        .iter()
        .take(scene.channels)
        .map(|light| {
            let material = (order, material.entries[0].rgb[0].as_slice());
            let d = shader.project((degree, light), material).expect("it fits");
            basis.collapse_into(d, vec![0.0; basis.scene_len()]).expect("room")
        })
        .collect();
    let normals = normals();
    let normals = normals.view().expect("as many of each");
    let mut irradiance = vec![0.0; normals.len()];
    let picture = of_nine_terms(|| {
        for scene in &scenes {
            scene.shade_slice(normals, &mut irradiance).expect("a place for each");
            black_box(&mut irradiance);
        }
    });
    picture / normals.len() as f64
}

fn of_changes() -> [f64; 4] {
    const LIGHT: usize = light::count(sphere::DEGREE);
    let scene = Scene::named("sun_leather");
    let coefficients = single(scene.light(sphere::DEGREE).entries[0].luminance());
    let material = scenes::material(&scene.whole_table(), sphere::ORDER);
    let material = single(material.entries[0].luminance());
    let light = Light::new(&coefficients).expect("100 coefficients");
    let material = Material::new(&material).expect("40 coefficients");
    let transfer = sphere::transfer(&material).expect("it fits");
    let collapsed = |light: &Light<'_, f32>, transfer: &sphere::Transfer| {
        let d = sphere::relight(transfer, light).expect("it fits");
        sphere::collapse(&d).expect("it fits")
    };
    let rotation = Rotation::from_quaternion([0.1, 0.2, 0.3, 1.0]).expect("a rotation");
    let normals = normals();
    let normals = normals.view().expect("as many of each");
    let mut irradiance = vec![0.0; normals.len()];
    let image = collapsed(&light, &transfer);
    let picture = of_nine_terms(|| {
        image.shade_slice(normals, &mut irradiance).expect("a place for each");
        black_box(&mut irradiance);
    });
    [
        of_nine_terms(|| {
            black_box(collapsed(black_box(&light), &transfer));
        }),
        of_nine_terms(|| {
            let turned = black_box(&light).turned::<LIGHT>(&rotation).expect("room");
            let light = Light::new(&turned).expect("100 coefficients");
            black_box(collapsed(&light, &transfer));
        }),
        of_nine_terms(|| {
            let transfer = sphere::transfer(black_box(&material)).expect("it fits");
            black_box(collapsed(&light, &transfer));
        }),
        picture / normals.len() as f64,
    ]
}
