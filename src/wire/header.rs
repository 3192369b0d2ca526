//! The header of a wire file.

use super::error::WireError;
use crate::index::effect::Effects;
use crate::index::wire::{HEADER, LABEL, MARK, MAX_DEGREE_AND_ORDER, VERSION, place};

/// The header of a wire file: its format, its size and the shape of its table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct Header {
    /// The version of the file.
    pub version: u16,
    /// The number format of the file: see [`WireFormat::of`](super::WireFormat::of).
    pub format: u16,
    /// Length of the whole file in bytes.
    pub length: usize,
    /// Largest degree l of the light.
    pub degree: usize,
    /// Largest order o of the BRDF.
    pub order: usize,
    /// The effects that the table covers.
    pub effects: Effects,
    /// Number of components; if there are eigenimages, the components of their span.
    pub components: usize,
    /// Number of eigenimages over the span, or 0.
    pub images: usize,
    /// Number of sections.
    pub sections: usize,
}

impl Header {
    /// Reads the header of a file. The bytes need not be aligned or complete, and the checksum is
    /// not checked.
    ///
    /// # Errors
    ///
    /// [`WireError::Foreign`], [`WireError::Endianness`], [`WireError::Version`],
    /// [`WireError::Shape`], or [`WireError::Length`] if even the header is incomplete.
    pub fn read(bytes: &[u8]) -> Result<Self, WireError> {
        if !bytes.starts_with(&LABEL) {
            return Err(WireError::Foreign);
        }
        let Some(header) = bytes.first_chunk::<HEADER>() else {
            return Err(WireError::Length { expected: HEADER, found: bytes.len() });
        };
        let mark = long(header, place::MARK);
        if mark != MARK {
            let other = mark == MARK.swap_bytes();
            return Err(if other { WireError::Endianness } else { WireError::Foreign });
        }
        let version = short(header, place::VERSION);
        let bits = short(header, place::EFFECTS);
        if version != VERSION {
            return Err(WireError::Version(version));
        }
        let effects = Effects::from_bits(bits).filter(|&one| one != Effects::NONE);
        let Some(effects) = effects else { return Err(WireError::Effects { bits }) };
        let size = |at| usize::from(short(header, at));
        let (degree, order) = (size(place::DEGREE), size(place::ORDER));
        if degree > MAX_DEGREE_AND_ORDER || order > MAX_DEGREE_AND_ORDER {
            return Err(WireError::Shape { degree, order });
        }
        Ok(Self {
            version,
            format: short(header, place::FORMAT),
            length: long(header, place::LENGTH) as usize,
            degree,
            order,
            effects,
            components: size(place::COMPONENTS),
            images: size(place::IMAGES),
            sections: size(place::SECTIONS),
        })
    }
}

/// The u16 at `at`, or 0 if the bytes end before.
fn short(bytes: &[u8], at: usize) -> u16 {
    let found = bytes.get(at..).and_then(|rest| rest.first_chunk());
    found.copied().map_or(0, u16::from_ne_bytes)
}

/// The u32 at `at`, or 0 if the bytes end before.
pub(super) fn long(bytes: &[u8], at: usize) -> u32 {
    let found = bytes.get(at..).and_then(|rest| rest.first_chunk());
    found.copied().map_or(0, u32::from_ne_bytes)
}
