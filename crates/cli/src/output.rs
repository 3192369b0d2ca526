//! Output of the commands: CSV rows, and files that are written completely or not at all.

pub use eigenshade_model::inputs::coefficient_text::exact;

use crate::messages::is_quiet;
use eigenshade_model::error::{Error, Result, STANDARD_INPUT};
use eigenshade_model::inputs::input_file::is_file;
use eigenshade_model::output::{Watched, end_of_links, write_atomically, write_error};
use serde::Serialize;
use std::ffi::OsStr;
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};

/// Setting the comment character makes the writer quote names that begin with it.
fn csv_writer(out: &mut dyn Write) -> csv::Writer<&mut dyn Write> {
    csv::WriterBuilder::new().comment(Some(b'#')).from_writer(out)
}

/// A CSV writer.
pub struct Rows<'a>(csv::Writer<&'a mut dyn Write>);

impl<'a> Rows<'a> {
    /// Starts the CSV with its header. Fails if the output fails.
    pub fn new<T: AsRef<[u8]>>(
        out: &'a mut dyn Write,
        header: impl IntoIterator<Item = T>,
    ) -> Result<Self> {
        let mut rows = Self(csv_writer(out));
        rows.row(header)?;
        Ok(rows)
    }

    /// Writes one row, which has as many fields as the header. Fails if the output fails.
    pub fn row<T: AsRef<[u8]>>(&mut self, fields: impl IntoIterator<Item = T>) -> Result<()> {
        self.0.write_record(fields).map_err(write_error)
    }

    /// Flushes the output. Fails if the output fails.
    pub fn finish(mut self) -> Result<()> {
        self.0.flush().map_err(write_error)
    }
}

/// Writes records as CSV with a header, or as a JSON array. A missing number is empty in CSV and
/// null in JSON. Fails if the output fails.
pub fn write_records<T: Serialize>(out: Option<&Path>, is_json: bool, records: &[T]) -> Result<()> {
    if is_json {
        return write_json(out, &records);
    }
    write(out, |out| {
        let mut rows = csv_writer(out);
        records.iter().try_for_each(|record| rows.serialize(record)).map_err(write_error)?;
        rows.flush().map_err(write_error)
    })
}

/// Writes a value as JSON. Fails if the output fails.
pub fn write_json(out: Option<&Path>, value: &impl Serialize) -> Result<()> {
    let text = serde_json::to_string_pretty(value);
    let text = text.map_err(|error| Error::new(error.to_string(), "leave --json out"))?;
    write_all(out, text + "\n")
}

/// Writes to the file, or to standard output if there is none.
///
/// It is not an error if the reader closes the pipe early.
///
/// Fails as `write` does, or if the file, its folder or the disk fails.
pub fn write(out: Option<&Path>, write: impl FnOnce(&mut dyn Write) -> Result<()>) -> Result<()> {
    match out {
        Some(path) => write_atomically(path, write),
        None => to_standard_output(write),
    }
}

/// Writes to a temporary file and runs `then` before the file gets its final name. Unless both
/// succeed, the file is left as it was. Without a file, only runs `then`. Fails as `write` and
/// `then` do, or if the file, its folder or the disk fails.
pub fn write_before(
    file: Option<&Path>,
    write: impl FnOnce(&mut dyn Write) -> Result<()>,
    then: impl FnOnce() -> Result<()>,
) -> Result<()> {
    match file {
        Some(path) => write_atomically(path, |out| {
            write(out)?;
            out.flush().map_err(write_error)?;
            then()
        }),
        None => then(),
    }
}

/// Like [`write`](fn@write), for complete contents. Fails if the file, its folder or the disk
/// fails.
pub fn write_all(out: Option<&Path>, contents: impl AsRef<[u8]>) -> Result<()> {
    write(out, |to| to.write_all(contents.as_ref()).map_err(write_error))
}

/// Writes what a command reports about its files to standard output, unless messages are hidden.
/// Fails if the output fails.
pub fn report(text: impl AsRef<[u8]>) -> Result<()> {
    if is_quiet() { Ok(()) } else { write_all(None, text) }
}

fn to_standard_output(write: impl FnOnce(&mut dyn Write) -> Result<()>) -> Result<()> {
    let mut pipe = Watched::new(io::stdout().lock());
    let mut buffer = BufWriter::with_capacity(1 << 16, &mut pipe);
    let written = write(&mut buffer).and_then(|()| buffer.flush().map_err(write_error));
    // Dropped without flushing: the reader has gone, or has received everything.
    drop(buffer.into_parts());
    match pipe.failed {
        Some(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        Some(error) => Err(Error::io("standard output", &error)),
        None => written,
    }
}

/// Checks, before anything is written, that all outputs of a command are different files and that
/// none of them is an input. An input that is not there, such as a shipped name, is no file.
///
/// The check compares files, not names: it follows links, `.` and `..`. Another hard link to an
/// input counts as a different file, because writing creates a new file under that name and leaves
/// the input intact. Devices and pipes hold no data that could be lost, so they are allowed.
///
/// Fails for the first output that goes to the same place as an earlier output or an input, and for
/// `-`.
pub fn refuse_collisions<P: AsRef<Path>, Q: AsRef<Path>>(
    outputs: impl IntoIterator<Item = P>,
    inputs: impl IntoIterator<Item = Q>,
) -> Result<()> {
    let with_place = |input: Q| (place(input.as_ref()), input);
    let inputs: Vec<(PathBuf, Q)> =
        inputs.into_iter().filter(|input| is_file(input.as_ref())).map(with_place).collect();
    let mut taken: Vec<(PathBuf, P)> = Vec::new();
    for output in outputs {
        let path = output.as_ref();
        if path.as_os_str() == STANDARD_INPUT {
            let remedy = "name a file; without --out, CSV and text go to standard output";
            return Err(Error::new("`-` stands for standard input only", remedy));
        }
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

/// Installs a handler: SIGINT and SIGTERM then remove the files being written and terminate the
/// program as they do by default.
///
/// Where signals cannot be caught, such files are left behind.
#[cfg(unix)]
pub fn clean_up_on_signals() {
    use eigenshade_model::output::remove_unfinished;
    use signal_hook::consts::{SIGINT, SIGTERM};
    let Ok(mut signals) = signal_hook::iterator::Signals::new([SIGINT, SIGTERM]) else { return };
    std::thread::spawn(move || {
        if let Some(signal) = signals.forever().next() {
            remove_unfinished();
            let _ = signal_hook::low_level::emulate_default_handler(signal);
            std::process::exit(128 + signal);
        }
    });
}

#[cfg(test)]
mod tests {
    use super::exact;

    #[test]
    fn numbers_read_back() {
        for number in [0.0, -0.0, 1.0 / 3.0, 1e-300, -2.5e17, f64::from(0.1f32), 5e-324] {
            let back: f64 = exact(number).parse().unwrap();
            assert_eq!(back.to_bits(), number.to_bits());
        }
        assert_eq!(exact(1e-7), "1e-7");
        assert_eq!(exact(0.25), "0.25");
    }
}
