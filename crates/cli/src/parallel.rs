//! Independent work on every core.

use indicatif::ProgressBar;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// Numbers that a thread takes at a time.
const SHARE: usize = 16;

/// f(k) for k = 0..count, in order; `progress` hears of each.
pub fn map<T: Send>(count: usize, progress: &ProgressBar, f: impl Fn(usize) -> T + Sync) -> Vec<T> {
    shared(SHARE, count, progress, f)
}

/// [`map`] of few long works: a thread takes one at a time.
pub fn map_each<T: Send>(
    count: usize,
    progress: &ProgressBar,
    f: impl Fn(usize) -> T + Sync,
) -> Vec<T> {
    shared(1, count, progress, f)
}

fn shared<T: Send>(
    share: usize,
    count: usize,
    progress: &ProgressBar,
    f: impl Fn(usize) -> T + Sync,
) -> Vec<T> {
    let next = AtomicUsize::new(0);
    let work = || {
        let mut done = Vec::new();
        loop {
            let start = next.fetch_add(share, Ordering::Relaxed);
            let share = start..count.min(start.saturating_add(share));
            if share.is_empty() {
                return done;
            }
            let taken = share.len();
            done.push((start, share.map(&f).collect::<Vec<T>>()));
            progress.inc(taken as u64);
        }
    };
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let mut parts: Vec<(usize, Vec<T>)> = thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        let joined = workers.into_iter().map(|worker| match worker.join() {
            Ok(done) => done,
            Err(panic) => std::panic::resume_unwind(panic),
        });
        joined.flatten().collect()
    });
    parts.sort_by_key(|(start, _)| *start);
    parts.into_iter().flat_map(|(_, values)| values).collect()
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
