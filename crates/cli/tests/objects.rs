//! Objects other than the sphere: their files and their pictures.

use crate::support::files::{ellipsoid, gray_png, obj, ply, square_png, stl};
use crate::support::{Folder, assert_fails};
use png::{BitDepth, ColorType};

/// Draws the object in a file to `p.png`.
fn drawing(name: &str) -> String {
    format!(
        "render --light lobby --material chrome --sources 0 --size 48 --normals {name} --out p.png"
    )
}

/// The picture of an object.
fn drawn(name: &str, bytes: &[u8]) -> Vec<u8> {
    let folder = Folder::new();
    folder.write(name, bytes);
    folder.ok(&drawing(name));
    folder.bytes("p.png")
}

#[test]
fn a_mesh_is_the_same_from_every_file() {
    assert!(drawn("m.obj", obj().as_bytes()) == drawn("m.ply", ply().as_bytes()));
}

/// Texts in upper or lower case, after blanks, of several solids; binary files that begin with
/// `solid`.
#[test]
fn kinds_of_stl() {
    let (corners, triangles) = ellipsoid();
    let facet = |[a, b, c]: &[usize; 3]| {
        let corner = |k: &usize| corners[*k].map(|x| format!("{x:e}")).join(" ");
        let [a, b, c] = [a, b, c].map(corner);
        format!(
            " facet normal 0 0 0\n  outer loop\n   vertex {a}\n   vertex {b}\n   vertex {c}\n  \
             endloop\n endfacet\n"
        )
    };
    let solid = |name: &str, triangles: &[[usize; 3]]| {
        let facets: String = triangles.iter().map(facet).collect();
        format!("solid {name}\n{facets}endsolid {name}\n")
    };
    let text = solid("egg", &triangles);
    let halves = triangles.split_at(1000);
    let mut binary = stl();
    let expected = drawn("m.stl", &binary);
    binary[..80].fill(b' ');
    binary[..10].copy_from_slice(b"solid egg\n");
    let mut longer = binary.clone();
    longer.extend(b"made by hand");
    let mut upper = binary.clone();
    upper[..5].copy_from_slice(b"SOLID");
    for (name, bytes) in [
        ("text", text.clone().into_bytes()),
        ("upper case", text.to_uppercase().into_bytes()),
        ("after blanks", format!("\u{feff}\n \t{text}\n\n").into_bytes()),
        ("nameless", text.replace(" egg", "").into_bytes()),
        ("Windows line ends", text.replace('\n', "\r\n").into_bytes()),
        ("two solids", (solid("a b", halves.0) + &solid("c", halves.1)).into_bytes()),
        ("not UTF-8", [&b"solid \xe9\n"[..], &text.as_bytes()[10..]].concat()),
        ("binary solid", binary.clone()),
        ("binary SOLID", upper),
        ("bytes after the last facet", longer),
    ] {
        assert!(drawn("m.stl", &bytes) == expected, "{name}");
    }
    let folder = Folder::new();
    for (bytes, fragments) in [
        (text.as_bytes()[..text.len() / 2].to_vec(), "endsolid"),
        (text.replacen("vertex", "corner", 1).into_bytes(), "corner"),
        (text.replacen("vertex", "vertex nan", 1).into_bytes(), "vertex"),
        (b"solid".to_vec(), "endsolid"),
        (b"solid\nendsolid\n".to_vec(), "no triangle"),
        (binary[..5000].to_vec(), "promise"),
    ] {
        folder.write("m.stl", bytes);
        assert_fails(&folder, &drawing("m.stl"), &["m.stl", fragments]);
    }
}

/// `render` and `read` agree on which pixels of a normal map are errors.
#[test]
fn normal_maps_have_one_rule() {
    let folder = Folder::with_table();
    let size = 8usize;
    let mut mask = [255; 64];
    mask[0] = 0;
    folder.write("mask.png", gray_png(8, 8, &mask));
    folder.write("image.png", gray_png(8, 8, &[128; 64]));
    let read = "read image.png --normals n.png --table b.bin --components 2 --out new.csv";
    // Pixel 0, 0 is of this kind, all others normals over the disc.
    let map = |first: [f64; 4]| {
        let mut samples = first.to_vec();
        for k in 1..size * size {
            let [x, y] = [k % size, k / size].map(|k| (k as f64 - 3.5) / 8.0);
            let z = (1.0 - x * x - y * y).sqrt();
            samples.extend([0.5 + 0.5 * x, 0.5 - 0.5 * y, 0.5 + 0.5 * z, 1.0]);
        }
        square_png(size, ColorType::Rgba, BitDepth::Eight, &samples)
    };
    // The number of pixels without a normal, according to `read`.
    let without = || -> usize {
        let message = folder.messages(read);
        std::fs::remove_file(folder.path("new.csv")).expect("an answer");
        let report = message.split("left out: ").nth(1).and_then(|rest| rest.split(' ').next());
        report.and_then(|count| count.parse().ok()).expect("a count")
    };
    for (name, first, expected) in [
        ("a normal", [0.5, 0.5, 1.0, 1.0], 0),
        ("half opaque", [0.5, 0.5, 1.0, 0.503], 0),
        ("less than half", [0.5, 0.5, 1.0, 0.497], 1),
        ("transparent and away", [0.5, 0.5, 0.0, 0.0], 1),
        ("gray", [0.5, 0.5, 0.5, 1.0], 1),
        ("black", [0.0, 0.0, 0.0, 1.0], 1),
        ("white", [1.0, 1.0, 1.0, 1.0], 1),
        ("filtered to 0.6", [0.5, 0.5, 0.8, 1.0], 0),
        ("short, 0.4", [0.5, 0.5, 0.7, 1.0], 1),
        ("short and away", [0.5, 0.5, 0.3, 1.0], 1),
        ("on the rim", [1.0, 0.5, 0.498, 1.0], 0),
    ] {
        folder.write("n.png", map(first));
        assert_eq!(without(), expected, "{name}");
    }
    folder.write("n.png", map([0.7, 0.5, 0.1, 1.0]));
    let render = "render --light lobby --material chrome --normals n.png --out new.png";
    for command in [render, read] {
        assert_fails(&folder, command, &["n.png", "pixel 0, 0", "away"]);
    }
    folder.ok(&format!("{read} --mask mask.png"));
}
