//! The ablation: ten scenes of `firmware/scenes`, each of which adds an effect or a demand to
//! the one before, what each costs, and what each effect is worth.
//!
//! `tests/ablation_page.rs` asserts what `docs/ablation.md` says; the example `ablation` writes it.
#![allow(dead_code, reason = "the test and the example take different parts")]

pub mod cells;
pub mod changes;
pub mod compare;
pub mod counts;
pub mod errors;
pub mod nine_terms;
pub mod page;
pub mod pictures;
pub mod savings;
pub mod scenes;
pub mod sentences;
pub mod shares;
pub mod speed;

pub(crate) use crate::tolerances;
