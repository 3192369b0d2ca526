//! The hard cases: what goes wrong naively, what is done about it, and how far off
//! the answer is, measured against an oracle.
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

/// One measured number and what it has to keep to.
#[derive(Clone, Debug)]
pub struct Figure {
    /// What was measured.
    pub what: String,
    /// The number.
    pub found: f64,
    /// What it may be.
    pub bound: Bound,
}

/// What a figure has to keep to.
#[derive(Clone, Copy, Debug)]
pub enum Bound {
    /// Ours: an error of no more than this.
    Most(f64),
    /// The naive way's: an error of this at least, or the case is none.
    Least(f64),
    /// A count.
    Exactly(f64),
    /// None: a ratio of times, which hosts decide.
    Told,
}

impl Figure {
    /// An error that may be no larger.
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

    /// Whether it keeps to it; a NaN keeps to nothing.
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
    /// What is hard.
    pub name: &'static str,
    /// What goes wrong naively.
    pub naively: &'static str,
    /// What is done here.
    pub here: &'static str,
    /// Measures.
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
