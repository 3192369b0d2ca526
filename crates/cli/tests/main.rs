//! Every test of the program, in one binary: to link each file by itself takes longer than the
//! tests do.

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
mod direct_integration;
mod direct_quadrature;
mod effects;
mod flat_objects;
mod hard_cases;
mod hard_databases;
mod input_faults;
mod ladder;
mod materials;
mod object_faults;
mod object_inputs;
mod object_kinds;
mod objects;
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
mod thread_counts;
mod tolerance_choice;
mod transfer;
mod ways;
