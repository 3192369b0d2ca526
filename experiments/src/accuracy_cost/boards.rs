//! Counted instructions of emulated boards, from `firmware/counts.csv`. They exist only for the
//! settings that a program there measures.

use super::ladder::{Rung, rungs};
use super::machine::{Machine, Price};
use super::setting::{Cut, Format, Recipe, Scaling, Setting, Way};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::sheet::Sheet;
use std::collections::BTreeMap;
use std::path::Path;

/// The counts that `firmware/run` recorded.
const COUNTS: &str = include_str!("../../../firmware/counts.csv");
const COLUMNS: [&str; 6] =
    ["board", "operation", "format", "instructions", "flash_bytes", "stack_bytes"];

/// Counts by board, operation and format, and the tables for which a program has both a pixel and a
/// new light.
pub struct Boards {
    counts: BTreeMap<[String; 3], Count>,
    rungs: Vec<Rung>,
}

/// One row of the counts.
#[derive(Clone, Copy, Default)]
struct Count {
    instructions: Option<f64>,
    flash: Option<usize>,
    /// RAM including the stack.
    ram: Option<usize>,
}

/// The operations for the pixel and the new light of a setting, if separate programs measure them.
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
    /// Reads the compiled-in counts.
    ///
    /// # Errors
    ///
    /// Never in practice: the project generated them.
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
            let used = whole(ram)?.zip(whole(stack)?);
            let count = Count {
                instructions: whole(instructions)?.map(|count: usize| count as f64),
                flash: whole(flash)?,
                ram: used.map(|(ram, stack)| ram + stack),
            };
            counts.insert(key, count);
        }
        if counts.is_empty() {
            return Err(Error::new("no counts", "run `firmware/run all --update`").in_file(path));
        }
        Ok(Self { counts, rungs: rungs()? })
    }

    /// The cost of a setting on a board, as far as it was counted: by the program with both its
    /// pixel and its new light, or by the programs with one operation each.
    #[must_use]
    pub fn price(&self, machine: Machine, setting: &Setting) -> Price {
        let Some(board) = machine.board() else { return Price::default() };
        // No program normalizes its normals.
        if setting.scaling != Scaling::None {
            return Price::default();
        }
        let format = setting.format.to_string();
        let find = |operation: &str| {
            self.counts.get(&[board.to_owned(), operation.to_owned(), format.clone()]).copied()
        };
        let is_it = |rung: &&Rung| (rung.recipe, Way::Polynomial) == (setting.recipe, setting.way);
        let whole = self.rungs.iter().find(is_it).and_then(|rung| {
            let [pixel, light, program] = ["pixel", "light", "scene"]
                .map(|operation| find(&format!("{}/{operation}", rung.name)));
            Some((pixel?, light?, program?))
        });
        let [pixel, light, program] = match whole {
            Some((pixel, light, program)) => [pixel, light, program],
            None => {
                let [pixel, light] = operations(setting)
                    .map(|operation| operation.and_then(find).unwrap_or_default());
                [pixel, light, pixel]
            }
        };
        let (pixel, light) = (pixel.instructions, light.instructions);
        Price { pixel, light, flash: program.flash, ram: program.ram }
    }
}
