//! Measurements for the documentation of eigenshade: CSV files, plots, and the generated parts of
//! its pages.
#![expect(missing_docs, reason = "no package depends on it")]

pub use eigenshade_testing::tolerances;

pub mod numbers;

pub mod sheet;

pub mod chart;

pub mod pages;

pub mod figures;

pub mod multiplications;

pub use eigenshade_sources::{light_tree, mirrored, sphere, texels};

pub mod reference;

pub mod paper;

pub mod accuracy_cost;

pub mod highlights;

pub mod material_errors;

pub mod ablation;

pub mod stability;

pub mod reading;

pub mod mutations;
