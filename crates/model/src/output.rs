//! Whole files or none: what is written stands under its name when it is
//! complete, and not before.

use crate::error::{Error, Result};
use crate::unfinished::Unfinished;
use std::fs::{self, File, Metadata, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// Writes a file by way of a temporary one in the same folder, renamed at the
/// end: whoever reads `path` finds the old file or the whole new one.
///
/// A file that is replaced keeps its mode. A symbolic link stays one: the file where it leads is
/// written, whether or not it was there. A device or pipe is written straight to.
///
/// # Errors
///
/// Whatever `write` returns, a file that may not be written, and every fault of the folder or the
/// disk; a file that stood there before is then as it was.
pub fn write_atomically(
    path: impl AsRef<Path>,
    write: impl FnOnce(&mut dyn Write) -> Result<()>,
) -> Result<()> {
    let path = path.as_ref();
    let fault = |error: io::Error| Error::io(path, &error);
    // A pipe's name leads to no path.
    if fs::metadata(path).is_ok_and(|found| !found.is_file() && !found.is_dir()) {
        return fill(path, File::create(path).map_err(fault)?, write).map(drop);
    }
    let (target, replaced) = replaceable(path)?;
    let folder = match target.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    let (unfinished, file) = Unfinished::create(folder, replaced.as_ref()).map_err(fault)?;
    let file = fill(path, file, write)?;
    file.sync_all().map_err(fault)?;
    drop(file);
    unfinished.finish(&target).map_err(fault)
}

/// Refuses what [`write_atomically`] would refuse to replace: of several outputs none is then
/// written without the others.
///
/// # Errors
///
/// A folder, a file that is read-only.
pub fn writable(path: &Path) -> Result<()> {
    replaceable(path).map(drop)
}

/// Where a path leads, and what is there.
fn replaceable(path: &Path) -> Result<(PathBuf, Option<Metadata>)> {
    let fault = |error: io::Error| Error::io(path, &error);
    let target = end_of_links(path).map_err(fault)?;
    let replaced = fs::metadata(&target).ok();
    match &replaced {
        Some(metadata) if metadata.is_dir() => {
            return Err(fault(io::ErrorKind::IsADirectory.into()));
        }
        Some(metadata) if metadata.is_file() => refuse_read_only(path, &target, metadata)?,
        _ => {}
    }
    Ok((target, replaced))
}

/// Where a path leads: the end of its symbolic links, whether or not a file is there.
///
/// # Errors
///
/// Links in a circle, folders that may not be searched.
pub fn end_of_links(path: &Path) -> io::Result<PathBuf> {
    let mut end = path.to_owned();
    loop {
        match fs::canonicalize(&end) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => {}
            found => return found,
        }
        match fs::read_link(&end) {
            Ok(to) => end = end.parent().unwrap_or(Path::new("")).join(to),
            Err(_) => return Ok(end),
        }
    }
}

/// To replace a file takes the right to write in its folder only: the file's own is checked
/// here, also for a user whom the system lets write everything.
fn refuse_read_only(path: &Path, target: &Path, metadata: &Metadata) -> Result<()> {
    if metadata.permissions().readonly() {
        let remedy = "make it writable, or give the output another name";
        return Err(Error::new("the file is read-only", remedy).in_file(path));
    }
    OpenOptions::new().write(true).open(target).map(drop).map_err(|error| Error::io(path, &error))
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
