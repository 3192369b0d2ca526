//! The fuzz targets of the runtime. The environment variable `TARGET` chooses one of [`TARGETS`].
#![cfg_attr(fuzzing, no_main)]

#[path = "../../tests/invariants/mod.rs"]
mod invariants;

use std::env::var;
use std::sync::OnceLock;

type Target = fn(&[u8]);

/// * `shade_any`: any light, material, normals, transfer and coefficients. f32 stays finite, and
///   integers stay in range and never wrap.
/// * `public_interface`: look-ups, baking, rotations, windows, truncation, estimates and drawing with
///   any numbers. No panic, and further invariants for moderate numbers.
/// * `project_reconstruct`: projection and reconstruction in every format are close to the results
///   in f64.
/// * `from_bytes`: any bytes as a table give an error, or a basis that projects and shades.
/// * `packed_object`: objects are drawn as pixel by pixel; changed bytes give an error or an object.
/// * `shadowed_object`: objects with shadows of any numbers, with and without base colors, have a color
///   for each code and are drawn as pixel by pixel; changed bytes give an error or an object.
const TARGETS: [(&str, Target); 6] = [
    ("shade_any", invariants::shade_any),
    ("public_interface", invariants::public_interface),
    ("project_reconstruct", invariants::project_reconstruct),
    ("from_bytes", invariants::from_bytes),
    ("packed_object", invariants::packed_object),
    ("shadowed_object", invariants::shadowed_object),
];

fn target() -> Target {
    static TARGET: OnceLock<Target> = OnceLock::new();
    *TARGET.get_or_init(|| {
        let name = var("TARGET").unwrap_or_default();
        let found = TARGETS.into_iter().find(|(target, _)| *target == name);
        let names = TARGETS.map(|(target, _)| target).join(", ");
        found.unwrap_or_else(|| panic!("TARGET is `{name}`; set it to one of {names}")).1
    })
}

#[cfg(fuzzing)]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| target()(bytes));

/// Without libFuzzer: runs on the files that the arguments name.
#[cfg(not(fuzzing))]
fn main() -> std::io::Result<()> {
    for path in std::env::args_os().skip(1) {
        target()(&std::fs::read(path)?);
    }
    Ok(())
}
