//! Times of the WebAssembly module in Node, from `crates/wasm/times.csv`, for the tables that
//! `crates/wasm/ladder` puts into modules.

use super::machines::compiled_in;
use super::setting::{Cut, Format, Recipe, Scaling, Setting, Way};
use super::settings::{DEGREE, ORDER};
use super::sheet::Record;
use eigenshade_model::error::{Error, Result};
use std::collections::BTreeMap;

/// Texels along a side of the module's map.
const MAP: usize = 32;

/// The tables that are put into modules.
pub fn tables() -> Vec<Recipe> {
    let first = |count| Recipe::first(DEGREE, ORDER, count);
    let trimmed = |count, tolerance| first(count).cut(Cut::Trimmed(tolerance));
    vec![
        Recipe::all(2, 0),
        trimmed(9, 1e-1),
        trimmed(25, 3e-2),
        first(50),
        trimmed(50, 1e-2),
        trimmed(100, 1e-2),
        trimmed(130, 1e-3),
        trimmed(130, 2e-4),
        Recipe::all(DEGREE, ORDER).cut(Cut::Terms(12)),
        Recipe::all(DEGREE, ORDER),
    ]
}

/// The measured settings that are timed with a table.
pub fn settings<'a>(table: &Recipe, all: &'a [Setting]) -> impl Iterator<Item = &'a Setting> {
    let table = *table;
    all.iter().filter(move |setting| {
        let is_timed = match setting.way {
            Way::Polynomial => setting.format != Format::F64,
            Way::Bilinear(size) => size == MAP && setting.format == Format::F32,
            _ => false,
        };
        is_timed && setting.recipe == table && setting.scaling == Scaling::None
    })
}

/// Nanoseconds of a pixel and of a new light with SIMD, by setting.
pub struct Times {
    times: BTreeMap<String, [Option<f64>; 2]>,
    /// A pixel of the nine-term formula in the same run.
    nine_terms: f64,
}

impl Times {
    /// Reads the compiled-in times.
    pub fn new() -> Result<Self> {
        let (sheet, [setting, pixel, light]) = compiled_in(
            include_str!("../../../crates/wasm/times.csv"),
            "crates/wasm/times.csv",
            ["setting", "pixel_ns", "light_ns"],
        )?;
        let mut times = BTreeMap::new();
        for row in sheet.rows() {
            let light = if row.text(light).is_empty() { None } else { Some(row.number(light)?) };
            times.insert(row.text(setting).to_owned(), [Some(row.number(pixel)?), light]);
        }
        let nine_terms = Setting::of(Recipe::all(2, 0)).by(Way::NineTerms).to_string();
        let Some(&[Some(nine_terms), _]) = times.get(&nine_terms) else {
            let remedy = "run `crates/wasm/ladder && node crates/wasm/measure.mjs --times`";
            return Err(Error::new("crates/wasm/times.csv has no nine-term pixel", remedy));
        };
        Ok(Self { times, nine_terms })
    }

    /// Fills in the cost of a setting, in nine-term pixels.
    pub fn fill(&self, row: &mut Record, setting: &Setting) {
        let found = self.times.get(&setting.to_string()).copied().unwrap_or_default();
        let [pixel, light] = found.map(|ns| ns.map(|ns| ns / self.nine_terms));
        row.measure("wasm_pixel", pixel);
        row.measure("wasm_light", light);
    }
}

#[cfg(test)]
mod tests {
    use super::super::settings;
    use super::{Setting, Times, tables};
    use std::collections::BTreeSet;

    #[test]
    fn the_timed_settings_are_those_of_the_tables() {
        let all: Vec<Setting> = settings::all(false).iter().map(|one| one.setting).collect();
        let mut expected = BTreeSet::from(["2/0 all nine-terms f32".to_owned()]);
        for table in &tables() {
            let of_table: Vec<String> =
                super::settings(table, &all).map(Setting::to_string).collect();
            assert!(!of_table.is_empty(), "{table}");
            expected.extend(of_table);
        }
        let times = Times::new().unwrap().times;
        assert_eq!(times.keys().cloned().collect::<BTreeSet<String>>(), expected);
        for (name, [pixel, light]) in &times {
            assert!(pixel.is_some_and(|ns| ns > 0.0), "{name}");
            assert_eq!(light.is_some_and(|ns| ns > 0.0), !name.contains("nine-terms"));
        }
    }
}
