//! Kinds of files that normals come in, through the command line, and what is said of
//! an object's table.

use crate::support::objects::{
    apart, eigenvalues, ellipsoid, encode, facets, stl, table, with_geometry,
};
use crate::support::{Folder, assert_fails};
use crate::tolerances;

/// A picture is of a sphere whatever the table is of, and that is said.
#[test]
fn a_picture_of_another_object_says_so() {
    let render = "render b.bin --light lights.csv:light-0 --material materials.csv:material-0 \
                  --size 16 --out p.png";
    for (geometry, name) in [
        ("normals = \"facets.csv\"\n", Some("`facets.csv`")),
        ("normals = \"slant-density\"\ndensity = \"cos(a)\"\n", Some("`slant-density cos(a)`")),
        ("normals = \"sphere\"\n", None),
    ] {
        let folder = table(geometry, &[("facets.csv", facets().into())]);
        let output = folder.run(render);
        assert_eq!(output.status.code(), Some(0));
        let said = String::from_utf8_lossy(&output.stderr);
        match name {
            Some(name) => {
                assert!(said.starts_with("note: ") && said.lines().count() == 1, "{said}");
                for word in [name, "sphere", "b.bin"] {
                    assert!(said.contains(word), "no {word} in {said}");
                }
            }
            None => assert_eq!(said, ""),
        }
    }
}

/// Texts in any case, behind blanks, of several solids; binary files that begin with
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
    let expected = eigenvalues(&table("normals = \"m.stl\"\n", &[("m.stl", binary.clone())]));
    binary[..80].fill(b' ');
    binary[..10].copy_from_slice(b"solid egg\n");
    let mut longer = binary.clone();
    longer.extend(b"made by hand");
    let mut upper = binary.clone();
    upper[..5].copy_from_slice(b"SOLID");
    for (name, bytes) in [
        ("text", text.clone().into_bytes()),
        ("upper case", text.to_uppercase().into_bytes()),
        ("behind blanks", format!("\u{feff}\n \t{text}\n\n").into_bytes()),
        ("nameless", text.replace(" egg", "").into_bytes()),
        ("lines of Windows", text.replace('\n', "\r\n").into_bytes()),
        ("two solids", (solid("a b", halves.0) + &solid("c", halves.1)).into_bytes()),
        ("no word of UTF-8", [&b"solid \xe9\n"[..], &text.as_bytes()[10..]].concat()),
        ("binary solid", binary.clone()),
        ("binary SOLID", upper),
    ] {
        let found = table("normals = \"m.stl\"\n", &[("m.stl", bytes)]);
        let found = apart(&eigenvalues(&found), &expected);
        assert!(found < tolerances::SAME_MESH_F32, "{name}: {found:e}");
    }
    let folder = Folder::new();
    folder.write("scene.toml", with_geometry("normals = \"m.stl\"\n"));
    for (bytes, words) in [
        (text.as_bytes()[..text.len() / 2].to_vec(), "endsolid"),
        (text.replacen("vertex", "corner", 1).into_bytes(), "corner"),
        (text.replacen("vertex", "vertex nan", 1).into_bytes(), "vertex"),
        (b"solid".to_vec(), "endsolid"),
        (b"solid\nendsolid\n".to_vec(), "no triangle"),
        (binary[..5000].to_vec(), "promised"),
        (longer, "115284 bytes promised, 115296 found"),
    ] {
        folder.write("m.stl", bytes);
        assert_fails(&folder, "basis --scene scene.toml --out new.bin", &["m.stl", words]);
    }
}

/// One rule of what is background and what is a fault, for `basis` and for `read`.
#[test]
fn normal_maps_have_one_rule() {
    let folder = table("normals = \"sphere\"\n", &[]);
    folder.write("scene.toml", with_geometry("normals = \"n.png\"\n"));
    let masked = with_geometry("normals = \"n.png\"\nmask = \"mask.png\"\n");
    folder.write("masked.toml", masked);
    let size = 8usize;
    let mut mask = vec![1.0; size * size];
    mask[0] = 0.0;
    folder.write(
        "mask.png",
        encode(size as u32, png::ColorType::Grayscale, png::BitDepth::Eight, &mask),
    );
    let image = vec![0.5; size * size];
    folder.write(
        "image.png",
        encode(size as u32, png::ColorType::Grayscale, png::BitDepth::Eight, &image),
    );
    let read = "read image.png --normals n.png --table b.bin --components 2 --out new.csv";
    // Pixel 0, 0 is of this kind, all others normals over the disc.
    let map = |first: [f64; 4]| {
        let mut samples = first.to_vec();
        for k in 1..size * size {
            let [x, y] = [k % size, k / size].map(|k| (k as f64 - 3.5) / 8.0);
            let z = (1.0 - x * x - y * y).sqrt();
            samples.extend([0.5 + 0.5 * x, 0.5 - 0.5 * y, 0.5 + 0.5 * z, 1.0]);
        }
        encode(size as u32, png::ColorType::Rgba, png::BitDepth::Eight, &samples)
    };
    // Pixels without a normal: of the table, and as `read` tells them.
    let without = || {
        folder.ok("basis --scene scene.toml --out object.bin");
        let bytes = std::fs::read(folder.path("object.bin")).expect("a table");
        let general = eigenshade_table::decode(&bytes).expect("a table").general;
        let output = folder.run(read);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(0), "{said}");
        std::fs::remove_file(folder.path("new.csv")).expect("an answer");
        let told = said.split("left out: ").nth(1).and_then(|rest| rest.split(' ').next());
        let told: usize = told.and_then(|count| count.parse().ok()).expect("a count");
        [size * size - general.expect("an object").normals, told]
    };
    for (name, first, expected) in [
        ("a normal", [0.5, 0.5, 1.0, 1.0], 0),
        ("half opaque", [0.5, 0.5, 1.0, 0.503], 0),
        ("less than half", [0.5, 0.5, 1.0, 0.497], 1),
        ("transparent and away", [0.5, 0.5, 0.0, 0.0], 1),
        ("grey", [0.5, 0.5, 0.5, 1.0], 1),
        ("black", [0.0, 0.0, 0.0, 1.0], 1),
        ("white", [1.0, 1.0, 1.0, 1.0], 1),
        ("filtered to 0.6", [0.5, 0.5, 0.8, 1.0], 0),
        ("short, 0.4", [0.5, 0.5, 0.7, 1.0], 1),
        ("short and away", [0.5, 0.5, 0.3, 1.0], 1),
        ("on the rim", [1.0, 0.5, 0.498, 1.0], 0),
    ] {
        folder.write("n.png", map(first));
        assert_eq!(without(), [expected; 2], "{name}");
    }
    folder.write("n.png", map([0.7, 0.5, 0.1, 1.0]));
    let basis = "basis --scene scene.toml --out new.bin";
    assert_fails(&folder, basis, &["n.png", "pixel 0, 0", "away"]);
    assert_fails(&folder, read, &["n.png", "pixel 0, 0", "away"]);
    folder.ok("basis --scene masked.toml --out new.bin");
    folder.ok(&format!("{read} --mask mask.png"));
}
