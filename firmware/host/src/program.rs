//! The emulated boards, and the programs of each.

use crate::list::{self, Listed};

#[derive(Clone, Copy, Debug)]
pub struct Board {
    /// Its name on the command line and in the CSV.
    pub name: &'static str,
    /// The processor, as in the documentation.
    pub processor: &'static str,
    pub target: &'static str,
    pub emulator: &'static str,
    /// The emulator's arguments that select the machine.
    pub machine: &'static [&'static str],
    /// Twice the number of instructions in a tick of its clock, which runs at 16 MHz or 25 MHz or
    /// counts instructions.
    pub half_instructions_in_a_tick: u64,
    /// How it computes in floats.
    pub floats: Floats,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Floats {
    /// Not at all.
    None,
    /// With routines for integers.
    Software,
    /// With a float unit.
    Hardware,
}

/// A Cortex-M0 with 256 KB of flash and 16 KB of RAM.
pub const MICROBIT: Board = Board {
    name: "microbit",
    processor: "M0",
    target: "thumbv6m-none-eabi",
    emulator: "qemu-system-arm",
    machine: &["-M", "microbit"],
    half_instructions_in_a_tick: 125,
    floats: Floats::None,
};

/// A Cortex-M4 with a float unit.
pub const AN386: Board = Board {
    name: "mps2-an386",
    processor: "M4F",
    target: "thumbv7em-none-eabihf",
    emulator: "qemu-system-arm",
    machine: &["-M", "mps2-an386"],
    half_instructions_in_a_tick: 80,
    floats: Floats::Hardware,
};

/// Every board: also a Cortex-M3, and RISC-V of 32 bits with multiplication, atomics and compressed
/// instructions.
pub const BOARDS: [Board; 4] = [
    MICROBIT,
    Board {
        name: "mps2-an385",
        processor: "M3",
        target: "thumbv7m-none-eabi",
        emulator: "qemu-system-arm",
        machine: &["-M", "mps2-an385"],
        half_instructions_in_a_tick: 80,
        floats: Floats::Software,
    },
    AN386,
    Board {
        name: "riscv32",
        processor: "RV32",
        target: "riscv32imac-unknown-none-elf",
        emulator: "qemu-system-riscv32",
        machine: &["-M", "virt", "-bios", "none"],
        half_instructions_in_a_tick: 2,
        floats: Floats::Software,
    },
];

/// The purpose of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The common part of the measured programs, without an operation.
    Empty,
    /// One operation, measured.
    Operation,
    /// A table of one size, or sources: several operations of one program, and its total
    /// memory.
    Scene,
    /// A complete program, whose size has a budget.
    Complete,
    /// Prints something, or fails.
    Demonstration,
}

/// Components K of the shipped table.
const COMPONENTS: u64 = 46;

impl Listed {
    pub fn kind(&self) -> Kind {
        match self.source {
            "empty" => Kind::Empty,
            "golden_f32" | "golden_q15" | "readme" => Kind::Demonstration,
            "scene_f32" | "size_q15" | "sources_f32" | "sources_q15" => Kind::Scene,
            "complete_q15" => Kind::Complete,
            _ => Kind::Operation,
        }
    }

    pub fn profile(&self) -> &'static str {
        if self.kind() == Kind::Complete { "small" } else { "fast" }
    }

    /// A factor for the counts: the number of rows of a matrix of which the program has one.
    pub fn times(&self) -> u64 {
        if self.name == "dense_row_q15" { COMPONENTS } else { 1 }
    }

    fn runs_on(&self, board: Board) -> bool {
        match (self.source, list::parts(self.name).1) {
            // Without a float unit, integers cost a twentieth of the instructions of floats.
            ("scene_f32" | "sources_f32", _) => board.floats == Floats::Hardware,
            // A frame is longer than the clock without one.
            ("watch", "f32") => board.floats == Floats::Hardware,
            // Its screen takes 115,200 bytes.
            ("readme", _) => board.floats != Floats::None,
            (_, format) => board.floats != Floats::None || format != "f32",
        }
    }
}

/// The programs that run on a board, the empty one first.
pub fn of_board(board: Board) -> impl Iterator<Item = Listed> {
    list::programs().filter(move |program| program.runs_on(board))
}

#[cfg(test)]
mod tests {
    use super::{BOARDS, Kind, of_board};
    use crate::list;

    #[test]
    fn every_program_runs_on_a_board_after_the_empty_one() {
        for listed in list::programs() {
            let runs = |board| of_board(board).any(|one| one.name == listed.name);
            assert!(BOARDS.into_iter().any(runs), "{}", listed.name);
        }
        for board in BOARDS {
            assert_eq!(of_board(board).next().map(|one| one.kind()), Some(Kind::Empty));
        }
    }

    #[test]
    fn every_table_has_programs() {
        let has = |name: &str, source: &str| {
            list::programs().any(|one| list::parts(one.name).0 == name && one.source == source)
        };
        let sizes = include_str!("../../tables/sizes.csv").lines();
        for line in sizes.filter(|line| !line.starts_with('#')).skip(1) {
            let name = line.split(',').next().unwrap();
            assert!(has(name, "scene_f32") && has(name, "size_q15"), "{name}");
        }
    }
}
