//! Independent work distributed over all cores.

use indicatif::ProgressBar;
use rayon::iter::{IntoParallelIterator, ParallelIterator};

/// Computes f(k) for k = 0..count, in order, and advances `progress` after each. The results do not
/// depend on the number of threads, which `RAYON_NUM_THREADS` sets.
pub fn map<T: Send>(count: usize, progress: &ProgressBar, f: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let one = |k| {
        let value = f(k);
        progress.inc(1);
        value
    };
    (0..count).into_par_iter().map(one).collect()
}

#[cfg(test)]
mod tests {
    #[test]
    fn answers_come_in_order() {
        let progress = indicatif::ProgressBar::hidden();
        for count in [0, 1, 15, 16, 17, 1000] {
            let squares = super::map(count, &progress, |k| k * k);
            assert!(squares.iter().copied().eq((0..count).map(|k| k * k)));
        }
    }
}
