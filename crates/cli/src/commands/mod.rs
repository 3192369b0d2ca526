//! The commands of the program.

#[cfg(feature = "generate")]
mod basis;
mod choices;
mod demo;
mod demo_relief;
mod drawing;
mod evaluate;
mod export;
mod highlights;
mod info;
#[cfg(feature = "generate")]
mod light;
#[cfg(feature = "generate")]
mod light_coefficients;
mod list;
mod manual;
#[cfg(feature = "generate")]
mod material;
#[cfg(feature = "generate")]
mod object_scene;
mod options;
mod pack;
#[cfg(feature = "generate")]
mod pack_object;
mod project;
#[cfg(feature = "generate")]
mod read;
#[cfg(feature = "generate")]
mod read_answer;
mod render;
#[cfg(feature = "generate")]
mod render_object;
#[cfg(feature = "generate")]
mod render_shadows;
mod shade;
mod shade_images;
mod shader;
#[cfg(feature = "generate")]
mod shadows;

use clap::Subcommand;
use eigenshade_model::error::Result;

/// A command.
#[derive(Debug, Subcommand)]
pub enum Command {
    Demo(demo::Demo),
    List(list::List),
    #[cfg(feature = "generate")]
    Light(light::Light),
    #[cfg(feature = "generate")]
    Material(material::Material),
    #[cfg(feature = "generate")]
    Basis(basis::Basis),
    Pack(pack::Pack),
    #[cfg(feature = "generate")]
    PackObject(pack_object::PackObject),
    Info(info::Info),
    Eigenvalues(info::Eigenvalues),
    Project(project::Project),
    Shade(shade::Shade),
    Render(render::Render),
    #[cfg(feature = "generate")]
    Read(read::Read),
    Shader(shader::Shader),
    Export(export::Export),
    Evaluate(evaluate::Evaluate),
    Completions(manual::Completions),
    Man(manual::Manual),
}

impl Command {
    /// Runs the command of this program.
    pub fn run(self, program: clap::Command) -> Result<()> {
        match self {
            Self::Demo(command) => command.run(),
            Self::List(command) => command.run(),
            #[cfg(feature = "generate")]
            Self::Light(command) => command.run(),
            #[cfg(feature = "generate")]
            Self::Material(command) => command.run(),
            #[cfg(feature = "generate")]
            Self::Basis(command) => command.run(),
            Self::Pack(command) => command.run(),
            #[cfg(feature = "generate")]
            Self::PackObject(command) => command.run(),
            Self::Info(command) => command.run(),
            Self::Eigenvalues(command) => command.run(),
            Self::Project(command) => command.run(),
            Self::Shade(command) => command.run(),
            Self::Render(command) => command.run(),
            #[cfg(feature = "generate")]
            Self::Read(command) => command.run(),
            Self::Shader(command) => command.run(),
            Self::Export(command) => command.run(),
            Self::Evaluate(command) => command.run(),
            Self::Completions(command) => command.run(program),
            Self::Man(command) => command.run(program),
        }
    }
}
