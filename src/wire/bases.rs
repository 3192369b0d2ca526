//! Bases from wire files, in floats and in integers.

use super::error::{WireError, WireFormat};
use super::file::File;
use crate::basis::Basis;
use crate::format::{Q15, Q31};
use crate::general::GeneralBasis;
use crate::index::record::Item;
use crate::index::record::floats::{GeneralParts, Parts};
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
        let (basis, general) = read(bytes)?;
        match general.components {
            0 => Ok(basis),
            found => Err(WireError::Images { found }),
        }
    }
}

impl<'a> GeneralBasis<'a, f32> {
    /// Reads the basis of an object other than the sphere from a [wire](crate::wire) file.
    /// Otherwise the same as [`Basis::from_bytes`].
    ///
    /// # Errors
    ///
    /// A [`WireError`] for any bytes that are not such a file.
    pub fn from_bytes(bytes: &'a [u8]) -> Result<Self, WireError> {
        let (span, parts) = read(bytes)?;
        if parts.components == 0 {
            return Err(WireError::Images { found: 0 });
        }
        Ok(Self::new(span, parts)?)
    }
}

/// Reads the basis or span of a file, and the eigenimages over that span.
fn read(bytes: &[u8]) -> Result<(Basis<'_, f32>, GeneralParts<'_, f32>), WireError> {
    let mut file = File::open(bytes, WireFormat::F32)?;
    let parts = Parts::read(file.header.shape(), &mut file)?;
    let general = GeneralParts::read((file.header.images,), &mut file)?;
    file.end()?;
    Ok((Basis::new(parts)?, general))
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
                Ok(Self::new(read_integers(bytes, WireFormat::$format)?)?)
            }
        }
    };
}
from_bytes!(Q15);
from_bytes!(Q31);

/// Reads the arrays of a file.
fn read_integers<Q: Item>(
    bytes: &[u8],
    format: WireFormat,
) -> Result<quantized::Parts<'_, Q>, WireError> {
    let mut file = File::open(bytes, format)?;
    if file.header.images != 0 {
        return Err(WireError::Images { found: file.header.images });
    }
    let parts = quantized::Parts::read(file.header.shape(), &mut file)?;
    file.end()?;
    Ok(parts)
}
