//! The number formats of a table on a device.

/// A number format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "files", derive(serde::Serialize, serde::Deserialize))]
pub enum NumberFormat {
    /// `f32`.
    F32,
    /// 15-bit mantissas and a sign, [`Q15`](crate::record::Q15), with a common power of two for
    /// each row.
    Q15,
}

impl NumberFormat {
    /// All formats.
    pub const ALL: [Self; 2] = [Self::F32, Self::Q15];

    /// The number of the format in a wire file.
    #[must_use]
    pub const fn number(self) -> u16 {
        match self {
            Self::F32 => 1,
            Self::Q15 => 2,
        }
    }

    /// The format with this number in a wire file, or `None` if there is none.
    #[must_use]
    pub fn of(number: u16) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.number() == number)
    }

    /// The format's name on the command line and the name of its module.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::Q15 => "q15",
        }
    }
}
