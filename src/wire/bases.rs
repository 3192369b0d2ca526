//! Bases from wire files, in floats and in integers.

use super::{Fault, WireError};
use crate::basis::Basis;
use crate::format::{Q15, Q31};
use crate::general::GeneralBasis;
use crate::index::wire::{read_floats, read_integers};
use crate::quantized;

impl<'a> Basis<'a, f32> {
    /// Reads a basis from a [wire](crate::wire) file that starts at a multiple of four.
    ///
    /// Cost: the checksum, with two look-ups per byte, and the checks of [`new`](Self::new).
    ///
    /// # Errors
    ///
    /// A [`WireError`] for any bytes that are not such a file.
    pub fn from_bytes(bytes: &'a [u8]) -> Result<Self, WireError> {
        let (parts, general) = read_floats(bytes)?;
        match general.components {
            0 => Ok(Self::new(parts)?),
            found => Err(Fault::Images { found }.into()),
        }
    }
}

impl<'a> GeneralBasis<'a, f32> {
    /// Reads the basis of an object other than the sphere from a [wire](crate::wire) file.
    /// Otherwise the same as [`Basis::from_bytes`].
    ///
    /// ```
    /// use eigenshade::wire::WireError;
    /// use eigenshade::{Coefficients, GeneralBasis, Light, Material};
    ///
    /// fn project(file: &[u8], light: &Light<f32>) -> Result<Coefficients<f32, 20>, WireError> {
    ///     let basis = GeneralBasis::from_bytes(file)?;
    ///     Ok(basis.project::<500, 20>(light, &Material::new(&[2.0])?)?)
    /// }
    ///
    /// assert!(project(&[], &Light::new(&[3.5])?).is_err());
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// A [`WireError`] for any bytes that are not such a file.
    pub fn from_bytes(bytes: &'a [u8]) -> Result<Self, WireError> {
        let (span, parts) = read_floats(bytes)?;
        if parts.components == 0 {
            return Err(Fault::Images { found: 0 }.into());
        }
        Ok(Self::new(Basis::new(span)?, parts)?)
    }
}

macro_rules! from_bytes {
    ($format:ident) => {
        impl<'a> quantized::Basis<'a, $format> {
            /// Reads a basis from a [wire](crate::wire) file that starts at a multiple of four.
            ///
            /// Cost: the checksum, with two look-ups per byte, and the checks of
            /// [`new`](Self::new). The largest values that a profile states are not checked: in a
            /// forged file, as opposed to a damaged one, they may make a pixel wrap.
            ///
            /// # Errors
            ///
            /// A [`WireError`] for any bytes that are not such a file.
            pub fn from_bytes(bytes: &'a [u8]) -> Result<Self, WireError> {
                Ok(Self::new(read_integers(bytes)?)?)
            }
        }
    };
}
from_bytes!(Q15);
from_bytes!(Q31);
