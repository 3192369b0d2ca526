//! A table as bytes that the runtime reads in place: the wire format of [`eigenshade_index::wire`].

pub use crate::format::Format;
use crate::parts::{Parts, ProfilePlace};
use crate::quantize::{self, QuantizeError, QuantizedParts};
use crate::table::{General, Table};
use eigenshade_index::effect::Effects;
use eigenshade_index::wire::{
    ALIGNMENT, CHECKSUM, ENTRY, FLOATS, HEADER, INTEGERS, LABEL, MARK, MAX_DEGREE_AND_ORDER,
    REQUIRED_FLOATS, VERSION, format,
};
use std::fmt;

/// The byte order of a wire file, which must be that of the machine that reads it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Endian {
    /// Least significant byte first.
    Little,
    /// Most significant byte first.
    Big,
}

/// Why a table cannot be encoded as a wire file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum WireError {
    /// It stores only transfers.
    TransfersOnly,
    /// Its degree or order exceeds [`MAX_DEGREE_AND_ORDER`].
    Shape {
        /// The degree.
        degree: usize,
        /// The order.
        order: usize,
    },
    /// The file would be longer than 32 bits can express.
    Long,
    /// One of its numbers exceeds the range of `f32`.
    Range,
    /// It cannot be converted to integers.
    Quantize(QuantizeError),
}

impl fmt::Display for WireError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TransfersOnly => QuantizeError::TransfersOnly.fmt(f),
            Self::Shape { degree, order } => write!(
                f,
                "degree {degree} and order {order}, a wire file allows at most \
                 {MAX_DEGREE_AND_ORDER}; make the table with a lower degree and order"
            ),
            Self::Long => {
                f.write_str("the wire file would exceed 4 GB; make the table with fewer components")
            }
            Self::Range => f.write_str(
                "a number exceeds the range of f32; scale the lights and materials of the scene \
                 toward 1",
            ),
            Self::Quantize(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for WireError {}

impl From<QuantizeError> for WireError {
    fn from(error: QuantizeError) -> Self {
        Self::Quantize(error)
    }
}

/// Encodes a table as the bytes of a wire file.
///
/// # Errors
///
/// If the table stores only transfers, its numbers exceed the format, or it cannot be converted to
/// integers.
pub fn encode(table: &Table, format: Format, endian: Endian) -> Result<Vec<u8>, WireError> {
    let (degree, order) = (table.gram.degree, table.gram.order);
    if degree > MAX_DEGREE_AND_ORDER || order > MAX_DEGREE_AND_ORDER {
        return Err(WireError::Shape { degree, order });
    }
    match format {
        Format::F32 if !table.has_projection() => Err(WireError::TransfersOnly),
        Format::F32 => floats(table, endian),
        Format::Integer(format) => {
            let parts = QuantizedParts::new(table, format, format.tolerance())?;
            integers(&parts, endian)
        }
    }
}

fn floats(table: &Table, endian: Endian) -> Result<Vec<u8>, WireError> {
    let parts = Parts::new(table);
    let general = table.general.as_ref();
    let of = |part: fn(&General) -> &Vec<f64>| general.map_or(&[][..], |general| part(general));
    // These arrays scale with the images. All others describe eigenimages, which have norm 1.
    let sized = [&parts.mean, &parts.mean_coefficients].map(Vec::as_slice);
    let sized = sized.into_iter().chain([of(|one| &one.mean), of(|one| &one.mean_coefficients)]);
    if sized.flatten().any(|&number| !(number as f32).is_finite()) {
        return Err(WireError::Range);
    }
    let section = || Bytes::new(endian);
    let mut sections = vec![
        parts.profiles.iter().fold(section(), Bytes::profile),
        parts.passes.iter().fold(section(), |bytes, one| {
            bytes.short(one.first.cast_unsigned()).short(one.profiles)
        }),
        section().shorts(&parts.slots),
        section().shorts(parts.couplings.as_flattened()),
        section().shorts(&parts.lengths),
        section().floats(&parts.polar),
        section().floats(&parts.factors),
        section().floats(&parts.terms),
        section().floats(&parts.mean),
        section().floats(&parts.mean_coefficients),
        parts.selection.iter().fold(section(), |bytes, &kept| bytes.byte(u8::from(kept))),
        section().floats(of(|general| &general.projection)),
        section().floats(of(|general| &general.synthesis)),
        section().floats(of(|general| &general.mean)),
        section().floats(of(|general| &general.mean_coefficients)),
        section().floats(&parts.ambient),
        parts
            .recurrences
            .as_flattened()
            .iter()
            .fold(section(), |bytes, one| bytes.long(one.to_bits())),
    ];
    debug_assert_eq!(sections.len(), FLOATS.len());
    while sections.len() > REQUIRED_FLOATS
        && sections.last().is_some_and(|last| last.bytes.is_empty())
    {
        sections.pop();
    }
    let images = general.map_or(0, |general| general.eigenvalues.len());
    let shape = [parts.degree, parts.order, parts.components, images];
    file(endian, format::F32, shape, parts.effects, &sections)
}

fn integers(parts: &QuantizedParts, endian: Endian) -> Result<Vec<u8>, WireError> {
    let number = match parts.format {
        quantize::Format::Q15 => format::Q15,
        quantize::Format::Q31 => format::Q31,
    };
    let section = || Bytes::new(endian);
    let mantissas = |numbers: &[i32]| {
        numbers.iter().fold(section(), |bytes, &one| match parts.format {
            quantize::Format::Q15 => bytes.short((one as i16).cast_unsigned()),
            quantize::Format::Q31 => bytes.long(one.cast_unsigned()),
        })
    };
    let small = |numbers: &[i8]| {
        numbers.iter().fold(section(), |bytes, number| bytes.byte(number.cast_unsigned()))
    };
    let profiles = parts.profiles.iter().fold(section(), |bytes, place| {
        let bytes = bytes.byte(place.azimuth).byte(place.exponent.cast_unsigned());
        bytes.shorts(&[place.plus, place.minus, place.size, place.step])
    });
    let sections: [Bytes; INTEGERS.len()] = [
        profiles,
        parts.lengths.iter().fold(section(), |bytes, &length| bytes.byte(length)),
        mantissas(&parts.polar),
        small(&parts.polar_exponents),
        mantissas(&parts.factors),
        small(&parts.factor_exponents),
        mantissas(&parts.terms),
    ];
    let shape = [parts.degree, parts.order, parts.components, 0];
    file(endian, number, shape, parts.effects, &sections)
}

/// Assembles header, entries, sections and checksum.
fn file(
    endian: Endian,
    format: u16,
    shape: [usize; 4],
    effects: Effects,
    sections: &[Bytes],
) -> Result<Vec<u8>, WireError> {
    let long = |number: usize| u32::try_from(number).map_err(|_| WireError::Long);
    let short = |number: usize| u16::try_from(number).expect("small shapes");
    let start = HEADER + ENTRY * sections.len();
    let padded: usize = sections.iter().map(Bytes::padded).sum();
    let mut file = Bytes { endian, bytes: LABEL.to_vec() }
        .long(MARK)
        .short(VERSION)
        .short(format)
        .long(long(start + padded + CHECKSUM)?)
        .shorts(&shape.map(short))
        .short(short(sections.len()))
        .short(effects.bits());
    let mut next = start;
    for section in sections {
        file = file.long(long(next)?).long(long(section.bytes.len())?);
        next += section.padded();
    }
    for section in sections {
        file.bytes.extend(&section.bytes);
        file.bytes.resize(file.bytes.len().next_multiple_of(ALIGNMENT), 0);
    }
    let checksum = crc32fast::hash(&file.bytes);
    Ok(file.long(checksum).bytes)
}

/// Bytes in a given byte order.
struct Bytes {
    endian: Endian,
    bytes: Vec<u8>,
}

impl Bytes {
    fn new(endian: Endian) -> Self {
        Self { endian, bytes: Vec::new() }
    }

    /// Length including the padding up to the start of the next section.
    fn padded(&self) -> usize {
        self.bytes.len().next_multiple_of(ALIGNMENT)
    }

    fn byte(mut self, byte: u8) -> Self {
        self.bytes.push(byte);
        self
    }

    fn short(mut self, number: u16) -> Self {
        self.bytes.extend(match self.endian {
            Endian::Little => number.to_le_bytes(),
            Endian::Big => number.to_be_bytes(),
        });
        self
    }

    fn long(mut self, number: u32) -> Self {
        self.bytes.extend(match self.endian {
            Endian::Little => number.to_le_bytes(),
            Endian::Big => number.to_be_bytes(),
        });
        self
    }

    fn shorts(self, numbers: &[u16]) -> Self {
        numbers.iter().fold(self, |bytes, &number| bytes.short(number))
    }

    fn floats(self, numbers: &[f64]) -> Self {
        numbers.iter().fold(self, |bytes, &number| bytes.long((number as f32).to_bits()))
    }

    /// Writes two zero bytes after the three shorts to align the rows.
    fn profile(self, place: &ProfilePlace) -> Self {
        let (plus, minus) = (place.plus_row, place.minus_row);
        self.shorts(&[place.azimuth, place.plus, place.minus, 0])
            .long(plus.start)
            .long(plus.step)
            .long(minus.start)
            .long(minus.step)
    }
}
