//! The counts measured on the emulated boards: `firmware/counts.csv`.

use std::collections::BTreeMap;

/// The processor without a floating-point unit, and the number format that suits it.
pub const M0: [&str; 2] = ["microbit", "q15"];
/// The processor with a floating-point unit.
pub const M4F: [&str; 2] = ["mps2-an386", "f32"];
/// Cortex-M3, in integers.
pub const M3: [&str; 2] = ["mps2-an385", "q15"];
/// 32-bit RISC-V, in integers.
pub const RV32: [&str; 2] = ["riscv32", "q15"];

/// A column of the file.
#[derive(Clone, Copy, Debug)]
pub enum Column {
    /// Instructions of one operation.
    Instructions,
    /// Bytes of flash.
    Flash,
    /// Bytes of RAM, without the stack.
    Ram,
    /// Bytes of stack.
    Stack,
}

/// The file's rows, by board, format and operation.
#[derive(Clone, Debug)]
pub struct Counts(BTreeMap<[String; 3], [Option<u64>; 4]>);

impl Counts {
    /// The recorded counts.
    pub fn recorded() -> Self {
        let path = eigenshade_testing::repository().join("firmware/counts.csv");
        let text = std::fs::read_to_string(path).expect("the recorded counts");
        let lines = text.lines().filter(|line| !line.starts_with('#')).skip(1);
        let row = |line: &str| {
            let fields: Vec<&str> = line.split(',').collect();
            let number = |k: usize| fields[k].parse().ok();
            let key = [fields[0], fields[2], fields[1]].map(str::to_owned);
            (key, [3, 4, 5, 6].map(number))
        };
        Self(lines.map(row).collect())
    }

    /// A count of an operation on a board in its format; `None` if it was not measured.
    pub fn get(&self, [board, format]: [&str; 2], operation: &str, column: Column) -> Option<u64> {
        let key = [board, format, operation].map(str::to_owned);
        self.0.get(&key)?[column as usize]
    }

    /// The instructions of an operation, relative to those of a pixel by the nine-term formula.
    ///
    /// # Panics
    ///
    /// If either was not counted.
    pub fn of_nine_terms(&self, on: [&str; 2], operation: &str) -> f64 {
        let count = |operation: &str| {
            self.get(on, operation, Column::Instructions).expect("an operation that was counted")
        };
        count(operation) as f64 / count("nine_terms") as f64
    }
}
