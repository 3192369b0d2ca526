//! Every test of the experiments, in one binary.

#[path = "../../crates/cli/tests/support/mod.rs"]
mod support;

mod ablation_page;
mod accuracy_cost;
mod economy_floor;
mod hard_cases;
mod high_degree;
mod ladder;
mod paper_command;
mod paper_oracle;
mod paper_statements;
mod reading_page;

use eigenshade_testing::oracle;
use experiments::tolerances;

/// The program that tests run.
const PROGRAM: &str = env!("CARGO_BIN_EXE_experiments");
