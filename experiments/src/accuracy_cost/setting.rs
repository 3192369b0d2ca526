//! One setting of all knobs: which basis, which way to a pixel, which numbers.

use eigenshade_cli::table::wire_file;
use eigenshade_index::effect::Effects;
use eigenshade_table::scene;
use std::fmt;

/// What of a basis is kept.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Recipe {
    /// Largest degree l of the light.
    pub degree: usize,
    /// Largest order o of the BRDF.
    pub order: usize,
    /// Number of components; none: all.
    pub components: Option<usize>,
    /// Modes of the highest variance that are kept; none: all.
    pub modes: Option<usize>,
    /// Largest azimuth |m| that is kept; none: all.
    pub azimuths: Option<usize>,
    /// The effects that it is for.
    pub effects: Effects,
    /// Where its polynomials end.
    pub cut: Cut,
}

impl Recipe {
    /// What a scene file says of it as `basis.cut`.
    #[must_use]
    pub fn cuts(&self) -> scene::Cut {
        let (terms, trim) = match self.cut {
            Cut::Whole => (None, None),
            Cut::Terms(count) => (Some(count), None),
            Cut::Trimmed(share) => (None, Some(share)),
        };
        scene::Cut { azimuths: self.azimuths, terms, trim }
    }
}

/// Where a basis's polynomials end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cut {
    /// At 1e-7 of each profile.
    Whole,
    /// After so many terms.
    Terms(usize),
    /// Where this much of the database's rms is lost in all.
    Trimmed(f64),
}

/// The way from coefficients to a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Way {
    /// The nine-term formula: a Lambertian material under light of degree 2.
    NineTerms,
    /// Component by component.
    Eigen,
    /// The collapsed polynomials.
    Polynomial,
    /// Those left within a tolerance of the scene, of its peak.
    Within(f64),
    /// Straight lines between so many knots.
    Linear(usize),
    /// Cubics between so many knots.
    Cubic(usize),
    /// Between four texels of a map so many across.
    Bilinear(usize),
    /// The nearest texel of such a map.
    Nearest(usize),
}

/// The numbers in which a pixel is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// 64 bits, floating.
    F64,
    /// 32 bits, floating.
    F32,
    /// Mantissas of 31 bits.
    Q31,
    /// Mantissas of 15 bits.
    Q15,
}

/// By what a normal that arrives unscaled is scaled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scaling {
    /// Normals arrive scaled.
    None,
    /// `libm`.
    Libm,
    /// `SinglePrecision`.
    Single,
    /// `Tabled`.
    Tabled,
    /// `micromath`.
    Micromath,
}

/// All knobs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// The basis.
    pub recipe: Recipe,
    /// The way to a pixel.
    pub way: Way,
    /// Its numbers.
    pub format: Format,
    /// What normals take.
    pub scaling: Scaling,
}

impl Recipe {
    /// All of a degree and an order.
    #[must_use]
    pub const fn all(degree: usize, order: usize) -> Self {
        let (components, modes, azimuths) = (None, None, None);
        let effects = Effects::ALL;
        Self { degree, order, components, modes, azimuths, effects, cut: Cut::Whole }
    }

    /// The first components of a degree and an order.
    #[must_use]
    pub const fn first(degree: usize, order: usize, components: usize) -> Self {
        Self { components: Some(components), ..Self::all(degree, order) }
    }

    /// With other polynomials.
    #[must_use]
    pub const fn cut(self, cut: Cut) -> Self {
        Self { cut, ..self }
    }
}

impl Setting {
    /// The collapsed polynomials of a basis in f32.
    #[must_use]
    pub const fn of(recipe: Recipe) -> Self {
        Self { recipe, way: Way::Polynomial, format: Format::F32, scaling: Scaling::None }
    }

    /// By another way.
    #[must_use]
    pub const fn by(self, way: Way) -> Self {
        Self { way, ..self }
    }

    /// In other numbers.
    #[must_use]
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
            write!(f, " {}", wire_file::named(self.effects).replace(' ', "+"))?;
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
        f.write_str(match self {
            Self::F64 => "f64",
            Self::F32 => "f32",
            Self::Q31 => "q31",
            Self::Q15 => "q15",
        })
    }
}

impl fmt::Display for Scaling {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::None => "",
            Self::Libm => "libm",
            Self::Single => "single",
            Self::Tabled => "tabled",
            Self::Micromath => "micromath",
        })
    }
}

/// The setting's name, by which files and tests know it.
impl fmt::Display for Setting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {} {}", self.recipe, self.way, self.format)?;
        match self.scaling {
            Scaling::None => Ok(()),
            scaling => write!(f, " {scaling}"),
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
