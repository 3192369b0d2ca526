//! The machines whose costs are known, and the counted instructions of emulated boards, from
//! `firmware/counts.csv`.

use super::setting::{Format, Recipe, Scaling, Setting, Way};
use super::settings::{DEGREE, ORDER};
use crate::counts::Counts;
use crate::sheet::Record;
use eigenshade_model::error::{Error, Result};
use serde::Deserialize;
use serde::de::DeserializeOwned;

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

/// The rows of a compiled-in CSV file.
pub(super) fn compiled_in<T: DeserializeOwned>(
    text: &str,
    path: &str,
    remedy: &str,
) -> Result<Vec<T>> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
    let rows = reader.deserialize().collect::<csv::Result<_>>();
    rows.map_err(|error| Error::new(error.to_string(), remedy).in_file(path))
}

/// A table for which programs of `firmware/` count a pixel and a new light. The programs are built
/// from the same file.
#[derive(Deserialize)]
struct BenchmarkTable {
    /// The name of the rows in `firmware/counts.csv`, before `/`.
    name: String,
    components: usize,
    trim: Option<f64>,
}

impl BenchmarkTable {
    fn recipe(&self) -> Recipe {
        let first = Recipe::first(DEGREE, ORDER, self.components);
        self.trim.map_or(first, |share| first.trimmed(share))
    }
}

/// The operations for the pixel and the new light of a setting that separate programs measure.
fn operations(setting: &Setting) -> [Option<&'static str>; 2] {
    let Setting { recipe, way, format, .. } = *setting;
    match way {
        Way::NineTerms => [Some("nine_terms"), None],
        Way::Bilinear(32) if format != Format::F64 => [Some("baked"), None],
        Way::Polynomial if recipe == Recipe::all(2, 0) => [Some("shade_lambertian"), None],
        Way::Polynomial if recipe == Recipe::first(DEGREE, ORDER, 130).trimmed(2e-4) => {
            [Some("shade"), None]
        }
        Way::Polynomial if recipe == Recipe::first(DEGREE, ORDER, 50) => {
            [None, Some("relight_collapse")]
        }
        _ => [None, None],
    }
}

/// The counts, and the tables for which a program has both a pixel and a new light.
pub struct Boards {
    counts: Counts,
    tables: Vec<BenchmarkTable>,
}

impl Boards {
    /// Reads the recorded counts.
    pub fn new() -> Result<Self> {
        let tables = include_str!("../../../firmware/tables/sizes.csv");
        let tables = compiled_in(
            tables,
            "firmware/tables/sizes.csv",
            "give it the columns name,file,components,trim",
        )?;
        Ok(Self { counts: Counts::recorded(), tables })
    }

    /// Fills in the costs of a setting on the boards, as far as they were counted: by the program
    /// with both its pixel and its new light, or by the programs with one operation each.
    pub fn fill(&self, row: &mut Record, setting: &Setting) {
        // No program normalizes its normals.
        if setting.scaling != Scaling::None {
            return;
        }
        let format = setting.format.to_string();
        let is_it = |table: &&BenchmarkTable| {
            (table.recipe(), Way::Polynomial) == (setting.recipe, setting.way)
        };
        let table = self.tables.iter().find(is_it);
        let whole = table.map(|table| {
            ["pixel", "light", "scene"].map(|operation| Some(format!("{}/{operation}", table.name)))
        });
        let [pixel, light] = operations(setting).map(|one| one.map(str::to_owned));
        let single = [pixel.clone(), light, pixel];
        for Machine { key, board, .. } in MACHINES {
            let Some(board) = board else { continue };
            let count = |operation: &Option<String>, column: &str| {
                let operation = operation.as_ref()?;
                self.counts.get([board, &format], operation, column).map(|count| count as f64)
            };
            let is_counted =
                |program: &&[Option<String>; 3]| count(&program[0], "instructions").is_some();
            let [pixel, light, program] = whole.as_ref().filter(is_counted).unwrap_or(&single);
            row.measure(format!("{key}_pixel"), count(pixel, "instructions"));
            row.measure(format!("{key}_light"), count(light, "instructions"));
            let [flash, ram, stack] =
                ["flash_bytes", "ram_bytes", "stack_bytes"].map(|column| count(program, column));
            let ram = ram.zip(stack).map(|(ram, stack)| ram + stack);
            for (column, bytes) in [("flash", flash), ("ram", ram)] {
                bytes.into_iter().for_each(|bytes| row.put(format!("{key}_{column}"), bytes));
            }
        }
    }
}
