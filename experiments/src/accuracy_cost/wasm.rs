//! Times of the WebAssembly module in Node, from `crates/wasm/times.csv`, for the tables that
//! `crates/wasm/benchmark-tables` puts into modules.

use super::machines::compiled_in;
use super::setting::{Format, Recipe, Scaling, Setting, Way};
use super::settings::{DEGREE, ORDER};
use crate::sheet::Record;
use eigenshade_model::error::{Error, Result};
use eigenshade_table::scene::Cut;
use serde::Deserialize;

/// Texels along a side of the module's map.
const MAP: usize = 32;

/// The tables that are put into modules.
pub fn tables() -> Vec<Recipe> {
    let first = |count| Recipe::first(DEGREE, ORDER, count);
    let trimmed = |count, tolerance| first(count).trimmed(tolerance);
    let whole = Recipe::all(DEGREE, ORDER);
    let cut = Cut { terms: Some(12), ..whole.cut };
    vec![
        Recipe::all(2, 0),
        trimmed(9, 1e-1),
        trimmed(25, 3e-2),
        first(50),
        trimmed(50, 1e-2),
        trimmed(100, 1e-2),
        trimmed(130, 1e-3),
        trimmed(130, 2e-4),
        Recipe { cut, ..whole },
        whole,
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

/// Nanoseconds with SIMD.
#[derive(Deserialize)]
struct Time {
    setting: String,
    pixel_ns: f64,
    light_ns: Option<f64>,
}

/// Times of a pixel and of a new light.
pub struct Times {
    times: Vec<Time>,
    /// A pixel of the nine-term formula in the same run.
    nine_terms: f64,
}

/// The remedy for a file of times that cannot be used.
const AGAIN: &str = "run `crates/wasm/benchmark-tables && node crates/wasm/measure.mjs --times`";

impl Times {
    /// Reads the compiled-in times.
    pub fn new() -> Result<Self> {
        let text = include_str!("../../../crates/wasm/times.csv");
        let times: Vec<Time> = compiled_in(text, "crates/wasm/times.csv", AGAIN)?;
        let nine_terms = Setting::of(Recipe::all(2, 0)).by(Way::NineTerms).to_string();
        let found = times.iter().find(|time| time.setting == nine_terms);
        let nine_terms = found
            .map(|time| time.pixel_ns)
            .ok_or_else(|| Error::new("crates/wasm/times.csv has no nine-term pixel", AGAIN))?;
        Ok(Self { times, nine_terms })
    }

    /// Fills in the cost of a setting, in nine-term pixels.
    pub fn fill(&self, row: &mut Record, setting: &Setting) {
        let name = setting.to_string();
        let Some(time) = self.times.iter().find(|time| time.setting == name) else { return };
        row.measure("wasm_pixel", time.pixel_ns / self.nine_terms);
        row.measure("wasm_light", time.light_ns.map(|ns| ns / self.nine_terms));
    }
}

#[cfg(test)]
mod tests {
    use super::super::settings;
    use super::{Setting, Time, Times, tables};
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
        let names: BTreeSet<String> = times.iter().map(|time| time.setting.clone()).collect();
        assert_eq!((&names, times.len()), (&expected, expected.len()));
        for Time { setting, pixel_ns, light_ns } in &times {
            assert!(*pixel_ns > 0.0, "{setting}");
            assert_eq!(light_ns.is_some_and(|ns| ns > 0.0), !setting.contains("nine-terms"));
        }
    }
}
