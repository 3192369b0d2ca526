//! The figures of Nillius and Eklundh, "Phenomenological Eigenfunctions for Image Irradiance", ICCV
//! 2003, on the shipped databases. Each file that [`make`] calls measures one figure; [`charts`] and
//! `tables` show the CSV files. All share the lights, the materials, the four bases, and how well
//! each basis represents every image.

pub mod bound;
mod eigenimages;
pub mod error;
pub mod node_image;
pub mod partial_sum;
mod plate;
pub mod reconstruction;
mod spheres;
pub mod tables;
pub mod variance;

use self::node_image::{Fit, MaterialImages, fit};
use crate::figures::{self, OutputFile};
use crate::numbers;
use crate::sheet::Sheet;
use eigenshade_generator::basis::moments::exposure;
use eigenshade_generator::basis::{self, gram};
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::selection;
use eigenshade_model::{parallel, shipped};
use eigenshade_table::scene::{self, Criterion, Effects, Normalize};
use eigenshade_table::{GramFactor, Scene, Table, decode, mode};
use std::collections::BTreeMap;
use std::fmt::Display;

/// Significant digits of the figures' numbers.
const DIGITS: usize = 6;

/// Measures the CSV files and draws the pictures of `docs/paper`.
pub fn make() -> Result<Vec<OutputFile>> {
    let study = Study::new()?;
    let files = [
        variance::Variance::new(&study).files()?,
        eigenimages::files(&study)?,
        spheres::files(&study)?,
        error::files(&study)?,
        reconstruction::files(&study)?,
        bound::files(&study)?,
    ];
    Ok(files.concat())
}

/// The CSV files of the figures, by name.
pub type Sheets = BTreeMap<String, Sheet>;

/// The charts of `docs/paper`, from its CSV files.
pub fn charts(sheets: &Sheets) -> Result<Vec<OutputFile>> {
    Ok([
        variance::Variance::of(&sheets["variance"]).charts()?,
        error::charts(sheets)?,
        vec![bound::chart(&sheets["bound_course"])?],
    ]
    .concat())
}

/// A CSV of the figures; `columns` are separated by commas.
fn csv<R: IntoIterator<Item: AsRef<[u8]>>>(
    name: &str,
    columns: &str,
    rows: impl IntoIterator<Item = R>,
) -> Result<OutputFile> {
    figures::csv("paper --out docs/paper", name, columns, rows)
}

/// A row of a CSV: texts, then numbers with six significant digits.
fn row(texts: &[&dyn Display], numbers: impl IntoIterator<Item = f64>) -> Vec<String> {
    let texts = texts.iter().map(ToString::to_string);
    texts.chain(numbers.into_iter().map(digits)).collect()
}

/// A number with six significant digits.
fn digits(value: f64) -> String {
    numbers::digits(value, DIGITS)
}

/// Largest degree of the light and order of the material, as in the paper.
pub const DEGREE: usize = 9;
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
    pub const BOTH: [Self; 2] = [Self::All, Self::Selected];

    /// The nominal number of modes.
    pub fn count(self) -> usize {
        match self {
            Self::All => mode::total(DEGREE, ORDER),
            Self::Selected => SELECTED,
        }
    }
}

/// How well the four bases represent one image.
pub struct Trial {
    pub light: usize,
    pub material: usize,
    pub variance: f64,
    /// I • 1.
    pub mean: f64,
    /// Variance within the contribution of the unselected modes.
    pub unselected: f64,
    /// The fits, in the order of [`Study::tables`].
    pub fits: [Fit; 4],
}

/// Lights, materials, bases, and every image.
pub struct Study {
    /// The shipped lights to degree 9, as captured.
    pub lights: Lights,
    /// The 61 materials of CUReT to order 7.
    pub materials: Materials,
    /// The lights' luminance with L_0^0 = 1.
    pub luminances: Vec<Vec<f64>>,
    /// The materials' luminance; they are gray.
    pub grays: Vec<Vec<f64>>,
    pub gram: GramFactor,
    /// The paper's selection, in the layout of `Table::selection`.
    pub selection: Vec<bool>,
    /// Of all components: image-centered and standard, of all modes, then of the selected ones.
    pub tables: [Table; 4],
    /// Every light on every material, light by light.
    pub trials: Vec<Trial>,
}

/// The index in [`Study::tables`] of the table with this criterion and these modes.
pub fn place(criterion: Criterion, modes: Modes) -> usize {
    usize::from(criterion == Criterion::Standard) + 2 * usize::from(modes == Modes::Selected)
}

/// A material's name for readers, without number and hyphens.
pub fn title(name: &str) -> String {
    let is_number = |letter: char| letter.is_ascii_digit() || letter == '-';
    name.trim_start_matches(is_number).replace('-', " ")
}

impl Study {
    /// Reads the shipped databases, makes the four bases and fits every image.
    pub fn new() -> Result<Self> {
        let lights = shipped::lights()?.truncated(DEGREE);
        let mut materials = shipped::materials()?.truncated(ORDER);
        materials.entries.retain(|entry| entry.name != NOT_CURET);
        let made = parallel::map(4, &(), |k| {
            let criterion = [Criterion::ImageCentered, Criterion::Standard][k % 2];
            let modes = [0, SELECTED][k / 2];
            basis::build(&scene(criterion, modes), &lights, &materials)
        });
        let tables = made.into_iter().collect::<Result<Vec<Table>>>()?;
        let Ok(tables) = <[Table; 4]>::try_from(tables) else { unreachable!("four were made") };
        let luminance = |entry: &Named| {
            let light = entry.luminance();
            let scale = exposure(&entry.name, light[0], Normalize::UnitAmbient)?;
            Ok(light.into_iter().map(|value| value * scale).collect::<Vec<f64>>())
        };
        let luminances = lights.entries.iter().map(luminance).collect::<Result<Vec<_>>>()?;
        let gram = gram::of_sphere(DEGREE, ORDER);
        let selection = selection::highest(&gram, SELECTED);
        let grays: Vec<Vec<f64>> = materials.entries.iter().map(Named::luminance).collect();
        let whole = MaterialImages::new(&gram, &[], &grays);
        let selected = MaterialImages::new(&gram, &selection, &grays);
        let count = grays.len();
        let trials = parallel::map(luminances.len() * count, &(), |k| {
            let (light, material) = (k / count, k % count);
            let of = |images: &MaterialImages| images.image(&luminances[light], material);
            let image = of(&whole);
            let (variance, mean) = (image.variance(&gram), image.mean(&gram));
            let unselected = image.minus(&of(&selected)).variance(&gram);
            let fits = tables.each_ref().map(|table| fit(table, &image));
            Trial { light, material, variance, mean, unselected, fits }
        });
        Ok(Self { lights, materials, luminances, grays, gram, selection, tables, trials })
    }

    /// The trial of a light on a material, unless the program was built from other databases.
    pub fn trial(&self, light: &str, material: &str) -> Result<&Trial> {
        let is_it = |trial: &&Trial| {
            self.lights.entries[trial.light].name == light
                && self.materials.entries[trial.material].name == material
        };
        self.trials.iter().find(is_it).ok_or_else(|| {
            let what = format!("the shipped data have no `{light}` on `{material}`");
            Error::new(what, "build the program anew")
        })
    }
}

/// The scene of the table of CUReT with another basis, without that table's effects.
fn scene(criterion: Criterion, modes: usize) -> Scene {
    let scene = decode(shipped::CURET).expect("a shipped table").scene;
    let (components, profile_tolerance) = (Some(usize::MAX), 1e-13);
    let basis = scene::Basis { criterion, components, modes, profile_tolerance, ..scene.basis };
    Scene { basis, effects: Effects::default(), ..scene }
}
