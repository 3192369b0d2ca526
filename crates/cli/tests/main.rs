//! Every test of the program, in one binary: to link each file by itself takes longer than the
//! tests do.

#[path = "../../../tests/every_file/mod.rs"]
mod every_file;
#[path = "../../../tests/oracle/mod.rs"]
mod oracle;
mod support;
#[path = "../../../tests/tolerances/mod.rs"]
mod tolerances;

mod accuracy_cost;
mod agreement;
mod bad_input;
mod baked_integers;
mod baked_tables;
mod check;
mod collisions;
mod commands;
mod corner_cases;
mod cuts;
mod direct_integration;
mod direct_quadrature;
mod effects;
mod flat_objects;
mod hard_cases;
mod hard_databases;
mod input_faults;
mod ladder;
mod materials;
mod memory;
mod object_faults;
mod object_inputs;
mod object_kinds;
mod objects;
mod outputs;
mod overflow;
mod pack;
mod paper_command;
mod paper_oracle;
mod paper_statements;
mod pbr_errors;
mod read;
mod read_faults;
mod read_objects;
mod read_pictures;
mod read_report;
mod readme;
mod sphere_normals;
mod stores;
mod terminal;
mod thread_counts;
mod tolerance_choice;
mod transfer;
mod warnings;
mod ways;

#[test]
fn every_file_is_compiled() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests");
    let left_out = every_file::left_out(folder, include_str!("main.rs"), &[]);
    assert!(left_out.is_empty(), "no binary has {left_out:?}");
}
