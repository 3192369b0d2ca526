//! The data that all figures share: the lights, the materials, the four bases, and how well each
//! basis represents every image.

use eigenshade_generator::basis;
use eigenshade_generator::basis::gram;
use eigenshade_generator::basis::moments::exposure;
use eigenshade_generator::basis::node_image::{MaterialImages, NodeImage};
use eigenshade_generator::basis::representation::{Fit, fit};
use eigenshade_index::{effect, mode};
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::selection;
use eigenshade_shading::{parallel, shipped};
use eigenshade_table::scene::{self, Criterion, Effects, LightRotation, Normalise, Store};
use eigenshade_table::{GramFactor, Scene, Table};
use indicatif::ProgressBar;
use std::collections::BTreeMap;

/// Largest degree of the light and order of the material, as in the paper.
pub const DEGREE: usize = 9;
/// See [`DEGREE`].
pub const ORDER: usize = 7;
/// The paper keeps this many modes, those of the highest variance.
pub const SELECTED: usize = 1000;
/// The shipped material that is not from CUReT and therefore not in the paper.
const NOT_CURET: &str = "ptfe-633nm";

/// The modes from which a basis is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Modes {
    /// All 3,704.
    All,
    /// The paper's 1,000 of the highest variance.
    Selected,
}

impl Modes {
    /// Both choices.
    pub const BOTH: [Self; 2] = [Self::All, Self::Selected];

    /// The ending of the names of files that show these modes.
    #[must_use]
    pub fn suffix(self) -> &'static str {
        match self {
            Self::All => "",
            Self::Selected => "_1000",
        }
    }

    /// The nominal number of modes.
    #[must_use]
    pub fn count(self) -> usize {
        match self {
            Self::All => mode::total(DEGREE, ORDER),
            Self::Selected => SELECTED,
        }
    }
}

/// Lights, materials and bases.
pub struct Study {
    /// The shipped lights to degree 9, as captured.
    pub lights: Lights,
    /// The 61 materials of CUReT to order 7.
    pub materials: Materials,
    /// The lights' luminance with L_0^0 = 1.
    pub luminances: Vec<Vec<f64>>,
    /// The materials' luminance; they are gray.
    pub greys: Vec<Vec<f64>>,
    /// The factor of M.
    pub gram: GramFactor,
    /// The paper's selection, in the layout of `Table::selection`.
    pub selection: Vec<bool>,
    /// Four tables with all components: image-centered and standard, of all modes, then of the
    /// selected modes.
    pub tables: [Table; 4],
}

/// How well the four bases represent one image.
pub struct Trial {
    /// The index of the light.
    pub light: usize,
    /// The index of the material.
    pub material: usize,
    /// Variance within the image.
    pub variance: f64,
    /// I • 1.
    pub mean: f64,
    /// Variance within the contribution of the unselected modes.
    pub unselected: f64,
    /// The fits, in the order of [`Study::tables`].
    pub fits: [Fit; 4],
}

/// The index in [`Study::tables`] of the table with this criterion and these modes.
#[must_use]
pub fn place(criterion: Criterion, modes: Modes) -> usize {
    usize::from(criterion == Criterion::Standard) + 2 * usize::from(modes == Modes::Selected)
}

impl Study {
    /// Reads the shipped databases and makes the four bases.
    ///
    /// # Errors
    ///
    /// If the folder for temporary files fails.
    pub fn new(progress: &ProgressBar) -> Result<Self> {
        let lights = shipped::lights()?.truncated(DEGREE);
        let mut materials = shipped::materials()?.truncated(ORDER);
        materials.entries.retain(|entry| entry.name != NOT_CURET);
        let made = parallel::map(4, progress, |k| {
            let criterion = [Criterion::ImageCentered, Criterion::Standard][k % 2];
            let modes = [0, SELECTED][k / 2];
            basis::build(&scene(criterion, modes), &lights, &materials)
        });
        let mut tables = Vec::new();
        for table in made {
            tables.push(table?);
        }
        let Ok(tables) = <[Table; 4]>::try_from(tables) else { unreachable!("four were made") };
        let mut luminances = Vec::new();
        for entry in &lights.entries {
            let mut light = entry.luminance();
            let scale = exposure(&entry.name, light[0], Normalise::UnitAmbient)?;
            light.iter_mut().for_each(|value| *value *= scale);
            luminances.push(light);
        }
        let gram = gram::of_sphere(DEGREE, ORDER);
        Ok(Self {
            selection: selection::highest(&gram, effect::Effects::ALL, SELECTED),
            greys: materials.entries.iter().map(Named::luminance).collect(),
            gram,
            luminances,
            lights,
            materials,
            tables,
        })
    }

    /// A light by its name.
    ///
    /// # Errors
    ///
    /// If there is none: the program was built from other databases.
    pub fn light(&self, name: &str) -> Result<&Named> {
        named(&self.lights.entries, name).map(|(_, entry)| entry)
    }

    /// A material by its name.
    ///
    /// # Errors
    ///
    /// As for [`light`](Self::light).
    pub fn material(&self, name: &str) -> Result<&Named> {
        named(&self.materials.entries, name).map(|(_, entry)| entry)
    }

    /// The trial of a light on a material.
    ///
    /// # Errors
    ///
    /// As for [`light`](Self::light).
    pub fn trial<'a>(&self, trials: &'a [Trial], light: &str, material: &str) -> Result<&'a Trial> {
        let (light, _) = named(&self.lights.entries, light)?;
        let (material, _) = named(&self.materials.entries, material)?;
        let found = trials.iter().find(|trial| (trial.light, trial.material) == (light, material));
        found.ok_or_else(|| Error::new("an image is missing", "build the program anew"))
    }

    /// Every light on every material, light by light.
    #[must_use]
    pub fn trials(&self, progress: &ProgressBar) -> Vec<Trial> {
        let whole = MaterialImages::new(&self.gram, &[], &self.greys);
        let selected = MaterialImages::new(&self.gram, &self.selection, &self.greys);
        let count = self.greys.len();
        parallel::map(self.luminances.len() * count, progress, |k| {
            let (light, material) = (k / count, k % count);
            let of = |images: &MaterialImages| images.image(&self.luminances[light], material);
            let image: NodeImage = of(&whole);
            Trial {
                light,
                material,
                variance: image.variance(&self.gram),
                mean: image.mean(&self.gram),
                unselected: image.minus(&of(&selected)).variance(&self.gram),
                fits: self.tables.each_ref().map(|table| fit(table, &image)),
            }
        })
    }
}

fn named<'a>(entries: &'a [Named], name: &str) -> Result<(usize, &'a Named)> {
    let found = entries.iter().enumerate().find(|(_, entry)| entry.name == name);
    found.ok_or_else(|| {
        Error::new(format!("the shipped data have no `{name}`"), "build the program anew")
    })
}

fn scene(criterion: Criterion, modes: usize) -> Scene {
    Scene {
        geometry: scene::Geometry { normals: "sphere".into(), mask: None, density: None },
        light: scene::Light {
            degree: DEGREE,
            database: "inputs/lights.csv".into(),
            rotation: LightRotation::Any,
            normalise: Normalise::UnitAmbient,
            weights: BTreeMap::new(),
        },
        material: scene::Material {
            order: ORDER,
            database: "inputs/materials.csv".into(),
            names: Vec::new(),
            weights: BTreeMap::new(),
        },
        basis: scene::Basis {
            criterion,
            components: Some(usize::MAX),
            tolerance: None,
            modes,
            store: Store::Modes,
            rank_cutoff: 1e-10,
            profile_tolerance: 1e-13,
            knots: None,
            cut: None,
        },
        effects: Effects::default(),
    }
}
