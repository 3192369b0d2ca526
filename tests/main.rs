//! Every test of the runtime but those of other features and the properties, in one binary: to
//! link each file by itself takes longer than the tests do.

mod blobs;
mod invariants;
mod reading;
mod wire_files;

mod baked_maps;
mod coefficients;
mod color;
mod corrupted;
mod format_support;
mod formats;
mod formulas;
mod found;
mod golden_file;
mod graphics;
mod highlights;
mod integer_color;
mod integer_highlights;
mod integer_lights;
mod kernels;
mod matcap;
mod packed_objects;
mod palettes;
mod paper;
mod parts;
mod polynomials;
mod quantized;
mod reading_scenes;
mod readme;
mod runtime;
mod shadowed_files;
mod shadowed_objects;
mod sources;
mod textured_objects;
mod truncation;
mod truncation_sets;
mod turned_lights;
mod windows;
mod wire;

use eigenshade_testing::{oracle, tolerances};
