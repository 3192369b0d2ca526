//! The commands, one per file.

mod ablation;
mod accuracy_cost;
mod errors;
mod float_errors;
mod glossy_materials;
mod golden;
mod page;
mod paper;
mod picture;
mod purpose;
mod reading;
mod same_order;
mod stability;
mod wasm_tables;

use clap::Subcommand;
use eigenshade_model::error::Result;

/// The commands of the program.
#[derive(Debug, Subcommand)]
pub enum Command {
    Paper(paper::Paper),
    Picture(picture::Picture),
    AccuracyCost(accuracy_cost::AccuracyCost),
    Ablation(ablation::Ablation),
    Stability(stability::Stability),
    Reading(reading::Reading),
    Errors(errors::Errors),
    FloatErrors(float_errors::FloatErrors),
    Golden(golden::Golden),
    GlossyMaterials(glossy_materials::GlossyMaterials),
    SameOrder(same_order::SameOrder),
    WasmTables(wasm_tables::WasmTables),
}

impl Command {
    /// Runs the command.
    pub fn run(self) -> Result<()> {
        match self {
            Self::Paper(command) => command.run(),
            Self::Picture(command) => command.run(),
            Self::AccuracyCost(command) => command.run(),
            Self::Ablation(command) => command.run(),
            Self::Stability(command) => command.run(),
            Self::Reading(command) => command.run(),
            Self::Errors(command) => command.run(),
            Self::FloatErrors(command) => command.run(),
            Self::Golden(command) => command.run(),
            Self::GlossyMaterials(command) => command.run(),
            Self::SameOrder(command) => command.run(),
            Self::WasmTables(command) => command.run(),
        }
    }
}
