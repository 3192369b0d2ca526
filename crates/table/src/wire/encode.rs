//! The writer of the wire format.

use super::{ALIGNMENT, CHECKSUM, ENTRY, HEADER, LABEL, MARK, VERSION};
use crate::format::NumberFormat;
use crate::format_error::FormatError;
use crate::parts;
use crate::quantize;
use crate::record::{Item, Visitor, Word};
use crate::table::Table;

/// The byte order of a wire file, which must be the byte order of the machine that reads it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Endian {
    /// Least significant byte first.
    Little,
    /// Most significant byte first.
    Big,
}

/// Encodes a table as the bytes of a wire file.
///
/// # Errors
///
/// If the table cannot be converted into the format.
pub fn encode(table: &Table, format: NumberFormat, endian: Endian) -> Result<Vec<u8>, FormatError> {
    match format {
        NumberFormat::F32 => floats(table, endian),
        NumberFormat::Q15 => {
            let parts = quantize::integers(table, quantize::TOLERANCE)?;
            let mut sections = Sections { endian, sections: Vec::new() };
            parts.borrow().visit(&mut sections);
            sections.file(format, [parts.degree, parts.order, parts.components])
        }
    }
}

fn floats(table: &Table, endian: Endian) -> Result<Vec<u8>, FormatError> {
    parts::check(table)?;
    let parts = parts::floats(table);
    let mut sections = Sections { endian, sections: Vec::new() };
    parts.convert(|&number| number as f32).borrow().visit(&mut sections);
    sections.file(NumberFormat::F32, [parts.degree, parts.order, parts.components])
}

/// The sections of a file.
struct Sections {
    endian: Endian,
    sections: Vec<Bytes>,
}

impl Visitor for Sections {
    fn array<T: Item>(&mut self, _name: &'static str, items: &[T]) {
        let mut bytes = Bytes { endian: self.endian, bytes: Vec::new() };
        items.iter().for_each(|item| item.words(&mut |word| bytes.word(word)));
        self.sections.push(bytes);
    }
}

impl Sections {
    /// The whole file: header, entries, sections up to the last that is not empty, checksum.
    fn file(self, format: NumberFormat, shape: [usize; 3]) -> Result<Vec<u8>, FormatError> {
        let Self { endian, mut sections } = self;
        let last = sections.iter().rposition(|section| !section.bytes.is_empty());
        sections.truncate(last.map_or(0, |last| last + 1));
        let long = |number: usize| u32::try_from(number).map_err(|_| FormatError::File);
        let short = |number: usize| u16::try_from(number).expect("small shapes");
        let start = HEADER + ENTRY * sections.len();
        let padded: usize = sections.iter().map(Bytes::padded).sum();
        let mut file = Bytes { endian, bytes: LABEL.to_vec() };
        file.long(MARK);
        file.short(VERSION);
        file.short(format.number());
        file.long(long(start + padded + CHECKSUM)?);
        shape.into_iter().chain([sections.len()]).for_each(|number| file.short(short(number)));
        let mut next = start;
        for section in &sections {
            file.long(long(next)?);
            file.long(long(section.bytes.len())?);
            next += section.padded();
        }
        for section in sections {
            file.bytes.extend(&section.bytes);
            file.bytes.resize(file.padded(), 0);
        }
        let checksum = crc32fast::hash(&file.bytes);
        file.long(checksum);
        Ok(file.bytes)
    }
}

/// Bytes in a given byte order.
struct Bytes {
    endian: Endian,
    bytes: Vec<u8>,
}

impl Bytes {
    /// Length including the padding up to the start of the next section.
    fn padded(&self) -> usize {
        self.bytes.len().next_multiple_of(ALIGNMENT)
    }

    fn word(&mut self, word: Word) {
        match word {
            Word::Byte(byte) => self.bytes.push(byte),
            Word::Short(number) => self.short(number),
            Word::Long(number) => {
                self.bytes.resize(self.padded(), 0);
                self.long(number);
            }
        }
    }

    fn short(&mut self, number: u16) {
        self.bytes.extend(match self.endian {
            Endian::Little => number.to_le_bytes(),
            Endian::Big => number.to_be_bytes(),
        });
    }

    fn long(&mut self, number: u32) {
        self.bytes.extend(match self.endian {
            Endian::Little => number.to_le_bytes(),
            Endian::Big => number.to_be_bytes(),
        });
    }
}
