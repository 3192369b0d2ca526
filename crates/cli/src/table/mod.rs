//! Table files, their contents and their errors.

#[cfg(feature = "generate")]
pub mod compare;
pub mod rounding;

use crate::description::Description;
use crate::messages::grouped;
use eigenshade::wire::{Fault, Header, NumberFormat, Parts, WireError, aligned};
use eigenshade::{Basis, q15};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::{InputFile, is_file};
use eigenshade_model::shipped;
use eigenshade_table::Table;
use eigenshade_table::effect::{Effect, Effects};
use eigenshade_table::wire::{ENTRY, HEADER, LABEL};
use std::borrow::Cow;
use std::path::Path;

/// The names of the shipped tables.
const SHIPPED: [&str; 4] = ["color", "sphere", "curet", "pbr"];

/// The bytes of a shipped table, if there is no file of its name.
#[must_use]
pub fn shipped(path: &Path) -> Option<&'static [u8]> {
    let tables = [shipped::COLOR, shipped::TABLE, shipped::CURET, shipped::PBR];
    let place = SHIPPED.iter().position(|name| path.as_os_str() == *name);
    place.filter(|_| !is_file(path)).map(|place| tables[place])
}

/// The bytes of a table's file, or of the shipped table of this name. Fails if the file cannot be
/// read.
pub fn bytes(file: &InputFile) -> Result<Cow<'static, [u8]>> {
    let path = file.path();
    if let Some(bytes) = shipped(path) {
        return Ok(Cow::Borrowed(bytes));
    }
    let name = path.to_string_lossy();
    let is_word = !name.contains(['/', '\\', '.']) && !file.is_standard_input();
    if is_word && !is_file(path) {
        let what = format!("`{name}` is neither a file nor a shipped table");
        let names = SHIPPED.map(|name| format!("`{name}`")).join(", ");
        return Err(Error::new(what, format!("use {names}, or the path of a file")));
    }
    file.bytes().map(Cow::Owned)
}

/// Reads a table's file, or the shipped table of this name. Fails if the file cannot be read, is
/// not a table, has another version, or is damaged.
pub fn read(file: impl Into<InputFile>) -> Result<Table> {
    let file = file.into();
    decode(&bytes(&file)?).map_err(|error| error.in_file(file.path()))
}

/// Decodes a table from the bytes of a file. Fails if the bytes are not a table, have another
/// version, or are damaged.
pub fn decode(bytes: &[u8]) -> Result<Table> {
    if is_wire(bytes) {
        let what = "it is a wire file, which only the runtime and `eigenshade info` read";
        return Err(Error::new(what, "use the table from which it was packed"));
    }
    eigenshade_table::decode(bytes).map_err(|error| Error::table(&error))
}

/// The number of components to use: the requested number, or all. Fails if the request exceeds the
/// number of components of the table at `path`.
pub fn components(table: &Table, requested: Option<usize>, path: &Path) -> Result<usize> {
    let all = table.count();
    match requested {
        Some(count) if count > all => {
            let what = format!("it has {all} components, but {count} are requested");
            let remedy = "at most, or make a larger table with `eigenshade basis`";
            Err(Error::new(what, format!("request {all} {remedy}")).in_file(path))
        }
        _ => Ok(requested.unwrap_or(all)),
    }
}

/// Whether the bytes begin like a wire file.
#[must_use]
pub fn is_wire(bytes: &[u8]) -> bool {
    bytes.starts_with(&LABEL)
}

/// Describes the contents of a wire file. Of a file in the other byte order only the header and the
/// table of sections are read: there are no lengths of buffers. Fails if the runtime refuses the
/// bytes.
pub fn wire_description(bytes: &[u8]) -> Result<Description> {
    let is_other = Header::read(bytes) == Err(Fault::Endianness);
    let bytes = if is_other { Cow::Owned(swapped(bytes)) } else { Cow::Borrowed(bytes) };
    let found = if is_other {
        complete(&bytes).map(|header| (header, Lengths::new()))
    } else {
        checked(&bytes)
    };
    let (header, lengths) = found.map_err(|error| Error::of_line(error, "pack the table again"))?;
    let (format, names) = match NumberFormat::of(header.format) {
        Some(NumberFormat::F32) | None => (NumberFormat::F32, Parts::ARRAYS),
        Some(format) => (format, q15::Parts::ARRAYS),
    };
    let mut description = Description::default();
    description.field("wire version", header.version);
    let is_little = cfg!(target_endian = "little") != is_other;
    description.field("byte order", if is_little { "little-endian" } else { "big-endian" });
    description.field("format", format.name());
    description.field("degree", header.degree);
    description.field("order", header.order);
    description.field("components", header.components);
    if !lengths.is_empty() {
        let lengths = lengths.iter().map(|(name, length)| format!("{name} {}", grouped(*length)));
        description.field("buffers", lengths.collect::<Vec<_>>().join(", "));
    }
    for (number, name) in names.iter().take(header.sections).enumerate() {
        let at = HEADER + ENTRY * number + ENTRY / 2;
        let length = u32::from_ne_bytes(std::array::from_fn(|k| bytes[at + k]));
        description.part(name.replace('_', " "), length as usize);
    }
    description.part("file", header.length);
    Ok(description)
}

/// The file with the numbers of its header and its table of sections in the other byte order.
fn swapped(bytes: &[u8]) -> Vec<u8> {
    use eigenshade_table::wire::place::{
        COMPONENTS, DEGREE, FORMAT, LENGTH, MARK, ORDER, SECTIONS, VERSION,
    };
    let starts = [MARK, VERSION, FORMAT, LENGTH, DEGREE, ORDER, COMPONENTS, SECTIONS];
    let mut bytes = bytes.to_vec();
    let ends = starts[1..].iter().copied().chain([SECTIONS + 2]);
    for (start, end) in starts.into_iter().zip(ends) {
        bytes[start..end].reverse();
    }
    // All numbers of the sections' table have four bytes.
    bytes[HEADER..].chunks_exact_mut(4).for_each(<[u8]>::reverse);
    bytes
}

/// The header of a file that has as many bytes as it claims.
fn complete(bytes: &[u8]) -> std::result::Result<Header, WireError> {
    let header = Header::read(bytes)?;
    let (expected, found) = (header.length.max(HEADER + ENTRY * header.sections), bytes.len());
    if found < expected {
        return Err(Fault::Length { expected, found }.into());
    }
    Ok(header)
}

/// The names of effects.
#[must_use]
pub fn effect_names(effects: Effects) -> String {
    let names = Effect::ALL.into_iter().filter(|&effect| effects.has(effect)).map(Effect::name);
    names.collect::<Vec<_>>().join(" ")
}

/// The lengths of the buffers that the functions of a basis take, by the names of the constants of
/// a table that is compiled in.
type Lengths = Vec<(&'static str, usize)>;

/// The header of a file that the runtime accepts, and the lengths of its buffers.
fn checked(bytes: &[u8]) -> std::result::Result<(Header, Lengths), WireError> {
    let header = Header::read(bytes)?;
    let mut room = vec![0; bytes.len().div_ceil(4)];
    let bytes = aligned(bytes, &mut room)?;
    let lengths = match NumberFormat::of(header.format) {
        Some(NumberFormat::Q15) => of_integers(&q15::Basis::from_bytes(bytes)?),
        _ => of_floats(&Basis::from_bytes(bytes)?),
    };
    Ok((header, lengths))
}

fn of_floats(basis: &Basis<'_>) -> Lengths {
    vec![
        ("WORKSPACE", basis.workspace_len()),
        ("TRANSFER", basis.transfer_len()),
        ("COMPONENTS", basis.components()),
        ("SCENE", basis.scene_len()),
    ]
}

fn of_integers(basis: &q15::Basis<'_>) -> Lengths {
    vec![
        ("WORKSPACE", basis.workspace_len()),
        ("TRANSFER", basis.transfer_len()),
        ("PROFILES", basis.profiles()),
        ("COMPONENTS", basis.components()),
        ("SCENE", basis.scene_len()),
    ]
}
