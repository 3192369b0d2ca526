//! Times of the WebAssembly module in Node, from `crates/wasm/times.csv`, which
//! `node crates/wasm/measure.mjs --times` writes.

use super::machine::Price;
use super::setting::{Recipe, Setting, Way};
use eigenshade_generator::error::{Error, Result};
use eigenshade_generator::inputs::sheet::Sheet;
use std::path::Path;

const TIMES: &str = include_str!("../../../wasm/times.csv");
const COLUMNS: [&str; 4] = ["simd", "operation", "format", "ns"];

/// Nanoseconds with SIMD, by operation and format.
pub struct Wasm(Vec<(String, String, f64)>);

impl Wasm {
    /// Reads the times that were compiled in.
    ///
    /// # Errors
    ///
    /// None in truth: they were made by the project.
    pub fn new() -> Result<Self> {
        let path = Path::new("crates/wasm/times.csv");
        let header = COLUMNS.join(",");
        let sheet = Sheet::parse(TIMES.as_bytes().to_vec(), path, &header)?;
        let columns = sheet.columns(COLUMNS).ok_or_else(|| sheet.wrong_header(&header))?;
        let mut times = Vec::new();
        for row in sheet.rows() {
            let [simd, operation, format, ns] = columns;
            if row.text(simd) == "1" {
                times.push((
                    row.text(operation).to_owned(),
                    row.text(format).to_owned(),
                    row.number(ns)?,
                ));
            }
        }
        let found = Self(times);
        found.nine_terms().map_or_else(
            || {
                let remedy = "run `node crates/wasm/measure.mjs --times`";
                Err(Error::new("no nine-term pixel", remedy).in_file(path))
            },
            |_| Ok(()),
        )?;
        Ok(found)
    }

    fn find(&self, operation: &str, format: &str) -> Option<f64> {
        let found = self.0.iter().find(|(o, f, _)| (o.as_str(), f.as_str()) == (operation, format));
        found.map(|(_, _, ns)| *ns)
    }

    fn nine_terms(&self) -> Option<f64> {
        self.find("nine_terms", "f32")
    }

    /// What a setting takes, in nine-term pixels; the module has the shipped table.
    #[must_use]
    pub fn price(&self, setting: &Setting) -> Price {
        let format = setting.format.to_string();
        let [pixel, light] = if setting.way == Way::NineTerms {
            [self.nine_terms(), None]
        } else if setting.recipe == Recipe::first(9, 7, 50)
            && setting.way == Way::Polynomial
            && setting.scaling == super::setting::Scaling::None
        {
            [self.find("pixel", &format), self.find("light", &format)]
        } else {
            [None, None]
        };
        let in_pixels = |ns: Option<f64>| ns.zip(self.nine_terms()).map(|(ns, nine)| ns / nine);
        Price { pixel: in_pixels(pixel), light: in_pixels(light), ..Price::default() }
    }
}
