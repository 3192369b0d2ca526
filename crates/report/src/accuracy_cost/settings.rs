//! The settings that are measured: each a basis, the method of computing a pixel, and the number
//! format. Each parameter varies by itself, and combinations of parameters.

use eigenshade_cli::table;
use eigenshade_table::effect::{Effect, Effects};
use std::fmt;

/// The part of a basis that is kept; `None` keeps all.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Recipe {
    pub degree: usize,
    pub order: usize,
    pub components: Option<usize>,
    pub effects: Effects,
    /// Where the polynomials are trimmed; `None` keeps each profile to 1e-7.
    pub trim: Option<f64>,
}

impl Recipe {
    /// All components of a degree and an order.
    pub fn all(degree: usize, order: usize) -> Self {
        let (components, trim) = (None, None);
        Self { degree, order, components, effects: Effects::ALL, trim }
    }

    /// The first components of a degree and an order.
    pub fn first(degree: usize, order: usize, components: usize) -> Self {
        Self { components: Some(components), ..Self::all(degree, order) }
    }

    /// The same with polynomials trimmed where the total loss is this share of the database's rms.
    pub fn trimmed(self, share: f64) -> Self {
        Self { trim: Some(share), ..self }
    }

    pub fn size(&self) -> (usize, usize) {
        (self.degree, self.order)
    }
}

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

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Format {
    F64,
    F32,
    Q15,
}

/// The method that scales normals to unit length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scaling {
    /// None: normals arrive scaled.
    None,
    /// `Normal::new`.
    Newton,
    /// `Normal::approximate`.
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
    pub window: WindowChoice,
}

/// The window of the light, or of what sources leave of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WindowChoice {
    /// The weakest that leaves no dark rings, as `eigenshade render` chooses it.
    Auto,
    None,
}

impl Setting {
    /// The collapsed polynomials of a basis in f32.
    pub fn of(recipe: Recipe) -> Self {
        let (way, format, scaling) = (Way::Polynomial, Format::F32, Scaling::None);
        Self { recipe, way, format, scaling, sources: 0, window: WindowChoice::Auto }
    }

    pub fn by(self, way: Way) -> Self {
        Self { way, ..self }
    }

    pub fn in_format(self, format: Format) -> Self {
        Self { format, ..self }
    }
}

impl fmt::Display for Recipe {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let effects = table::effect_names(self.effects).replace(' ', "+");
        let parts = [
            Some(self.components.map_or("all".into(), |count| format!("K{count}"))),
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
        if self.window == WindowChoice::None {
            write!(f, " no-window")?;
        }
        Ok(())
    }
}

/// Degree and order of the shipped set, at which all other parameters are varied.
pub const DEGREE: usize = 9;
pub const ORDER: usize = 7;
/// Degrees and orders of the measured materials, below the shipped ones.
const LOWER: [(usize, usize); 8] = [(1, 0), (2, 0), (2, 2), (3, 2), (4, 3), (5, 4), (6, 5), (7, 6)];
/// The highest degree and order of the runtime, for materials given by formulas.
const HIGH: (usize, usize) = (12, 12);
/// Degrees and orders beyond the runtime, in f64.
const BEYOND: [(usize, usize); 3] = [(16, 16), (24, 24), (32, 32)];
/// The largest number of components that a basis beyond the shipped order keeps.
const HIGH_COMPONENTS: usize = 400;
const QUICK_SOURCES: usize = 4;

/// A setting and the parameter that it varies, by its name in the file.
#[derive(Clone, Debug, PartialEq)]
pub struct Varied {
    pub parameter: &'static str,
    pub setting: Setting,
}

/// The degrees and orders, in rising order.
pub fn sizes() -> impl Iterator<Item = (usize, usize)> {
    LOWER.into_iter().chain([(DEGREE, ORDER), HIGH]).chain(BEYOND)
}

/// The settings, or a part of them. A new parameter is a field of [`Setting`] or [`Recipe`].
pub fn all(quick: bool) -> Vec<Varied> {
    let mut found: Vec<Varied> = Vec::new();
    let mut add = |parameter: &'static str, setting: Setting| {
        if !found.iter().any(|other| other.setting == setting) {
            found.push(Varied { parameter, setting });
        }
    };
    let whole = Recipe::all(DEGREE, ORDER);
    let first = |count: usize| Recipe::first(DEGREE, ORDER, count);
    let trimmed = |recipe: Recipe, share: f64| Setting::of(recipe.trimmed(share));
    // All values of a parameter, or the second list in a quick run.
    fn either<'a, T: Copy>(quick: bool, all: &'a [T], few: &'a [T]) -> impl Iterator<Item = T> {
        if quick { few } else { all }.iter().copied()
    }
    add("nine terms", Setting::of(Recipe::all(2, 0)).by(Way::NineTerms));
    for format in [Format::F32, Format::Q15] {
        add("degree and order", Setting::of(Recipe::all(2, 0)).in_format(format));
    }
    for count in either(quick, &[1, 4, 9, 16, 25, 36, 50, 75, 100, 130, 160], &[9, 25, 50, 130]) {
        add("components", Setting::of(first(count)));
    }
    add("components", Setting::of(whole));
    add("format", Setting::of(whole).in_format(Format::F64));
    // Beyond 130, the weakest profiles are larger than integers can represent.
    for count in either(quick, &[25, 50, 100, 130], &[50]) {
        for format in [Format::F64, Format::Q15] {
            add("format", Setting::of(first(count)).in_format(format));
        }
    }
    // The table that firmware/tables/full.toml and its build script make.
    for format in [Format::F32, Format::Q15] {
        add("polynomials", trimmed(first(130), 2e-4).in_format(format));
    }
    for count in either(quick, &[4, 9, 16, 25, 50, 100, 130], &[25, 50]) {
        for share in either(quick, &[0.3, 0.1, 0.03, 1e-2, 3e-3, 1e-3, 1e-4], &[0.1, 1e-2]) {
            add("polynomials", trimmed(first(count), share));
        }
    }
    // More tables whose pixel and new light are counted on boards without a float unit.
    let counted = [(9, 0.1), (25, 0.03), (50, 1e-2), (100, 1e-2), (130, 1e-3)];
    for (count, share) in either(quick, &counted, &counted[1..2]) {
        add("polynomials", trimmed(first(count), share).in_format(Format::Q15));
    }
    for setting in [Setting::of(first(50)), trimmed(first(130), 2e-4)] {
        let shares = [0.3, 0.1, 0.03, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 1e-5];
        for share in either(quick, &shares, &[0.1, 1e-2, 1e-4]) {
            add("tolerance", setting.by(Way::Within(share)));
        }
    }
    // Without highlights: order 3; then also without rim and roughness: order 0; then only uniform
    // light: degree 0.
    let ambient = Effects::NONE.with(Effect::Ambient);
    let matte = ambient.with(Effect::Diffuse);
    for effects in [matte.with(Effect::Broad), matte, ambient] {
        add("effects", Setting::of(Recipe { effects, ..whole }));
    }
    for size in either(quick, &[8, 16, 32, 64, 128], &[16, 32]) {
        let few = Setting::of(first(50));
        for setting in [Setting::of(whole), few, few.in_format(Format::Q15)] {
            add("baked maps", setting.by(Way::Bilinear(size)));
        }
    }
    for format in [Format::F32, Format::Q15] {
        add("baked maps", higher().by(Way::Bilinear(32)).in_format(format));
    }
    add("component by component", Setting::of(first(50)).by(Way::Eigen));
    for scaling in [Scaling::Newton, Scaling::Micromath] {
        add("mathematics", Setting { scaling, ..Setting::of(first(50)) });
    }
    for (degree, order) in LOWER {
        let recipe = Recipe::all(degree, order);
        add("degree and order", Setting::of(recipe));
        for share in either(quick, &[1e-2, 1e-3], &[1e-2]) {
            add("degree and order", trimmed(recipe, share));
        }
    }
    let counts = SOURCE_COUNTS.into_iter();
    for sources in counts.filter(|count| !quick || *count == QUICK_SOURCES) {
        for setting in with_sources() {
            add("sources", Setting { sources, ..setting });
        }
    }
    for setting in [Setting::of(whole), higher()] {
        for sources in either(quick, &[0, 4, 8], &[0, 4]) {
            add("window", Setting { sources, window: WindowChoice::None, ..setting });
        }
    }
    add("degree and order", higher());
    add("degree and order", higher().in_format(Format::F64));
    for share in either(quick, &[1e-2, 1e-3], &[1e-2]) {
        let setting = trimmed(higher().recipe, share);
        add("degree and order", setting);
        add("degree and order", setting.by(Way::Within(share)));
    }
    for (degree, order) in BEYOND {
        let recipe = Recipe::first(degree, order, HIGH_COMPONENTS);
        add("degree and order", Setting::of(recipe).in_format(Format::F64));
    }
    found
}

/// The highest degree and order of the runtime.
fn higher() -> Setting {
    Setting::of(Recipe::first(HIGH.0, HIGH.1, HIGH_COMPONENTS))
}

/// Numbers of sources.
const SOURCE_COUNTS: [usize; 5] = [1, 2, 4, 8, 16];

/// The settings that sources are added to: the nine-term formula, tables whose pixels are counted
/// on boards, and all that a degree and an order have.
fn with_sources() -> impl Iterator<Item = Setting> {
    let of = |count, share| Setting::of(Recipe::first(DEGREE, ORDER, count).trimmed(share));
    let whole = Setting::of(Recipe::all(DEGREE, ORDER));
    let few = Setting::of(Recipe::first(DEGREE, ORDER, 50));
    let higher = higher();
    let trimmed = Setting { recipe: higher.recipe.trimmed(1e-2), ..higher };
    let baked = Way::Bilinear(32);
    let in_floats = [
        Setting::of(Recipe::all(2, 0)).by(Way::NineTerms),
        of(9, 1e-1),
        of(25, 3e-2),
        of(50, 1e-2),
        few,
        of(130, 2e-4),
        whole,
        whole.by(baked),
        higher,
        trimmed,
        trimmed.by(Way::Within(1e-2)),
        higher.by(baked),
    ];
    let in_integers =
        [of(9, 1e-1), of(25, 3e-2), of(50, 1e-2), of(130, 2e-4), few.by(baked), higher.by(baked)];
    let in_integers = in_integers.map(|setting| setting.in_format(Format::Q15));
    in_floats.into_iter().chain(in_integers)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;
    use std::mem::discriminant;

    #[test]
    fn names_tell_settings_apart() {
        let recipe = Recipe::first(9, 7, 50).trimmed(1e-3);
        let setting = Setting::of(recipe).by(Way::Within(0.01)).in_format(Format::F64);
        assert_eq!(setting.to_string(), "9/7 K50 trim1e-3 within1e-2 f64");
        assert_eq!(Setting::of(Recipe::all(2, 0)).to_string(), "2/0 all polynomial f32");
    }

    /// The kind of a setting, ignoring sizes.
    fn kind(Varied { parameter, setting }: &Varied) -> impl PartialEq + std::fmt::Debug {
        let recipe = setting.recipe;
        let parts = recipe.components.is_some();
        let forms = (discriminant(&setting.way), recipe.trim.is_some(), setting.window);
        let format = (setting.format, setting.scaling, setting.sources > 0);
        (*parameter, parts, recipe.effects == Effects::ALL, forms, format)
    }

    #[test]
    fn a_quick_run_has_every_kind_and_every_degree() {
        let (quick, all) = (all(true), all(false));
        let size = |one: &Varied| one.setting.recipe.size();
        for one in &all {
            let name = one.setting;
            assert!(quick.iter().any(|other| kind(other) == kind(one)), "none is like `{name}`");
            assert!(quick.iter().any(|other| size(other) == size(one)), "no size of `{name}`");
        }
        assert!(quick.len() < all.len() / 2);
    }

    #[test]
    fn each_setting_is_there_once_and_quick_ones_are_among_all() {
        let names = |quick| -> Vec<String> {
            all(quick).iter().map(|one| one.setting.to_string()).collect()
        };
        let (quick, all) = (names(true), names(false));
        let set: BTreeSet<&String> = all.iter().collect();
        assert_eq!(set.len(), all.len());
        assert!(quick.iter().all(|name| set.contains(name)), "{quick:?}");
        for mathematics in ["newton", "micromath"] {
            let name = format!("9/7 K50 polynomial f32 {mathematics}");
            assert!(quick.contains(&name), "{name}");
        }
    }
}
