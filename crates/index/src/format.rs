//! The number formats of a table on a device.

use crate::record::{Item, Q15, Q31};

/// A number format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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

    /// The number of the format in a wire file.
    #[must_use]
    pub const fn number(self) -> u16 {
        match self {
            Self::F32 => 1,
            Self::Integer(IntegerFormat::Q15) => 2,
            Self::Integer(IntegerFormat::Q31) => 3,
        }
    }

    /// The format with this number in a wire file, or `None` if there is none.
    #[must_use]
    pub const fn of(number: u16) -> Option<Self> {
        let mut rest = Self::ALL.as_slice();
        while let [format, others @ ..] = rest {
            if format.number() == number {
                return Some(*format);
            }
            rest = others;
        }
        None
    }
}

/// An integer format: mantissas with a common power of two for each row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum IntegerFormat {
    /// 15-bit mantissas and a sign, [`Q15`].
    Q15,
    /// 31-bit mantissas and a sign, [`Q31`].
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

/// A mantissa of an integer format.
pub trait Mantissa: Item {
    /// The format.
    const FORMAT: IntegerFormat;
    /// The name of this type.
    const TYPE_NAME: &'static str;
    /// The number with this mantissa, which must fit the format.
    fn of(mantissa: i32) -> Self;
}

macro_rules! mantissa {
    ($format:ident) => {
        impl Mantissa for $format {
            const FORMAT: IntegerFormat = IntegerFormat::$format;
            const TYPE_NAME: &'static str = stringify!($format);
            fn of(mantissa: i32) -> Self {
                Self(mantissa as _)
            }
        }
    };
}
mantissa!(Q15);
mantissa!(Q31);

/// Evaluates `$body` with `$mantissa` as the type of the mantissas of an [`IntegerFormat`].
#[macro_export]
macro_rules! by_format {
    ($format:expr, $mantissa:ident => $body:expr) => {
        match $format {
            $crate::format::IntegerFormat::Q15 => {
                type $mantissa = $crate::record::Q15;
                $body
            }
            $crate::format::IntegerFormat::Q31 => {
                type $mantissa = $crate::record::Q31;
                $body
            }
        }
    };
}
