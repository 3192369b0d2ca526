//! Times of the WebAssembly module in Node, from `crates/wasm/times.csv`, for the tables that
//! `crates/wasm/ladder` puts into modules.

use super::knobs::{DEGREE, ORDER};
use super::machine::Price;
use super::setting::{Cut, Format, Recipe, Setting, Way};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::sheet::Sheet;
use std::collections::BTreeMap;
use std::path::Path;

const TIMES: &str = include_str!("../../../crates/wasm/times.csv");
const COLUMNS: [&str; 3] = ["setting", "pixel_ns", "light_ns"];
/// Texels along a side of the module's map.
const MAP: usize = 32;

/// The tables that are put into modules.
#[must_use]
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
        is_timed && setting.recipe == table && **setting == bare(setting)
    })
}

/// The setting without scaling of normals.
fn bare(setting: &Setting) -> Setting {
    Setting::of(setting.recipe).by(setting.way).in_format(setting.format)
}

/// The nine-term formula.
fn nine_terms() -> Setting {
    Setting::of(Recipe::all(2, 0)).by(Way::NineTerms)
}

/// Nanoseconds of a pixel and of a new light with SIMD, by setting.
pub struct Wasm(BTreeMap<String, [Option<f64>; 2]>);

impl Wasm {
    /// Reads the compiled-in times.
    ///
    /// # Errors
    ///
    /// Never in practice: the project generated them.
    pub fn new() -> Result<Self> {
        let path = Path::new("crates/wasm/times.csv");
        let header = COLUMNS.join(",");
        let sheet = Sheet::parse(TIMES.as_bytes().to_vec(), path, &header)?;
        let columns = sheet.columns(COLUMNS).ok_or_else(|| sheet.wrong_header(&header))?;
        let mut times = BTreeMap::new();
        for row in sheet.rows() {
            let [setting, pixel, light] = columns;
            let light = if row.text(light).is_empty() { None } else { Some(row.number(light)?) };
            times.insert(row.text(setting).to_owned(), [Some(row.number(pixel)?), light]);
        }
        if !times.contains_key(&nine_terms().to_string()) {
            let remedy = "run `crates/wasm/ladder && node crates/wasm/measure.mjs --times`";
            return Err(Error::new("no nine-term pixel", remedy).in_file(path));
        }
        Ok(Self(times))
    }

    fn find(&self, setting: &Setting) -> [Option<f64>; 2] {
        self.0.get(&setting.to_string()).copied().unwrap_or_default()
    }

    /// The cost of a setting, in nine-term pixels of the same run.
    #[must_use]
    pub fn price(&self, setting: &Setting) -> Price {
        let [nine, _] = self.find(&nine_terms());
        let [pixel, light] = self.find(setting).map(|ns| ns.zip(nine).map(|(ns, nine)| ns / nine));
        Price { pixel, light, ..Price::default() }
    }
}

#[cfg(test)]
mod tests {
    use super::super::knobs;
    use super::{Setting, Wasm, nine_terms, settings, tables};
    use std::collections::BTreeSet;

    #[test]
    fn what_was_timed_is_the_ladder_and_of_settings_that_are_measured() {
        let all: Vec<Setting> = knobs::settings(false).iter().map(|knob| knob.setting).collect();
        let tables = tables();
        let mut expected = BTreeSet::from([nine_terms().to_string()]);
        for table in &tables {
            let of_table: Vec<String> = settings(table, &all).map(Setting::to_string).collect();
            assert!(!of_table.is_empty(), "{table}");
            expected.extend(of_table);
        }
        let names: BTreeSet<String> = all.iter().map(Setting::to_string).collect();
        assert!(expected.is_subset(&names));
        let wasm = Wasm::new().unwrap();
        assert_eq!(wasm.0.keys().cloned().collect::<BTreeSet<String>>(), expected);
        for (name, [pixel, light]) in &wasm.0 {
            assert!(pixel.is_some_and(|ns| ns > 0.0), "{name}");
            assert_eq!(light.is_some_and(|ns| ns > 0.0), *name != nine_terms().to_string());
        }
    }
}
