//! Bad files of every kind that an object's normals may come from: cut short, of another type, of
//! an absurd size, with a number that is not finite; and scenes of objects that have no table. Each
//! gives one line that names the file, and nothing is written.

use crate::support::files::{claims, gray_png, normal_map, obj, ply, ply_header, square_png, stl};
use crate::support::{Folder, NEW_BASIS, assert_fails, scene};
use png::{BitDepth, ColorType};
use std::time::Instant;

/// The beginning of a file of another type.
const FOREIGN: &[u8] = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\xff\xfe\xfd and more of it, \0 up to a facet's length and beyond \
    the header of an STL, which has eighty bytes";

const TEXT_STL: &str = "solid one\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n\
    endloop\nendfacet\nendsolid one\n";

/// A binary polygon file of one triangle, from the type of its lists' counts, the number of
/// corners, a coordinate, and the bytes of the list.
fn binary_ply(list: &str, vertices: &str, coordinate: f32, face: &[u8]) -> Vec<u8> {
    let list = format!("{list} int");
    let mut bytes = ply_header("binary_little_endian", vertices, "float", 1, &list).into_bytes();
    let corners = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, coordinate, 0.0];
    bytes.extend(corners.iter().flat_map(|value: &f32| value.to_le_bytes()));
    bytes.extend(face);
    bytes
}

/// A list of three corners, after its count in these bytes.
fn list(count: &[u8]) -> Vec<u8> {
    count.iter().copied().chain([0i32, 1, 2].iter().flat_map(|place| place.to_le_bytes())).collect()
}

/// Asserts that a picture of each object's file is refused, and takes no time for it.
fn assert_each(cases: &[(&str, &[u8], &[&str])]) {
    let folder = Folder::new();
    for (name, bytes, fragments) in cases {
        folder.write(name, bytes);
        let command = match name.ends_with(".csv") {
            true => "shade --out new.csv",
            false => "render --out new.png",
        };
        let command = format!("{command} --light lobby --material chrome --normals {name}");
        let start = Instant::now();
        assert_fails(&folder, &command, &[&[*name][..], fragments].concat());
        assert!(start.elapsed().as_secs() < 20, "{name}");
    }
}

#[test]
fn lists_of_normals() {
    assert_each(&[
        ("cut.csv", b"x,y,z,id\n0,0,1,1\n0,0,1", &["cut.csv:3:", "4 fields"]),
        ("header.csv", b"a,b,c\n0,0,1\n", &["header.csv:1:"]),
        ("foreign.csv", FOREIGN, &["UTF-8"]),
        ("empty.csv", b"x,y,z\n", &["no normal"]),
        ("nan.csv", b"x,y,z\n0,0,1\n0,nan,1\n", &["nan.csv:3:", "`nan`"]),
        ("doubled.csv", b"x,y,z,z\n0,0,1,1\n", &["doubled.csv:1:", "column 4", "`z`"]),
        ("infinite.csv", b"x,y,z\n0,0,1e999\n", &["infinite.csv:2:", "`1e999`"]),
    ]);
}

#[test]
fn wavefront_meshes() {
    // Such a text has no end mark; only a line that is cut short shows.
    let good = obj();
    let last = good.rfind(' ').expect("a corner");
    let with = |face: &str| format!("v 0 0 0\nv 1 0 0\nv 0 1 0\n{face}\n").into_bytes();
    assert_each(&[
        ("cut.obj", &good.as_bytes()[..last], &["fewer than three corners"]),
        ("cut-corner.obj", b"v 0 0 0\nv 1 0 0\nv 0 1\nf 1 2 3\n", &["OBJ"]),
        ("foreign.obj", FOREIGN, &["no triangle"]),
        ("text.obj", b"hello\nworld\n", &["no triangle"]),
        ("far.obj", &with("f 1 2 4000000000"), &["OBJ"]),
        ("farther.obj", &with("f 1 2 99999999999999999999999"), &["OBJ"]),
        ("negative.obj", &with("f 1 2 -9"), &["OBJ"]),
        ("zero.obj", &with("f 0 1 2"), &["OBJ"]),
        ("nan.obj", b"v 0 0 0\nv 1 0 0\nv 0 nan 0\nf 1 2 3\n", &["not finite"]),
        ("infinite.obj", b"v 0 0 0\nv 1 0 0\nv 0 1e999 0\nf 1 2 3\n", &["not finite"]),
    ]);
}

#[test]
fn binary_stereolithography() {
    let good = stl();
    let changed = |at: usize, with: &[u8]| {
        let mut bytes = good.clone();
        bytes[at..at + with.len()].copy_from_slice(with);
        bytes
    };
    let foreign = FOREIGN.iter().cycle().take(400).copied().collect::<Vec<u8>>();
    assert_each(&[
        ("cut.stl", &good[..good.len() - 1], &["promise"]),
        ("cut-head.stl", &good[..83], &["promise"]),
        ("foreign.stl", &foreign, &["promise"]),
        ("fewer.stl", &changed(80, &100u32.to_le_bytes()), &["5084 bytes"]),
        ("none.stl", &changed(80, &[0; 4])[..84], &["no triangle"]),
        ("huge.stl", &changed(80, &[0xff; 4]), &["214748364834 bytes"]),
        ("nan.stl", &changed(84 + 12, &f32::NAN.to_le_bytes()), &["facet 0", "not finite"]),
        (
            "infinite.stl",
            &changed(134 + 16, &f32::INFINITY.to_le_bytes()),
            &["facet 1", "not finite"],
        ),
    ]);
}

#[test]
fn texts_of_stereolithography() {
    let with = |from: &str, to: &str| TEXT_STL.replace(from, to).into_bytes();
    assert_each(&[
        ("cut.stl", &TEXT_STL.as_bytes()[..60], &["endsolid"]),
        ("cut-facet.stl", &with("vertex 0 1 0\n", ""), &["STL"]),
        ("text.stl", "hello\n".repeat(60).as_bytes(), &["promise"]),
        ("fragment.stl", &with("0 1 0", "0 one 0"), &["STL"]),
        ("tail.stl", &with("endsolid one\n", "endsolid one\nand more\n"), &["line 10", "and more"]),
        ("nan.stl", &with("0 1 0", "0 nan 0"), &["finite"]),
        ("infinite.stl", &with("0 1 0", "0 1e999 0"), &["finite"]),
    ]);
}

#[test]
fn polygon_files() {
    let text = ply();
    let in_text = |from: &str, to: &str| text.replacen(from, to, 1).into_bytes();
    let first = text.lines().nth(9).expect("a corner");
    let whole = binary_ply("uchar", "3", 1.0, &list(&[3]));
    assert_each(&[
        ("cut.ply", &text.as_bytes()[..text.len() - 6], &["PLY"]),
        ("cut-head.ply", &text.as_bytes()[..40], &["PLY"]),
        ("foreign.ply", FOREIGN, &["PLY"]),
        ("text.ply", b"hello\n", &["PLY", "magic"]),
        ("huge.ply", &in_text("element face ", "element face 9999"), &["promise"]),
        ("nan.ply", &in_text(first, "nan 0 0"), &["not finite"]),
        ("infinite.ply", &in_text(first, "1e999 0 0"), &["not finite"]),
        ("cut-binary.ply", &whole[..whole.len() - 4], &["PLY"]),
        ("huge-binary.ply", &binary_ply("uchar", "18446744073709551615", 1.0, &[]), &["promise"]),
        ("long-list.ply", &binary_ply("uint", "3", 1.0, &list(&[0xff; 4])), &["PLY"]),
        (
            "negative-list.ply",
            &binary_ply("int", "3", 1.0, &list(&[0xff; 4])),
            &["PLY", "negative"],
        ),
        (
            "tail.ply",
            &in_text("", "").iter().chain(b"3 0 1 2\n").copied().collect::<Vec<u8>>(),
            &["more follows"],
        ),
        ("fewer.ply", &in_text("element face 2304", "element face 2303"), &["more follows"]),
        (
            "two-corners.ply",
            &binary_ply("uchar", "3", 1.0, &[2, 0, 0, 0, 0, 1, 0, 0, 0]),
            &["fewer than three corners: it has 2"],
        ),
        ("no-corner.ply", &binary_ply("uchar", "3", 1.0, &[0, 0, 0, 0]), &["it has none"]),
        ("nan-binary.ply", &binary_ply("uchar", "3", f32::NAN, &list(&[3])), &["not finite"]),
    ]);
}

/// Samples are integers, so all are finite.
#[test]
fn normal_maps() {
    for bits in [BitDepth::Eight, BitDepth::Sixteen] {
        let good = normal_map(bits);
        assert_each(&[
            ("cut.png", &good[..good.len() / 2], &["cut short"]),
            ("cut-end.png", &good[..good.len() - 1], &["cut short"]),
            ("foreign.png", b"no picture at all", &["not a PNG"]),
            ("absurd.png", &claims(good.clone(), u32::MAX >> 1, u32::MAX >> 1), &["2147483647"]),
            ("wide.png", &claims(good.clone(), 8000, 8000), &["8000 x 8000", "cannot hold"]),
            ("none.png", &claims(good.clone(), 0, 64), &["none.png"]),
        ]);
    }
    // A picture that holds no vector of a normal's length.
    let folder = Folder::new();
    folder.write("black.png", gray_png(8, 8, &[0; 64]));
    let render = "render --light lobby --material chrome --normals black.png --out new.png";
    let expected = "is opaque and holds a normal (a vector of length 1/2 to 3/2); check";
    assert_fails(&folder, render, &["black.png: ", expected]);
}

#[test]
fn bad_objects() {
    let away = [0.5, 0.5, 0.0].repeat(64);
    let away = square_png(8, ColorType::Rgb, BitDepth::Eight, &away);
    let wide = claims(normal_map(BitDepth::Eight), 16_384, 16_384);
    assert_each(&[
        ("short.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 2 3\n", &["line 5", "corners"]),
        ("wide.png", &wide, &["16384 x 16384"]),
        ("back.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 3 2 1\n", &["faces away"]),
        ("away.png", &away, &["pixel 0, 0"]),
    ]);
}

/// A table is that of a sphere: a scene of another object, or of light that does not turn, says what
/// to do.
#[test]
fn scenes_of_other_objects() {
    let folder = Folder::new();
    let of_sphere = scene("image-centered", 10, "[]");
    let remedy = "leave [geometry] out for a sphere, or name a mesh with geometry.object";
    for (section, expected) in [
        ("[geometry]\nnormals = \"sphere\"\n", "scene.toml:2: geometry.normals: "),
        ("[geometry]\nmask = \"a.png\"\n", "scene.toml:2: geometry.mask: "),
        ("\n[geometry]\n", "scene.toml:2: [geometry]: "),
    ] {
        folder.write("scene.toml", format!("{section}{of_sphere}"));
        assert_fails(&folder, NEW_BASIS, &[expected, "a table is that of a sphere", remedy]);
    }
    folder.write("scene.toml", of_sphere.replace("[material]", "rotation = \"none\"\n[material]"));
    let expected = ["scene.toml:4: light.rotation: ", "turns freely; leave it out"];
    assert_fails(&folder, NEW_BASIS, &expected);
}

#[test]
fn bad_weights() {
    let folder = Folder::new();
    for (weights, fragments) in [
        ("nobody = 2.0", "nobody"),
        ("light-1 = -1.0", "-1"),
        ("light-1 = nan", "NaN"),
        ("light-0 = 0.0\nlight-1 = 0.0\nlight-2 = 0.0", "weight 0"),
    ] {
        let text = scene("image-centered", 10, "[]");
        folder.write("scene.toml", format!("{text}[light.weights]\n{weights}\n"));
        assert_fails(&folder, NEW_BASIS, &[fragments]);
    }
}
