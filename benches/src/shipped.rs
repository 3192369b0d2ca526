//! The shipped lights and materials, their scenes, and normals to draw them for.

use eigenshade::lights::NineTerms;
use eigenshade::truncation::{Tolerance, Truncation};
use eigenshade::{Light, Material, Normals, Scene, sphere};
use eigenshade_model::database::Named;
use eigenshade_model::inputs::coefficient_csv::{read_lights, read_materials};
use eigenshade_table::{light, material};
use std::path::{Path, PathBuf};

/// The folder of the shipped tables.
#[must_use]
pub fn tables() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../tables")
}

/// Lights and materials of the degree and order of the table `sphere`.
pub struct Shipped {
    /// In color.
    pub lights: Vec<Named>,
    /// In color.
    pub materials: Vec<Named>,
}

impl Shipped {
    /// Reads them.
    #[must_use]
    pub fn read() -> Self {
        let inputs = tables().join("inputs");
        let lights = read_lights(inputs.join("lights.csv"), Some(sphere::DEGREE));
        let materials = read_materials(inputs.join("materials.csv"), Some(sphere::ORDER));
        Self {
            lights: lights.expect("the shipped lights").entries,
            materials: materials.expect("the shipped materials").entries,
        }
    }

    /// `count` lights and materials spread over all pairs.
    pub fn sample(&self, count: usize) -> impl Iterator<Item = (&Named, &Named)> {
        let (lights, materials) = (&self.lights, &self.materials);
        (0..count).map(move |k| {
            let place = (2 * k + 1) * lights.len() * materials.len() / (2 * count);
            (&lights[place % lights.len()], &materials[place / lights.len()])
        })
    }

    /// The luminance of a sample.
    #[must_use]
    pub fn pairs(&self, count: usize) -> Vec<Pair> {
        let sample = self.sample(count);
        sample.map(|(one, other)| Pair::new(one.luminance(), other.luminance())).collect()
    }

    /// Every light, as far as a degree, on a white matte.
    #[must_use]
    pub fn on_matte(&self, degree: usize) -> Vec<Pair> {
        let pair = |light: &Named| {
            let mut light = light.luminance();
            light[light::count(degree)..].fill(0.0);
            Pair::new(light, white_matte())
        };
        self.lights.iter().map(pair).collect()
    }
}

/// f = 1/π.
#[must_use]
pub fn white_matte() -> Vec<f64> {
    let mut matte = vec![0.0; material::count(sphere::ORDER)];
    matte[0] = 2.0;
    matte
}

/// One channel of a light and a material.
pub struct Pair {
    /// Coefficients of the light.
    pub light: Vec<f64>,
    /// Coefficients of the material.
    pub material: Vec<f64>,
    light_single: Vec<f32>,
    material_single: Vec<f32>,
}

impl Pair {
    /// Of these coefficients.
    #[must_use]
    pub fn new(light: Vec<f64>, material: Vec<f64>) -> Self {
        let single = |of: &[f64]| of.iter().map(|&value| value as f32).collect();
        let (light_single, material_single) = (single(&light), single(&material));
        Self { light, material, light_single, material_single }
    }

    /// The light in f32.
    #[must_use]
    pub fn light(&self) -> Light<'_> {
        Light::from_finite(&self.light_single).expect("coefficients of its degree")
    }

    /// The material in f32.
    #[must_use]
    pub fn material(&self) -> Material<'_> {
        Material::from_finite(&self.material_single).expect("coefficients of its order")
    }

    /// The formula of a white matte under the light.
    #[must_use]
    pub fn nine_terms(&self) -> NineTerms {
        let light = Light::from_finite(&self.light_single[..9]);
        NineTerms::lambertian(&light.expect("coefficients of its degree"), 1.0)
    }

    /// d of the light on the material.
    #[must_use]
    pub fn project(&self) -> sphere::Coefficients {
        sphere::project(&self.light(), &self.material()).expect("it fits")
    }
}

/// A scene of the shipped table.
pub type Shown = Scene<'static, [f32; sphere::SCENE]>;

/// The full scene of coefficients.
#[must_use]
pub fn full(d: &[f32]) -> Shown {
    sphere::BASIS.collapse_into(d, [0.0; sphere::SCENE]).expect("it fits")
}

/// The scene of coefficients within a share of the peak, and the lengths of its polynomials.
#[must_use]
pub fn within(d: &[f32], share: f32) -> (Shown, Vec<u16>) {
    let (mut room, mut reports) = ([0.0; sphere::SCENE], [Truncation::default()]);
    // A scene borrows its lengths; these are kept to the end.
    let (tolerance, lengths) = (Tolerance::OfPeak(share), Vec::leak(vec![0; 16]));
    let shape =
        sphere::BASIS.collapse_set_within(&[d], 1, tolerance, lengths, &mut room, &mut reports);
    let shape = shape.expect("it fits");
    (shape.scene(room).expect("it fits"), shape.lengths[..shape.azimuths()].to_vec())
}

/// Coordinates of normals.
pub struct Axes([Vec<f32>; 3]);

impl Axes {
    /// Of these normals.
    #[must_use]
    pub fn new(normals: &[[f64; 3]]) -> Self {
        Self([0, 1, 2].map(|axis| normals.iter().map(|normal| normal[axis] as f32).collect()))
    }

    /// Of `count` normals over the visible hemisphere.
    #[must_use]
    pub fn spread(count: usize) -> Self {
        let normal = |k: usize| {
            let z = (k as f64 + 0.5) / count as f64;
            let (sine, tilt) = ((1.0 - z * z).sqrt(), 2.399_963 * k as f64);
            [sine * tilt.cos(), sine * tilt.sin(), z]
        };
        Self::new(&(0..count).map(normal).collect::<Vec<_>>())
    }

    /// Each normal.
    pub fn each(&self) -> impl Iterator<Item = [f64; 3]> {
        let [x, y, z] = &self.0;
        x.iter().zip(y).zip(z).map(|((&x, &y), &z)| [x, y, z].map(f64::from))
    }

    /// All of them.
    #[must_use]
    pub fn normals(&self) -> Normals<'_> {
        let [x, y, z] = &self.0;
        Normals::new(x, y, z).expect("one length")
    }
}
