//! Every number format against the f64 sum of the same components, over every light on
//! every material of the database, all channels.
//!
//! The reference is summed mode by mode from the table's rows of UᵀM, and its Chebyshev
//! series; nothing of it is the runtime's.

use crate::invariants::integer::{self, eigenimage};
use crate::tolerances;
use eigenshade_model::database::{Lights, Materials};
use eigenshade_shading::integer_shader::{self, IntegerShader};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader};
use eigenshade_testing::fixtures::{captured, measured, of_equal_areas};
use eigenshade_testing::largest;

/// Signal to error of f32 over the database, in decibels, and of its worst pair: 24 bits
/// are 150, and polynomials are trimmed to 1e-7, 140.
const F32_ALL: f64 = 130.0;

/// See [`F32_ALL`]; d of a dark image is small beside its addends.
const F32_WORST: f64 = 120.0;

/// Signal to error of mantissas of 15 bits: 96 less what a pixel of 17 bits loses to its
/// headroom (docs/formats.md) and to 13 polynomials' rounding.
const Q15_ALL: f64 = 80.0;

/// Signal to error of one component over the database: the addends of UᵀM cancel, to a
/// thirtieth in the weakest.
const Q15_COMPONENT: f64 = 64.0;

/// What a scene's scale leaves free, times the peak: the mean and the most over the database.
const HEADROOM: [f64; 2] = [1.7, 3.4];

/// Normals at which images are compared, of equal projected areas.
const NORMALS: usize = 400;

/// Energies of what should be and of what is wrong.
#[derive(Clone, Copy, Default)]
struct Ratio {
    signal: f64,
    noise: f64,
}

impl Ratio {
    fn add(&mut self, reference: f64, found: f64) {
        self.signal += reference * reference;
        self.noise += (found - reference).powi(2);
    }

    fn decibels(self) -> f64 {
        10.0 * (self.signal / self.noise).log10()
    }
}

/// Signal to error: over all, of the worst pair, of the weakest component.
#[derive(Debug)]
struct Score {
    all: f64,
    worst: f64,
    component: f64,
}

struct Reference {
    shipped: &'static integer::Shipped,
    lights: Lights,
    materials: Materials,
    normals: Vec<[f64; 3]>,
    /// For each component, each normal.
    images: Vec<Vec<f64>>,
}

impl Reference {
    fn new() -> Self {
        let (shipped, normals) = (integer::shipped(), of_equal_areas(NORMALS));
        let table = &shipped.table;
        let image =
            |component| normals.iter().map(|&at| eigenimage(table, component, at)).collect();
        Self {
            images: table.components.iter().map(image).collect(),
            lights: captured(table.gram.degree),
            materials: measured(table.gram.order),
            normals,
            shipped,
        }
    }

    fn image(&self, d: &[f64]) -> Vec<f64> {
        let at = |k: usize| d.iter().zip(&self.images).map(|(d, image)| d * image[k]).sum();
        (0..NORMALS).map(at).collect()
    }

    /// The score of a format, in which `image` gives a channel's d and its image.
    fn score(&self, mut image: impl FnMut(&[f64], &[f64]) -> [Vec<f64>; 2]) -> Score {
        let mut all = Ratio::default();
        let mut components = vec![Ratio::default(); self.images.len()];
        let mut worst = f64::INFINITY;
        for material in &self.materials.entries {
            for light in &self.lights.entries {
                let mut pair = Ratio::default();
                for (light, material) in light.rgb.iter().zip(&material.rgb) {
                    let d = self.shipped.project(light, material);
                    let [of_d, seen] = image(light, material);
                    for ((ratio, reference), found) in components.iter_mut().zip(&d).zip(of_d) {
                        ratio.add(*reference, found);
                    }
                    for (reference, found) in self.image(&d).into_iter().zip(seen) {
                        pair.add(reference, found);
                    }
                }
                all.signal += pair.signal;
                all.noise += pair.noise;
                worst = worst.min(pair.decibels());
            }
        }
        let component = components.into_iter().map(Ratio::decibels).fold(f64::INFINITY, f64::min);
        Score { all: all.decibels(), worst, component }
    }
}

#[test]
fn floats_are_good() {
    let reference = Reference::new();
    let basis = OwnedBasis::new(&reference.shipped.table).expect("a table for f32");
    let mut shader = Shader::new(basis.basis().expect("a basis"), usize::MAX);
    let normals = OwnedNormals::new(&reference.normals);
    let score = reference.score(|light, material| {
        let image = shader.polynomial(light, material, &normals).expect("it fits");
        let d = shader.project(light, material).expect("it fits");
        [d, &image[..]].map(|values| values.iter().copied().map(f64::from).collect())
    });
    assert!(score.all >= F32_ALL && score.worst >= F32_WORST);
    println!("f32: {score:.1?}");
}

fn integers() -> Score {
    let reference = Reference::new();
    let shader = IntegerShader::new(&reference.shipped.table, usize::MAX);
    let mut shader = shader.expect("a sphere's table");
    let normals = integer_shader::normals(&reference.normals).expect("unit normals");
    reference.score(|light, material| {
        let image = shader.polynomial(light, material, &normals).expect("it fits");
        [shader.project(light, material).expect("it fits"), image]
    })
}

#[test]
fn q15_is_good() {
    let score = integers();
    assert!(score.all >= Q15_ALL && score.worst >= tolerances::Q15_WORST);
    assert!(score.component >= Q15_COMPONENT);
    println!("Q15: {score:.1?}");
}

/// What a scene's scale leaves free: Σ |d_i| max |U_i| over the peak, both at the normals here.
#[test]
fn headroom_is_small() {
    let reference = Reference::new();
    let most_of = |image: &Vec<f64>| largest(image.iter().copied());
    let sizes: Vec<f64> = reference.images.iter().map(most_of).collect();
    let (mut sum, mut count, mut most) = (0.0, 0.0, 0.0f64);
    for material in &reference.materials.entries {
        for light in &reference.lights.entries {
            for (light, material) in light.rgb.iter().zip(&material.rgb) {
                let d = reference.shipped.project(light, material);
                let peak = largest(reference.image(&d));
                let bound: f64 = d.iter().zip(&sizes).map(|(d, size)| d.abs() * size).sum();
                (sum, count, most) = (sum + bound / peak, count + 1.0, most.max(bound / peak));
            }
        }
    }
    println!("headroom: mean {:.2}, most {most:.2}", sum / count);
    assert!(sum / count <= HEADROOM[0] && most <= HEADROOM[1]);
}
