//! The machines whose costs are known, and the unit of each cost.

/// A machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Machine {
    /// This machine.
    Host,
    /// Cortex-M0, emulated.
    M0,
    /// Cortex-M3, emulated.
    M3,
    /// Cortex-M4F, emulated.
    M4f,
    /// RV32IMAC, emulated.
    Rv32,
    /// WebAssembly with SIMD, in Node.
    Wasm,
}

/// The cost of a setting on a machine.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Price {
    /// A pixel; `None` if it has not been counted.
    pub pixel: Option<f64>,
    /// A new light on a transferred material, up to the first pixel.
    pub light: Option<f64>,
    /// Code and tables of the counted program.
    pub flash: Option<usize>,
    /// RAM of the counted program, including the stack.
    pub ram: Option<usize>,
}

impl Machine {
    /// All machines.
    pub const ALL: [Self; 6] = [Self::Host, Self::M0, Self::M3, Self::M4f, Self::Rv32, Self::Wasm];
    /// The machines whose instructions are counted.
    pub const BOARDS: [Self; 4] = [Self::M0, Self::M3, Self::M4f, Self::Rv32];

    /// The name in files and columns.
    #[must_use]
    pub fn key(self) -> &'static str {
        match self {
            Self::Host => "host",
            Self::M0 => "m0",
            Self::M3 => "m3",
            Self::M4f => "m4f",
            Self::Rv32 => "rv32",
            Self::Wasm => "wasm",
        }
    }

    /// The name in titles.
    #[must_use]
    pub fn title(self) -> &'static str {
        match self {
            Self::Host => "x86-64",
            Self::M0 => "Cortex-M0",
            Self::M3 => "Cortex-M3",
            Self::M4f => "Cortex-M4F",
            Self::Rv32 => "RV32IMAC",
            Self::Wasm => "WebAssembly",
        }
    }

    /// The unit of a pixel's cost.
    #[must_use]
    pub fn unit(self) -> &'static str {
        if self.counts() { "instructions" } else { "nine-term pixels" }
    }

    /// Whether its costs are instruction counts instead of times.
    #[must_use]
    pub fn counts(self) -> bool {
        !matches!(self, Self::Host | Self::Wasm)
    }

    /// Its board in `firmware/counts.csv`.
    #[must_use]
    pub fn board(self) -> Option<&'static str> {
        match self {
            Self::M0 => Some("microbit"),
            Self::M3 => Some("mps2-an385"),
            Self::M4f => Some("mps2-an386"),
            Self::Rv32 => Some("riscv32"),
            Self::Host | Self::Wasm => None,
        }
    }
}
