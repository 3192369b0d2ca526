//! The tests of the program in one binary, because linking a binary for each file takes longer than
//! the tests.

mod support;

mod bad_objects;
mod basis;
mod commands;
mod compiled;
mod corner_cases;
mod direct_sum;
mod effects;
mod export;
mod export_source;
mod foreign_files;
mod habits;
mod highlights;
mod limits;
mod materials;
mod object_scenes;
mod objects;
mod outputs;
mod own_materials;
mod pictures;
mod read;
mod read_meshes;
mod results;
mod scene_choices;
mod shade;
mod shader;
mod shader_sources;
mod shapes;
#[cfg(unix)]
mod tables;
mod tolerance_choice;

use eigenshade_testing::tolerances;

/// The program.
const PROGRAM: &str = env!("CARGO_BIN_EXE_eigenshade");

/// The program that has this command.
fn program(_command: &str) -> &'static str {
    PROGRAM
}
