//! The commands. Short ones are methods of [`Command`], the others have files of their own.

mod errors;
mod figures;
mod files;
mod highlights;
mod material_errors;
mod pictures;

use clap::{Args, Subcommand};
use eigenshade_cli::messages::printable;
use eigenshade_cli::messages::spinner;
use eigenshade_cli::output::write_error;
use eigenshade_model::error::{Error, Result};
use experiments::pages::Purpose;
use experiments::{ablation, mutations, reading, stability};
use std::io::Write;
use std::path::{Path, PathBuf};

/// Where a command writes its CSV.
#[derive(Args, Debug)]
pub struct Csv {
    /// Write the CSV to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

/// The file that a command makes.
#[derive(Args, Debug)]
pub struct OutputFile {
    /// The file to write
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
}

/// The commands of the program.
#[derive(Debug, Subcommand)]
pub enum Command {
    Paper(figures::Paper),
    Picture(pictures::Picture),
    /// All presets, docs/presets.png: the materials in the lobby with one exposure, then the lights
    /// on gold paint, each with a window and its own exposure
    ContactSheet(OutputFile),
    AccuracyCost(figures::AccuracyCost),
    /// Cost and contribution of each effect, docs/ablation.md; times are not compared
    Ablation(Purpose),
    /// The numerically hard cases, measured, docs/stability.md
    Stability(Purpose),
    /// Errors of estimates from degraded images, docs/reading.md
    Reading {
        #[command(flatten)]
        purpose: Purpose,
        /// Folder of the shipped tables
        #[arg(long, value_name = "DIR", default_value = "tables")]
        tables: PathBuf,
    },
    Errors(errors::Errors),
    /// Results of the runtime, tests/golden/sphere.csv
    ///
    /// Integers must be equal; floats may differ by the tolerance that the file states.
    Golden(Purpose),
    /// The gloss of the shipped materials in color, tables/inputs/gloss.csv
    ///
    /// One GGX lobe over a matte base is fitted to each. `error` is the rms of what it leaves of
    /// pictures under points of light, relative to that of the pictures.
    Gloss(Csv),
    GlossyMaterials(files::GlossyMaterials),
    Highlights(highlights::Highlights),
    /// Spheres with sources beside those without, and direct integration, docs/highlights.png
    HighlightPicture(OutputFile),
    /// The errors that the shipped sources leave, tables/inputs/sources.errors.csv
    ///
    /// Those that `eigenshade light --sources` writes are of sources that are not yet rounded.
    SourceErrors(Csv),
    /// Total errors of the shipped materials, tables/inputs/merl.errors.csv
    ///
    /// The reference is direct integration of each BRDF under the environment maps, without degree
    /// or order; PTFE, which was measured, is its own coefficients. The error of a map is the rms
    /// over a sphere's picture and the channels, relative to the picture's peak. The CSV has its
    /// median and its worst over the maps, the map of the worst, and the largest error of any pixel
    /// under any map, for the coefficients that are shipped at 9/7 and for the same at 12/12. The
    /// normals are evenly spaced ones, and others that mirror the lamps of the maps. Takes some ten
    /// minutes on two cores.
    MaterialErrors(Csv),
    /// Coefficients of glTF materials, tables/inputs/metallic-roughness.csv
    ///
    /// A material's coefficients are albedo (1 - f0) `matte` + `rim` + f0 `metal`. `matte` does not
    /// depend on roughness; `rim` and `metal` are sums of Chebyshev polynomials T_k in
    /// (roughness - 0.6) / 0.4. Writes the CSV `order,k,o,p,q,matte,rim,metal`.
    MetallicRoughness(OutputFile),
    SameOrder(files::SameOrder),
    WasmTables(files::WasmTables),
    Mutations(mutations::Mutations),
}

impl Command {
    /// Runs the command.
    pub fn run(self) -> Result<()> {
        match self {
            Self::Paper(command) => command.run(),
            Self::Picture(command) => command.run(),
            Self::ContactSheet(file) => pictures::contact_sheet(&file.out),
            Self::AccuracyCost(command) => command.run(),
            Self::Ablation(purpose) => {
                let parts = ablation::parts(&ablation::scenes::Times::measured());
                let remedy = "every scene must keep its tolerance, in f32 and in Q15";
                let parts = parts.map_err(|fault| Error::new(fault, remedy))?;
                ablation::PAGE.write_or_compare(&purpose, &parts)
            }
            Self::Stability(purpose) => {
                let progress = spinner("cases");
                let parts = stability::parts(|name| progress.set_message(name.to_owned()));
                progress.finish_and_clear();
                let remedy =
                    "every bound must hold, and a tight one be at most ten times the error";
                let parts = parts.map_err(|fault| Error::new(fault, remedy))?;
                stability::PAGE.write_or_compare(&purpose, &parts)
            }
            Self::Reading { purpose, tables } => {
                reading::PAGE.write_or_compare(&purpose, &reading::parts(&tables)?)
            }
            Self::Errors(command) => command.run(),
            Self::Golden(purpose) => files::golden(&purpose),
            Self::Gloss(csv) => highlights::gloss(csv.out.as_deref()),
            Self::GlossyMaterials(command) => command.run(),
            Self::Highlights(command) => command.run(),
            Self::HighlightPicture(file) => highlights::picture(&file.out),
            Self::SourceErrors(csv) => highlights::source_errors(csv.out.as_deref()),
            Self::MaterialErrors(csv) => material_errors::run(csv.out.as_deref()),
            Self::MetallicRoughness(file) => files::metallic_roughness(&file.out),
            Self::SameOrder(command) => command.run(),
            Self::WasmTables(command) => command.run(),
            Self::Mutations(command) => command.run(),
        }
    }
}

/// The folder of the shipped tables' inputs, from the repository's root.
fn inputs() -> &'static Path {
    Path::new("tables/inputs")
}

/// Writes the comment line `# experiments ...` with the command that makes this file.
fn write_command_line(out: &mut dyn Write) -> Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let line = printable(&arguments.join(" "));
    writeln!(out, "# experiments {line}").map_err(|error| write_error(&error))
}
