//! Times of several ways, run in turn, so that what disturbs one disturbs all.

use std::time::Instant;

/// Seconds that one measurement takes, if one call does not take longer: so short that where
/// other programs run few measurements are interrupted, and the median is of none.
const MEASUREMENT: f64 = 3e-4;

/// One way to do a thing; it is told the round.
pub struct Way<'a>(Box<dyn FnMut(usize) + 'a>);

impl<'a> Way<'a> {
    pub fn new(run: impl FnMut(usize) + 'a) -> Self {
        Self(Box::new(run))
    }

    /// Seconds of `calls` together.
    fn seconds(&mut self, calls: usize, round: usize) -> f64 {
        let start = Instant::now();
        for _ in 0..calls {
            (self.0)(round);
        }
        start.elapsed().as_secs_f64()
    }

    /// How many calls make a measurement.
    fn calls(&mut self) -> usize {
        let mut calls = 1;
        while self.seconds(calls, 0) < MEASUREMENT {
            calls *= 2;
        }
        calls
    }
}

/// What each way takes, in calls of the first: the median over the rounds of what each gives.
pub fn ratios(rounds: usize, ways: &mut [Way<'_>]) -> Vec<f64> {
    let calls: Vec<usize> = ways.iter_mut().map(Way::calls).collect();
    let mut seconds = vec![Vec::with_capacity(rounds); ways.len()];
    for round in 0..rounds {
        for ((way, &calls), seconds) in ways.iter_mut().zip(&calls).zip(&mut seconds) {
            // What it reads is near from the first call on.
            way.seconds(1, round);
            seconds.push(way.seconds(calls, round) / calls as f64);
        }
    }
    let first = seconds[0].clone();
    let ratio = |of: Vec<f64>| median(of.iter().zip(&first).map(|(one, first)| one / first));
    seconds.into_iter().map(ratio).collect()
}

/// The middle of some numbers, the upper of two.
pub fn median(numbers: impl Iterator<Item = f64>) -> f64 {
    let mut numbers: Vec<f64> = numbers.collect();
    numbers.sort_by(f64::total_cmp);
    numbers[numbers.len() / 2]
}

/// The middle and the largest of some errors.
pub fn median_and_worst(errors: &[f64]) -> [Option<f64>; 2] {
    let worst = errors.iter().fold(0.0, |most: f64, &error| most.max(error));
    [Some(median(errors.iter().copied())), Some(worst)]
}
