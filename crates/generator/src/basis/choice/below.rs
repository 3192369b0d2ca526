//! The energy that remains after the first components.

use crate::basis::choice::Share;

/// Energies that remain after the first components.
pub(crate) struct Below {
    /// Remaining energy by number of components, starting at the smallest possible number.
    left: Vec<f64>,
    /// The smallest possible number of components: the constant is always kept.
    first: usize,
}

impl Below {
    /// Computes the remaining energies of a spectrum and of the energy that a cut-off drops.
    pub(crate) fn new(spectrum: &[(Option<i32>, Option<f64>)], dropped: f64) -> Self {
        let first = usize::from(spectrum.first().is_some_and(|(_, value)| value.is_none()));
        let values: Vec<f64> = spectrum.iter().filter_map(|(_, value)| *value).collect();
        // Sum from the smallest value, so that small values are not lost.
        let mut left = vec![dropped];
        for value in values.iter().rev() {
            left.push(left.last().copied().unwrap_or(0.0) + value);
        }
        left.reverse();
        Self { left, first }
    }

    /// The smallest number of components that leaves at most `allowed`, or all of them.
    pub(crate) fn least(&self, allowed: f64) -> usize {
        let last = self.left.len() - 1;
        self.first + self.left.iter().position(|left| *left <= allowed).unwrap_or(last)
    }

    /// The energy that remains after `count` components. Domain: a possible number of components.
    pub(super) fn left(&self, count: usize) -> f64 {
        self.left[count - self.first]
    }

    /// The share of `count` components in all; `share` converts energies.
    pub(super) fn share(&self, count: usize, share: impl Fn(f64) -> f64) -> Share {
        Share {
            kept: count,
            of: self.first + self.left.len() - 1,
            leaves: share(self.left(count)),
            one_less: (count > self.first).then(|| share(self.left(count - 1))),
        }
    }
}
