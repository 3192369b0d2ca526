//! Where an answer goes: to a file, whole or not at all, or to standard output.

use eigenshade_model::error::{Error, Result};
use eigenshade_model::output::write_atomically;
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::Path;

/// Writes to the file, or to standard output if there is none.
///
/// A reader that has seen enough and closes the pipe is no fault.
///
/// # Errors
///
/// What `write` returns, and the faults of the file, its folder or the disk.
pub fn write(out: Option<&Path>, write: impl FnOnce(&mut dyn Write) -> Result<()>) -> Result<()> {
    match out {
        Some(path) => write_atomically(path, write),
        None => to_standard_output(write),
    }
}

/// Writes to the file and does `then` when all is written but does not stand under its name
/// yet: unless both succeed, the file is as it was. Without a file does `then` alone.
///
/// # Errors
///
/// What `write` and `then` return, and the faults of the file, its folder or the disk.
pub fn write_before(
    file: Option<&Path>,
    write: impl FnOnce(&mut dyn Write) -> Result<()>,
    then: impl FnOnce() -> Result<()>,
) -> Result<()> {
    match file {
        Some(path) => write_atomically(path, |out| {
            write(out)?;
            out.flush().map_err(|error| fault(&error))?;
            then()
        }),
        None => then(),
    }
}

/// [`write`](fn@write) of a text that is ready.
///
/// # Errors
///
/// The faults of the file, its folder or the disk.
pub fn write_text(out: Option<&Path>, text: &str) -> Result<()> {
    write(out, |to| to.write_all(text.as_bytes()).map_err(|error| fault(&error)))
}

/// The fault of an output that cannot be written.
#[must_use]
pub fn fault(error: &io::Error) -> Error {
    Error::new(error.to_string(), "check where the output goes")
}

fn to_standard_output(write: impl FnOnce(&mut dyn Write) -> Result<()>) -> Result<()> {
    let mut pipe = Pipe { inner: io::stdout().lock(), closed: false };
    let mut buffer = BufWriter::with_capacity(1 << 16, &mut pipe);
    let written = write(&mut buffer)
        .and_then(|()| buffer.flush().map_err(|error| Error::io("standard output", &error)));
    // Dropped with its contents, not flushed: whoever listened has gone, or heard all.
    drop(buffer.into_parts());
    if pipe.closed { Ok(()) } else { written }
}

/// Notes whether the other end was closed.
struct Pipe<W> {
    inner: W,
    closed: bool,
}

impl<W: Write> Pipe<W> {
    fn note<T>(&mut self, result: io::Result<T>) -> io::Result<T> {
        let kind = result.as_ref().err().map(io::Error::kind);
        self.closed |= kind == Some(ErrorKind::BrokenPipe);
        result
    }
}

impl<W: Write> Write for Pipe<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let result = self.inner.write(bytes);
        self.note(result)
    }

    fn flush(&mut self) -> io::Result<()> {
        let result = self.inner.flush();
        self.note(result)
    }
}
