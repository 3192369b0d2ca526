//! Every test of the program, in one binary: to link each file by itself takes longer than the
//! tests do.

mod support;
use eigenshade_testing::tolerances;

mod accuracy_page;
mod agreement;
mod bad_input;
mod baked_integers;
mod baked_tables;
mod check;
mod collisions;
mod commands;
mod corner_cases;
mod cuts;
mod direct_quadrature;
mod effects;
mod flat_objects;
mod hard_cases;
mod hard_databases;
mod input_faults;
mod materials;
mod memory;
mod object_faults;
mod object_inputs;
mod object_kinds;
mod objects;
mod outputs;
mod overflow;
mod pack;
mod pbr_errors;
mod read;
mod read_faults;
mod read_objects;
mod read_pictures;

mod sphere_normals;
mod stores;
mod terminal;
mod thread_counts;
mod tolerance_choice;
mod transfer;
mod warnings;
mod ways;

use eigenshade_testing::oracle;

/// The program that has this command.
fn program(_command: &str) -> &'static str {
    env!("CARGO_BIN_EXE_eigenshade")
}
