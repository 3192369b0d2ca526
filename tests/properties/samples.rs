//! Random scenes.

use eigenshade_generator::scene_file::Loaded;
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_table::scene::{Criterion, Normalize};
use eigenshade_table::{light, material};
use eigenshade_testing::fixtures::{self, named};
use eigenshade_testing::oracle::Numbers;
use proptest::prelude::*;

/// A random scene, by what it is made from.
#[derive(Clone, Debug)]
pub struct Sample {
    pub degree: usize,
    pub order: usize,
    pub lights: usize,
    pub materials: usize,
    pub seed: u64,
    /// Lights and materials differ in size by 10 to this.
    pub spread: f64,
    /// Share of coefficients that are zero.
    pub empty: f64,
    pub standard: bool,
    pub unit_ambient: bool,
    pub cutoff: f64,
    pub modes: usize,
    /// Each material again, off by so much of itself: eigenvalues nearly zero, or zero.
    pub copies: Option<f64>,
}

prop_compose! {
    pub fn samples()(
        degree in 0usize..9,
        order in 0usize..8,
        lights in 1usize..5,
        materials in 1usize..6,
        seed in any::<u64>(),
        spread in prop_oneof![0.0f64..8.0, 0.0f64..60.0],
        empty in 0.0f64..0.9,
        standard in any::<bool>(),
        unit_ambient in any::<bool>(),
        cutoff in -12.0f64..-5.0,
        modes in prop_oneof![Just(0usize), 1usize..2000],
        copies in prop_oneof![Just(None), Just(Some(0.0)), (-16.0f64..-4.0).prop_map(|e| Some(10f64.powf(e)))],
    ) -> Sample {
        let cutoff = 10f64.powf(cutoff);
        Sample {
            degree, order, lights, materials, seed, spread, empty, standard, unit_ambient, cutoff, modes, copies,
        }
    }
}

impl Sample {
    pub fn scene(&self) -> Loaded {
        let mut numbers = Numbers(self.seed);
        let (spread, empty) = (self.spread, self.empty);
        let mut entry = |name: String, count: usize| {
            let size = 10f64.powf(spread * numbers.next());
            let value = |k: usize| {
                let (value, chance) = (numbers.next(), 0.5 * (numbers.next() + 1.0));
                // A light or a matte part there is always.
                let value = if k == 0 { 1.0 + 0.5 * value } else { value };
                if k > 0 && chance < empty { 0.0 } else { size * value }
            };
            named(name, (0..count).map(value).collect())
        };
        let mut entries = |name: &str, number: usize, count: usize| -> Vec<Named> {
            (0..number).map(|k| entry(format!("{name}-{k}"), count)).collect()
        };
        let lights = entries("light", self.lights, light::count(self.degree));
        let mut materials = entries("material", self.materials, material::count(self.order));
        if let Some(off) = self.copies {
            for k in 0..materials.len() {
                let values = materials[k].rgb[0].iter();
                let copy = values.map(|value| value * (1.0 + off * numbers.next())).collect();
                materials.push(named(format!("copy-{k}"), copy));
            }
        }
        let mut loaded = fixtures::scene(
            Lights { degree: self.degree, entries: lights },
            Materials { order: self.order, entries: materials },
        );
        let scene = &mut loaded.scene;
        if self.standard {
            scene.basis.criterion = Criterion::Standard;
        }
        if !self.unit_ambient {
            scene.light.normalize = Normalize::None;
        }
        scene.basis.rank_cutoff = self.cutoff;
        scene.basis.modes = self.modes;
        loaded
    }

    /// With all modes.
    pub fn whole(&self) -> Self {
        Self { modes: 0, ..self.clone() }
    }
}

/// A light and a material that are not of the database.
pub fn strangers(sample: &Sample) -> ([Vec<f64>; 2], [Vec<f64>; 2]) {
    let mut numbers = Numbers(sample.seed ^ 0x5eed);
    let mut some = |count: usize| (0..count).map(|_| numbers.next()).collect::<Vec<_>>();
    let (l, b) = (light::count(sample.degree), material::count(sample.order));
    ([some(l), some(l)], [some(b), some(b)])
}
