//! Images of the shipped lights on the shipped materials, and errors of other ways to
//! their pixels.

use eigenshade::{Normal, sphere};
use eigenshade_model::inputs::coefficient_csv::{read_lights, read_materials};

/// One image.
pub type Shipped = sphere::Scene;

/// Every `step`-th light on every `step`-th material.
pub fn scenes(step: usize) -> Vec<Shipped> {
    let lights = read_lights("tables/inputs/lights.csv", Some(9)).expect("the shipped lights");
    let materials = read_materials("tables/inputs/materials.csv", Some(7)).expect("materials");
    let single = |values: Vec<f64>| values.iter().map(|&value| value as f32).collect::<Vec<_>>();
    let mut scenes = Vec::new();
    for light in lights.entries.iter().step_by(step) {
        let light = single(light.luminance());
        let light = eigenshade::Light::new(&light).expect("coefficients");
        for material in materials.entries.iter().step_by(step) {
            let material = single(material.luminance());
            let material = eigenshade::Material::new(&material).expect("coefficients");
            let d = sphere::project(&light, &material).expect("it fits");
            scenes.push(sphere::collapse(&d).expect("it fits"));
        }
    }
    scenes
}

/// Normals as a picture of a sphere has them, `across` pixels across.
pub fn normals(across: i32) -> Vec<Normal<f32>> {
    let place = |k: i32| f64::from(2 * k + 1) / f64::from(across) - 1.0;
    let pixels = (0..across).flat_map(|j| (0..across).map(move |k| (place(k), place(j))));
    let visible = pixels.filter(|(x, y)| x * x + y * y <= 1.0);
    let normal = |(x, y): (f64, f64)| {
        let z = (1.0 - x * x - y * y).sqrt();
        Normal::new(x as f32, y as f32, z as f32).expect("visible")
    };
    visible.map(normal).collect()
}

/// Rms and largest error, of the peak, of each scene.
pub fn errors(
    scenes: &[Shipped],
    normals: &[Normal<f32>],
    mut image: impl FnMut(&Shipped) -> Vec<f32>,
) -> Vec<[f64; 2]> {
    let one = |scene: &Shipped| {
        let reference: Vec<f64> = normals.iter().map(|&n| f64::from(scene.shade(n))).collect();
        let peak = largest(reference.iter().copied());
        let image = image(scene);
        let apart: Vec<f64> =
            image.iter().zip(&reference).map(|(&a, b)| f64::from(a) - b).collect();
        let rms = (apart.iter().map(|e| e * e).sum::<f64>() / apart.len() as f64).sqrt();
        [rms / peak, largest(apart) / peak]
    };
    scenes.iter().map(one).collect()
}

fn middle(errors: &[[f64; 2]], which: usize) -> [f64; 2] {
    let mut values: Vec<f64> = errors.iter().map(|error| error[which]).collect();
    values.sort_by(f64::total_cmp);
    [values[values.len() / 2], values[values.len() - 1]]
}

pub fn assert_within(what: &str, errors: &[[f64; 2]], [rms, worst]: [f64; 2]) {
    let found = middle(errors, 0);
    println!("{what}: rms {found:?}, largest {:?}", middle(errors, 1));
    assert!(found[0] <= rms && found[1] <= worst, "{what}: {found:?} of {rms}, {worst}");
}

fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, |most: f64, value| {
        if value.is_nan() || value.abs() > most { value.abs() } else { most }
    })
}
