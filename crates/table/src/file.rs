//! The table's file: label, version, length, checksum, bincode.
//!
//! | bytes | what |
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

/// Why bytes are not a table.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FileError {
    /// They do not start with [`LABEL`].
    Foreign,
    /// Another version, with its number.
    Version(u32),
    /// Fewer or more bytes than the header promises.
    Length {
        /// Bytes of payload promised.
        expected: u64,
        /// Bytes of payload found.
        found: u64,
    },
    /// The checksum does not fit the payload.
    Checksum,
    /// The payload does not decode, or its parts contradict each other.
    Payload(String),
}

impl FileError {
    /// What is wrong.
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

    /// What to do about it.
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

/// The bytes of a table's file.
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

/// Any value as the table's payload has it.
pub(crate) fn section(value: &impl serde::Serialize) -> Vec<u8> {
    bincode::serde::encode_to_vec(value, bincode::config::standard())
        .expect("plain numbers and strings always encode")
}

/// The table in a file's bytes.
///
/// # Errors
///
/// [`FileError`] for any bytes that are no table, or one of more than 1 GiB; never
/// a panic, and never an allocation of more than some eight times the bytes.
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

/// The table at the start of a payload, and how many bytes it takes.
///
/// bincode makes room for as long a text as the bytes claim before it looks whether
/// they are there; a limit, which has to be a constant, keeps that in bounds. It
/// counts at most eight bytes for each that is read.
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
        // Almost all of so large a table is f64, which counts as what it is.
        length if length <= STEPS[2] => {
            decode_from_slice(payload, standard.with_limit::<{ 2 * STEPS[2] }>())
        }
        _ => Err(DecodeError::LimitExceeded),
    }
}
