//! What accuracy costs: every knob turned, its error and its price.

pub mod setting;

pub mod knobs;

pub mod materials;

pub mod bases;

pub mod images;

pub mod nine_terms;

pub mod shading;

pub mod method;

pub mod sizes;

pub mod times;

pub mod model;

pub mod machine;

pub mod boards;

pub mod wasm;

pub mod points;

pub mod front;

pub mod sheet;

/// What makes the files; each says so in its first line.
pub const COMMAND: &str = "eigenshade accuracy-cost";
