//! Shipped lights and materials by name, wherever a command takes a file.

use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::coefficient_csv::{read_lights, read_materials};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_shading::shipped;
use std::path::Path;

/// The least similarity of a name that an error message offers, from 0 to 1.
const SIMILAR: f64 = 0.75;

/// The most names that an error message offers.
const OFFERED: usize = 3;

/// The lights of a file, or the shipped light of this name.
///
/// # Errors
///
/// Those of [`read_lights`]; if there is no such file, and the text looks like a name but is none.
pub fn lights(file: InputFile) -> Result<Lights> {
    let Some(name) = name(file.path()) else { return read_lights(file, None) };
    let Lights { degree, entries } = shipped::lights()?;
    Ok(Lights { degree, entries: vec![find("light", name, entries)?] })
}

/// The materials of a file, or the shipped material of this name.
///
/// # Errors
///
/// As [`lights`].
pub fn materials(file: InputFile) -> Result<Materials> {
    let Some(name) = name(file.path()) else { return read_materials(file, None) };
    let Materials { order, entries } = shipped::named_materials()?;
    Ok(Materials { order, entries: vec![find("material", name, entries)?] })
}

/// A total error above this share is worth a note.
const LARGE: f64 = 0.05;

/// A note if this is a shipped material whose pictures at this degree and order are far from those
/// of its BRDF.
#[must_use]
pub fn error_note(material: &Path, size: (usize, usize)) -> Option<String> {
    let name = name(material)?;
    let error = shipped::total_error(name, size).filter(|error| error.worst > LARGE)?;
    Some(format!(
        "note: `{name}` is sharper than order {} can show: pictures are off by {:.1} % of their \
         peak, under some lights by {:.0} %, and highlights are blurred",
        size.1,
        100.0 * error.median,
        100.0 * error.worst
    ))
}

/// The path as the name of something shipped: one word without an extension, and no file.
fn name(path: &Path) -> Option<&str> {
    let name = path.to_str()?;
    let is_word = !name.is_empty() && !name.contains(['/', '\\', ':']);
    (is_word && path.extension().is_none() && !path.exists()).then_some(name)
}

fn find(kind: &str, name: &str, entries: Vec<Named>) -> Result<Named> {
    let mut similar: Vec<(f64, String)> = entries
        .iter()
        .map(|entry| (strsim::jaro_winkler(name, &entry.name), entry.name.clone()))
        .filter(|(similarity, other)| *similarity >= SIMILAR || other.contains(name))
        .collect();
    similar.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    let offered: Vec<String> =
        similar.into_iter().take(OFFERED).map(|(_, name)| format!("`{name}`")).collect();
    let offered = match offered.as_slice() {
        [] => String::new(),
        names => format!("{}, or ", names.join(", ")),
    };
    entries.into_iter().find(|entry| entry.name == name).ok_or_else(|| {
        Error::new(
            format!("`{name}` is neither a file nor a shipped {kind}"),
            format!("use {offered}a name that `eigenshade list` prints"),
        )
    })
}
