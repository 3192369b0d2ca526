//! The shipped table, lights and materials, and a sample of their pairs with the reference images
//! of each: the direct sum (15) over all 3,704 modes in f64.

use eigenshade::{Light, Material, NineTerms, Normal, Scene, sphere};
use eigenshade_index::{light, material, mode};
use eigenshade_model::database::Named;
use eigenshade_model::inputs::coefficient_csv::{read_lights, read_materials};
use eigenshade_model::reference::{DirectSum, Modes};
use eigenshade_model::selection;
use eigenshade_model::special::quadrature::gauss_legendre;
use eigenshade_table::{Component, Table};
use std::error::Error;
use std::f64::consts::TAU;
use std::path::{Path, PathBuf};

pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Lights and materials in f64: luminance, of the table's degree and order.
pub struct Shipped {
    pub table: Table,
    pub lights: Vec<Named>,
    pub materials: Vec<Named>,
}

impl Shipped {
    pub fn read() -> Result<Self, Box<dyn Error>> {
        let tables = root().join("tables");
        let lights = read_lights(tables.join("inputs/lights.csv"), Some(sphere::DEGREE))?;
        let materials = read_materials(tables.join("inputs/materials.csv"), Some(sphere::ORDER))?;
        let table = eigenshade_table::decode(&std::fs::read(tables.join("sphere.bin"))?)?;
        Ok(Self { table, lights: lights.entries, materials: materials.entries })
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
    pub fn pairs(&self, count: usize) -> Vec<Pair> {
        let sample = self.sample(count);
        sample.map(|(one, other)| Pair::new(one.luminance(), other.luminance())).collect()
    }

    /// Every light, as far as a degree, on a white matte.
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
pub fn white_matte() -> Vec<f64> {
    let mut matte = vec![0.0; material::count(sphere::ORDER)];
    matte[0] = 2.0;
    matte
}

/// One channel of a light and a material.
pub struct Pair {
    pub light: Vec<f64>,
    pub material: Vec<f64>,
    light_single: Vec<f32>,
    material_single: Vec<f32>,
}

impl Pair {
    fn new(light: Vec<f64>, material: Vec<f64>) -> Self {
        let single = |of: &[f64]| of.iter().map(|&value| value as f32).collect();
        let (light_single, material_single) = (single(&light), single(&material));
        Self { light, material, light_single, material_single }
    }

    pub fn light_single(&self) -> Light<'_> {
        Light::from_finite(&self.light_single).expect("coefficients of its degree")
    }

    pub fn material_single(&self) -> Material<'_> {
        Material::from_finite(&self.material_single).expect("coefficients of its order")
    }

    /// The formula of a white matte under the light.
    pub fn nine_terms(&self) -> NineTerms {
        let light = Light::from_finite(&self.light_single[..9]);
        NineTerms::lambertian(&light.expect("coefficients of its degree"), 1.0)
    }

    pub fn project(&self) -> sphere::Coefficients {
        sphere::project(&self.light_single(), &self.material_single()).expect("it fits")
    }
}

/// Normals at which images are compared.
pub struct View {
    /// Unit, z >= 0.
    pub normals: Vec<[f64; 3]>,
    /// That integrate squares over a sphere's disc; 0 of the pole and the rim, where only a
    /// peak may be.
    pub weights: Vec<f64>,
    pub reference: DirectSum,
}

const RIM: usize = 64;

impl View {
    pub fn new() -> Self {
        let around = 2 * sphere::DEGREE + 2;
        let (mut normals, mut weights) = (Vec::new(), Vec::new());
        for (z, weight) in gauss_legendre(24, 0.0, 1.0) {
            let sine = (1.0 - z * z).sqrt();
            for k in 0..around {
                let (y, x) = (TAU * k as f64 / around as f64).sin_cos();
                normals.push([sine * x, sine * y, z]);
                weights.push(2.0 * z * weight / around as f64);
            }
        }
        normals.push([0.0, 0.0, 1.0]);
        normals.extend((0..RIM).map(|k| {
            let (y, x) = (TAU * k as f64 / RIM as f64).sin_cos();
            [x, y, 0.0]
        }));
        weights.resize(normals.len(), 0.0);
        Self { normals, weights, reference: DirectSum::new(sphere::DEGREE, sphere::ORDER) }
    }

    pub fn modes(&self) -> Vec<Modes<'_>> {
        self.normals.iter().map(|&normal| self.reference.at(normal)).collect()
    }

    /// The true image of a pair.
    pub fn image(modes: &[Modes<'_>], pair: &Pair) -> Vec<f64> {
        let at = |modes: &Modes<'_>| modes.irradiance(&pair.light, &modes.scatter(&pair.material));
        modes.iter().map(at).collect()
    }

    /// The image of a scene.
    pub fn shade(&self, scene: &Scene<'_, impl AsRef<[f32]>>) -> Vec<f64> {
        let at = |&[x, y, z]: &[f64; 3]| {
            let normal = Normal::new(x as f32, y as f32, z as f32).expect("visible");
            f64::from(scene.shade(normal))
        };
        self.normals.iter().map(at).collect()
    }

    /// Root mean square of the difference over a sphere, of the peak of the reference.
    pub fn error(&self, reference: &[f64], image: &[f64]) -> f64 {
        let peak = reference.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        let squares = reference.iter().zip(image).zip(&self.weights);
        squares.map(|((a, b), weight)| weight * (a - b).powi(2)).sum::<f64>().sqrt() / peak
    }
}

/// l, m, o, p, q.
pub type Mode = (usize, isize, usize, usize, usize);

/// So many the paper kept.
pub const SELECTED: usize = 1000;

/// All modes, m by m.
pub fn all_modes() -> Vec<Mode> {
    let top = sphere::DEGREE.cast_signed();
    let of = |m: isize| {
        let modes = mode::indices(sphere::DEGREE, sphere::ORDER, m.unsigned_abs());
        modes.map(move |(l, o, p, q)| (l, m, o, p, q))
    };
    (-top..=top).flat_map(of).collect()
}

/// Which of [`all_modes`] the paper's selection keeps; ties stay whole.
pub fn selected_modes(shipped: &Shipped) -> Vec<bool> {
    let gram = &shipped.table.gram;
    let kept = selection::highest(gram, eigenshade::Effects::ALL, SELECTED);
    let keeps = |(l, m, o, p, q): Mode| kept[gram.place(m.unsigned_abs(), l, o, p, q)];
    all_modes().into_iter().map(keeps).collect()
}

/// What of `values`, one for each of [`all_modes`], a selection keeps.
pub fn only<T: Copy>(values: &[T], kept: &[bool]) -> Vec<T> {
    let both = values.iter().zip(kept);
    both.filter_map(|(&value, &is_kept)| is_kept.then_some(value)).collect()
}

/// c of a pair.
pub fn coefficients(pair: &Pair) -> Vec<f64> {
    let c = |(l, m, o, p, q): Mode| {
        pair.light[light::position(l, m)] * pair.material[material::position(o, p, q)]
    };
    all_modes().into_iter().map(c).collect()
}

/// UᵀM, a row for each component.
pub fn gram_rows(shipped: &Shipped) -> Vec<Vec<f64>> {
    let table = &shipped.table;
    let row = |component: &Component| {
        let values = table.gram_row(&table.profiles[component.profile]);
        let mut values = values.into_iter();
        let sign = if component.order < 0 && component.order % 2 != 0 { -1.0 } else { 1.0 };
        let entry = |(_, m, ..): Mode| {
            if m as i32 == component.order {
                sign * values.next().expect("a value for each mode of its azimuth")
            } else {
                0.0
            }
        };
        all_modes().into_iter().map(entry).collect()
    };
    table.components.iter().map(row).collect()
}
