//! The commands. Short ones are methods of [`Command`], the others have files of their own.

mod errors;
mod figures;
mod files;
mod highlights;
mod material_errors;
mod pictures;

use clap::Subcommand;
use eigenshade_cli::messages::printable;
use eigenshade_cli::messages::spinner;
use eigenshade_cli::output::write_error;
use eigenshade_model::error::{Error, Result};
use experiments::pages::Purpose;
use experiments::{ablation, mutations, reading, stability};
use std::io::Write;
use std::path::{Path, PathBuf};

/// The commands of the program.
#[derive(Debug, Subcommand)]
pub enum Command {
    Paper(figures::Paper),
    Picture(pictures::Picture),
    ContactSheet(pictures::ContactSheet),
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
    Gloss(highlights::Gloss),
    GlossyMaterials(files::GlossyMaterials),
    Highlights(highlights::Highlights),
    HighlightPicture(highlights::HighlightPicture),
    SourceErrors(highlights::SourceErrors),
    MaterialErrors(material_errors::MaterialErrors),
    MetallicRoughness(files::MetallicRoughness),
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
            Self::ContactSheet(command) => command.run(),
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
            Self::Gloss(command) => command.run(),
            Self::GlossyMaterials(command) => command.run(),
            Self::Highlights(command) => command.run(),
            Self::HighlightPicture(command) => command.run(),
            Self::SourceErrors(command) => command.run(),
            Self::MaterialErrors(command) => command.run(),
            Self::MetallicRoughness(command) => command.run(),
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
