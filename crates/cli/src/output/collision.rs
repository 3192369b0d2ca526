//! Outputs that would replace one another, or an input.

use eigenshade_model::error::{Error, Result};
use eigenshade_model::output::end_of_links;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};

/// Checks, before anything is written, that each output of a command is a file of its own
/// and none of its inputs.
///
/// Files are compared, not names: links, `.` and `..` are followed. Another hard link of an
/// input is another file, since a new one takes its name and leaves the input. Devices and
/// pipes, which keep nothing that could be lost, are let through.
///
/// # Errors
///
/// For the first output, in their order, that goes where an earlier one goes, or where an
/// input is.
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

/// Where a file is, or would be: the end of its links, or its folder's place and its name.
fn place(path: &Path) -> PathBuf {
    let path = end_of_links(path).unwrap_or_else(|_| path.to_owned());
    path.canonicalize().unwrap_or_else(|_| {
        let folder = match path.parent() {
            Some(folder) if folder != OsStr::new("") => folder,
            _ => Path::new("."),
        };
        match (folder.canonicalize(), path.file_name()) {
            (Ok(folder), Some(name)) => folder.join(name),
            // A folder that is not there: writing says so.
            _ => path.to_owned(),
        }
    })
}
