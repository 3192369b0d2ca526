//! The emulated boards.

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
