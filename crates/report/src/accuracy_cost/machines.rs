//! The machines whose costs are known: this one, and emulated boards, whose counted instructions are
//! in `firmware/counts.csv`. Their costs choose settings: the cheapest below an error, and those that
//! no other beats.

use super::settings::{DEGREE, Format, ORDER, Recipe, Scaling, Setting, Way};
use crate::sheet::{Counts, Record, Sheet};
use eigenshade_model::error::Result;

pub struct Machine {
    /// The name in files and columns.
    pub key: &'static str,
    /// The name in titles.
    pub title: &'static str,
    /// The board in `firmware/counts.csv`; `None` if costs are times.
    pub board: Option<&'static str>,
}

/// All machines. Boards are emulated.
pub const MACHINES: [Machine; 3] = [
    Machine { key: "host", title: "x86-64", board: None },
    Machine { key: "m0", title: "Cortex-M0", board: Some("microbit") },
    Machine { key: "m4f", title: "Cortex-M4F", board: Some("mps2-an386") },
];

impl Machine {
    pub fn unit(&self) -> &'static str {
        if self.board.is_some() { "instructions" } else { "nine-term pixels" }
    }

    pub fn number(&self, row: &Record, column: &str) -> Option<f64> {
        row.number(&format!("{}_{column}", self.key))
    }
}

/// The operations for the pixel and the new light of a setting that separate programs measure.
fn operations(setting: &Setting) -> [Option<&'static str>; 2] {
    let Setting { recipe, way, format, .. } = *setting;
    match way {
        Way::NineTerms => [Some("nine_terms"), None],
        Way::Bilinear(32) if format != Format::F64 => [Some("baked"), None],
        Way::Polynomial if recipe == Recipe::first(DEGREE, ORDER, 130).trimmed(2e-4) => {
            [Some("shade"), None]
        }
        Way::Polynomial if recipe == Recipe::first(DEGREE, ORDER, 50) => {
            [None, Some("relight_collapse")]
        }
        _ => [None, None],
    }
}

/// The counts, and the tables for which programs of `firmware/` count both a pixel and a new light,
/// with their names before `/` in the counts. The programs are built from the same file.
pub struct Boards {
    counts: Counts,
    tables: Vec<(String, Recipe)>,
}

impl Boards {
    pub fn new() -> Result<Self> {
        let listed = include_str!("../../../../firmware/tables/sizes.csv");
        let listed = Sheet::parse(listed, "firmware/tables/sizes.csv")?;
        let components = listed.numbers("components").into_iter();
        let tables = listed.rows.iter().zip(components).map(|(row, components)| {
            let first = Recipe::first(DEGREE, ORDER, components as usize);
            (row.text("name").to_owned(), Recipe { trim: row.number("trim"), ..first })
        });
        Ok(Self { tables: tables.collect(), counts: Counts::recorded() })
    }

    /// Fills in the costs of a setting on the boards, as far as they were counted: by the program
    /// with both its pixel and its new light, or by the programs with one operation each. Those of
    /// its sources are added: they are counted alone, with normals that face all of them.
    pub fn fill(&self, row: &mut Record, setting: &Setting) {
        // No program normalizes its normals.
        if setting.scaling != Scaling::None {
            return;
        }
        let format = setting.format.to_string();
        let mut tables = self.tables.iter().filter(|_| setting.way == Way::Polynomial);
        let table = tables.find(|(_, recipe)| *recipe == setting.recipe);
        let whole = table.map(|(name, _)| {
            ["pixel", "light", "scene"].map(|operation| Some(format!("{name}/{operation}")))
        });
        let [pixel, light] = operations(setting).map(|one| one.map(str::to_owned));
        let single = [pixel.clone(), light, pixel];
        let sources = (setting.sources > 0).then(|| {
            let [pixel, light] = ["pixel", "light"].map(|of| format!("{of}_{}", setting.sources));
            [pixel, light, "scene".into()].map(|operation| format!("sources/{operation}"))
        });
        for Machine { key, board, .. } in MACHINES {
            let Some(board) = board else { continue };
            let count = |operation: &str, column: &str| {
                self.counts.get([board, &format], operation, column).map(|count| count as f64)
            };
            let is_counted = |program: &&[Option<String>; 3]| {
                program[0].as_ref().is_some_and(|pixel| count(pixel, "instructions").is_some())
            };
            let program = whole.as_ref().filter(is_counted).unwrap_or(&single);
            // Of the pixel, the new light, or the program; with the sources.
            let both = |of: usize, column: &str| {
                let highlights = match &sources {
                    None => 0.0,
                    Some(sources) => count(&sources[of], column)?,
                };
                Some([count(program[of].as_ref()?, column)?, highlights])
            };
            let sum = |of: usize, column: &str| both(of, column).map(|[a, b]| a + b);
            row.measure(format!("{key}_pixel"), sum(0, "instructions"));
            row.measure(format!("{key}_light"), sum(1, "instructions"));
            let flash = sum(2, "flash_bytes");
            let stack = both(2, "stack_bytes").map(|[a, b]| a.max(b));
            let ram = sum(2, "ram_bytes").zip(stack).map(|(ram, stack)| ram + stack);
            for (column, bytes) in [("flash", flash), ("ram", ram)] {
                bytes.into_iter().for_each(|bytes| row.put(format!("{key}_{column}"), bytes));
            }
        }
    }
}

/// The limits of the total screen error: CIEDE2000, the mean of a picture.
pub const LIMITS: [f64; 7] = [20.0, 16.0, 12.0, 10.0, 9.0, 8.0, 7.0];
/// The number of pixels of the picture over which costs are summed.
pub const PIXELS: f64 = 96.0 * 96.0;
/// Times that differ by less than this factor count as equal, because runs differ by more.
pub const TIE: f64 = 1.05;

/// How often the light changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lighting {
    /// Never: only pixels are counted.
    Still,
    /// For every picture of [`PIXELS`].
    Moving,
}

/// The cost of a picture; `None` if it is not known.
pub fn picture(row: &Record, machine: &Machine, lighting: Lighting) -> Option<f64> {
    let pixels = PIXELS * machine.number(row, "pixel")?;
    match lighting {
        Lighting::Still => Some(pixels),
        Lighting::Moving => machine.number(row, "light").map(|light| pixels + light),
    }
}

/// Whether a setting takes normals of unit length, as those that can be chosen do.
pub fn is_choice(row: &Record) -> bool {
    row.text("parameter") != "mathematics"
}

/// The cheapest setting whose total error is below a limit. Times that differ by no more than
/// [`TIE`] count as equal; among those, the setting with the least total error is chosen, then that
/// with the least error of the method.
pub fn cheapest<'a>(
    rows: &'a [Record],
    machine: &Machine,
    lighting: Lighting,
    limit: f64,
) -> Option<&'a Record> {
    let able = rows.iter().filter(|row| {
        is_choice(row) && row.number("total_mean_most").is_some_and(|error| error <= limit)
    });
    let priced: Vec<(&Record, f64)> =
        able.filter_map(|row| picture(row, machine, lighting).map(|cost| (row, cost))).collect();
    let least = priced.iter().map(|(_, cost)| *cost).fold(f64::INFINITY, f64::min);
    let most = if machine.board.is_some() { least } else { least * TIE };
    let tied = priced.into_iter().filter(|(_, cost)| *cost <= most).map(|(row, _)| row);
    tied.min_by(|a, b| {
        let by = |column: &str| {
            let [a, b] = [a, b].map(|row| row.number(column).unwrap_or(f64::INFINITY));
            a.total_cmp(&b)
        };
        by("total_mean_most").then_with(|| by("unseen_rms_most"))
    })
}

/// The points (cost, error) of the Pareto front, by rising cost. For each of them, every other
/// point that is as cheap or cheaper has a larger error.
pub fn pareto(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut points = points.to_vec();
    points.retain(|(cost, error)| cost.is_finite() && error.is_finite());
    points.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut least = f64::INFINITY;
    points.retain(|point| {
        let is_better = point.1 < least;
        least = least.min(point.1);
        is_better
    });
    points
}
