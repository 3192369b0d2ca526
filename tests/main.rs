//! Every test of the runtime but those of other features and the properties, in one binary: to
//! link each file by itself takes longer than the tests do.

mod ablation;
mod every_file;
mod float_errors;
mod golden;
mod images;
mod invariants;
mod oracle;
mod reading;
mod shipped;
mod stability;
mod tolerances;
mod wire_files;

mod ablation_page;
mod baked;
mod economy;
mod economy_fewest;
mod economy_floor;
mod economy_sets;
mod estimate;
mod format_support;
mod formats;
mod formats_any;
mod found;
mod golden_file;
mod hard_cases;
mod high_degree;
mod kernels;
mod lookup;
mod nine_terms;
mod paper;
mod parts;
mod polynomials;
mod quantised;
mod reading_objects;
mod reading_scenes;
mod reading_spheres;
mod rotation;
mod runtime;
mod trim;
mod window;
mod wire;
mod wire_versions;

use stability::glossy;

#[test]
fn every_file_is_compiled() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests");
    let left_out = every_file::left_out(
        folder,
        include_str!("main.rs"),
        &["generated", "mathematics", "mint"],
    );
    assert!(left_out.is_empty(), "no binary has {left_out:?}");
}
