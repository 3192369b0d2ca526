//! One command a file.

mod basis;
mod demo;
mod demo_sheet;
mod eigenvalues;
mod evaluate;
mod evaluate_functions;
mod info;
mod light;
mod material;
mod material_formula;
mod memory;
mod pack;
mod project;
mod read;
mod read_answer;
mod render;
mod shade;
mod shade_options;

use clap::Subcommand;
use eigenshade_generator::error::Result;
pub use memory::Memory;

/// What the program can do.
#[derive(Debug, Subcommand)]
pub enum Command {
    Demo(demo::Demo),
    Light(light::Light),
    Material(material::Material),
    Basis(basis::Basis),
    Pack(pack::Pack),
    Info(info::Info),
    Eigenvalues(eigenvalues::Eigenvalues),
    Project(project::Project),
    Shade(shade::Shade),
    Render(render::Render),
    Read(read::Read),
    Evaluate(evaluate::Evaluate),
}

impl Command {
    /// Does it.
    pub fn run(self, memory: Memory) -> Result<()> {
        match self {
            Self::Demo(command) => command.run(),
            Self::Light(command) => command.run(memory),
            Self::Material(command) => command.run(memory),
            Self::Basis(command) => command.run(memory),
            Self::Pack(command) => command.run(memory),
            Self::Info(command) => command.run(memory),
            Self::Eigenvalues(command) => command.run(memory),
            Self::Project(command) => command.run(memory),
            Self::Shade(command) => command.run(memory),
            Self::Render(command) => command.run(memory),
            Self::Read(command) => command.run(memory),
            Self::Evaluate(command) => command.run(memory),
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
