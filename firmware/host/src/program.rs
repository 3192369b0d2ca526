//! The emulated boards, and the programs of each.

use crate::list::{self, Program};

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
    /// Twice the number of instructions in a tick of its clock, which runs at 16 MHz or 25 MHz; 0
    /// if only answers are checked on it.
    pub half_instructions_in_a_tick: u64,
    /// Whether it computes in floats, and has the memory of a screen.
    pub is_large: bool,
}

/// A Cortex-M0 with 256 KB of flash and 16 KB of RAM.
pub const MICROBIT: Board = Board {
    name: "microbit",
    processor: "M0",
    target: "thumbv6m-none-eabi",
    emulator: "qemu-system-arm",
    machine: &["-M", "microbit"],
    half_instructions_in_a_tick: 125,
    is_large: false,
};

/// A Cortex-M4 with a float unit.
pub const AN386: Board = Board {
    name: "mps2-an386",
    processor: "M4F",
    target: "thumbv7em-none-eabihf",
    emulator: "qemu-system-arm",
    machine: &["-M", "mps2-an386"],
    half_instructions_in_a_tick: 80,
    is_large: true,
};

/// The boards whose instructions are counted: without a float unit and with one.
pub const COUNTED: [Board; 2] = [MICROBIT, AN386];

/// Every board: also a Cortex-M3, and RISC-V of 32 bits with multiplication, atomics and compressed
/// instructions, which compute floats with routines.
pub const BOARDS: [Board; 4] = [
    MICROBIT,
    AN386,
    Board {
        name: "mps2-an385",
        processor: "M3",
        target: "thumbv7m-none-eabi",
        emulator: "qemu-system-arm",
        machine: &["-M", "mps2-an385"],
        half_instructions_in_a_tick: 0,
        is_large: true,
    },
    Board {
        name: "riscv32",
        processor: "RV32",
        target: "riscv32imac-unknown-none-elf",
        emulator: "qemu-system-riscv32",
        machine: &["-M", "virt", "-bios", "none"],
        half_instructions_in_a_tick: 0,
        is_large: true,
    },
];

impl Board {
    pub fn is_counted(&self) -> bool {
        self.half_instructions_in_a_tick > 0
    }
}

/// The purpose of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The common part of the measured programs, without an operation.
    Empty,
    /// Compares its results with the expected ones.
    Answers,
    /// One operation, measured.
    Operation,
    /// A table of one size, or sources: several operations of one program, and its total memory.
    Scene,
    /// Draws a picture; its size has a limit.
    Complete,
}

impl Program {
    pub fn kind(&self) -> Kind {
        match self.source {
            "empty" => Kind::Empty,
            "golden" | "readme" => Kind::Answers,
            "scene" | "sources" => Kind::Scene,
            "complete" => Kind::Complete,
            _ => Kind::Operation,
        }
    }

    /// Complete programs are small, because their flash has a limit.
    pub fn opt_level(&self) -> &'static str {
        if self.kind() == Kind::Complete { "s" } else { "3" }
    }

    /// The machine that a program of this board runs on. Large ones of the micro:bit have the memory
    /// of a Cortex-M3's machine, which executes the instructions of a Cortex-M0.
    pub fn machine(&self, board: Board) -> Board {
        if self.is_large() && !board.is_large {
            let half_instructions_in_a_tick = AN386.half_instructions_in_a_tick;
            Board { machine: &["-M", "mps2-an385"], half_instructions_in_a_tick, ..board }
        } else {
            board
        }
    }

    fn runs_on(&self, board: Board) -> bool {
        match (self.source, self.format) {
            ("golden", "f32") | ("readme", _) => board.is_large,
            ("golden" | "complete" | "watch", "q15") => true,
            (_, format) => board.is_counted() && (board.is_large || format != "f32"),
        }
    }
}

/// The programs that run on a board. On one that is counted, the empty one is the first.
pub fn of_board(board: Board) -> Vec<Program> {
    list::programs().into_iter().filter(|program| program.runs_on(board)).collect()
}

#[cfg(test)]
mod tests {
    use super::{BOARDS, COUNTED, Kind, of_board};
    use crate::list;

    #[test]
    fn every_program_is_counted_after_the_empty_one_or_has_answers() {
        for one in list::programs() {
            let runs = |board| of_board(board).iter().any(|other| other.name() == one.name());
            assert!(COUNTED.into_iter().any(runs), "{one:?}");
        }
        for board in COUNTED {
            assert_eq!(of_board(board)[0].kind(), Kind::Empty);
        }
        let names = |program: &list::Program| program.name();
        let others = BOARDS.into_iter().filter(|board| !board.is_counted());
        for board in others {
            let found: Vec<String> = of_board(board).iter().map(names).collect();
            assert_eq!(
                found,
                [
                    "golden_f32",
                    "golden_q15",
                    "readme_q15",
                    "watch_q15",
                    "watch_240_q15",
                    "watch_240_still_q15",
                    "any_material_q15",
                    "one_material_q15"
                ]
            );
        }
    }
}
