//! Measurements for the documentation of eigenshade: CSV files, plots, and parts of pages.
#![expect(missing_docs, reason = "no package depends on it")]

pub use eigenshade_shading::sources::{light_tree, mirrored, sphere, texels};
pub use eigenshade_testing::tolerances;

pub mod accuracy_cost;
pub mod chart;
pub mod figures;
pub mod highlights;
pub mod material_errors;
pub mod numbers;
pub mod objects;
pub mod pages;
pub mod palette_errors;
pub mod paper;
pub mod reading;
pub mod reference;
pub mod roughness_weights;
pub mod shadow_lights;
pub mod shadow_shapes;
pub mod shadow_table;
pub mod shadows;
pub mod sheet;
pub mod stability;
