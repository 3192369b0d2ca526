//! One command a file.

mod accuracy_cost;
mod basis;
mod demo;
mod demo_sheet;
mod eigenvalues;
mod errors;
mod evaluate;
mod evaluate_functions;
mod info;
mod light;
mod material;
mod material_formula;
mod pack;
mod paper;
mod project;
mod purpose;
mod read;
mod read_answer;
mod read_report;
mod read_score;
mod render;
mod shade;
mod shade_options;

use clap::Subcommand;
use eigenshade_generator::error::Result;

/// What the program can do.
#[derive(Debug, Subcommand)]
pub enum Command {
    Demo(demo::Demo),
    Light(light::Light),
    Material(material::Material),
    Basis(basis::Basis),
    Errors(errors::Errors),
    Pack(pack::Pack),
    Info(info::Info),
    Eigenvalues(eigenvalues::Eigenvalues),
    Project(project::Project),
    Shade(shade::Shade),
    Render(render::Render),
    Read(read::Read),
    ReadReport(read_report::ReadReport),
    Evaluate(evaluate::Evaluate),
    Paper(paper::Paper),
    AccuracyCost(accuracy_cost::AccuracyCost),
}

impl Command {
    /// Does it.
    pub fn run(self) -> Result<()> {
        match self {
            Self::Demo(command) => command.run(),
            Self::Light(command) => command.run(),
            Self::Material(command) => command.run(),
            Self::Basis(command) => command.run(),
            Self::Errors(command) => command.run(),
            Self::Pack(command) => command.run(),
            Self::Info(command) => command.run(),
            Self::Eigenvalues(command) => command.run(),
            Self::Project(command) => command.run(),
            Self::Shade(command) => command.run(),
            Self::Render(command) => command.run(),
            Self::Read(command) => command.run(),
            Self::ReadReport(command) => command.run(),
            Self::Evaluate(command) => command.run(),
            Self::Paper(command) => command.run(),
            Self::AccuracyCost(command) => command.run(),
        }
    }
}

/// Clap's reader of whole numbers within a range.
fn count(low: u64, high: u64) -> impl Fn(&str) -> std::result::Result<usize, String> + Clone {
    move |text| match text.parse::<u64>() {
        Ok(number) if (low..=high).contains(&number) => Ok(number as usize),
        _ => Err(format!("a whole number from {low} to {high} is wanted")),
    }
}
