//! Independent work distributed over all cores.

use crate::task::Steps;
use rayon::iter::{IntoParallelIterator, ParallelIterator};

/// Counts finished steps.
pub trait Progress: Sync {
    /// One more step is finished.
    fn advance(&self);
}

/// Counts nothing.
impl Progress for () {
    fn advance(&self) {}
}

#[cfg(feature = "indicatif")]
impl Progress for indicatif::ProgressBar {
    fn advance(&self) {
        self.inc(1);
    }
}

/// Computes f(k) for k = 0..count, in order, and advances `progress` after each. The results do not
/// depend on the number of threads, which `RAYON_NUM_THREADS` sets.
///
/// # Panics
///
/// If f does. In a [`Task`](crate::task::Task) that is stopped it unwinds before the next f(k).
pub fn map<T: Send>(
    count: usize,
    progress: &impl Progress,
    f: impl Fn(usize) -> T + Sync,
) -> Vec<T> {
    let steps = Steps::new(count);
    let one = |k| {
        let value = f(k);
        progress.advance();
        value
    };
    let in_thread = |_: &mut _, k| steps.take(|| one(k));
    (0..count).into_par_iter().map_init(|| steps.enter(), in_thread).collect()
}

/// The number of threads that [`map`] uses here.
#[must_use]
pub fn threads() -> usize {
    rayon::current_num_threads()
}

#[cfg(test)]
mod tests {
    #[test]
    fn answers_come_in_order() {
        for count in [0, 1, 15, 16, 17, 1000] {
            let squares = super::map(count, &(), |k| k * k);
            assert!(squares.iter().copied().eq((0..count).map(|k| k * k)));
        }
    }
}
