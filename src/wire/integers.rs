//! Fixed-point bases from wire files.

use super::WireError;
use super::file::File;
use super::format::WireFormat;
use crate::format::{Q15, Q31};
use crate::quantised::{Basis, Parts};
use zerocopy::{FromBytes, Immutable, KnownLayout};

macro_rules! from_bytes {
    ($format:ident) => {
        impl<'a> Basis<'a, $format> {
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
                Ok(Self::new(read(bytes, WireFormat::$format)?)?)
            }
        }
    };
}
from_bytes!(Q15);
from_bytes!(Q31);

/// Reads the arrays of a file.
fn read<Q>(bytes: &[u8], format: WireFormat) -> Result<Parts<'_, Q>, WireError>
where
    Q: FromBytes + KnownLayout + Immutable,
{
    let mut file = File::open(bytes, format)?;
    let header = file.header;
    if header.images != 0 {
        return Err(WireError::Images { found: header.images });
    }
    let parts = Parts {
        degree: header.degree,
        order: header.order,
        effects: header.effects,
        components: header.components,
        profiles: file.section()?,
        lengths: file.section()?,
        polar: file.section()?,
        polar_exponents: file.section()?,
        factors: file.section()?,
        factor_exponents: file.section()?,
        terms: file.section()?,
    };
    file.end()?;
    Ok(parts)
}
