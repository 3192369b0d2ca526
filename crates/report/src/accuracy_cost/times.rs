//! Times of operations on this machine, in the same run as the nine-term formula.

use super::images::{Numbers, Pair, Work};
use super::numbers::numbers;
use super::settings::Setting;
use crate::numbers::median;
use eigenshade_model::error::Result;
use eigenshade_table::Table;
use eigenshade_testing::fixtures::spiral;
use std::time::Instant;

/// Pixels per run.
pub const PIXELS: usize = 4096;
/// The least duration of a timing in seconds; shorter operations are repeated.
const SHORTEST: f64 = 3e-5;

/// A setting ready to be timed on one image.
pub struct Case {
    numbers: Box<dyn Numbers>,
    pair: Pair,
    /// Buffer for the lengths of a scene within a tolerance.
    lengths: Vec<u16>,
}

impl Case {
    pub fn new(setting: &Setting, table: &Table, pair: &Pair) -> Result<Self> {
        let numbers = numbers(setting, table, &hemisphere(PIXELS))?;
        let lengths = vec![0; setting.recipe.degree + 1];
        Ok(Self { numbers, pair: pair.clone(), lengths })
    }

    /// All pixels, and a new light.
    pub fn works(&mut self) -> Result<[Work<'_>; 2]> {
        self.numbers.works(&self.pair, &mut self.lengths)
    }
}

/// The median nanoseconds of a pixel and of a new light over interleaved rounds.
pub fn costs(works: Vec<[Work<'_>; 2]>, rounds: usize) -> Vec<[f64; 2]> {
    let times = interleaved(works.into_iter().flatten().collect(), rounds);
    let medians: Vec<f64> = times.iter().map(|times| median(times)).collect();
    medians.chunks_exact(2).map(|pair| [pair[0] / PIXELS as f64, pair[1]]).collect()
}

/// Nanoseconds of each work in each round. The works run one after the other, so that a temporary
/// slowdown of the machine affects all of them. Each first runs untimed, because the others have
/// replaced the contents of the cache.
fn interleaved(works: Vec<Work<'_>>, rounds: usize) -> Vec<Vec<f64>> {
    let timed = |work: &mut Work<'_>, repeats: u32| {
        let start = Instant::now();
        (0..repeats).for_each(|_| work());
        start.elapsed().as_secs_f64() / f64::from(repeats)
    };
    let mut works: Vec<_> = works
        .into_iter()
        .map(|mut work| {
            work();
            let once = timed(&mut work, 1).max(1e-9);
            let repeats = (SHORTEST / once).ceil().clamp(1.0, 1e4) as u32;
            (work, repeats, Vec::new())
        })
        .collect();
    for _ in 0..rounds {
        for (work, repeats, times) in &mut works {
            work();
            times.push(1e9 * timed(work, *repeats));
        }
    }
    works.into_iter().map(|(_, _, times)| times).collect()
}

/// Normals spread over the visible hemisphere.
pub fn hemisphere(count: usize) -> Vec<[f64; 3]> {
    spiral((0..count).map(|k| (k as f64 + 0.5) / count as f64))
}
