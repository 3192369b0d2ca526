//! What may be wrong with a wire file.

use super::{ALIGNMENT, VERSION};
use crate::format::NumberFormat;
use crate::layout::{MAX_DEGREE, MAX_ORDER};
use core::fmt;

/// The first problem found in the bytes of a wire file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Fault {
    /// The bytes do not begin with the label of a wire file.
    BadMagic,
    /// The file has the other byte order.
    Endianness,
    /// The file has another version, which is given.
    Version(u16),
    /// The numbers have another format.
    Format {
        /// The format to be read.
        expected: NumberFormat,
        /// The number of the format in the file; see [`NumberFormat::of`].
        found: u16,
    },
    /// There are fewer bytes than the file should have.
    Length {
        /// Number of bytes that the file should have.
        expected: usize,
        /// Number of bytes found.
        found: usize,
    },
    /// The bytes do not start at a multiple of four.
    Alignment {
        /// Distance in bytes from the last multiple of four.
        beyond: usize,
    },
    /// The checksum does not match.
    Checksum {
        /// The checksum in the file.
        expected: u32,
        /// The checksum of the bytes.
        found: u32,
    },
    /// A degree or order is larger than a file may have.
    Shape {
        /// The degree found.
        degree: usize,
        /// The order found.
        order: usize,
    },
    /// A section lies outside the file, is not an array of its kind or is missing, or there is one
    /// section too many.
    Section {
        /// The number of the section, from 0.
        number: usize,
    },
    /// The `room` given to [`aligned`](super::aligned) is too short.
    Room {
        /// How many numbers are needed.
        needed: usize,
        /// How many numbers there are.
        found: usize,
    },
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::BadMagic => f.write_str(
                "EIGSWIRE expected, other bytes found: not a wire file; make one with \
                 `eigenshade pack`",
            ),
            Self::Endianness => f.write_str(
                "this machine's byte order expected, the other found; pack the table for this \
                 machine: --big-endian or without",
            ),
            Self::Version(found) => write!(
                f,
                "wire version {VERSION} expected, {found} found; pack the table with the version of \
                 eigenshade that reads it"
            ),
            Self::Format { expected, found } => {
                let name = NumberFormat::of(*found).map_or("an unknown one", NumberFormat::name);
                let expected = expected.name();
                write!(
                    f,
                    "numbers in {expected} expected, {name} found; pack the table with --format \
                     {expected}, or read it as what it is"
                )
            }
            Self::Length { expected, found } => write!(
                f,
                "wire file: {expected} bytes expected, {found} found; take all of the file"
            ),
            Self::Alignment { beyond } => write!(
                f,
                "wire file: a start at a multiple of {ALIGNMENT} expected, {beyond} beyond one \
                 found; put the bytes into wire::Aligned, or copy them with wire::aligned"
            ),
            Self::Checksum { expected, found } => write!(
                f,
                "damaged wire file: checksum {expected:08x} expected, {found:08x} found; bring it \
                 here again"
            ),
            Self::Shape { degree, order } => write!(
                f,
                "wire file: degree up to {MAX_DEGREE} and order up to {MAX_ORDER} expected, {degree} and \
                 {order} found; pack the table again"
            ),
            Self::Section { number } => write!(
                f,
                "wire file: section {number} is not within it, not an array of its kind, or not \
                 expected; pack the table again"
            ),
            Self::Room { needed, found } => {
                write!(f, "room for {needed} numbers expected, for {found} found; give more")
            }
        }
    }
}

impl core::error::Error for Fault {}
