//! Lights and materials in the runtime's numbers, for source in a programming language.

use crate::messages::printable;
use eigenshade::{Q15, q15};
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::error::{Error, Result};

/// A light or a material.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// L_l^m.
    Light,
    /// b_op^q.
    Material,
}

/// The number format of source.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Format {
    /// Single precision.
    #[default]
    F32,
    /// Integers of 16 bits.
    Q15,
}

/// A light or a material to be written as source.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// Light or material.
    pub kind: Kind,
    /// Its name.
    pub name: String,
    /// Its name as [`identifier`] writes it.
    pub identifier: String,
    /// Degree of a light, order of a material.
    pub size: usize,
    /// The number format of the channels.
    pub format: Format,
    /// Three channels, or one for all three if it is gray.
    pub channels: Vec<Channel>,
}

/// The numbers of one channel.
#[derive(Clone, Debug, PartialEq)]
pub enum Channel {
    /// Coefficients.
    Floats(Vec<f32>),
    /// Coefficients as mantissas times 2 to the power of an exponent: one exponent for a light, one
    /// for each o of a material.
    Integers {
        /// Mantissas.
        mantissas: Vec<i16>,
        /// Exponents.
        exponents: Vec<i32>,
    },
}

impl Kind {
    /// `light` or `material`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Light => "light",
            Self::Material => "material",
        }
    }

    /// The comment on the coefficients: their unit and order.
    #[must_use]
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Light => "L_l^m in radiance; that of l and m is at l * l + l + m",
            Self::Material => "b_op^q in 1/sr, by o, then p, then q",
        }
    }

    /// `degree` or `order`.
    fn size(self) -> &'static str {
        match self {
            Self::Light => "degree",
            Self::Material => "order",
        }
    }
}

impl Entry {
    /// A line for a comment: name and size.
    #[must_use]
    pub fn comment(&self) -> String {
        format!("`{}`, {} {}", printable(&self.name), self.kind.size(), self.size)
    }

    /// Names of the channels.
    #[must_use]
    pub fn channel_names(&self) -> &'static [&'static str] {
        if self.channels.len() == 1 { &["gray"] } else { &["r", "g", "b"] }
    }
}

/// The entries of these lights and materials, in a number format for each, for languages that need
/// identifiers. Fails as [`quoted_entries`] does, and if two names have the same identifier or a
/// name has none.
pub fn entries(lights: &Lights, materials: &Materials, formats: [Format; 2]) -> Result<Vec<Entry>> {
    let all = quoted_entries(lights, materials, formats)?;
    for (place, entry) in all.iter().enumerate() {
        if entry.identifier.is_empty() {
            let remedy = "give it a name with a letter from a to z or a digit";
            let error = Error::new("its name gives no identifier", remedy);
            return Err(error.of(format_args!("{} `{}`", entry.kind.name(), entry.name)));
        }
        let same =
            |other: &&Entry| other.kind == entry.kind && other.identifier == entry.identifier;
        if let Some(other) = all.iter().take(place).find(same) {
            let what = format!("`{}` and `{}` give one identifier", other.name, entry.name);
            return Err(Error::new(what, "rename one of them, or export one with FILE:NAME"));
        }
    }
    Ok(all)
}

/// The entries of these lights and materials, in a number format for each, for languages that quote
/// names. Fails if a coefficient exceeds `f32`.
pub fn quoted_entries(
    lights: &Lights,
    materials: &Materials,
    [of_lights, of_materials]: [Format; 2],
) -> Result<Vec<Entry>> {
    let lights = lights.entries.iter().map(|named| (Kind::Light, lights.degree, named, of_lights));
    let order = materials.order;
    let materials = materials.entries.iter();
    let materials = materials.map(|named| (Kind::Material, order, named, of_materials));
    let all = lights.chain(materials);
    all.map(|(kind, size, named, format)| entry(kind, size, named, format)).collect()
}

/// The letters from a to z and digits of a name in lower case, with `_` between those that others
/// separate.
#[must_use]
pub fn identifier(name: &str) -> String {
    let words = name.split(|letter: char| !letter.is_ascii_alphanumeric());
    words.filter(|word| !word.is_empty()).collect::<Vec<_>>().join("_").to_ascii_lowercase()
}

fn entry(kind: Kind, size: usize, named: &Named, format: Format) -> Result<Entry> {
    let of = |error: Error| error.of(format_args!("{} `{}`", kind.name(), named.name));
    let count = if named.is_gray() { 1 } else { 3 };
    let channels = named.rgb.iter().take(count).map(|numbers| channel(kind, size, numbers, format));
    Ok(Entry {
        kind,
        name: named.name.clone(),
        identifier: identifier(&named.name),
        size,
        format,
        channels: channels.collect::<Result<_>>().map_err(of)?,
    })
}

fn channel(kind: Kind, size: usize, numbers: &[f64], format: Format) -> Result<Channel> {
    let floats: Vec<f32> = numbers.iter().map(|&number| number as f32).collect();
    if let Some(place) = floats.iter().position(|number| !number.is_finite()) {
        let what = format!("coefficient {place} is {:e}, beyond f32", numbers[place]);
        return Err(Error::new(what, "scale it toward 1"));
    }
    if format == Format::F32 {
        return Ok(Channel::Floats(floats));
    }
    let fault = |error: eigenshade::Error| Error::new(error.to_string(), "report it");
    let mut mantissas = vec![Q15(0); floats.len()];
    let exponents = match kind {
        Kind::Light => {
            vec![q15::Light::quantize(&floats, &mut mantissas).map_err(fault)?.exponent()]
        }
        Kind::Material => {
            let mut exponents = vec![0; size + 1];
            q15::Material::quantize(&floats, &mut mantissas, &mut exponents).map_err(fault)?;
            exponents.into_iter().map(i32::from).collect()
        }
    };
    Ok(Channel::Integers { mantissas: mantissas.iter().map(|one| one.0).collect(), exponents })
}
