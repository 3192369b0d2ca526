//! Every test of the generator but one that weighs its process, in one binary: to link each file
//! by itself takes longer than the tests do.

#[path = "../../../tests/every_file/mod.rs"]
mod every_file;
#[path = "../../../tests/tolerances/mod.rs"]
mod tolerances;

mod any_object;
mod brdf;
mod build;
mod environment_maps;
mod light_csv;
mod material_fits;
mod measurements;
mod merl;
mod reference_values;
mod rotation;
mod scattering;
mod visible_facets;
mod weights;

#[test]
fn every_file_is_compiled() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests");
    let left_out = every_file::left_out(folder, include_str!("main.rs"), &["png_memory"]);
    assert!(left_out.is_empty(), "no binary has {left_out:?}");
}
