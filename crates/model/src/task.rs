//! Long work that another thread watches and stops.
//!
//! A task belongs to the thread that runs it, and [`parallel::map`](crate::parallel::map) hands it
//! on to the threads that take its steps. Work that no task runs is not counted and cannot be
//! stopped.

use std::cell::RefCell;
use std::panic::resume_unwind;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// The steps of some work, and whether it has to stop.
#[derive(Debug, Default)]
pub struct Task {
    is_stopped: AtomicBool,
    finished: AtomicUsize,
    count: AtomicUsize,
}

impl Task {
    /// Runs work as this task.
    ///
    /// # Panics
    ///
    /// Unwinds, without a message, if the task is stopped.
    pub fn run<T>(self: &Arc<Self>, work: impl FnOnce() -> T) -> T {
        let _entered = Entered::new(Some(Current { task: Arc::clone(self), is_step: false }));
        work()
    }

    /// Makes the work unwind at its next [`checkpoint`] or step.
    pub fn stop(&self) {
        self.is_stopped.store(true, Ordering::Relaxed);
    }

    /// The number of finished steps of the present part of the work, and of all its steps; zeros
    /// where they are not counted.
    #[must_use]
    pub fn steps(&self) -> (usize, usize) {
        (self.finished.load(Ordering::Relaxed), self.count.load(Ordering::Relaxed))
    }

    fn check(&self) {
        if self.is_stopped.load(Ordering::Relaxed) {
            // Without the hook of panics, which would print a message.
            resume_unwind(Box::new("the task is stopped"));
        }
    }
}

/// Unwinds if the work that runs here is stopped. For work of more than a few milliseconds that is
/// not in steps.
pub fn checkpoint() {
    CURRENT.with_borrow(|current| {
        if let Some(current) = current {
            current.task.check();
        }
    });
}

/// The task that a thread runs.
#[derive(Clone)]
struct Current {
    task: Arc<Task>,
    /// Whether this is a step of the task: steps within steps are not counted.
    is_step: bool,
}

thread_local! {
    static CURRENT: RefCell<Option<Current>> = const { RefCell::new(None) };
}

fn current() -> Option<Current> {
    CURRENT.with_borrow(Clone::clone)
}

/// Holds the task that the thread ran before, and restores it.
pub struct Entered(Option<Current>);

impl Entered {
    fn new(current: Option<Current>) -> Self {
        Self(CURRENT.replace(current))
    }
}

impl Drop for Entered {
    fn drop(&mut self) {
        CURRENT.set(self.0.take());
    }
}

/// A part of a task in steps, which any thread may take. They are counted unless they are within
/// other steps.
pub struct Steps {
    task: Option<Arc<Task>>,
    is_counted: bool,
}

impl Steps {
    /// Steps of the task that runs here, if one does, until they are dropped.
    #[must_use]
    pub fn new(count: usize) -> Self {
        let current = current();
        let is_counted = current.as_ref().is_some_and(|current| !current.is_step);
        let steps = Self { task: current.map(|current| current.task), is_counted };
        steps.restart(count);
        steps
    }

    /// What this thread does until the result is dropped is within these steps.
    #[must_use]
    pub fn enter(&self) -> Entered {
        Entered::new(self.task.clone().map(|task| Current { task, is_step: true }))
    }

    /// Takes one step, or unwinds if the task is stopped.
    pub fn take<T>(&self, step: impl FnOnce() -> T) -> T {
        let Some(task) = &self.task else { return step() };
        task.check();
        let value = step();
        if self.is_counted {
            task.finished.fetch_add(1, Ordering::Relaxed);
        }
        value
    }

    fn restart(&self, count: usize) {
        if let Some(task) = self.task.as_ref().filter(|_| self.is_counted) {
            task.finished.store(0, Ordering::Relaxed);
            task.count.store(count, Ordering::Relaxed);
        }
    }
}

impl Drop for Steps {
    fn drop(&mut self) {
        self.restart(0);
    }
}

#[cfg(test)]
mod tests {
    use super::{Task, checkpoint};
    use crate::parallel::map;
    use std::panic::{AssertUnwindSafe, catch_unwind};
    use std::sync::Arc;
    use std::sync::atomic::{AtomicUsize, Ordering};

    #[test]
    fn outer_steps_are_counted() {
        let task = Arc::new(Task::default());
        let seen = task.run(|| {
            map(1000, &(), |_| {
                map(7, &(), |_| ());
                task.steps()
            })
        });
        assert!(seen.iter().all(|(finished, count)| *finished < 1000 && *count == 1000));
        assert!(seen.iter().any(|(finished, _)| *finished >= 500));
        assert_eq!(task.steps(), (0, 0));
        let outside = map(3, &(), |_| task.steps());
        assert_eq!(outside, [(0, 0); 3]);
    }

    #[test]
    fn a_stopped_task_takes_no_more_steps_and_others_go_on() {
        let (task, taken) = (Arc::new(Task::default()), AtomicUsize::new(0));
        let stopped = catch_unwind(AssertUnwindSafe(|| {
            task.run(|| {
                map(1_000_000, &(), |_| {
                    map(3, &(), |k| taken.fetch_add(k, Ordering::Relaxed));
                    task.stop();
                })
            })
        }));
        assert!(stopped.is_err());
        assert!(taken.into_inner() < 3000);
        assert!(catch_unwind(|| task.run(checkpoint)).is_err());
        checkpoint();
        assert_eq!(Arc::new(Task::default()).run(|| map(3, &(), |k| k)), [0, 1, 2]);
    }
}
