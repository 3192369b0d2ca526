//! The number formats in which images are computed.

use eigenshade_table::{quantize, wire};
use std::fmt;

/// The number format in which an image is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// `f64`, in which tables are made.
    F64,
    /// A format of tables on a device.
    Table(wire::Format),
}

impl Format {
    /// `f32`.
    pub const F32: Self = Self::Table(wire::Format::F32);

    /// Mantissas of 15 bits.
    pub const Q15: Self = Self::Table(wire::Format::Integer(quantize::Format::Q15));

    /// Mantissas of 31 bits.
    pub const Q31: Self = Self::Table(wire::Format::Integer(quantize::Format::Q31));

    /// All formats.
    pub fn all() -> impl Iterator<Item = Self> {
        [Self::F64].into_iter().chain(wire::Format::ALL.map(Self::Table))
    }

    /// The format's name on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::F64 => "f64",
            Self::Table(format) => format.name(),
        }
    }

    /// The format to which the numbers of a table are rounded, if any.
    #[must_use]
    pub const fn of_table(self) -> Option<wire::Format> {
        match self {
            Self::F64 => None,
            Self::Table(format) => Some(format),
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
