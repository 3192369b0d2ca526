//! Work that takes long, and what it says.

use crate::arrays::{raised, refused};
use eigenshade_cli::messages::spinner;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use pyo3::exceptions::PyUserWarning;
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
        // On threads of its own: work that nobody waits for any more would hold up what comes next.
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
    loop {
        let next = py.detach(|| receiver.lock().expect("one reader").recv_timeout(PAUSE));
        match next {
            Ok(result) => {
                progress.finish_and_clear();
                return result.map_err(raised);
            }
            Err(RecvTimeoutError::Timeout) => {
                py.check_signals().inspect_err(|_| progress.finish_and_clear())?;
            }
            Err(RecvTimeoutError::Disconnected) => {
                return Err(refused("the work stopped with a panic", "report it"));
            }
        }
    }
}

/// A file whose warnings are those of Python.
pub fn input_file(path: impl AsRef<Path>) -> InputFile {
    InputFile::new(path).with_warnings(|path, what| {
        Python::attach(|py| {
            let text = CString::new(format!("{}: {what}", path.display())).unwrap_or_default();
            let category = py.get_type::<PyUserWarning>();
            // If warnings are errors, the file is read all the same.
            let _ = PyErr::warn(py, &category, &text, 2);
        });
    })
}
