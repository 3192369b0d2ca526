//! `basis --check` knows its own tables, and others from them.

use crate::support::{Folder, assert_fails, scene};
use eigenshade_table::{General, MeanImage, Table, decode, encode};
use std::fs;

/// A table, changed.
fn altered(change: impl FnOnce(&mut Table)) -> Folder {
    let folder = Folder::with_table();
    let mut table = decode(&fs::read(folder.path("b.bin")).unwrap()).unwrap();
    change(&mut table);
    folder.write("b.bin", encode(&table));
    folder
}

fn assert_differs(folder: &Folder, what: &str) {
    let arguments = "basis --scene scene.toml --check b.bin";
    assert_fails(
        folder,
        arguments,
        &["b.bin", what, "eigenshade basis --scene scene.toml --out b.bin"],
    );
    let text = String::from_utf8(folder.run(arguments).stdout).unwrap();
    assert!(text.lines().any(|line| line.starts_with(what) && line.ends_with("OVER")), "{text}");
}

#[test]
fn what_was_just_made_passes() {
    for criterion in ["image-centered", "standard"] {
        let folder = Folder::new();
        folder.write("scene.toml", scene(criterion, 30, "[]"));
        folder.ok("basis --scene scene.toml --out b.bin");
        let text = folder.ok("basis --scene scene.toml --check b.bin");
        assert_eq!(text.lines().count(), 9, "{text}");
        assert!(!text.contains("OVER"), "{text}");
    }
}

#[test]
fn an_altered_eigenvalue_is_found() {
    let folder = altered(|table| {
        let value = table.components[3].eigenvalue.as_mut().unwrap();
        *value *= 1.0 + 1e-6;
    });
    assert_differs(&folder, "components' eigenvalues");
    let folder = altered(|table| *table.spectrum[3].1.as_mut().unwrap() *= 1.0 + 1e-6);
    assert_differs(&folder, "spectrum");
}

#[test]
fn altered_profiles_are_found() {
    let folder = altered(|table| table.profiles[0].node_values[5] += 1e-6);
    assert_differs(&folder, "profiles at the nodes");
    let folder = altered(|table| table.profiles[1].chebyshev[0] += 1e-6);
    assert_differs(&folder, "polynomials");
    let folder = altered(|table| table.profiles[1].factors[0] += 1e-6);
    assert_differs(&folder, "rows of U^T M");
    let folder = altered(|table| table.profiles[0].modes[0] += 1e-6);
    assert_differs(&folder, "images A U");
    let folder = altered(|table| table.gram.root_weights[2] += 1e-6);
    assert_differs(&folder, "mode means e");
}

/// A polynomial cut elsewhere is compared as closely as one that is not.
#[test]
fn polynomials_of_other_lengths_are_compared_term_by_term() {
    let folder = altered(|table| table.profiles[1].chebyshev.push(1e-14));
    folder.ok("basis --scene scene.toml --check b.bin");
    let folder = altered(|table| table.profiles[1].chebyshev.push(1e-6));
    assert_differs(&folder, "terms of one alone");
    let folder = altered(|table| {
        table.profiles[1].chebyshev.push(0.0);
        table.profiles[1].chebyshev[0] += 1e-7;
    });
    assert_differs(&folder, "polynomials");
    let folder = altered(|table| table.profiles[1].chebyshev.truncate(2));
    assert_differs(&folder, "terms of one alone");
}

#[test]
fn altered_means_are_found() {
    let altered = |change: fn(&mut MeanImage), what| {
        let folder = Folder::new();
        folder.write("scene.toml", scene("standard", 30, "[]"));
        folder.ok("basis --scene scene.toml --out b.bin");
        let mut table = decode(&fs::read(folder.path("b.bin")).unwrap()).unwrap();
        change(table.mean.as_mut().unwrap());
        folder.write("b.bin", encode(&table));
        assert_differs(&folder, what);
    };
    altered(|mean| mean.chebyshev[1] += 1e-6, "polynomials");
    altered(|mean| mean.coefficients[0] += 1e-6, "coefficients of the mean");
}

#[test]
fn another_scene_is_told() {
    let folder = Folder::with_table();
    folder.write("scene.toml", scene("image-centered", 9, "[]"));
    let arguments = "basis --scene scene.toml --check b.bin";
    assert_fails(&folder, arguments, &["b.bin", "another scene"]);
}

/// A table of an object: its eigenimages, their modes and what projects.
#[test]
fn an_object_whose_eigenimages_are_moved() {
    for (change, what) in [
        (|one: &mut General| one.synthesis[3] += 0.1, "eigenimages drawn"),
        (|one: &mut General| one.synthesis[3] += 0.1, "d of the eigenimages"),
        (|one: &mut General| one.modes[3] += 0.1, "d of their modes"),
        (|one: &mut General| one.projection[3] += 0.1, "rows of U^T M"),
    ] as [(fn(&mut General), &str); 4]
    {
        let folder = Folder::new();
        let scene = scene("image-centered", 12, "[]").replace("\"any\"", "\"vertical\"");
        folder.write("scene.toml", scene);
        folder.ok("basis --scene scene.toml --out b.bin");
        folder.ok("basis --scene scene.toml --check b.bin");
        let mut table = decode(&fs::read(folder.path("b.bin")).unwrap()).unwrap();
        change(table.general.as_mut().unwrap());
        folder.write("b.bin", encode(&table));
        assert_differs(&folder, what);
    }
}
