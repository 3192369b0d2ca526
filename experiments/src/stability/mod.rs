//! The numerically hard cases: how the naive method fails, what this project does instead, and its
//! error measured against an oracle.
//!
//! Every bound is asserted in a test; `experiments stability` writes the figures to
//! `docs/stability.md`.

pub mod databases;
pub mod edges;
pub mod exact_rank;
pub mod facets;
pub mod flat;
pub mod high_degree;
pub mod page;
pub mod rotations;
pub mod scales;
pub mod singular;
pub mod special;
pub mod spectra;
pub mod subnormal;
pub mod summation;
pub mod sun;
pub mod user_inputs;

/// A measured number and its bound.
#[derive(Clone, Debug)]
pub struct Figure {
    /// What was measured.
    pub what: String,
    /// The measured number.
    pub found: f64,
    /// Its bound.
    pub bound: Bound,
}

/// The bound of a figure.
#[derive(Clone, Copy, Debug)]
pub enum Bound {
    /// For our method: the error is at most this.
    Most(f64),
    /// For the naive method: the error is at least this; otherwise the case is not hard.
    Least(f64),
    /// For a count: exactly this number.
    Exactly(f64),
    /// No bound: a ratio of times, which depends on the host.
    Told,
}

impl Figure {
    /// An error with an upper bound.
    pub fn most(what: impl Into<String>, found: f64, bound: f64) -> Self {
        Self { what: what.into(), found: found.abs(), bound: Bound::Most(bound) }
    }

    /// An error of the naive way.
    pub fn least(what: impl Into<String>, found: f64, bound: f64) -> Self {
        Self { what: what.into(), found, bound: Bound::Least(bound) }
    }

    /// A count.
    pub fn exactly(what: impl Into<String>, found: usize, bound: usize) -> Self {
        Self { what: what.into(), found: found as f64, bound: Bound::Exactly(bound as f64) }
    }

    /// A ratio of times.
    pub fn told(what: impl Into<String>, found: f64) -> Self {
        Self { what: what.into(), found, bound: Bound::Told }
    }

    /// Whether the figure is within its bound; false for NaN.
    pub fn holds(&self) -> bool {
        match self.bound {
            Bound::Most(bound) => self.found <= bound,
            Bound::Least(bound) => self.found >= bound,
            Bound::Exactly(bound) => self.found == bound,
            Bound::Told => self.found > 0.0,
        }
    }
}

/// A line of `docs/stability.md`.
pub struct Case {
    /// The difficulty.
    pub name: &'static str,
    /// How the naive method fails.
    pub naively: &'static str,
    /// What this project does instead.
    pub here: &'static str,
    /// Measures the figures.
    pub measure: fn() -> Vec<Figure>,
}

/// All cases, in the order of the document.
pub const CASES: &[Case] = &[
    special::FUNCTIONS,
    rotations::COMPOSITION,
    rotations::TOGETHER,
    high_degree::CASE,
    singular::ROOT,
    singular::RANKS,
    singular::MORE_THAN_RANK,
    spectra::SAME_ORDER,
    spectra::NEARLY_EQUAL,
    edges::POLE_AND_RIM,
    databases::FEW,
    databases::ALIKE,
    databases::ZEROS,
    databases::PLAIN,
    databases::RANK_ONE,
    sun::TEXEL,
    sun::SIZES,
    flat::FLAT,
    flat::WEIGHTS,
    facets::DEGENERATE,
    scales::DOUBLE,
    scales::SINGLE,
    subnormal::TINY,
    summation::MILLION,
    user_inputs::EIGHT_BITS,
    user_inputs::BEHIND,
    user_inputs::SUN,
    user_inputs::DELTA,
    user_inputs::DRIFT,
    user_inputs::ALMOST,
    user_inputs::FULL_WEIGHT,
];
