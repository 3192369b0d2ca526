//! The counts measured on the emulated boards: `firmware/counts.csv`.

use std::collections::HashMap;

/// The processor without a floating-point unit, and the number format that suits it.
pub const M0: [&str; 2] = ["microbit", "q15"];
/// The processor with a floating-point unit.
pub const M4F: [&str; 2] = ["mps2-an386", "f32"];
/// Cortex-M3, in integers.
pub const M3: [&str; 2] = ["mps2-an385", "q15"];
/// 32-bit RISC-V, in integers.
pub const RV32: [&str; 2] = ["riscv32", "q15"];

/// The file's rows: texts by column.
#[derive(Clone, Debug)]
pub struct Counts(Vec<HashMap<String, String>>);

impl Counts {
    /// The recorded counts.
    pub fn recorded() -> Self {
        let path = eigenshade_testing::repository().join("firmware/counts.csv");
        let reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(path);
        let rows = reader.expect("the recorded counts").into_deserialize();
        Self(rows.map(|row| row.expect("a row")).collect())
    }

    /// A count of an operation on a board in its format: `instructions`, or bytes of flash, RAM
    /// without the stack, or stack. `None` if it was not measured.
    pub fn get(&self, [board, format]: [&str; 2], operation: &str, column: &str) -> Option<u64> {
        let is_it = |row: &&HashMap<String, String>| {
            row["board"] == board && row["format"] == format && row["operation"] == operation
        };
        let text = &self.0.iter().find(is_it)?[column];
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
