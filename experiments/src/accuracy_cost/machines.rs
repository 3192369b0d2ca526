//! The machines whose costs are known, and the counted instructions of emulated boards, from
//! `firmware/counts.csv`.

use super::setting::{Cut, Format, Recipe, Scaling, Setting, Way};
use super::settings::{DEGREE, ORDER};
use super::sheet::Record;
use eigenshade_model::error::Result;
use eigenshade_model::inputs::sheet::Sheet;
use std::collections::BTreeMap;
use std::path::Path;

/// A machine.
pub struct Machine {
    /// The name in files and columns.
    pub key: &'static str,
    /// The name in titles.
    pub title: &'static str,
    /// The board in `firmware/counts.csv`; `None` if costs are times.
    pub board: Option<&'static str>,
}

/// All machines. Boards are emulated; WebAssembly has SIMD and runs in Node.
pub const MACHINES: [Machine; 6] = [
    Machine { key: "host", title: "x86-64", board: None },
    Machine { key: "m0", title: "Cortex-M0", board: Some("microbit") },
    Machine { key: "m3", title: "Cortex-M3", board: Some("mps2-an385") },
    Machine { key: "m4f", title: "Cortex-M4F", board: Some("mps2-an386") },
    Machine { key: "rv32", title: "RV32IMAC", board: Some("riscv32") },
    Machine { key: "wasm", title: "WebAssembly", board: None },
];

impl Machine {
    /// The unit of a pixel's cost.
    pub fn unit(&self) -> &'static str {
        if self.board.is_some() { "instructions" } else { "nine-term pixels" }
    }

    /// The number in this machine's column of a row.
    pub fn number(&self, row: &Record, column: &str) -> Option<f64> {
        row.number(&format!("{}_{column}", self.key))
    }
}

/// Counts by board, operation and format, and the tables for which a program has both a pixel and a
/// new light.
pub struct Counts {
    counts: BTreeMap<[String; 3], Count>,
    tables: Vec<(String, Recipe)>,
}

/// One row of the counts.
#[derive(Clone, Copy, Default)]
struct Count {
    instructions: Option<f64>,
    flash: Option<f64>,
    /// RAM including the stack.
    ram: Option<f64>,
}

/// A compiled-in CSV file and the places of its columns.
pub(super) fn compiled_in<const N: usize>(
    text: &str,
    path: &str,
    columns: [&str; N],
) -> Result<(Sheet, [usize; N])> {
    let header = columns.join(",");
    let sheet = Sheet::parse(text.as_bytes().to_vec(), Path::new(path), &header)?;
    let places = sheet.columns(columns).ok_or_else(|| sheet.wrong_header(&header))?;
    Ok((sheet, places))
}

/// The tables for which programs of `firmware/` count a pixel and a new light: the name of the rows
/// in `firmware/counts.csv`, before `/`, and the recipe. The programs are built from the same file.
pub fn benchmark_tables() -> Result<Vec<(String, Recipe)>> {
    let (sheet, [name, components, trim]) = compiled_in(
        include_str!("../../../firmware/tables/sizes.csv"),
        "firmware/tables/sizes.csv",
        ["name", "components", "trim"],
    )?;
    let table = |row: eigenshade_model::inputs::sheet::Row<'_>| {
        let cut = match row.text(trim) {
            "" => Cut::Whole,
            _ => Cut::Trimmed(row.number(trim)?),
        };
        let recipe = Recipe::first(DEGREE, ORDER, row.number(components)? as usize).cut(cut);
        Ok((row.text(name).to_owned(), recipe))
    };
    sheet.rows().map(table).collect()
}

/// The operations for the pixel and the new light of a setting that separate programs measure.
fn operations(setting: &Setting) -> [Option<&'static str>; 2] {
    let Setting { recipe, way, format, .. } = *setting;
    match way {
        Way::NineTerms => [Some("nine_terms"), None],
        Way::Bilinear(32) if format != Format::F64 => [Some("baked"), None],
        Way::Polynomial if recipe == Recipe::all(2, 0) => [Some("shade_lambertian"), None],
        Way::Polynomial if recipe == Recipe::first(DEGREE, ORDER, 130).cut(Cut::Trimmed(2e-4)) => {
            [Some("shade"), None]
        }
        Way::Polynomial if recipe == Recipe::first(DEGREE, ORDER, 50) => {
            [None, Some("relight_collapse")]
        }
        _ => [None, None],
    }
}

impl Counts {
    /// Reads the compiled-in counts.
    pub fn new() -> Result<Self> {
        let (sheet, columns) = compiled_in(
            include_str!("../../../firmware/counts.csv"),
            "firmware/counts.csv",
            [
                "board",
                "operation",
                "format",
                "instructions",
                "flash_bytes",
                "ram_bytes",
                "stack_bytes",
            ],
        )?;
        let [board, operation, format, instructions, flash, ram, stack] = columns;
        let mut counts = BTreeMap::new();
        for row in sheet.rows() {
            let number = |column: usize| match row.text(column) {
                "" => Ok(None),
                _ => row.number(column).map(Some),
            };
            let ram = number(ram)?.zip(number(stack)?).map(|(ram, stack)| ram + stack);
            let count = Count { instructions: number(instructions)?, flash: number(flash)?, ram };
            counts.insert([board, operation, format].map(|at| row.text(at).to_owned()), count);
        }
        Ok(Self { counts, tables: benchmark_tables()? })
    }

    /// Fills in the costs of a setting on the boards, as far as they were counted: by the program
    /// with both its pixel and its new light, or by the programs with one operation each.
    pub fn fill(&self, row: &mut Record, setting: &Setting) {
        // No program normalizes its normals.
        if setting.scaling != Scaling::None {
            return;
        }
        for machine in MACHINES {
            let Some(board) = machine.board else { continue };
            let format = setting.format.to_string();
            let find = |operation: &str| {
                self.counts.get(&[board, operation, &format].map(str::to_owned)).copied()
            };
            let is_it =
                |recipe: &Recipe| (*recipe, Way::Polynomial) == (setting.recipe, setting.way);
            let table = self.tables.iter().find(|(_, recipe)| is_it(recipe));
            let both = table.and_then(|(name, _)| {
                let of = |operation| find(&format!("{name}/{operation}"));
                Some([of("pixel")?, of("light")?, of("scene")?])
            });
            let [pixel, light, program] = both.unwrap_or_else(|| {
                let [pixel, light] =
                    operations(setting).map(|one| one.and_then(find).unwrap_or_default());
                [pixel, light, pixel]
            });
            let key = machine.key;
            row.measure(format!("{key}_pixel"), pixel.instructions);
            row.measure(format!("{key}_light"), light.instructions);
            for (column, bytes) in [("flash", program.flash), ("ram", program.ram)] {
                bytes.into_iter().for_each(|bytes| row.put(format!("{key}_{column}"), bytes));
            }
        }
    }
}
