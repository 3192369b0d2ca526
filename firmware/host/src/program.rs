//! The emulated boards, and the list of programs.

/// An emulated board.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Board {
    /// Cortex-M0, 256 KB of flash, 16 KB of RAM, no float unit.
    Microbit,
    /// Cortex-M3.
    An385,
    /// Cortex-M4 with a float unit.
    An386,
    /// RISC-V of 32 bits: integers, multiplication, atomics, compressed.
    Riscv32,
}

impl Board {
    /// Every board.
    pub const ALL: [Self; 4] = [Self::Microbit, Self::An385, Self::An386, Self::Riscv32];

    /// The board of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|board| board.name() == name)
    }

    /// Its name on the command line and in the CSV.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Microbit => "microbit",
            Self::An385 => "mps2-an385",
            Self::An386 => "mps2-an386",
            Self::Riscv32 => "riscv32",
        }
    }

    /// The processor, as in the documentation.
    pub const fn processor(self) -> &'static str {
        match self {
            Self::Microbit => "M0",
            Self::An385 => "M3",
            Self::An386 => "M4F",
            Self::Riscv32 => "RV32",
        }
    }

    /// The compiler's target.
    pub const fn target(self) -> &'static str {
        match self {
            Self::Microbit => "thumbv6m-none-eabi",
            Self::An385 => "thumbv7m-none-eabi",
            Self::An386 => "thumbv7em-none-eabihf",
            Self::Riscv32 => "riscv32imac-unknown-none-elf",
        }
    }

    /// The emulator, with the arguments that select the machine.
    pub const fn emulator(self) -> (&'static str, &'static [&'static str]) {
        match self {
            Self::Microbit => ("qemu-system-arm", &["-M", "microbit"]),
            Self::An385 => ("qemu-system-arm", &["-M", "mps2-an385"]),
            Self::An386 => ("qemu-system-arm", &["-M", "mps2-an386"]),
            Self::Riscv32 => ("qemu-system-riscv32", &["-M", "virt", "-bios", "none"]),
        }
    }

    /// Twice the number of instructions in a tick of its clock, which runs at 16 MHz or 25 MHz or
    /// counts instructions.
    pub const fn half_instructions_in_a_tick(self) -> u64 {
        match self {
            Self::Microbit => 125,
            Self::An385 | Self::An386 => 80,
            Self::Riscv32 => 2,
        }
    }

    /// Whether its programs may compute in floats.
    pub const fn takes_floats(self) -> bool {
        !matches!(self, Self::Microbit)
    }

    /// Whether it computes floats in hardware.
    pub const fn has_float_unit(self) -> bool {
        matches!(self, Self::An386)
    }
}

/// The purpose of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The common part of the measured programs, without an operation.
    Empty,
    /// One operation, measured.
    Operation,
    /// A scene of the ablation, or a table of the ladder: several operations of one program, and
    /// its total memory.
    Scene,
    /// A whole program, whose size has a budget.
    Whole,
    /// Prints something, or fails.
    Demonstration,
}

/// A program: `OPERATION_FORMAT` in `programs/src/bin`.
#[derive(Clone, Copy, Debug)]
pub struct Program {
    /// Its operation.
    pub operation: &'static str,
    /// Its number format.
    pub format: &'static str,
    /// Its purpose.
    pub kind: Kind,
    /// A factor for the counts: the number of rows of a matrix of which the program has one.
    pub times: u64,
}

impl Program {
    /// The name of its binary.
    pub fn binary(&self) -> String {
        match self.kind {
            Kind::Empty => self.operation.into(),
            _ => format!("{}_{}", self.operation, self.format),
        }
    }

    /// The profile it is built with.
    pub const fn profile(&self) -> &'static str {
        match self.kind {
            Kind::Whole => "small",
            _ => "fast",
        }
    }
}

/// Operations that exist in all three formats.
const OPERATIONS: [&str; 6] =
    ["shade", "shade_lambertian", "relight", "collapse", "relight_collapse", "transfer"];

/// The scenes of `firmware/scenes`, in the order of `docs/ablation.md`.
const SCENES: [&str; 10] = [
    "ambient_lambertian",
    "ambient_velvet",
    "sky_lambertian",
    "park_lambertian",
    "park_lambertian_fine",
    "studio_plaster",
    "studio_velvet",
    "sun_leather",
    "sun_leather_color",
    "sun_leather_turning",
];

/// The scene without an integer program, because integers do not turn lights.
const TURNING: &str = "sun_leather_turning";

/// The tables for which a pixel and a new light are counted.
const LADDER: &str = include_str!("../../tables/ladder.csv");

/// Components K of the shipped table.
const COMPONENTS: u64 = 50;

/// The names of the ladder's tables.
fn ladder() -> impl Iterator<Item = &'static str> {
    let rows = LADDER.lines().filter(|line| !line.starts_with('#')).skip(1);
    rows.filter_map(|row| row.split(',').next())
}

/// The programs that run on a board, the empty one first.
pub fn of_board(board: Board) -> impl Iterator<Item = Program> {
    let one = |operation, format, kind| Program { operation, format, kind, times: 1 };
    let mut all = vec![one("empty", "none", Kind::Empty)];
    for format in ["f32", "q15", "q31"] {
        all.push(one("golden", format, Kind::Demonstration));
        all.push(one("sphere", format, Kind::Demonstration));
        all.extend(OPERATIONS.map(|operation| one(operation, format, Kind::Operation)));
    }
    all.extend(
        ["project", "collapse_within", "nine_terms"].map(|name| one(name, "f32", Kind::Operation)),
    );
    all.push(one("nine_terms", "q15", Kind::Operation));
    for format in ["f32", "q15"] {
        all.extend(["baked", "baked_point"].map(|name| one(name, format, Kind::Operation)));
    }
    all.push(Program { times: COMPONENTS, ..one("dense_row", "q15", Kind::Operation) });
    all.push(one("any_material", "q15", Kind::Whole));
    all.push(one("one_material", "q15", Kind::Whole));
    for name in ladder() {
        // Without a float unit, integers cost a twentieth of the instructions.
        if board.has_float_unit() {
            all.push(one(name, "f32", Kind::Scene));
        }
        all.push(one(name, "q15", Kind::Scene));
    }
    // Scenes: Q15 on the processor without a float unit, f32 on the one with it.
    match board {
        Board::Microbit => {
            let still = SCENES.into_iter().filter(|name| *name != TURNING);
            all.extend(still.map(|name| one(name, "q15", Kind::Scene)));
        }
        Board::An386 => all.extend(SCENES.map(|name| one(name, "f32", Kind::Scene))),
        _ => {}
    }
    all.into_iter().filter(move |program| board.takes_floats() || program.format != "f32")
}
