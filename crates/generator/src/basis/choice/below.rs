//! What the first components leave.

use crate::basis::choice::Share;

/// Energies that the first components leave.
pub(crate) struct Below {
    /// By their number, from the least that there can be.
    left: Vec<f64>,
    /// The least: the constant is always kept.
    first: usize,
}

impl Below {
    /// Of a spectrum, and of the energy that a cut-off drops.
    pub(crate) fn new(spectrum: &[(Option<i32>, Option<f64>)], dropped: f64) -> Self {
        let first = usize::from(spectrum.first().is_some_and(|(_, value)| value.is_none()));
        let values: Vec<f64> = spectrum.iter().filter_map(|(_, value)| *value).collect();
        // From the small end, so that nothing small is lost.
        let mut left = vec![dropped];
        for value in values.iter().rev() {
            left.push(left.last().copied().unwrap_or(0.0) + value);
        }
        left.reverse();
        Self { left, first }
    }

    /// The least number that leaves at most `allowed`, or all.
    pub(crate) fn least(&self, allowed: f64) -> usize {
        let last = self.left.len() - 1;
        self.first + self.left.iter().position(|left| *left <= allowed).unwrap_or(last)
    }

    /// What `count` components leave, of numbers that there can be.
    pub(super) fn left(&self, count: usize) -> f64 {
        self.left[count - self.first]
    }

    /// `count` components of all, energies as `share` has them.
    pub(super) fn share(&self, count: usize, share: impl Fn(f64) -> f64) -> Share {
        Share {
            kept: count,
            of: self.first + self.left.len() - 1,
            leaves: share(self.left(count)),
            one_less: (count > self.first).then(|| share(self.left(count - 1))),
        }
    }
}
