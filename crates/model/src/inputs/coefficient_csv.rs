//! Lights and materials as CSV: one row per coefficient.
//!
//! | | columns |
//! |---|---|
//! | light | `name,l,m,r,g,b` or `name,l,m,value` |
//! | material | `name,o,p,q,r,g,b` or `name,o,p,q,value` |
//!
//! `value` is a gray coefficient, the same in all three channels. The columns may come in any
//! order. Other columns and lines that begin with `#` are ignored. The rows may come in any order
//! too; entries are returned in the order in which their names first appear.

use super::coefficient_text::{Kind, LIGHT, MATERIAL, exact};
use super::input_file::InputFile;
use super::sheet::{Row, Sheet, output_fault};
use crate::database::{Lights, Materials, Named};
use crate::error::{Error, Result};
use std::collections::HashMap;
use std::io::Write;

/// Reads lights up to `degree`, or up to the largest degree in the file if `degree` is `None`.
///
/// # Errors
///
/// If the file cannot be read, contains no light, or ends below `degree`; if a row is missing,
/// duplicated, ragged or out of range; or if a number is not finite.
pub fn read_lights(file: impl Into<InputFile>, degree: Option<usize>) -> Result<Lights> {
    let sheet = Sheet::read(file, &LIGHT.header("r,g,b"))?;
    let (degree, _, entries) = entries(&LIGHT, &sheet, degree)?;
    Ok(Lights { degree, entries })
}

/// Reads materials up to `order`, or up to the largest order in the file if `order` is `None`.
///
/// # Errors
///
/// See [`read_lights`].
pub fn read_materials(file: impl Into<InputFile>, order: Option<usize>) -> Result<Materials> {
    Ok(read_materials_and_order(file, order)?.0)
}

/// Like [`read_materials`], and also returns the largest order in the file. The coefficients up to
/// a lower order are not necessarily the projection to that order.
///
/// # Errors
///
/// See [`read_lights`].
pub fn read_materials_and_order(
    file: impl Into<InputFile>,
    order: Option<usize>,
) -> Result<(Materials, usize)> {
    let sheet = Sheet::read(file, &MATERIAL.header("r,g,b"))?;
    let (order, largest, entries) = entries(&MATERIAL, &sheet, order)?;
    Ok((Materials { order, entries }, largest))
}

/// Writes lights so that reading the file restores every number to the last bit. If all lights are
/// gray, the file has the single column `value`.
///
/// # Errors
///
/// If a number is not finite, an entry does not have (degree + 1)² coefficients, or the output
/// fails.
pub fn write_lights(lights: &Lights, out: &mut (impl Write + ?Sized)) -> Result<()> {
    write(&LIGHT, lights.degree, &lights.entries, out)
}

/// Writes materials in the same way as [`write_lights`].
///
/// # Errors
///
/// See [`write_lights`].
pub fn write_materials(materials: &Materials, out: &mut (impl Write + ?Sized)) -> Result<()> {
    write(&MATERIAL, materials.order, &materials.entries, out)
}

/// The rows of one name, in file order.
struct Found<'a> {
    name: &'a str,
    rows: Vec<(usize, [f64; 3], Row<'a>)>,
}

fn entries<const N: usize>(
    kind: &Kind<N>,
    sheet: &Sheet,
    wanted: Option<usize>,
) -> Result<(usize, usize, Vec<Named>)> {
    let (largest, found) = gather(kind, sheet)?;
    if found.is_empty() {
        let remedy = format!("add rows below the header `{}`", kind.header("r,g,b"));
        return Err(sheet.fault(format!("it contains no {}", kind.thing), remedy));
    }
    let size = wanted.unwrap_or(largest);
    if size > largest {
        let word = kind.size;
        let what = format!("it has {word} {largest}, but {word} {size} is needed");
        let remedy = format!("ask for at most {word} {largest}, or create the file again");
        return Err(sheet.fault(what, remedy));
    }
    let entries =
        found.into_iter().map(|found| complete(kind, size, found)).collect::<Result<_>>()?;
    Ok((size, largest, entries))
}

/// Groups the rows by name; also returns the largest degree or order.
fn gather<'a, const N: usize>(kind: &Kind<N>, sheet: &'a Sheet) -> Result<(usize, Vec<Found<'a>>)> {
    let wrong_header = || {
        let (rgb, gray) = (kind.header("r,g,b"), kind.header("value"));
        sheet.wrong_header(&format!("`{rgb}` or `{gray}`"))
    };
    let [name_column] = sheet.columns(["name"]).ok_or_else(wrong_header)?;
    let index_columns = sheet.columns(kind.names).ok_or_else(wrong_header)?;
    let value_columns = sheet.colors()?.ok_or_else(wrong_header)?;
    let (mut largest, mut found) = (0, Vec::<Found<'a>>::new());
    let mut entry_of = HashMap::new();
    for row in sheet.rows() {
        let name = row.text(name_column);
        if name.is_empty() {
            return Err(row.fault("the name is empty", "give every row a name"));
        }
        let mut index = [0; N];
        for (index, column) in index.iter_mut().zip(index_columns) {
            *index = row.integer(column)?;
        }
        let (size, position) = (kind.place)(index).ok_or_else(|| {
            let what = format!("no {} has {}", kind.thing, kind.spell(index));
            row.fault(what, format!("a valid index has {}", kind.rule))
        })?;
        let rgb = row.numbers(value_columns)?;
        largest = largest.max(size);
        let entry = *entry_of.entry(name).or_insert(found.len());
        if entry == found.len() {
            found.push(Found { name, rows: Vec::new() });
        }
        found[entry].rows.push((position, rgb, row));
    }
    Ok((largest, found))
}

/// The coefficients of one name; fails unless each occurs exactly once.
fn complete<const N: usize>(kind: &Kind<N>, size: usize, found: Found<'_>) -> Result<Named> {
    let (thing, name) = (kind.thing, found.name);
    let mut rows = found.rows;
    let first = rows.first().map(|&(.., row)| row);
    // The sort is stable: of two rows with the same index, the later one comes second.
    rows.sort_by_key(|&(position, ..)| position);
    if let Some([_, (.., row)]) = rows.windows(2).find(|pair| pair[0].0 == pair[1].0) {
        let what = format!("the {thing} `{name}` has this index twice");
        return Err(row.fault(what, "keep one of the two rows"));
    }
    let count = (kind.count)(size);
    let mut positions = rows.iter().take(count).map(|&(position, ..)| position).zip(0..);
    let missing = positions.position(|(position, k)| position != k).unwrap_or(rows.len());
    if let Some(row) = first
        && missing < count
        && let Some(index) = (kind.indices)(size).nth(missing)
    {
        let index = kind.spell(index);
        let what = format!("the {thing} `{name}`, which begins here, has no row {index}");
        let remedy = format!("add the row; {} {size} has {count} rows", kind.size);
        return Err(row.fault(what, remedy));
    }
    rows.truncate(count);
    Ok(Named {
        name: name.to_owned(),
        rgb: [0, 1, 2].map(|channel| rows.iter().map(|(_, rgb, _)| rgb[channel]).collect()),
    })
}

fn write<const N: usize>(
    kind: &Kind<N>,
    size: usize,
    entries: &[Named],
    out: &mut (impl Write + ?Sized),
) -> Result<()> {
    let gray = entries.iter().all(Named::is_gray);
    let header = kind.header(if gray { "value" } else { "r,g,b" });
    let indices: Vec<_> = (kind.indices)(size).collect();
    let mut writer = csv::WriterBuilder::new().comment(Some(b'#')).from_writer(out);
    writer.write_record(header.split(',')).map_err(output_fault)?;
    for entry in entries {
        if entry.rgb.iter().any(|channel| channel.len() != indices.len()) {
            let (thing, name, word) = (kind.thing, &entry.name, kind.size);
            let what = format!("the {thing} `{name}` is not of {word} {size}");
            return Err(Error::new(what, format!("bring every {thing} to one {word} first")));
        }
        let channels = if gray { &entry.rgb[..1] } else { &entry.rgb[..] };
        for (k, &index) in indices.iter().enumerate() {
            let mut fields = vec![entry.name.clone()];
            fields.extend(index.map(|i| i.to_string()));
            for channel in channels {
                if !channel[k].is_finite() {
                    let (thing, name, place) = (kind.thing, &entry.name, kind.spell(index));
                    let what = format!("the {thing} `{name}` is not finite at {place}");
                    return Err(Error::new(what, "scale its inputs toward 1"));
                }
                fields.push(exact(channel[k]));
            }
            writer.write_record(&fields).map_err(output_fault)?;
        }
    }
    writer.flush().map_err(|error| output_fault(error.into()))
}
