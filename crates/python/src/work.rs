//! Work that takes long, on threads that outlive a call.

use crate::arrays::raised;
use eigenshade_cli::messages::{progress_bar, spinner};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::task::Task;
use pyo3::exceptions::{PyRuntimeError, PyUserWarning};
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::ffi::CString;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex};
use std::time::Duration;

/// Time between two looks for signals; shorter work shows no progress.
const PAUSE: Duration = Duration::from_millis(50);

/// The result of work without the lock of the interpreter; a terminal shows the progress of `what`.
/// Ctrl-C raises `KeyboardInterrupt` at once, and the work ends at its next step.
pub fn done<T: Send + 'static>(
    py: Python<'_>,
    what: &'static str,
    work: impl FnOnce() -> Result<T> + Send + 'static,
) -> PyResult<T> {
    let pool = Pool::taken().map_err(raised)?;
    let task = Arc::new(Task::default());
    let (sender, receiver) = channel();
    let of_work = Arc::clone(&task);
    pool.threads.spawn(move || {
        // Without a result the sender is dropped.
        if let Ok(result) = catch_unwind(AssertUnwindSafe(|| of_work.run(work))) {
            // Nobody listens after Ctrl-C.
            let _ = sender.send(result);
        }
    });
    let receiver = Mutex::new(receiver);
    let mut shown = None;
    let result = loop {
        let next = py.detach(|| receiver.lock().expect("one reader").recv_timeout(PAUSE));
        match next {
            Ok(result) => {
                pool.give_back();
                break result.map_err(raised);
            }
            Err(RecvTimeoutError::Timeout) => {
                let (finished, count) = task.steps();
                let bar = match shown.take() {
                    Some((of, bar)) if count == 0 || of == count => (of, bar),
                    _ if count == 0 => (count, spinner(what)),
                    _ => (count, progress_bar(what, count)),
                };
                // Not back to 0 in work without steps.
                if count > 0 {
                    bar.1.set_position(finished as u64);
                }
                shown = Some(bar);
                if let Err(interrupted) = py.check_signals() {
                    task.stop();
                    break Err(interrupted);
                }
            }
            Err(RecvTimeoutError::Disconnected) => {
                let what = "the work stopped with a panic; please report it";
                break Err(PyRuntimeError::new_err(what));
            }
        }
    };
    drop(shown);
    warn(py)?;
    result
}

/// The threads of one call, and the process that started them.
struct Pool {
    process: u32,
    threads: ThreadPool,
}

/// Those that no call uses. A call beside another one, or after one that was interrupted, starts its
/// own, so that it does not wait for the other's steps.
static IDLE: Mutex<Option<Pool>> = Mutex::new(None);

impl Pool {
    fn taken() -> Result<Self> {
        let process = std::process::id();
        match IDLE.lock().expect("no panic").take() {
            Some(pool) if pool.process == process => return Ok(pool),
            // The child of a fork has a copy without threads, which would wait for them when dropped.
            Some(copy) => std::mem::forget(copy),
            None => {}
        }
        let threads = ThreadPoolBuilder::new().build();
        let threads =
            threads.map_err(|_| Error::new("no threads can be had", "end other programs"))?;
        Ok(Self { process, threads })
    }

    fn give_back(self) {
        IDLE.lock().expect("no panic").get_or_insert(self);
    }
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
