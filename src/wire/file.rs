//! A wire file with a valid checksum, and its sections.

use super::WireError;
use super::checksum::checksum;
use super::format::WireFormat;
use super::header::{Header, long};
use crate::index::wire::{ALIGNMENT, CHECKSUM, ENTRY, HEADER};
use zerocopy::{Immutable, KnownLayout, TryFromBytes};

/// A wire file whose sections are read one after the other.
pub(super) struct File<'a> {
    pub(super) header: Header,
    /// All bytes but the checksum.
    bytes: &'a [u8],
    taken: usize,
}

impl<'a> File<'a> {
    /// Opens the file at the start of these bytes, which must have this format.
    pub(super) fn open(bytes: &'a [u8], expected: WireFormat) -> Result<Self, WireError> {
        let header = Header::read(bytes)?;
        if WireFormat::of(header.format) != Some(expected) {
            return Err(WireError::Format { expected, found: header.format });
        }
        // Whatever length the header claims, there are sections and a checksum.
        let least = HEADER + ENTRY * header.sections + CHECKSUM;
        let expected = header.length.max(least);
        let Some(file) = bytes.get(..expected) else {
            return Err(WireError::Length { expected, found: bytes.len() });
        };
        let beyond = file.as_ptr().addr() % ALIGNMENT;
        if beyond != 0 {
            return Err(WireError::Alignment { beyond });
        }
        let (bytes, sum) = file.split_at_checked(expected - CHECKSUM).unwrap_or_default();
        let (expected, found) = (long(sum, 0), checksum(bytes));
        if expected != found {
            return Err(WireError::Checksum { expected, found });
        }
        Ok(Self { header, bytes, taken: 0 })
    }

    /// Reads the next section.
    pub(super) fn section<T>(&mut self) -> Result<&'a [T], WireError>
    where
        T: TryFromBytes + KnownLayout + Immutable,
    {
        let number = self.taken;
        let fault = WireError::Section { number };
        if number >= self.header.sections {
            return Err(fault);
        }
        self.taken += 1;
        let entry = HEADER + ENTRY * number;
        let start = long(self.bytes, entry) as usize;
        let length = long(self.bytes, entry + ENTRY / 2) as usize;
        let rest = self.bytes.get(start..).ok_or(fault)?;
        let section = rest.get(..length).ok_or(fault)?;
        <[T]>::try_ref_from_bytes(section).map_err(|_| fault)
    }

    /// Reads the next section, or gives an empty one if none is left.
    pub(super) fn rest<T>(&mut self) -> Result<&'a [T], WireError>
    where
        T: TryFromBytes + KnownLayout + Immutable,
    {
        if self.taken == self.header.sections { Ok(&[]) } else { self.section() }
    }

    /// Checks that no section is left.
    pub(super) fn end(&self) -> Result<(), WireError> {
        if self.taken == self.header.sections {
            Ok(())
        } else {
            Err(WireError::Section { number: self.taken })
        }
    }
}
