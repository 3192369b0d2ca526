//! The settings that are measured: each parameter varied by itself, and combinations of parameters.

use super::setting::{Cut, Format, Recipe, Scaling, Setting, Way};
use eigenshade_index::effect::{Effect, Effects};

/// Degree and order of the shipped set, at which all other parameters are varied.
pub const DEGREE: usize = 9;
/// See [`DEGREE`].
pub const ORDER: usize = 7;
/// Degrees and orders of the measured materials, below the shipped ones.
pub const LOWER: [(usize, usize); 8] =
    [(1, 0), (2, 0), (2, 2), (3, 2), (4, 3), (5, 4), (6, 5), (7, 6)];
/// Higher degrees and orders, for materials given by formulas.
pub const HIGHER: [(usize, usize); 4] = [(12, 12), (16, 16), (24, 24), (32, 32)];
/// The largest number of components that a basis beyond the shipped order keeps.
pub const HIGH_COMPONENTS: usize = 400;

/// A setting and the parameter that it varies.
#[derive(Clone, Debug, PartialEq)]
pub struct Knob {
    /// The name of the parameter in the file.
    pub knob: &'static str,
    /// The setting.
    pub setting: Setting,
}

/// The settings, or a part of them with `quick`. To add a parameter, add a field to [`Setting`] or
/// its recipe, and a row here.
#[must_use]
pub fn settings(quick: bool) -> Vec<Knob> {
    let mut found: Vec<Knob> = Vec::new();
    let mut add = |knob: &'static str, setting: Setting| {
        if !found.iter().any(|other| other.setting == setting) {
            found.push(Knob { knob, setting });
        }
    };
    let all = Recipe::all(DEGREE, ORDER);
    let first = |count: usize| Recipe::first(DEGREE, ORDER, count);
    let few = |values: &[usize], taken: &[usize]| -> Vec<usize> {
        if quick { taken.to_vec() } else { values.to_vec() }
    };
    add("nine terms", Setting::of(Recipe::all(2, 0)).by(Way::NineTerms));
    for format in [Format::F32, Format::Q31, Format::Q15] {
        add("degree and order", Setting::of(Recipe::all(2, 0)).in_format(format));
    }
    for count in few(&[1, 4, 9, 16, 25, 36, 50, 75, 100, 130, 160], &[9, 25, 50, 130]) {
        add("components", Setting::of(first(count)));
    }
    add("components", Setting::of(all));
    add("format", Setting::of(all).in_format(Format::F64));
    // Beyond that, the weakest profiles are larger than integers can represent.
    for count in few(&[25, 50, 100, 130], &[50]) {
        for format in [Format::F64, Format::Q31, Format::Q15] {
            add("format", Setting::of(first(count)).in_format(format));
        }
    }
    // The table that firmware/tables/full.toml and its build script make.
    for format in [Format::F32, Format::Q31, Format::Q15] {
        let recipe = first(130).cut(Cut::Trimmed(2e-4));
        add("polynomials", Setting::of(recipe).in_format(format));
    }
    let trims: &[f64] =
        if quick { &[0.1, 1e-2] } else { &[0.3, 0.1, 0.03, 1e-2, 3e-3, 1e-3, 1e-4] };
    for count in few(&[4, 9, 16, 25, 50, 100, 130], &[25, 50]) {
        for &tolerance in trims {
            add("polynomials", Setting::of(first(count).cut(Cut::Trimmed(tolerance))));
        }
    }
    // The tables whose pixel and new light are counted on boards without a float unit, in addition
    // to those above: firmware/tables/ladder.csv.
    let counted = [(9, 0.1), (25, 0.03), (50, 1e-2), (100, 1e-2), (130, 1e-3)];
    for (count, tolerance) in if quick { &counted[1..2] } else { &counted[..] }.iter().copied() {
        let recipe = first(count).cut(Cut::Trimmed(tolerance));
        add("polynomials", Setting::of(recipe).in_format(Format::Q15));
    }
    let within: &[f64] = if quick {
        &[0.1, 1e-2, 1e-4]
    } else {
        &[0.3, 0.1, 0.03, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 1e-5]
    };
    // The starting points for a tolerance.
    let trimmed = first(130).cut(Cut::Trimmed(2e-4));
    for recipe in [first(50), trimmed] {
        for &tolerance in within {
            add("tolerance", Setting::of(recipe).by(Way::Within(tolerance)));
        }
    }
    for count in few(&[2, 3, 4, 6, 8, 10, 12, 16], &[4, 8]) {
        add("degree of polynomials", Setting::of(all.cut(Cut::Terms(count))));
    }
    for azimuths in few(&[0, 1, 2, 3, 4, 5, 6, 7, 8], &[1, 4]) {
        add("azimuths", Setting::of(Recipe { azimuths: Some(azimuths), ..all }));
    }
    for modes in few(&[250, 500, 1000, 2000], &[1000]) {
        add("modes", Setting::of(Recipe { modes: Some(modes), ..all }));
    }
    // Without highlights; then also without rim and roughness; then only uniform light.
    let matte = Effects::NONE.with(Effect::Ambient).with(Effect::Diffuse);
    for effects in [
        matte.with(Effect::Broad),
        matte,
        Effects::NONE.with(Effect::Ambient),
        Effects::ALL.without(Effect::Ambient),
    ] {
        add("effects", Setting::of(Recipe { effects, ..all }));
    }
    for knots in few(&[8, 16, 32, 64, 128], &[16, 64]) {
        for way in [Way::Linear(knots), Way::Cubic(knots)] {
            add("look-ups", Setting::of(all).by(way));
            add("look-ups", Setting::of(first(50)).by(way));
        }
    }
    for size in few(&[8, 16, 32, 64, 128], &[16, 32]) {
        for way in [Way::Bilinear(size), Way::Nearest(size)] {
            add("baked maps", Setting::of(all).by(way));
        }
        add("baked maps", Setting::of(first(50)).by(Way::Bilinear(size)));
        add("baked maps", Setting::of(first(50)).by(Way::Bilinear(size)).in_format(Format::Q15));
    }
    add("component by component", Setting::of(first(50)).by(Way::Eigen));
    for scaling in [Scaling::Libm, Scaling::Single, Scaling::Tabled, Scaling::Micromath] {
        add("mathematics", Setting { scaling, ..Setting::of(first(50)) });
    }
    for (degree, order) in LOWER {
        add("degree and order", Setting::of(Recipe::all(degree, order)));
        for tolerance in if quick { &[1e-2][..] } else { &[1e-2, 1e-3] }.iter().copied() {
            let recipe = Recipe::all(degree, order).cut(Cut::Trimmed(tolerance));
            add("degree and order", Setting::of(recipe));
        }
    }
    for (degree, order) in HIGHER {
        let recipe = Recipe::first(degree, order, HIGH_COMPONENTS);
        add("degree and order", Setting::of(recipe));
        // A quick run has all kinds at the first of these sizes, and one setting at the others.
        if quick && (degree, order) != HIGHER[0] {
            continue;
        }
        add("degree and order", Setting::of(recipe).in_format(Format::F64));
        for tolerance in if quick { &[1e-2][..] } else { &[1e-2, 1e-3] }.iter().copied() {
            let recipe = recipe.cut(Cut::Trimmed(tolerance));
            add("degree and order", Setting::of(recipe));
            add("degree and order", Setting::of(recipe).by(Way::Within(tolerance)));
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::{Knob, settings};
    use eigenshade_index::effect::Effects;
    use std::collections::BTreeSet;
    use std::mem::discriminant;

    /// The kind of a setting, ignoring sizes.
    fn kind(Knob { knob, setting }: &Knob) -> impl PartialEq + std::fmt::Debug {
        let recipe = setting.recipe;
        let parts = [recipe.components, recipe.modes, recipe.azimuths].map(|part| part.is_some());
        let forms = (discriminant(&setting.way), discriminant(&recipe.cut));
        (*knob, parts, recipe.effects == Effects::ALL, forms, setting.format, setting.scaling)
    }

    #[test]
    fn a_quick_run_has_every_kind_and_every_degree() {
        let (quick, all) = (settings(true), settings(false));
        for knob in &all {
            let alike = |other: &Knob| kind(other) == kind(knob);
            assert!(quick.iter().any(alike), "no quick setting is like `{}`", knob.setting);
            let size = |knob: &Knob| (knob.setting.recipe.degree, knob.setting.recipe.order);
            let sized = |other: &Knob| size(other) == size(knob);
            assert!(
                quick.iter().any(sized),
                "no quick setting is of the size of `{}`",
                knob.setting
            );
        }
    }

    #[test]
    fn each_setting_is_there_once_and_quick_ones_are_among_all() {
        let names = |quick| -> Vec<String> {
            settings(quick).iter().map(|knob| knob.setting.to_string()).collect()
        };
        let (quick, all) = (names(true), names(false));
        let set: BTreeSet<&String> = all.iter().collect();
        assert_eq!(set.len(), all.len());
        assert!(quick.iter().all(|name| set.contains(name)), "{quick:?}");
        assert!(quick.len() < all.len() / 2);
        for mathematics in ["libm", "single", "tabled", "micromath"] {
            let name = format!("9/7 K50 polynomial f32 {mathematics}");
            assert!(quick.contains(&name), "{name}");
        }
    }
}
