//! The table file: label, version, length, checksum, bincode.
//!
//! | bytes | content |
//! |---|---|
//! | 8 | `EIGSHADE` |
//! | 4 | version, little-endian |
//! | 8 | length of the payload, little-endian |
//! | 4 | CRC-32 of the payload, little-endian |
//! | rest | [`Table`] by bincode 2.0.1, standard configuration |

use crate::table::{Profile, Table};
use bincode::error::DecodeError;
use bincode::serde::decode_from_slice;
use std::fmt::{self, Write};

/// The first bytes of every table file.
pub const LABEL: [u8; 8] = *b"EIGSHADE";
/// The version that this crate reads and writes.
pub const VERSION: u32 = 3;
const HEADER: usize = 24;

/// Why bytes are not a valid table.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FileError {
    /// The bytes do not start with [`LABEL`].
    BadMagic,
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
            Self::BadMagic => "not an eigenshade table".to_owned(),
            Self::Version(found) => format!("table version {VERSION} expected, {found} found"),
            Self::Length { expected, found } => {
                format!("corrupt table: {expected} bytes expected, {found} found")
            }
            Self::Checksum => "corrupt table: wrong checksum".to_owned(),
            Self::Payload(why) => format!("corrupt table: {why}"),
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
    let (header, payload) = bytes.split_at_checked(HEADER).ok_or(FileError::BadMagic)?;
    if header[..8] != LABEL {
        return Err(FileError::BadMagic);
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

/// A CSV of `entry,value,bytes,crc32`. Sections have their size in bytes and a checksum of their
/// encoded values in the file; figures have values.
#[must_use]
pub fn manifest(table: &Table) -> String {
    let mut text = "entry,value,bytes,crc32\n".to_owned();
    let gram = &table.gram;
    let of_profiles = |part: fn(&Profile) -> &Vec<f64>| {
        section(&table.profiles.iter().map(part).collect::<Vec<_>>())
    };
    let sections = [
        ("scene", section(&table.scene)),
        ("gram.nodes", section(&gram.nodes)),
        ("gram.root_weights", section(&gram.root_weights)),
        ("gram.gains", section(&gram.gains)),
        ("gram.polar_integrals", section(&gram.polar_integrals)),
        ("gram.radials", section(&gram.radials)),
        ("gram.rotations", section(&gram.rotations)),
        ("selection", section(&table.selection)),
        ("components", section(&table.components)),
        ("profiles.node_values", of_profiles(|profile| &profile.node_values)),
        ("profiles.chebyshev", of_profiles(|profile| &profile.chebyshev)),
        ("profiles.modes", of_profiles(|profile| &profile.modes)),
        ("profiles.factors", of_profiles(|profile| &profile.factors)),
        ("mean", section(&table.mean)),
        ("spectrum", section(&table.spectrum)),
        ("transfers", section(&table.transfers)),
        ("file", encode(table)),
    ];
    for (entry, bytes) in sections {
        row(&mut text, format_args!("{entry},,{},{:08x}", bytes.len(), crc32fast::hash(&bytes)));
    }
    let summary = &table.summary;
    let per_azimuth: Vec<String> = summary.ranks.iter().map(ToString::to_string).collect();
    let total: usize =
        summary.ranks.iter().enumerate().map(|(m, rank)| rank * if m == 0 { 1 } else { 2 }).sum();
    let figures = [
        ("degree", gram.degree.to_string()),
        ("order", gram.order.to_string()),
        ("lights", summary.lights.to_string()),
        ("materials", summary.materials.to_string()),
        ("store", table.scene.basis.store.name().to_owned()),
        ("components", table.count().to_string()),
        ("rank", total.to_string()),
        ("rank of each |m|", per_azimuth.join(" ")),
        ("largest singular value", format!("{:.6e}", summary.largest_singular_value)),
        ("energy kept", format!("{:.9}", summary.energy_kept)),
        ("residual energy", format!("{:.3e}", 1.0 - summary.energy_kept)),
        ("orthonormality", format!("{:.0e}", summary.orthonormality)),
    ];
    for (entry, value) in figures {
        row(&mut text, format_args!("{entry},{value},,"));
    }
    for one in &summary.roundings {
        let format = one.format.name();
        row(&mut text, format_args!("largest error in {format},{:.1e},,", one.largest));
        row(&mut text, format_args!("rms error in {format},{:.1e},,", one.rms));
    }
    text
}

fn row(text: &mut String, line: std::fmt::Arguments<'_>) {
    writeln!(text, "{line}").expect("a string takes everything");
}
