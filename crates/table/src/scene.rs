//! The scene file: what a basis is to be made for.

use eigenshade_index::effect;
pub use eigenshade_index::effect::Effect;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fmt;

/// A whole scene file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scene {
    /// Which normals the object shows.
    pub geometry: Geometry,
    /// Which light falls on it.
    pub light: Light,
    /// What it is made of.
    pub material: Material,
    /// Which basis is wanted.
    pub basis: Basis,
    /// Which effects are wanted.
    #[serde(default)]
    pub effects: Effects,
}

impl Scene {
    /// The largest degree l of the light that the scene's effects take.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.effects.set().degree(self.light.degree)
    }

    /// The largest order o of the BRDF that the scene's effects take.
    #[must_use]
    pub fn order(&self) -> usize {
        self.effects.set().order(self.material.order)
    }
}

/// Which normals the object shows.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Geometry {
    /// `sphere`; `slant-density`; or a path: normals as CSV, a mesh, a normal map.
    pub normals: String,
    /// Of a normal map: an image of the same size, black where it is not to count.
    #[serde(default)]
    pub mask: Option<String>,
    /// Of `slant-density`: a formula in the slant `a`, or a path to a CSV of it; per
    /// solid angle, of any scale.
    #[serde(default)]
    pub density: Option<String>,
}

/// Which light falls on the object.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Light {
    /// Degree to which the light is taken.
    pub degree: usize,
    /// Light CSV, relative to the scene file.
    pub database: String,
    /// Which rotations of the captured light are to be expected.
    pub rotation: LightRotation,
    /// How the lights' exposures are made comparable, for the statistics alone.
    #[serde(default)]
    pub normalise: Normalise,
    /// How much lights count in the statistics, by name; 1 where nothing is said.
    #[serde(default)]
    pub weights: BTreeMap<String, f64>,
}

/// Which rotations of the captured light are to be expected.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum LightRotation {
    /// All rotations alike, (37)-(39).
    Any,
    /// As captured.
    None,
    /// All rotations about the vertical axis y alike.
    Vertical,
}

/// How the lights' exposures are made comparable, for the statistics alone.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Normalise {
    /// Each light is scaled to luminance coefficient L_0^0 = 1.
    #[default]
    UnitAmbient,
    /// Lights are taken as they come.
    None,
}

/// What the object is made of.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Order to which the BRDF is taken.
    pub order: usize,
    /// Material CSV, relative to the scene file.
    pub database: String,
    /// The materials that are meant; empty: all.
    #[serde(default)]
    pub names: Vec<String>,
    /// How much materials count in the statistics, by name; 1 where nothing is said.
    #[serde(default)]
    pub weights: BTreeMap<String, f64>,
}

/// Which basis is wanted.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Basis {
    /// What the principal components maximise.
    pub criterion: Criterion,
    /// Number of components, the constant of [`Criterion::ImageCentered`]
    /// counted. Either this or `tolerance`.
    #[serde(default)]
    pub components: Option<usize>,
    /// Rms error that truncation may cost, of the peak. Either this or
    /// `components`.
    #[serde(default)]
    pub tolerance: Option<f64>,
    /// Keep so many modes, those of the highest variance; 0: all.
    #[serde(default)]
    pub modes: usize,
    /// Singular values below this, relative to the largest of all blocks, count
    /// as zero.
    #[serde(default = "default_rank_cutoff")]
    pub rank_cutoff: f64,
    /// Largest error of a profile's polynomial, relative to the profile's
    /// largest value; it sets the degrees.
    #[serde(default = "default_profile_tolerance")]
    pub profile_tolerance: f64,
    /// How much of the basis the table keeps.
    #[serde(default)]
    pub store: Store,
    /// Knots of look-ups: what the generated code samples an image at. None: it has no look-ups.
    #[serde(default)]
    pub knots: Option<usize>,
    /// What the table does without, beside the components after the last; not with `tolerance`.
    #[serde(default)]
    pub cut: Option<Cut>,
}

/// What `knots` may be, as in the runtime.
pub const KNOTS: std::ops::RangeInclusive<usize> = 8..=65_536;

fn default_rank_cutoff() -> f64 {
    1e-10
}

fn default_profile_tolerance() -> f64 {
    1e-7
}

/// What a table does without, beside components after the last; nothing by default.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Cut {
    /// Largest |m| of a component.
    pub azimuths: Option<usize>,
    /// Most terms of a polynomial: its Chebyshev series ends there.
    pub terms: Option<usize>,
    /// What the polynomials may lack in all, of the images' root mean square deviation from
    /// their means: see [`trim`](crate::trim::trim).
    pub trim: Option<f64>,
}

impl Cut {
    /// What is out of range, and what to do about it, if anything is.
    #[must_use]
    pub fn fault(&self) -> Option<(String, &'static str)> {
        match (self.terms, self.trim) {
            (Some(0), _) => Some(("basis.cut.terms = 0".into(), "ask for at least one")),
            (_, Some(share)) if !(share > 0.0 && share < 1.0) => {
                Some((format!("basis.cut.trim = {share}"), "set it between 0 and 1"))
            }
            _ => None,
        }
    }
}

impl fmt::Display for Cut {
    /// As `azimuths to 4, polynomials of 12 terms, trimmed to 3e-2`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let parts = [
            self.azimuths.map(|azimuths| format!("azimuths to {azimuths}")),
            self.terms.map(|terms| format!("polynomials of {terms} terms")),
            self.trim.map(|share| format!("trimmed to {share:e}")),
        ];
        f.write_str(&parts.into_iter().flatten().collect::<Vec<_>>().join(", "))
    }
}

/// How much of the basis a table keeps. What it does not keep, its scene makes again.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Store {
    /// All of it: U over modes, the factors of UᵀM, the factor of M.
    #[default]
    Modes,
    /// Without U over modes: what projects any material.
    Projection,
    /// The transfers of the scene's materials, instead of the factors of UᵀM and of M:
    /// at high order far less, where materials are few.
    Materials,
}

impl Store {
    /// The name that the scene file uses.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Modes => "modes",
            Self::Projection => "projection",
            Self::Materials => "materials",
        }
    }
}

/// What the principal components maximise.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Criterion {
    /// Variance over light and material, (17): images are the mean image and what
    /// differs from it. What all of the database have in common, like the exposure
    /// of one material, is then in no component.
    Standard,
    /// Variance in the image, (18); the constant is component 0.
    ImageCentered,
}

impl Criterion {
    /// The name that the scene file uses.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Standard => "standard",
            Self::ImageCentered => "image-centered",
        }
    }
}

/// Which effects are wanted.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Effects {
    /// The effects by name.
    #[serde(rename = "use")]
    pub wanted: Vec<Effect>,
    /// Three channels, or one.
    pub colour: bool,
    /// Whether the light may turn at run time.
    pub rotation: bool,
}

impl Effects {
    /// The wanted effects as a set.
    #[must_use]
    pub fn set(&self) -> effect::Effects {
        self.wanted.iter().copied().collect()
    }
}

impl Default for Effects {
    fn default() -> Self {
        Self { wanted: Effect::ALL.to_vec(), colour: true, rotation: true }
    }
}
