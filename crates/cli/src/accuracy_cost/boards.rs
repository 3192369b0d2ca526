//! Counted instructions of emulated boards, from `firmware/counts.csv`: of the settings that
//! a program there measures, and of no others.

use super::machine::{Machine, Price};
use super::setting::{Cut, Format, Recipe, Setting, Way};
use eigenshade_generator::error::{Error, Result};
use eigenshade_generator::inputs::sheet::Sheet;
use std::collections::BTreeMap;
use std::path::Path;

/// What `firmware/run` counted.
const COUNTS: &str = include_str!("../../../../firmware/counts.csv");
const COLUMNS: [&str; 6] =
    ["board", "operation", "format", "instructions", "flash_bytes", "stack_bytes"];

/// Counts by board, operation and format.
pub struct Boards(BTreeMap<[String; 3], Price>);

/// The operations that are the pixel and the new light of a setting.
fn operations(setting: &Setting) -> [Option<&'static str>; 2] {
    let Setting { recipe, way, format, .. } = *setting;
    let full = Recipe::first(9, 7, 130).cut(Cut::Trimmed(2e-4));
    if way == Way::NineTerms {
        [Some("nine_terms"), None]
    } else if recipe == Recipe::all(2, 0) && way == Way::Polynomial {
        [Some("shade_lambertian"), None]
    } else if recipe == full && way == Way::Polynomial {
        [Some("shade"), None]
    } else if recipe == Recipe::first(9, 7, 50) && way == Way::Polynomial {
        [None, Some("relight_collapse")]
    } else if way == Way::Bilinear(32) && format != Format::F64 {
        [Some("baked"), None]
    } else {
        [None, None]
    }
}

impl Boards {
    /// Reads the counts that were compiled in.
    ///
    /// # Errors
    ///
    /// None in truth: they were made by the project.
    pub fn new() -> Result<Self> {
        let path = Path::new("firmware/counts.csv");
        let header = COLUMNS.join(",");
        let sheet = Sheet::parse(COUNTS.as_bytes().to_vec(), path, &header)?;
        let columns = sheet.columns(COLUMNS).ok_or_else(|| sheet.wrong_header(&header))?;
        let ram = sheet.column("ram_bytes").ok_or_else(|| sheet.wrong_header(&header))?;
        let mut counts = BTreeMap::new();
        for row in sheet.rows() {
            let [board, operation, format, instructions, flash, stack] = columns;
            let whole = |column: usize| {
                let text = row.text(column);
                let fault = |_| row.fault(format!("`{text}` is no count"), "count it again");
                if text.is_empty() { Ok(None) } else { text.parse().map(Some).map_err(fault) }
            };
            let key = [board, operation, format].map(|column| row.text(column).to_owned());
            let used =
                whole(ram)?.zip(whole(stack)?).map(|(ram, stack): (usize, usize)| ram + stack);
            let price = Price {
                pixel: whole(instructions)?.map(|count: usize| count as f64),
                light: None,
                flash: whole(flash)?,
                ram: used,
            };
            counts.insert(key, price);
        }
        if counts.is_empty() {
            return Err(Error::new("no counts", "run `firmware/run all --update`").in_file(path));
        }
        Ok(Self(counts))
    }

    /// What a setting takes on a board, as far as it was counted.
    #[must_use]
    pub fn price(&self, machine: Machine, setting: &Setting) -> Price {
        let Some(board) = machine.board() else { return Price::default() };
        let find = |operation: &str| {
            let format = setting.format.to_string();
            self.0.get(&[board.to_owned(), operation.to_owned(), format])
        };
        let [pixel, light] = operations(setting).map(|operation| operation.and_then(find));
        Price { light: light.and_then(|light| light.pixel), ..pixel.copied().unwrap_or_default() }
    }
}
