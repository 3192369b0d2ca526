//! The ablation: the cost of the ten scenes of `firmware/scenes`, each of which adds an effect or a
//! requirement to the previous one, and the contribution of each effect.
//!
//! `experiments ablation` writes the generated parts of `docs/ablation.md`.

pub mod beside;
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
pub mod shares;
pub mod speed;
