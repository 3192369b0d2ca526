//! Files that are being written. They are removed if the writing fails or the program is asked to
//! terminate.

use std::collections::BTreeSet;
use std::fs::{self, File, Metadata};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use tempfile::TempPath;

/// The paths of all unfinished files. Creating, renaming or removing one requires the lock.
static PATHS: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

fn paths() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    PATHS.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A temporary file that will replace its target.
pub(crate) struct Unfinished {
    path: PathBuf,
    file: Option<TempPath>,
}

impl Unfinished {
    /// Creates a file in `folder` with the permissions of the file that it will replace, or with
    /// those of any new file.
    pub(crate) fn create(folder: &Path, replaced: Option<&Metadata>) -> io::Result<(Self, File)> {
        let mut builder = tempfile::Builder::new();
        builder.prefix(".eigenshade-");
        #[cfg(unix)]
        {
            use std::os::unix::fs::{MetadataExt, PermissionsExt};
            let mode = replaced.map_or(0o666, |old| old.mode() & 0o777);
            builder.permissions(fs::Permissions::from_mode(mode));
        }
        let mut paths = paths();
        let (file, temporary) = builder.tempfile_in(folder).map_err(unnamed)?.into_parts();
        let path = temporary.to_path_buf();
        paths.insert(path.clone());
        drop(paths);
        let unfinished = Self { path, file: Some(temporary) };
        if let Some(old) = replaced {
            keep_owner(&file, old);
            file.set_permissions(old.permissions())?;
        }
        Ok((unfinished, file))
    }

    /// Renames the file to `target`.
    pub(crate) fn finish(mut self, target: &Path) -> io::Result<()> {
        let mut paths = paths();
        paths.remove(&self.path);
        self.file.take().map_or(Ok(()), |file| file.persist(target).map_err(|failed| failed.error))
    }
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        if let Some(file) = self.file.take() {
            let mut paths = paths();
            drop(file);
            paths.remove(&self.path);
        }
    }
}

/// Removes every unfinished file, for a program that is about to terminate. Afterwards no
/// unfinished file can be created or renamed: a thread that tries to waits forever.
pub fn remove_all() {
    let paths = paths();
    for path in paths.iter() {
        let _ = fs::remove_file(path);
    }
    std::mem::forget(paths);
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

/// Removes the name of the temporary file, which `tempfile` appends to the system's message.
fn unnamed(error: io::Error) -> io::Error {
    match error.to_string().split_once(" at path ") {
        Some((word, _)) => io::Error::new(error.kind(), word),
        None => error,
    }
}
