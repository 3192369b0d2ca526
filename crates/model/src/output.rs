//! Complete files or none: an output appears under its name only when it is complete.

use crate::error::{Error, Result};
use std::fmt::Display;
use std::fs::{self, File, Metadata, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use tempfile::NamedTempFile;

/// The error for an output that cannot be written.
#[must_use]
pub fn write_error(error: impl Display) -> Error {
    Error::new(error.to_string(), "check where the output goes")
}

/// Writes a file through a temporary file in the same folder, which is renamed at the end. A reader
/// of `path` finds either the old file or the complete new one.
///
/// A replaced file keeps its mode. A symbolic link stays a link: its target is written, whether or
/// not the target exists. A device or pipe is written directly.
///
/// # Errors
///
/// If `write` fails, the file may not be written, or the folder or the disk fails. An existing file
/// is then unchanged.
pub fn write_atomically(
    path: impl AsRef<Path>,
    write: impl FnOnce(&mut dyn Write) -> Result<()>,
) -> Result<()> {
    let path = path.as_ref();
    let fault = |error: io::Error| Error::io(path, &error);
    // The name of a pipe does not resolve to a path.
    if fs::metadata(path).is_ok_and(|found| !found.is_file() && !found.is_dir()) {
        return fill(path, File::create(path).map_err(fault)?, write).map(drop);
    }
    let (target, replaced) = replaceable(path)?;
    let folder = match target.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    let unfinished = Unfinished::create(folder, replaced.as_ref()).map_err(fault)?;
    fill(path, unfinished.0.as_file(), write)?;
    unfinished.0.as_file().sync_all().map_err(fault)?;
    unfinished.finish(&target).map_err(fault)
}

/// Checks whether [`write_atomically`] may replace a file. Checking all outputs first avoids
/// writing only some of them.
///
/// # Errors
///
/// If the path is a folder or a read-only file.
pub fn writable(path: &Path) -> Result<()> {
    replaceable(path).map(drop)
}

/// The target of a path, and the metadata of the file there.
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

/// The target of a path after following its symbolic links, whether or not a file exists there.
///
/// # Errors
///
/// If links form a cycle or a folder may not be searched.
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

/// Replacing a file requires only write permission for its folder. This checks the permission of
/// the file itself, even for a user who may write everything.
fn refuse_read_only(path: &Path, target: &Path, metadata: &Metadata) -> Result<()> {
    if metadata.permissions().readonly() {
        let remedy = "make it writable, or give the output another name";
        return Err(Error::new("the file is read-only", remedy).in_file(path));
    }
    OpenOptions::new().write(true).open(target).map(drop).map_err(|error| Error::io(path, &error))
}

/// The paths of all unfinished files, and of files that were finished.
static PATHS: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

fn paths() -> MutexGuard<'static, Vec<PathBuf>> {
    PATHS.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes every unfinished file, for a program that is about to terminate. Afterwards no
/// unfinished file can be created or renamed: a thread that tries to waits forever.
pub fn remove_unfinished() {
    let paths = paths();
    for path in paths.iter() {
        let _ = fs::remove_file(path);
    }
    std::mem::forget(paths);
}

/// A file that is being written and will replace its target. Dropping it removes the file.
struct Unfinished(NamedTempFile);

impl Unfinished {
    /// Creates a file in `folder` with the permissions of the file that it will replace, or with
    /// the permissions of any new file.
    fn create(folder: &Path, replaced: Option<&Metadata>) -> io::Result<Self> {
        let mut options = OpenOptions::new();
        options.write(true).create_new(true);
        #[cfg(unix)]
        {
            use std::os::unix::fs::{MetadataExt, OpenOptionsExt};
            options.mode(replaced.map_or(0o666, |old| old.mode() & 0o777));
        }
        let mut paths = paths();
        let mut builder = tempfile::Builder::new();
        let file = builder.prefix(".eigenshade-").make_in(folder, |path| options.open(path))?;
        paths.push(file.path().to_owned());
        drop(paths);
        if let Some(old) = replaced {
            keep_owner(file.as_file(), old);
            file.as_file().set_permissions(old.permissions())?;
        }
        Ok(Self(file))
    }

    /// Renames the file to `target`.
    fn finish(self, target: &Path) -> io::Result<()> {
        let _paths = paths();
        self.0.persist(target).map(drop).map_err(|error| error.error)
    }
}

/// Gives `file` the owner and group of `old`, as far as the user is permitted to.
#[cfg(unix)]
fn keep_owner(file: &File, old: &Metadata) {
    use std::os::unix::fs::{MetadataExt, fchown};
    if fchown(file, Some(old.uid()), Some(old.gid())).is_err() {
        let _ = fchown(file, None, Some(old.gid()));
    }
}

#[cfg(not(unix))]
fn keep_owner(_: &File, _: &Metadata) {}

fn fill<W: Write>(
    path: &Path,
    file: W,
    write: impl FnOnce(&mut dyn Write) -> Result<()>,
) -> Result<W> {
    let mut watched = Watched::new(BufWriter::new(file));
    let written =
        write(&mut watched).and_then(|()| watched.flush().map_err(|error| Error::io(path, &error)));
    if let Some(error) = watched.failed {
        // Reports the system's error with the path instead of the error that the writer derived
        // from it.
        return Err(Error::io(path, &error));
    }
    written?;
    watched.inner.into_inner().map_err(|error| Error::io(path, error.error()))
}

/// Remembers the first error of the inner writer.
pub struct Watched<W> {
    inner: W,
    /// The error.
    pub failed: Option<io::Error>,
}

impl<W: Write> Watched<W> {
    /// A writer that has not failed.
    pub fn new(inner: W) -> Self {
        Self { inner, failed: None }
    }

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
