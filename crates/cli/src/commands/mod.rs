//! One command a file.

#[cfg(feature = "generate")]
mod basis;
mod demo;
mod demo_sheet;
mod eigenvalues;
mod evaluate;
mod evaluate_functions;
mod info;
#[cfg(feature = "generate")]
mod light;
#[cfg(feature = "generate")]
mod material;
#[cfg(feature = "generate")]
mod material_formula;
mod memory;
mod pack;
mod project;
#[cfg(feature = "generate")]
mod read;
#[cfg(feature = "generate")]
mod read_answer;
mod render;
mod shade;
mod shade_options;

use clap::Subcommand;
use eigenshade_model::error::Result;
pub use memory::Memory;

/// The commands of the program.
#[derive(Debug, Subcommand)]
pub enum Command {
    Demo(demo::Demo),
    #[cfg(feature = "generate")]
    Light(light::Light),
    #[cfg(feature = "generate")]
    Material(material::Material),
    #[cfg(feature = "generate")]
    Basis(basis::Basis),
    Pack(pack::Pack),
    Info(info::Info),
    Eigenvalues(eigenvalues::Eigenvalues),
    Project(project::Project),
    Shade(shade::Shade),
    Render(render::Render),
    #[cfg(feature = "generate")]
    Read(read::Read),
    Evaluate(evaluate::Evaluate),
}

impl Command {
    /// Runs it.
    pub fn run(self, memory: Memory) -> Result<()> {
        match self {
            Self::Demo(command) => command.run(),
            #[cfg(feature = "generate")]
            Self::Light(command) => command.run(memory),
            #[cfg(feature = "generate")]
            Self::Material(command) => command.run(memory),
            #[cfg(feature = "generate")]
            Self::Basis(command) => command.run(memory),
            Self::Pack(command) => command.run(memory),
            Self::Info(command) => command.run(memory),
            Self::Eigenvalues(command) => command.run(memory),
            Self::Project(command) => command.run(memory),
            Self::Shade(command) => command.run(memory),
            Self::Render(command) => command.run(memory),
            #[cfg(feature = "generate")]
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
