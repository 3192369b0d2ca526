//! One complete setting: the basis, the method of computing a pixel, and the number format.

use eigenshade_cli::table;
use eigenshade_index::effect::Effects;
use eigenshade_table::scene;
use std::fmt;

/// The part of a basis that is kept.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Recipe {
    /// Largest degree l of the light.
    pub degree: usize,
    /// Largest order o of the BRDF.
    pub order: usize,
    /// Number of components; `None` keeps all.
    pub components: Option<usize>,
    /// Number of modes of the highest variance that are kept; `None` keeps all.
    pub modes: Option<usize>,
    /// Largest azimuth |m| that is kept; `None` keeps all.
    pub azimuths: Option<usize>,
    /// The effects that it includes.
    pub effects: Effects,
    /// Where its polynomials are truncated.
    pub cut: Cut,
}

impl Recipe {
    /// The corresponding `basis.cut` of a scene file.
    pub fn cuts(&self) -> scene::Cut {
        let (terms, trim) = match self.cut {
            Cut::Whole => (None, None),
            Cut::Terms(count) => (Some(count), None),
            Cut::Trimmed(share) => (None, Some(share)),
        };
        scene::Cut { azimuths: self.azimuths, terms, trim }
    }
}

/// Where the polynomials of a basis are truncated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cut {
    /// At 1e-7 of each profile.
    Whole,
    /// After this many terms.
    Terms(usize),
    /// Where the total loss is this share of the database's rms.
    Trimmed(f64),
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
    /// Linear interpolation between this many knots.
    Linear(usize),
    /// Cubic interpolation between this many knots.
    Cubic(usize),
    /// Bilinear interpolation between four texels of a map of this width.
    Bilinear(usize),
    /// The nearest texel of a map of this width.
    Nearest(usize),
}

/// The number format in which a pixel is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    F64,
    F32,
    /// Integers with mantissas of 31 bits.
    Q31,
    /// Integers with mantissas of 15 bits.
    Q15,
}

/// The method that scales normals to unit length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scaling {
    /// None: normals arrive scaled.
    None,
    Libm,
    Single,
    Tabled,
    Micromath,
}

/// One value for every parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    pub recipe: Recipe,
    pub way: Way,
    pub format: Format,
    pub scaling: Scaling,
}

impl Recipe {
    /// All components of a degree and an order.
    pub const fn all(degree: usize, order: usize) -> Self {
        let (components, modes, azimuths) = (None, None, None);
        let effects = Effects::ALL;
        Self { degree, order, components, modes, azimuths, effects, cut: Cut::Whole }
    }

    /// The first components of a degree and an order.
    pub const fn first(degree: usize, order: usize, components: usize) -> Self {
        Self { components: Some(components), ..Self::all(degree, order) }
    }

    /// The same with other polynomials.
    pub const fn cut(self, cut: Cut) -> Self {
        Self { cut, ..self }
    }
}

impl Setting {
    /// The collapsed polynomials of a basis in f32.
    pub const fn of(recipe: Recipe) -> Self {
        Self { recipe, way: Way::Polynomial, format: Format::F32, scaling: Scaling::None }
    }

    /// The same by another method.
    pub const fn by(self, way: Way) -> Self {
        Self { way, ..self }
    }

    /// The same in another number format.
    pub const fn in_format(self, format: Format) -> Self {
        Self { format, ..self }
    }
}

impl fmt::Display for Recipe {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.degree, self.order)?;
        match self.components {
            Some(count) => write!(f, " K{count}")?,
            None => write!(f, " all")?,
        }
        if let Some(modes) = self.modes {
            write!(f, " modes{modes}")?;
        }
        if let Some(azimuths) = self.azimuths {
            write!(f, " m{azimuths}")?;
        }
        if !self.effects.is_all() {
            write!(f, " {}", table::effect_names(self.effects).replace(' ', "+"))?;
        }
        match self.cut {
            Cut::Whole => Ok(()),
            Cut::Terms(count) => write!(f, " terms{count}"),
            Cut::Trimmed(tolerance) => write!(f, " trim{tolerance:e}"),
        }
    }
}

impl fmt::Display for Way {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NineTerms => write!(f, "nine-terms"),
            Self::Eigen => write!(f, "eigen"),
            Self::Polynomial => write!(f, "polynomial"),
            Self::Within(tolerance) => write!(f, "within{tolerance:e}"),
            Self::Linear(knots) => write!(f, "linear{knots}"),
            Self::Cubic(knots) => write!(f, "cubic{knots}"),
            Self::Bilinear(size) => write!(f, "bilinear{size}"),
            Self::Nearest(size) => write!(f, "nearest{size}"),
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
        match self.scaling {
            Scaling::None => Ok(()),
            scaling => write!(f, " {}", format!("{scaling:?}").to_lowercase()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_tell_settings_apart() {
        let recipe = Recipe::first(9, 7, 50).cut(Cut::Trimmed(1e-3));
        let setting = Setting::of(recipe).by(Way::Within(0.01)).in_format(Format::F64);
        assert_eq!(setting.to_string(), "9/7 K50 trim1e-3 within1e-2 f64");
        assert_eq!(Setting::of(Recipe::all(2, 0)).to_string(), "2/0 all polynomial f32");
    }
}
