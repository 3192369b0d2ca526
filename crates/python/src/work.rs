//! Work that takes long, and what it says.

use crate::arrays::raised;
use eigenshade_cli::messages::spinner;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use pyo3::exceptions::{PyRuntimeError, PyUserWarning};
use pyo3::prelude::*;
use rayon::ThreadPoolBuilder;
use std::ffi::CString;
use std::path::Path;
use std::sync::Mutex;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

/// Time between two looks for signals.
const PAUSE: Duration = Duration::from_millis(50);

/// The result of work without the lock of the interpreter; a terminal shows `what` is done. Ctrl-C
/// raises `KeyboardInterrupt` at once: the work ends by itself, and its result is dropped.
pub fn done<T: Send + 'static>(
    py: Python<'_>,
    what: &'static str,
    work: impl FnOnce() -> Result<T> + Send + 'static,
) -> PyResult<T> {
    let (sender, receiver) = channel();
    thread::spawn(move || {
        // A pool for each call: after Ctrl-C the abandoned work must not block the next call.
        let pool = ThreadPoolBuilder::new().build();
        let result = pool.map_or_else(
            |_| Err(Error::new("no threads can be had", "end other programs")),
            |pool| pool.install(work),
        );
        // Nobody listens after Ctrl-C.
        let _ = sender.send(result);
    });
    let receiver = Mutex::new(receiver);
    let progress = spinner(what);
    let result = loop {
        let next = py.detach(|| receiver.lock().expect("one reader").recv_timeout(PAUSE));
        match next {
            Ok(result) => break result.map_err(raised),
            Err(RecvTimeoutError::Timeout) => {
                if let Err(interrupted) = py.check_signals() {
                    break Err(interrupted);
                }
            }
            Err(RecvTimeoutError::Disconnected) => {
                let what = "the work stopped with a panic; please report it";
                break Err(PyRuntimeError::new_err(what));
            }
        }
    };
    progress.finish_and_clear();
    warn(py)?;
    result
}

/// Warnings of files that were read. Files do not know who reads them: with several threads, one
/// may get those of another.
static WARNINGS: Mutex<Vec<String>> = Mutex::new(Vec::new());

/// Raises the warnings in the thread of the caller.
fn warn(py: Python<'_>) -> PyResult<()> {
    let warnings = WARNINGS.lock().map(|mut all| std::mem::take(&mut *all)).unwrap_or_default();
    for text in warnings {
        let category = py.get_type::<PyUserWarning>();
        PyErr::warn(py, &category, &CString::new(text).unwrap_or_default(), 1)?;
    }
    Ok(())
}

/// A file whose warnings are those of Python.
pub fn input_file(path: impl AsRef<Path>) -> InputFile {
    InputFile::new(path).with_warnings(|path, what| {
        if let Ok(mut all) = WARNINGS.lock() {
            all.push(format!("{}: {what}", path.display()));
        }
    })
}
