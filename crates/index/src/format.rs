//! The number formats of a table on a device.

/// A number format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum NumberFormat {
    /// `f32`.
    F32,
    /// An integer format.
    Integer(IntegerFormat),
}

impl NumberFormat {
    /// 15-bit mantissas, [`Q15`](crate::record::Q15).
    pub const Q15: Self = Self::Integer(IntegerFormat::Q15);
    /// 31-bit mantissas, [`Q31`](crate::record::Q31).
    pub const Q31: Self = Self::Integer(IntegerFormat::Q31);
    /// All formats.
    pub const ALL: [Self; 3] = [Self::F32, Self::Q31, Self::Q15];

    /// The number of the format in a wire file.
    #[must_use]
    pub const fn number(self) -> u16 {
        match self {
            Self::F32 => 1,
            Self::Q15 => 2,
            Self::Q31 => 3,
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
            Self::Q31 => "q31",
        }
    }
}

/// An integer format: mantissas with a common power of two for each row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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

    /// As [`NumberFormat::name`].
    #[must_use]
    pub const fn name(self) -> &'static str {
        NumberFormat::Integer(self).name()
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
