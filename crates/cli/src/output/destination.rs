//! Writes output to standard output, or to a file, either completely or not at all.

use eigenshade_model::error::{Error, Result};
use eigenshade_model::output::write_atomically;
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::Path;

/// Writes to the file, or to standard output if there is none.
///
/// It is not an error if the reader closes the pipe early.
///
/// # Errors
///
/// Whatever `write` returns, and any failure of the file, its folder or the disk.
pub fn write(out: Option<&Path>, write: impl FnOnce(&mut dyn Write) -> Result<()>) -> Result<()> {
    match out {
        Some(path) => write_atomically(path, write),
        None => to_standard_output(write),
    }
}

/// Writes to a temporary file and runs `then` before the file gets its final name. Unless both
/// succeed, the file is left as it was. Without a file, only runs `then`.
///
/// # Errors
///
/// Whatever `write` and `then` return, and any failure of the file, its folder or the disk.
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

/// Like [`write`](fn@write), for a complete text.
///
/// # Errors
///
/// If the file, its folder or the disk fails.
pub fn write_text(out: Option<&Path>, text: &str) -> Result<()> {
    write(out, |to| to.write_all(text.as_bytes()).map_err(|error| fault(&error)))
}

/// The error for an output that cannot be written.
#[must_use]
pub fn fault(error: &io::Error) -> Error {
    Error::new(error.to_string(), "check where the output goes")
}

fn to_standard_output(write: impl FnOnce(&mut dyn Write) -> Result<()>) -> Result<()> {
    let mut pipe = Pipe { inner: io::stdout().lock(), closed: false };
    let mut buffer = BufWriter::with_capacity(1 << 16, &mut pipe);
    let written = write(&mut buffer)
        .and_then(|()| buffer.flush().map_err(|error| Error::io("standard output", &error)));
    // Dropped without flushing: the reader has gone, or has received everything.
    drop(buffer.into_parts());
    if pipe.closed { Ok(()) } else { written }
}

/// Records whether the reader closed the pipe.
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
