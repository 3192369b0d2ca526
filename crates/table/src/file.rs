//! The table file: label, version, length, checksum, bincode.
//!
//! | bytes | content |
//! |---|---|
//! | 8 | `EIGSHADE` |
//! | 4 | version, little-endian |
//! | 8 | length of the payload, little-endian |
//! | 4 | CRC-32 of the payload, little-endian |
//! | rest | [`Table`] by bincode 2.0.1, standard configuration |

use crate::table::Table;
use bincode::error::DecodeError;
use bincode::serde::decode_from_slice;
use std::fmt;

/// The first bytes of every table file.
pub const LABEL: [u8; 8] = *b"EIGSHADE";
/// The version that this crate reads and writes.
pub const VERSION: u32 = 1;
const HEADER: usize = 24;

/// Why bytes are not a valid table.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FileError {
    /// The bytes do not start with [`LABEL`].
    Foreign,
    /// The file has another version, given here.
    Version(u32),
    /// The payload is shorter or longer than the header states.
    Length {
        /// Payload length in bytes according to the header.
        expected: u64,
        /// Payload length in bytes found.
        found: u64,
    },
    /// The checksum does not match the payload.
    Checksum,
    /// The payload does not decode, or its parts contradict each other.
    Payload(String),
}

impl FileError {
    /// The problem.
    #[must_use]
    pub fn what(&self) -> String {
        match self {
            Self::Foreign => "not an eigenshade table".to_owned(),
            Self::Version(found) => {
                format!("table version {found}, this program reads {VERSION}")
            }
            Self::Length { expected, found } => {
                format!("damaged table: {expected} bytes promised, {found} found")
            }
            Self::Checksum => "damaged table: the checksum does not fit".to_owned(),
            Self::Payload(why) => format!("damaged table: {why}"),
        }
    }

    /// The remedy.
    #[must_use]
    pub const fn remedy(&self) -> &'static str {
        "make it again with `eigenshade basis`"
    }
}

impl fmt::Display for FileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}; {}", self.what(), self.remedy())
    }
}

impl std::error::Error for FileError {}

/// Encodes a table as the bytes of a table file.
#[must_use]
pub fn encode(table: &Table) -> Vec<u8> {
    let payload = section(table);
    let mut bytes = Vec::with_capacity(HEADER + payload.len());
    bytes.extend(LABEL);
    bytes.extend(VERSION.to_le_bytes());
    bytes.extend((payload.len() as u64).to_le_bytes());
    bytes.extend(crc32fast::hash(&payload).to_le_bytes());
    bytes.extend(payload);
    bytes
}

/// Encodes any value in the format of the table's payload.
pub(crate) fn section(value: &impl serde::Serialize) -> Vec<u8> {
    bincode::serde::encode_to_vec(value, bincode::config::standard())
        .expect("plain numbers and strings always encode")
}

/// Decodes the table in the bytes of a file.
///
/// # Errors
///
/// [`FileError`] for any bytes that are not a table, or for a table of more than 1 GiB. Never
/// panics, and never allocates more than about eight times the number of bytes.
pub fn decode(bytes: &[u8]) -> Result<Table, FileError> {
    let (header, payload) = bytes.split_at_checked(HEADER).ok_or(FileError::Foreign)?;
    if header[..8] != LABEL {
        return Err(FileError::Foreign);
    }
    let word = |at: usize| u32::from_le_bytes(std::array::from_fn(|k| header[at + k]));
    let version = word(8);
    if version != VERSION {
        return Err(FileError::Version(version));
    }
    let expected = u64::from_le_bytes(std::array::from_fn(|k| header[12 + k]));
    let found = payload.len() as u64;
    if expected != found {
        return Err(FileError::Length { expected, found });
    }
    if word(20) != crc32fast::hash(payload) {
        return Err(FileError::Checksum);
    }
    let broken = |why: String| FileError::Payload(why);
    let (table, read) = unpack(payload).map_err(|error| broken(error.to_string()))?;
    if read != payload.len() {
        return Err(broken(format!("{} bytes after the end", payload.len() - read)));
    }
    table.check().map_err(broken)?;
    Ok(table)
}

/// Decodes the table at the start of a payload; also returns the number of bytes read.
///
/// bincode allocates the claimed length of a text before it checks that the bytes exist. A decoding
/// limit, which must be a constant, bounds this. The limit counts at most eight bytes for each byte
/// read.
fn unpack(payload: &[u8]) -> Result<(Table, usize), DecodeError> {
    const STEPS: [usize; 3] = [1 << 20, 1 << 25, 1 << 30];
    let standard = bincode::config::standard();
    match payload.len() {
        length if length <= STEPS[0] => {
            decode_from_slice(payload, standard.with_limit::<{ 8 * STEPS[0] }>())
        }
        length if length <= STEPS[1] => {
            decode_from_slice(payload, standard.with_limit::<{ 8 * STEPS[1] }>())
        }
        // A table of this size consists almost entirely of f64, which count as their actual size.
        length if length <= STEPS[2] => {
            decode_from_slice(payload, standard.with_limit::<{ 2 * STEPS[2] }>())
        }
        _ => Err(DecodeError::LimitExceeded),
    }
}
