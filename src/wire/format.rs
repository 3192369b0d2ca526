//! The number formats of wire files.

use crate::index::wire::format;

/// The number format of a wire file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum WireFormat {
    /// 32-bit floats, `f32`.
    F32,
    /// 16-bit fixed point, [`Q15`](crate::Q15).
    Q15,
    /// 32-bit fixed point, [`Q31`](crate::Q31).
    Q31,
}

impl WireFormat {
    /// The format with this number in a file, or `None` if there is none.
    #[must_use]
    pub const fn of(number: u16) -> Option<Self> {
        match number {
            format::F32 => Some(Self::F32),
            format::Q15 => Some(Self::Q15),
            format::Q31 => Some(Self::Q31),
            _ => None,
        }
    }

    /// The name of the format on a command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::Q15 => "q15",
            Self::Q31 => "q31",
        }
    }
}
