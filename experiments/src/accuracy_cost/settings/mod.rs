//! The settings that are measured: each a basis, the method of computing a pixel, and the number
//! format. Each parameter varies by itself, and combinations of parameters.

mod list;

pub use list::{DEGREE, ORDER, Varied, all, sizes};

use eigenshade_cli::table;
use eigenshade_index::effect::Effects;
use std::fmt;

/// The part of a basis that is kept; `None` keeps all.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Recipe {
    pub degree: usize,
    pub order: usize,
    pub components: Option<usize>,
    /// The number of modes, by highest variance.
    pub modes: Option<usize>,
    pub effects: Effects,
    /// Where the polynomials are trimmed; `None` keeps each profile to 1e-7.
    pub trim: Option<f64>,
}

impl Recipe {
    /// All components of a degree and an order.
    pub fn all(degree: usize, order: usize) -> Self {
        let (components, modes, trim) = (None, None, None);
        Self { degree, order, components, modes, effects: Effects::ALL, trim }
    }

    /// The first components of a degree and an order.
    pub fn first(degree: usize, order: usize, components: usize) -> Self {
        Self { components: Some(components), ..Self::all(degree, order) }
    }

    /// The same with polynomials trimmed where the total loss is this share of the database's rms.
    pub fn trimmed(self, share: f64) -> Self {
        Self { trim: Some(share), ..self }
    }

    /// Degree and order.
    pub fn size(&self) -> (usize, usize) {
        (self.degree, self.order)
    }
}

/// The method that computes a pixel from coefficients.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Way {
    /// The nine-term formula: a Lambertian material under light of degree 2.
    NineTerms,
    /// Component by component.
    Eigen,
    /// The collapsed polynomials.
    Polynomial,
    /// The collapsed polynomials truncated to a tolerance of the scene, relative to its peak.
    Within(f64),
    /// Bilinear interpolation between four texels of a map of this width.
    Bilinear(usize),
}

/// The number format in which a pixel is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Format {
    F64,
    F32,
    Q31,
    Q15,
}

/// The method that scales normals to unit length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scaling {
    /// None: normals arrive scaled.
    None,
    Libm,
    Single,
    Micromath,
}

/// One value for every parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    pub recipe: Recipe,
    pub way: Way,
    pub format: Format,
    pub scaling: Scaling,
    /// The most small sources of the light whose highlights a pixel adds.
    pub sources: usize,
}

impl Setting {
    /// The collapsed polynomials of a basis in f32.
    pub fn of(recipe: Recipe) -> Self {
        let (way, format, scaling) = (Way::Polynomial, Format::F32, Scaling::None);
        Self { recipe, way, format, scaling, sources: 0 }
    }

    /// The same by another method.
    pub fn by(self, way: Way) -> Self {
        Self { way, ..self }
    }

    /// The same in another number format.
    pub fn in_format(self, format: Format) -> Self {
        Self { format, ..self }
    }
}

impl fmt::Display for Recipe {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let effects = table::effect_names(self.effects).replace(' ', "+");
        let parts = [
            Some(self.components.map_or("all".into(), |count| format!("K{count}"))),
            self.modes.map(|count| format!("modes{count}")),
            (!self.effects.is_all()).then_some(effects),
            self.trim.map(|share| format!("trim{share:e}")),
        ];
        write!(f, "{}/{}", self.degree, self.order)?;
        parts.into_iter().flatten().try_for_each(|part| write!(f, " {part}"))
    }
}

impl fmt::Display for Way {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NineTerms => write!(f, "nine-terms"),
            Self::Eigen => write!(f, "eigen"),
            Self::Polynomial => write!(f, "polynomial"),
            Self::Within(tolerance) => write!(f, "within{tolerance:e}"),
            Self::Bilinear(size) => write!(f, "bilinear{size}"),
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&format!("{self:?}").to_lowercase())
    }
}

/// The setting's name, which identifies it in files and tests.
impl fmt::Display for Setting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {} {}", self.recipe, self.way, self.format)?;
        if self.scaling != Scaling::None {
            write!(f, " {}", format!("{:?}", self.scaling).to_lowercase())?;
        }
        if self.sources > 0 {
            write!(f, " sources{}", self.sources)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_tell_settings_apart() {
        let recipe = Recipe::first(9, 7, 50).trimmed(1e-3);
        let setting = Setting::of(recipe).by(Way::Within(0.01)).in_format(Format::F64);
        assert_eq!(setting.to_string(), "9/7 K50 trim1e-3 within1e-2 f64");
        assert_eq!(Setting::of(Recipe::all(2, 0)).to_string(), "2/0 all polynomial f32");
    }
}
