//! A wire file: its alignment, its header, its checksum and its sections.

use super::fault::Fault;
use super::{ALIGNMENT, CHECKSUM, ENTRY, HEADER, LABEL, MARK, VERSION, place};
use crate::format::NumberFormat;
use crate::layout::{MAX_DEGREE, MAX_ORDER};
use crate::record::{Item, Q15, Reader, floats, integers};
use zerocopy::{IntoBytes, TryFromBytes};

/// Reads the record of a table in `f32` from the file at the start of these bytes.
///
/// # Errors
///
/// A [`Fault`] for any bytes that are not such a file. What the arrays hold is not checked.
pub fn read_floats(bytes: &[u8]) -> Result<floats::Parts<'_, f32>, Fault> {
    let mut file = File::open(bytes, NumberFormat::F32)?;
    let parts = floats::Parts::read(file.header.shape(), &mut file)?;
    file.end()?;
    Ok(parts)
}

/// Reads the record of a table in integers from the file at the start of these bytes.
///
/// # Errors
///
/// A [`Fault`] for any bytes that are not such a file. What the arrays hold is not checked.
pub fn read_integers(bytes: &[u8]) -> Result<integers::Parts<'_, Q15>, Fault> {
    let mut file = File::open(bytes, NumberFormat::Q15)?;
    let parts = integers::Parts::read(file.header.shape(), &mut file)?;
    file.end()?;
    Ok(parts)
}

/// A wire file whose sections are read one after the other.
struct File<'a> {
    header: Header,
    /// All bytes but the checksum.
    bytes: &'a [u8],
    taken: usize,
}

impl<'a> File<'a> {
    /// Opens the file at the start of these bytes, which must have this format.
    fn open(bytes: &'a [u8], expected: NumberFormat) -> Result<Self, Fault> {
        let header = Header::read(bytes)?;
        if header.format != expected.number() {
            return Err(Fault::Format { expected, found: header.format });
        }
        // Whatever length the header claims, there are sections and a checksum.
        let least = HEADER + ENTRY * header.sections + CHECKSUM;
        let expected = header.length.max(least);
        let Some(file) = bytes.get(..expected) else {
            return Err(Fault::Length { expected, found: bytes.len() });
        };
        let beyond = file.as_ptr().addr() % ALIGNMENT;
        if beyond != 0 {
            return Err(Fault::Alignment { beyond });
        }
        let (bytes, sum) = file.split_at_checked(expected - CHECKSUM).unwrap_or_default();
        let (expected, found) = (long(sum, 0), checksum(bytes));
        if expected != found {
            return Err(Fault::Checksum { expected, found });
        }
        Ok(Self { header, bytes, taken: 0 })
    }

    /// Checks that no section is left.
    fn end(&self) -> Result<(), Fault> {
        if self.taken == self.header.sections {
            Ok(())
        } else {
            Err(Fault::Section { number: self.taken })
        }
    }
}

impl<'a> Reader<'a> for File<'a> {
    type Error = Fault;

    /// The next section, or an empty one if none is left.
    fn array<T: Item>(&mut self) -> Result<&'a [T], Fault> {
        let number = self.taken;
        if number >= self.header.sections {
            return Ok(&[]);
        }
        self.taken += 1;
        let fault = Fault::Section { number };
        let entry = HEADER + ENTRY * number;
        let start = long(self.bytes, entry) as usize;
        let length = long(self.bytes, entry + ENTRY / 2) as usize;
        let rest = self.bytes.get(start..).ok_or(fault)?;
        let section = rest.get(..length).ok_or(fault)?;
        <[T]>::try_ref_from_bytes(section).map_err(|_| fault)
    }
}

/// The header of a wire file: its format, its size and the shape of its table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct Header {
    /// The version of the file.
    pub version: u16,
    /// The number format of the file: see [`NumberFormat::of`].
    pub format: u16,
    /// Length of the whole file in bytes.
    pub length: usize,
    /// Largest degree l of the light.
    pub degree: usize,
    /// Largest order o of the BRDF.
    pub order: usize,
    /// Number of components.
    pub components: usize,
    /// Number of sections.
    pub sections: usize,
}

impl Header {
    /// The sizes of a record.
    const fn shape(&self) -> (usize, usize, usize) {
        (self.degree, self.order, self.components)
    }

    /// Reads the header of a file. The bytes need not be aligned or complete, and the checksum is
    /// not checked.
    ///
    /// # Errors
    ///
    /// [`Fault::BadMagic`], [`Fault::Endianness`], [`Fault::Version`],
    /// [`Fault::Shape`], or [`Fault::Length`] if even the header is incomplete.
    pub fn read(bytes: &[u8]) -> Result<Self, Fault> {
        if !bytes.starts_with(&LABEL) {
            return Err(Fault::BadMagic);
        }
        let Some(header) = bytes.first_chunk::<HEADER>() else {
            return Err(Fault::Length { expected: HEADER, found: bytes.len() });
        };
        let mark = long(header, place::MARK);
        if mark != MARK {
            let other = mark == MARK.swap_bytes();
            return Err(if other { Fault::Endianness } else { Fault::BadMagic });
        }
        let version = short(header, place::VERSION);
        if version != VERSION {
            return Err(Fault::Version(version));
        }
        let size = |at| usize::from(short(header, at));
        let (degree, order) = (size(place::DEGREE), size(place::ORDER));
        if degree > MAX_DEGREE || order > MAX_ORDER {
            return Err(Fault::Shape { degree, order });
        }
        Ok(Self {
            version,
            format: short(header, place::FORMAT),
            length: long(header, place::LENGTH) as usize,
            degree,
            order,
            components: size(place::COMPONENTS),
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
fn long(bytes: &[u8], at: usize) -> u32 {
    let found = bytes.get(at..).and_then(|rest| rest.first_chunk());
    found.copied().map_or(0, u32::from_ne_bytes)
}

/// Bytes embedded at compile time, aligned to four: `static TABLE: &Aligned<[u8]> =
/// &Aligned(*include_bytes!("table.esw"));`.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(C, align(4))]
pub struct Aligned<T: ?Sized>(pub T);

const _: () = assert!(align_of::<Aligned<u8>>() == ALIGNMENT && align_of::<u32>() <= ALIGNMENT);

/// Copies bytes to an aligned place. `room` needs one number for every four bytes, rounded up.
///
/// # Errors
///
/// [`Fault::Room`] if `room` is too short.
pub fn aligned<'r>(bytes: &[u8], room: &'r mut [u32]) -> Result<&'r [u8], Fault> {
    let (needed, found) = (bytes.len().div_ceil(ALIGNMENT), room.len());
    let to = room.as_mut_bytes().get_mut(..bytes.len()).ok_or(Fault::Room { needed, found })?;
    for (to, &from) in to.iter_mut().zip(bytes) {
        *to = from;
    }
    Ok(to)
}

/// The effect of four steps of a reflected CRC-32, for each low nibble.
const NIBBLES: [u32; 16] = {
    let (mut table, mut nibble) = ([0; 16], 0);
    let mut rest = table.as_mut_slice();
    while let [first, others @ ..] = rest {
        let (mut remainder, mut bits) = (nibble, 4);
        while bits > 0 {
            let odd = remainder & 1 == 1;
            remainder = (remainder >> 1) ^ if odd { 0xedb8_8320 } else { 0 };
            bits -= 1;
        }
        *first = remainder;
        (rest, nibble) = (others, nibble + 1);
    }
    table
};

/// The CRC-32 of ISO 3309, as in PNG and ZIP.
fn checksum(bytes: &[u8]) -> u32 {
    let step = |sum: u32| {
        let nibble = NIBBLES.get((sum & 15) as usize).copied();
        (sum >> 4) ^ nibble.unwrap_or_default()
    };
    !bytes.iter().fold(u32::MAX, |sum, &byte| step(step(sum ^ u32::from(byte))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_standards_own_value() {
        assert_eq!(checksum(b"123456789"), 0xcbf4_3926);
        assert_eq!(checksum(b""), 0);
    }
}
