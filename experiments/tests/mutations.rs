//! The list of mutations belongs to the sources as they are. Whether tests notice the mutations,
//! `experiments mutations` finds out.

use eigenshade_model::error::Error;
use experiments::mutations::{read, switched};
use std::path::Path;

#[test]
fn each_mutation_has_its_place_in_the_sources() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mutations = read(&root.join("tests/mutations.csv")).expect("a list");
    let text = |file: &str| {
        let path = root.join(file);
        std::fs::read_to_string(&path).map_err(|error| Error::io(&path, &error))
    };
    let files = switched(&mutations, text).expect("the expressions of the list");
    let switches = files.values().map(|text| text.matches("(if crate::mutated(").count());
    assert_eq!(switches.sum::<usize>(), mutations.len());
    assert!(mutations.iter().all(|mutation| mutation.original != mutation.mutated));
    let stated = format!("lists {} small defects", mutations.len());
    assert!(include_str!("../../CONTRIBUTING.md").contains(&stated), "{stated}");
}
