//! Refuses outputs that would overwrite each other or an input.

use eigenshade_model::error::{Error, Result};
use eigenshade_model::output::end_of_links;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};

/// Checks, before anything is written, that all outputs of a command are different files and that
/// none of them is an input.
///
/// The check compares files, not names: it follows links, `.` and `..`. Another hard link to an
/// input counts as a different file, because writing creates a new file under that name and leaves
/// the input intact. Devices and pipes hold no data that could be lost, so they are allowed.
///
/// # Errors
///
/// For the first output that goes to the same place as an earlier output or an input.
pub fn refuse<P: AsRef<Path>, Q: AsRef<Path>>(
    outputs: impl IntoIterator<Item = P>,
    inputs: impl IntoIterator<Item = Q>,
) -> Result<()> {
    let inputs: Vec<(PathBuf, Q)> =
        inputs.into_iter().map(|input| (place(input.as_ref()), input)).collect();
    let mut taken: Vec<(PathBuf, P)> = Vec::new();
    for output in outputs {
        let path = output.as_ref();
        let place = place(path);
        if place.exists() && !place.is_file() {
            continue;
        }
        if let Some((_, input)) = inputs.iter().find(|(other, _)| *other == place) {
            let input = input.as_ref().display();
            let what = format!("it would replace the input `{input}`");
            return Err(Error::new(what, "give the output another name").in_file(path));
        }
        if let Some((_, other)) = taken.iter().find(|(other, _)| *other == place) {
            let other = other.as_ref().display();
            let what = format!("two outputs go there, the other as `{other}`");
            return Err(Error::new(what, "give each its own file").in_file(path));
        }
        taken.push((place, output));
    }
    Ok(())
}

/// The location of a file that may not exist yet: the end of its links, or its name in its resolved
/// folder.
fn place(path: &Path) -> PathBuf {
    let path = end_of_links(path).unwrap_or_else(|_| path.to_owned());
    path.canonicalize().unwrap_or_else(|_| {
        let folder = match path.parent() {
            Some(folder) if folder != OsStr::new("") => folder,
            _ => Path::new("."),
        };
        match (folder.canonicalize(), path.file_name()) {
            (Ok(folder), Some(name)) => folder.join(name),
            // The folder does not exist; writing will report it.
            _ => path.to_owned(),
        }
    })
}
