//! The scene file: the specification of a basis.

use crate::effect;
pub use crate::effect::Effect;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A complete scene file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scene {
    /// The light that falls on the object.
    pub light: Light,
    /// The materials of the object.
    pub material: Material,
    /// The basis to compute.
    pub basis: Basis,
    /// The effects to include.
    #[serde(default)]
    pub effects: Effects,
}

impl Scene {
    /// The largest degree l of the light that the scene's effects contain.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.effects.set().degree(self.light.degree)
    }

    /// The largest order o of the BRDF that the scene's effects contain.
    #[must_use]
    pub fn order(&self) -> usize {
        self.effects.set().order(self.material.order)
    }
}

/// The light that falls on the object.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Light {
    /// Maximum degree of the light.
    pub degree: usize,
    /// Path to the light CSV, relative to the scene file.
    pub database: String,
    /// How the exposures of the lights are normalized; this affects only the statistics.
    #[serde(default)]
    pub normalize: Normalize,
    /// Weights of the lights in the statistics, by name; 1 by default.
    #[serde(default)]
    pub weights: BTreeMap<String, f64>,
}

/// How the exposures of the lights are normalized; this affects only the statistics.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Normalize {
    /// Each light is scaled to luminance coefficient L_0^0 = 1.
    #[default]
    UnitAmbient,
    /// Lights are used as captured.
    None,
}

/// The materials of the object.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Maximum order of the BRDF.
    pub order: usize,
    /// Paths to the material CSVs, relative to the scene file. In a scene file, a single one may
    /// be written without a list.
    #[serde(with = "one_or_several")]
    pub database: Vec<String>,
    /// Names of the materials to use; all if empty.
    #[serde(default)]
    pub names: Vec<String>,
    /// How bright materials are made comparable to dark ones; this affects only the statistics.
    #[serde(default)]
    pub normalize: MaterialNormalize,
    /// Weights of the materials in the statistics, by name; 1 by default.
    #[serde(default)]
    pub weights: BTreeMap<String, f64>,
}

/// How bright materials are made comparable to dark ones; this affects only the statistics.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum MaterialNormalize {
    /// Each material is scaled so that its images vary equally.
    EqualVariance,
    /// Materials are used as they are.
    #[default]
    None,
}

/// A list of strings that text formats may write as a single string.
mod one_or_several {
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    #[derive(Deserialize)]
    #[serde(untagged, expecting = "a path or a list of paths")]
    enum OneOrSeveral {
        One(String),
        Several(Vec<String>),
    }

    pub fn serialize<S: Serializer>(list: &[String], serializer: S) -> Result<S::Ok, S::Error> {
        match list {
            [one] if serializer.is_human_readable() => one.serialize(serializer),
            _ => list.serialize(serializer),
        }
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(source: D) -> Result<Vec<String>, D::Error> {
        if !source.is_human_readable() {
            return Vec::deserialize(source);
        }
        Ok(match OneOrSeveral::deserialize(source)? {
            OneOrSeveral::One(path) => vec![path],
            OneOrSeveral::Several(paths) => paths,
        })
    }
}

/// The basis to compute.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Basis {
    /// What the principal components maximize.
    pub criterion: Criterion,
    /// Number of components, including the constant of [`Criterion::ImageCentered`]. Exclusive with
    /// `tolerance`; one of the two is required.
    #[serde(default)]
    pub components: Option<usize>,
    /// Rms error that truncation may cause, relative to the peak. Exclusive with `components`; one
    /// of the two is required.
    #[serde(default)]
    pub tolerance: Option<f64>,
    /// Number of modes to keep, by highest variance; 0 keeps all.
    #[serde(default)]
    pub modes: usize,
    /// Singular values below this, relative to the largest of all blocks, count as zero.
    #[serde(default = "default_rank_cutoff")]
    pub rank_cutoff: f64,
    /// Largest error of a profile's polynomial, relative to the profile's largest value. This error
    /// determines the degrees of the polynomials.
    #[serde(default = "default_profile_tolerance")]
    pub profile_tolerance: f64,
    /// The parts of the basis that the table stores.
    #[serde(default)]
    pub store: Store,
    /// Total error allowed for [trimming](crate::trim::trim) the polynomials, relative to the
    /// images' root mean square deviation from their means. Exclusive with `tolerance`.
    #[serde(default)]
    pub trim: Option<f64>,
}

/// Whether a tolerance or a cut-off is a share: above 0 and below 1.
#[must_use]
pub fn is_share(value: f64) -> bool {
    value > 0.0 && value < 1.0
}

fn default_rank_cutoff() -> f64 {
    1e-10
}

fn default_profile_tolerance() -> f64 {
    1e-7
}

/// The parts of a basis that a table stores. The other parts can be computed again from the scene.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Store {
    /// Everything: U over modes, the factors of UᵀM, and the factor of M.
    #[default]
    Modes,
    /// Everything except U over modes: enough to project any material.
    Projection,
    /// The transfers of the scene's materials instead of the factors of UᵀM and M. At high order
    /// this takes far less space if there are few materials.
    Materials,
}

impl Store {
    /// The name in a scene file.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Modes => "modes",
            Self::Projection => "projection",
            Self::Materials => "materials",
        }
    }
}

/// What the principal components maximize.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Criterion {
    /// Variance over light and material, (17): an image is the mean image plus its deviation.
    /// Anything common to all images of the database, such as the exposure of a single material, is
    /// then in no component.
    Standard,
    /// Variance within the image, (18); the constant is component 0.
    ImageCentered,
}

impl Criterion {
    /// The name in a scene file.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Standard => "standard",
            Self::ImageCentered => "image-centered",
        }
    }
}

/// The effects to include.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Effects {
    /// The effects, by name.
    #[serde(rename = "use")]
    pub wanted: Vec<Effect>,
    /// Whether there are three color channels or one.
    pub color: bool,
    /// Whether the light may rotate at run time.
    pub rotation: bool,
}

impl Effects {
    /// The effects as a set.
    #[must_use]
    pub fn set(&self) -> effect::Effects {
        self.wanted.iter().copied().collect()
    }
}

impl Default for Effects {
    fn default() -> Self {
        Self { wanted: Effect::ALL.to_vec(), color: true, rotation: true }
    }
}
