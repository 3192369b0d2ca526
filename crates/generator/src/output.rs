//! Whole files or none: what is written stands under its name when it is
//! complete, and not before.

use crate::error::{Error, Result};
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::Path;
use tempfile::NamedTempFile;

/// Writes a file by way of a temporary one in the same folder, renamed at the
/// end: whoever reads `path` finds the old file or the whole new one.
///
/// A symbolic link stays one; a device or pipe is written straight to.
///
/// # Errors
///
/// Whatever `write` returns, and every fault of the folder or the disk; a file
/// that stood there before is then as it was.
pub fn write_atomically(
    path: impl AsRef<Path>,
    write: impl FnOnce(&mut dyn Write) -> Result<()>,
) -> Result<()> {
    let path = path.as_ref();
    let fault = |error: io::Error| Error::io(path, &error);
    // What exists is followed to its end, so that links are kept.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    if let Ok(metadata) = fs::metadata(&target) {
        if metadata.is_dir() {
            return Err(fault(io::ErrorKind::IsADirectory.into()));
        }
        if !metadata.is_file() {
            return fill(path, File::create(&target).map_err(fault)?, write).map(drop);
        }
    }
    let folder = match target.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    let temporary = fill(path, temporary_in(folder).map_err(unnamed).map_err(fault)?, write)?;
    temporary.as_file().sync_all().map_err(fault)?;
    temporary.persist(&target).map_err(|failed| fault(failed.error))?;
    Ok(())
}

/// With the rights that any new file gets, not those of a secret.
fn temporary_in(folder: &Path) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".eigenshade-");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    builder.tempfile_in(folder)
}

/// Without the name of the temporary file, which `tempfile` puts behind the system's
/// word.
fn unnamed(error: io::Error) -> io::Error {
    match error.to_string().split_once(" at path ") {
        Some((word, _)) => io::Error::new(error.kind(), word),
        None => error,
    }
}

fn fill<W: Write>(
    path: &Path,
    file: W,
    write: impl FnOnce(&mut dyn Write) -> Result<()>,
) -> Result<W> {
    let mut watched = Watched { inner: BufWriter::new(file), failed: None };
    let written =
        write(&mut watched).and_then(|()| watched.flush().map_err(|error| Error::io(path, &error)));
    if let Some(error) = watched.failed {
        // The disk's own word, with the path, before what the writer made of it.
        return Err(Error::io(path, &error));
    }
    written?;
    watched.inner.into_inner().map_err(|error| Error::io(path, error.error()))
}

/// Keeps the first error of the writer within.
struct Watched<W: Write> {
    inner: BufWriter<W>,
    failed: Option<io::Error>,
}

impl<W: Write> Watched<W> {
    fn note<T>(&mut self, result: io::Result<T>) -> io::Result<T> {
        if let Err(error) = &result
            && self.failed.is_none()
            && error.kind() != io::ErrorKind::Interrupted
        {
            self.failed = Some(io::Error::new(error.kind(), error.to_string()));
        }
        result
    }
}

impl<W: Write> Write for Watched<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let result = self.inner.write(bytes);
        self.note(result)
    }

    fn flush(&mut self) -> io::Result<()> {
        let result = self.inner.flush();
        self.note(result)
    }
}
