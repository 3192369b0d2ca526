//! Times on this machine, relative to a pixel by the nine-term formula in the same run.

use super::scenes::{self, SCENES, Scene};
use crate::median::median;
use eigenshade::{Light, Material, NineTerms, Rotation, sphere};
use eigenshade_index::light;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader};
use eigenshade_testing::images::single;
use std::hint::black_box;
use std::time::Instant;

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

/// Width and height of the picture in pixels.
const SIDE: usize = 96;
/// The number of rounds, of which the median is taken.
const ROUNDS: usize = 41;

/// The normals of the picture's pixels inside the disc.
fn normals() -> OwnedNormals<f32> {
    let along = |k: usize| (2 * k + 1) as f64 / SIDE as f64 - 1.0;
    let points = (0..SIDE * SIDE).map(|k| (along(k % SIDE), -along(k / SIDE)));
    let inside = points.filter(|(x, y)| x * x + y * y < 1.0);
    let normals = inside.map(|(x, y)| [x, y, (1.0 - x * x - y * y).sqrt()]);
    OwnedNormals::new(&normals.collect::<Vec<_>>())
}

/// The median time of an operation relative to that of a nine-term pixel; the two are timed in
/// turn.
fn ratio(operations: usize, mut operation: impl FnMut()) -> f64 {
    let owned = normals();
    let normals = owned.view().expect("as many of each");
    let formula = NineTerms::new([0.7f32, -0.1, 0.1, 0.2, -0.03, 0.05, 0.04, 0.02, 0.1]);
    let mut irradiance = vec![0.0f32; normals.len()];
    let mut nine_terms = || {
        let (formula, normals) = black_box((&formula, normals));
        formula.shade_slice(normals, black_box(&mut irradiance)).expect("a place for each");
    };
    let time = |work: &mut dyn FnMut()| {
        let start = Instant::now();
        work();
        start.elapsed().as_secs_f64()
    };
    let (mut ours, mut theirs) = (Vec::new(), Vec::new());
    for _ in 0..ROUNDS {
        ours.push(time(&mut operation) / operations as f64);
        theirs.push(time(&mut nine_terms) / normals.len() as f64);
    }
    median(&ours) / median(&theirs)
}

fn of_scene(scene: &Scene) -> f64 {
    let table = scene.whole_table();
    let (degree, order) = (table.gram.degree, table.gram.order);
    let material = scenes::material(&table, order);
    let basis = OwnedBasis::<f32>::new(&table);
    let basis = basis.basis().expect("a basis");
    let mut shader = Shader::new(basis, table.count());
    let mut channels = Vec::new();
    for light in scene.light(degree) {
        let mut numbers = vec![0.0; basis.scene_len()];
        let d = shader.project((degree, &light), (order, &material)).expect("it fits");
        basis.collapse_into(d, &mut numbers).expect("room");
        channels.push(numbers);
    }
    let normals = normals();
    let normals = normals.view().expect("as many of each");
    let mut irradiance = vec![0.0; normals.len()];
    let scenes: Vec<_> = channels
        .iter()
        .map(|numbers| basis.scene(numbers.as_slice()).expect("its own numbers"))
        .collect();
    ratio(normals.len(), || {
        for scene in &scenes {
            scene.shade_slice(normals, &mut irradiance).expect("a place for each");
            black_box(&mut irradiance);
        }
    })
}

fn of_changes() -> [f64; 4] {
    const ROOM: usize = Light::<f32>::turn_len(sphere::DEGREE);
    const LIGHT: usize = light::count(sphere::DEGREE);
    let scene = Scene::named("sun_leather");
    let coefficients = single(scene.light(sphere::DEGREE).remove(0));
    let material = single(scenes::material(&scene.whole_table(), sphere::ORDER));
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
    let times = |mut one: Box<dyn FnMut() + '_>| ratio(20, move || (0..20).for_each(|_| one()));
    [
        times(Box::new(|| {
            black_box(collapsed(black_box(&light), &transfer));
        })),
        times(Box::new(|| {
            let turned = black_box(&light).turned::<LIGHT, ROOM>(&rotation).expect("room");
            let light = Light::new(&turned).expect("100 coefficients");
            black_box(collapsed(&light, &transfer));
        })),
        times(Box::new(|| {
            let transfer = sphere::transfer(black_box(&material)).expect("it fits");
            black_box(collapsed(&light, &transfer));
        })),
        ratio(normals.len(), || {
            image.shade_slice(normals, &mut irradiance).expect("a place for each");
            black_box(&mut irradiance);
        }),
    ]
}
