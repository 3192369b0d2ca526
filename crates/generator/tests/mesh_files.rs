//! Mesh files of every spelling: comments, line ends, polygons of any shape, and files cut short.

use eigenshade_generator::object::mesh;
use eigenshade_model::error::Result;

/// Areas of a few facets: the same products, in another order.
const AREA: f64 = 1e-14;

/// Normals and visible areas of the facets in a file of this text.
fn read(name: &str, text: &str) -> Result<Vec<([f64; 3], f64)>> {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join(name);
    std::fs::write(&path, text).expect("a file");
    mesh::read(path)
}

#[test]
fn comments_end_with_their_line() {
    let plain = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let expected = read("plain.obj", plain).expect("a mesh");
    assert_eq!(expected.len(), 1);
    for text in [
        &format!("# saved in C:\\models\\\n{plain}"),
        &plain.replace("1 2 3", "1 2 3 # top"),
        &plain.replace("1 2 3", "1 2 3# top \\"),
        &plain.replace("1 2 3", "1 \\\n2 \\\n3 # top"),
        &plain.replace("v 1 0 0", "v 1 0 0 # right"),
    ] {
        assert_eq!(read("with.obj", text).as_ref(), Ok(&expected), "{text}");
    }
}

#[test]
fn lines_end_in_any_way() {
    let text = "# a corner\nv 0 0 0\nv 1 0 0\n\nv 0 1 \\\n0\nf 1 2 3\n";
    let expected = read("plain.obj", text).expect("a mesh");
    assert_eq!(expected.len(), 1);
    for end in ["\r", "\r\n"] {
        let text = text.replace('\n', end);
        assert_eq!(read("with.obj", &text).as_ref(), Ok(&expected), "{end:?}");
        // Blank lines count, so that messages name the line that an editor shows.
        let wrong = text.replace("f 1 2 3", "f 1 2 4");
        let error = read("wrong.obj", &wrong).expect_err("no such corner").to_string();
        assert!(error.contains("line 7"), "{end:?}: {error}");
    }
    // Longer than the buffer of a reader.
    let long = format!("#{}\r\n{text}", "-".repeat(20_000));
    assert_eq!(read("long.obj", &long).as_ref(), Ok(&expected));
}
