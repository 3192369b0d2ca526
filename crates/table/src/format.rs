//! The number formats of a table on a device.

use serde::{Deserialize, Serialize};

/// A number format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Format {
    /// `f32`.
    F32,
    /// An integer format.
    Integer(IntegerFormat),
}

impl Format {
    /// All formats.
    pub const ALL: [Self; 3] =
        [Self::F32, Self::Integer(IntegerFormat::Q31), Self::Integer(IntegerFormat::Q15)];

    /// The format's name on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::Integer(format) => format.name(),
        }
    }
}

/// An integer format: mantissas with a common power of two for each row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum IntegerFormat {
    /// 15-bit mantissas and a sign.
    Q15,
    /// 31-bit mantissas and a sign.
    Q31,
}

impl IntegerFormat {
    /// Number of bits of a mantissa, without the sign.
    #[must_use]
    pub const fn bits(self) -> i32 {
        match self {
            Self::Q15 => 15,
            Self::Q31 => 31,
        }
    }

    /// The format's name on the command line and the name of its module.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Q15 => "q15",
            Self::Q31 => "q31",
        }
    }

    /// The truncation error that is allowed for polynomials in this format, relative to the
    /// database's rms. It is smaller than the format's rounding error.
    #[must_use]
    pub const fn tolerance(self) -> f64 {
        match self {
            Self::Q15 => 1e-5,
            Self::Q31 => 1e-8,
        }
    }
}
