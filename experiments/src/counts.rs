//! The counts measured on the emulated boards: `firmware/counts.csv`.

use crate::sheet::{Record, Sheet};

/// The processor without a floating-point unit, and the number format that suits it.
pub const M0: [&str; 2] = ["microbit", "q15"];
/// The processor with a floating-point unit.
pub const M4F: [&str; 2] = ["mps2-an386", "f32"];
/// Cortex-M3, in integers.
pub const M3: [&str; 2] = ["mps2-an385", "q15"];
/// 32-bit RISC-V, in integers.
pub const RV32: [&str; 2] = ["riscv32", "q15"];

/// The file's rows.
#[derive(Clone, Debug)]
pub struct Counts(pub Vec<Record>);

impl Counts {
    /// The recorded counts.
    pub fn recorded() -> Self {
        let path = eigenshade_testing::repository().join("firmware/counts.csv");
        let text = std::fs::read_to_string(&path).expect("the recorded counts");
        Self(Sheet::parse(&text, path).expect("rows of counts").rows)
    }

    /// A count of an operation on a board in its format: `instructions`, or bytes of flash, RAM
    /// without the stack, or stack. `None` if it was not measured.
    pub fn get(&self, on: [&str; 2], operation: &str, column: &str) -> Option<u64> {
        let is_it = |row: &&Record| {
            ["board", "format"].map(|one| row.text(one)) == on && row.text("operation") == operation
        };
        let text = self.0.iter().find(is_it)?.text(column);
        (!text.is_empty()).then(|| text.parse().expect("a whole number"))
    }

    /// The instructions of an operation, relative to those of a pixel by the nine-term formula.
    ///
    /// # Panics
    ///
    /// If either was not counted.
    pub fn of_nine_terms(&self, on: [&str; 2], operation: &str) -> f64 {
        let count = |operation: &str| {
            self.get(on, operation, "instructions").expect("an operation that was counted")
        };
        count(operation) as f64 / count("nine_terms") as f64
    }
}
