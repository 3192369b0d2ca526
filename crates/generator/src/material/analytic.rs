//! Analytic materials, read from a TOML file.
//!
//! ```toml
//! [[material]]
//! name = "red-plastic"
//! model = "ggx"             # or "lambertian", "oren-nayar"
//! roughness = 0.4           # ggx
//! f0 = 0.04                 # ggx: a number, or [r, g, b], linear, or "#b87333" in sRGB
//! albedo = [0.7, 0.1, 0.1]  # all three: the same; 0 for ggx if left out
//! # sigma = 0.3             # oren-nayar, radians
//! ```

use crate::material::brdf::{Brdf, Ggx, Lambertian, OrenNayar, Surface};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::source::Gloss;
use eigenshade_model::srgb::from_hex;
use eigenshade_table::highlights::DIELECTRIC;
use serde::Deserialize;
use std::collections::HashSet;
use std::str::FromStr;

/// Maximum size of a material file, in bytes.
const LONGEST: u64 = 1 << 22;

/// A model and its parameters.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Analytic {
    /// Name of the material.
    pub name: String,
    /// The BRDF formula.
    pub model: Model,
    /// Fraction of light that the matte part reflects.
    #[serde(default)]
    pub albedo: Option<Shares>,
    /// Oren and Nayar's σ, radians.
    #[serde(default)]
    pub sigma: Option<f64>,
    /// GGX's perceptual roughness.
    #[serde(default)]
    pub roughness: Option<f64>,
    /// GGX's reflectance at normal incidence.
    #[serde(default)]
    pub f0: Option<Shares>,
}

/// The BRDF formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Model {
    /// [`Lambertian`].
    Lambertian,
    /// [`OrenNayar`].
    OrenNayar,
    /// [`Ggx`].
    Ggx,
}

/// A number for all channels, or one for each channel; linear. It can also be written
/// as a hexadecimal sRGB code.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(try_from = "Written")]
pub enum Shares {
    /// The same value in all channels.
    Gray(f64),
    /// Values for r, g and b.
    Rgb([f64; 3]),
}

/// Shares as a file has them.
#[derive(Deserialize)]
#[serde(untagged, expecting = "a share is a number, [r, g, b], or \"#b87333\" in sRGB")]
enum Written {
    Gray(f64),
    Rgb([f64; 3]),
    Hex(String),
}

impl TryFrom<Written> for Shares {
    type Error = String;

    fn try_from(written: Written) -> std::result::Result<Self, String> {
        match written {
            Written::Gray(value) => Ok(Self::Gray(value)),
            Written::Rgb(rgb) => Ok(Self::Rgb(rgb)),
            Written::Hex(text) => from_hex(&text).map(Self::Rgb),
        }
    }
}

impl FromStr for Shares {
    type Err = String;

    /// A number, three with commas between them, or a hexadecimal sRGB code.
    fn from_str(text: &str) -> std::result::Result<Self, String> {
        if text.starts_with('#') {
            return from_hex(text).map(Self::Rgb);
        }
        let numbers = text.split(',').map(|field| field.trim().parse().ok());
        match numbers.collect::<Option<Vec<f64>>>().as_deref() {
            Some(&[gray]) => Ok(Self::Gray(gray)),
            Some(&[r, g, b]) => Ok(Self::Rgb([r, g, b])),
            _ => Err("expected a number, three: r,g,b, or '#b87333'".to_owned()),
        }
    }
}

impl Shares {
    /// The same with each value changed.
    #[must_use]
    pub fn map(self, of: impl Fn(f64) -> f64) -> Self {
        match self {
            Self::Gray(value) => Self::Gray(of(value)),
            Self::Rgb(rgb) => Self::Rgb(rgb.map(of)),
        }
    }

    fn channel(self, channel: usize) -> f64 {
        match self {
            Self::Gray(value) => value,
            Self::Rgb(rgb) => rgb[channel],
        }
    }

    fn is_gray(self) -> bool {
        match self {
            Self::Gray(_) => true,
            Self::Rgb([r, g, b]) => r == g && g == b,
        }
    }
}

impl Analytic {
    /// A glTF metallic-roughness material: a GGX lobe over a matte base. `metallic`, from 0 to 1,
    /// mixes a dielectric with a metal of the base color.
    #[must_use]
    pub fn gltf(name: impl Into<String>, base: Shares, metallic: f64, roughness: f64) -> Self {
        Self {
            name: name.into(),
            model: Model::Ggx,
            albedo: Some(base.map(|base| base * (1.0 - metallic))),
            sigma: None,
            roughness: Some(roughness),
            f0: Some(base.map(|base| DIELECTRIC + (base - DIELECTRIC) * metallic)),
        }
    }

    /// The BRDF functions of the material.
    ///
    /// # Errors
    ///
    /// If a parameter is missing, does not belong to the model, or is out of range.
    pub fn surface(&self) -> Result<Surface> {
        let given = [
            ("sigma", self.sigma.is_some(), self.model == Model::OrenNayar),
            ("roughness", self.roughness.is_some(), self.model == Model::Ggx),
            ("f0", self.f0.is_some(), self.model == Model::Ggx),
            ("albedo", self.albedo.is_some() || self.model == Model::Ggx, true),
        ];
        let name = &self.name;
        if let Some((what, is_given, _)) =
            given.into_iter().find(|(_, is_given, is_wanted)| is_given != is_wanted)
        {
            let fault = if is_given { "has no parameter" } else { "needs a parameter" };
            let (model, remedy) = (self.model, if is_given { "leave it out" } else { "give it" });
            return Err(Error::new(
                format!("`{name}`: the model {model:?} {fault} `{what}`"),
                remedy,
            ));
        }
        let of =
            |channel| self.channel(channel).map_err(|error| error.of(format_args!("`{name}`")));
        let gray = [self.albedo, self.f0].into_iter().flatten().all(Shares::is_gray);
        let surface = if gray {
            Surface::gray(name.clone(), of(0)?)
        } else {
            Surface::colored(name.clone(), [of(0)?, of(1)?, of(2)?])
        };
        Ok(match self.gloss() {
            Some(gloss) => surface.with_gloss(gloss),
            None => surface,
        })
    }

    /// The lobe over a matte base that the material exactly is.
    fn gloss(&self) -> Option<Gloss> {
        let rgb = |shares: Option<Shares>| {
            [0, 1, 2].map(|c: usize| shares.map_or(0.0, |shares| shares.channel(c)))
        };
        let (reflectance, albedo) = (rgb(self.f0), rgb(self.albedo));
        let (roughness, grazing) = match self.model {
            Model::Ggx => (self.roughness?, [1.0; 3]),
            Model::Lambertian => (1.0, [0.0; 3]),
            Model::OrenNayar => return None,
        };
        Some(Gloss { roughness, reflectance, grazing, albedo })
    }

    fn channel(&self, channel: usize) -> Result<Box<dyn Brdf>> {
        let share = |shares: Option<Shares>| shares.map_or(0.0, |shares| shares.channel(channel));
        let albedo = share(self.albedo);
        Ok(match self.model {
            Model::Lambertian => Box::new(Lambertian::new(albedo)?),
            Model::OrenNayar => Box::new(OrenNayar::new(albedo, self.sigma.unwrap_or(0.0))?),
            Model::Ggx => {
                Box::new(Ggx::new(self.roughness.unwrap_or(0.0), share(self.f0), albedo)?)
            }
        })
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(default)]
    material: Vec<Analytic>,
}

/// Reads the materials of a file.
///
/// # Errors
///
/// If the file cannot be read or is longer than 4 MiB; a field is unknown, missing, of the wrong
/// type or out of range; a name is empty or occurs twice; or there is no material.
pub fn read(file: impl Into<InputFile>) -> Result<Vec<Surface>> {
    let file = file.into();
    let path = file.path();
    let bytes = std::fs::metadata(path).map_err(|error| Error::io(path, &error))?.len();
    if bytes > LONGEST {
        return Err(Error::new(
            format!("it has {bytes} bytes, too many for a list of materials"),
            format!("give at most {LONGEST}"),
        )
        .in_file(path));
    }
    let text = file.text()?;
    let file: File = toml::from_str(&text).map_err(|error| {
        let what = error.message().lines().next().unwrap_or("no list of materials").to_owned();
        let fault = Error::new(what, "see tables/README.md for the fields of a material");
        match error.span() {
            Some(span) => fault.at_line(path, 1 + text[..span.start].matches('\n').count() as u64),
            None => fault.in_file(path),
        }
    })?;
    let mut names = HashSet::new();
    for Analytic { name, .. } in &file.material {
        if name.is_empty() || !names.insert(name) {
            return Err(Error::new(
                format!("the name `{name}` is empty or occurs twice"),
                "give every material its own name",
            )
            .in_file(path));
        }
    }
    if file.material.is_empty() {
        return Err(Error::new("it contains no material", "add a table [[material]]").in_file(path));
    }
    file.material.iter().map(|one| one.surface().map_err(|error| error.in_file(path))).collect()
}
