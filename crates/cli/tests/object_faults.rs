//! Objects that are no objects, through the command line.

use crate::support::objects::{encode, normal_map, ply, stl, with_geometry};
use crate::support::{Folder, assert_fails, scene};

#[test]
fn bad_objects() {
    let folder = Folder::new();
    folder.write("cut.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
    folder.write("short.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 2 3\n");
    let mut wide = normal_map(png::BitDepth::Eight);
    wide[16..24].copy_from_slice(&[0, 0, 0x40, 0, 0, 0, 0x40, 0]);
    // The header's checksum.
    wide[29..33].copy_from_slice(&[0xa9, 0xc8, 0x10, 0x84]);
    folder.write("wide.png", &wide);
    folder.write("empty.obj", "# nothing\n");
    folder.write("nan.obj", "v 0 0 0\nv 1 0 0\nv 0 nan 0\nf 1 2 3\n");
    folder.write("back.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 3 2 1\n");
    folder.write("cut.stl", &stl()[..5000]);
    folder.write("short.stl", b"abc");
    folder.write("cut.ply", &ply().as_bytes()[..3000]);
    folder.write("foreign.ply", b"plum\n");
    folder.write("huge.ply", ply().replace("element face 2304", "element face 4000000000"));
    folder.write("cut.png", &normal_map(png::BitDepth::Eight)[..900]);
    folder.write("foreign.png", "no picture");
    let mut huge = normal_map(png::BitDepth::Eight);
    huge[16..24].copy_from_slice(&[0x40, 0, 0, 0, 0x40, 0, 0, 0]);
    folder.write("huge.png", &huge);
    folder.write("n.png", normal_map(png::BitDepth::Eight));
    let small = encode(8, png::ColorType::Grayscale, png::BitDepth::Eight, &[1.0; 64]);
    folder.write("small.png", small);
    let black = encode(64, png::ColorType::Grayscale, png::BitDepth::Eight, &[0.0; 64 * 64]);
    folder.write("black.png", black);
    let away = [0.5, 0.5, 0.0].repeat(64);
    folder.write("away.png", encode(8, png::ColorType::Rgb, png::BitDepth::Eight, &away));
    folder.write("falls.csv", "slant,density\n0.5,1\n0.2,1\n");
    folder.write("beyond.csv", "slant,density\n0.5,1\n2.2,1\n");
    folder.write("one.csv", "slant,density\n0.5,1\n");
    folder.write("nan.csv", "slant,density\n0.5,1\n0.6,nan\n");
    folder.write("weight.csv", "x,y,z,weight\n0,0,1,-1\n");
    folder.write("weightless.csv", "x,y,z,weight\n0,0,1,0\n");
    for (geometry, words) in [
        ("normals = \"none.obj\"", &["none.obj"][..]),
        ("normals = \"cut.obj\"", &["cut.obj"]),
        ("normals = \"short.obj\"", &["short.obj", "line 5", "corners"]),
        ("normals = \"wide.png\"", &["wide.png", "16384 x 16384"]),
        ("normals = \"empty.obj\"", &["empty.obj", "no triangle"]),
        ("normals = \"nan.obj\"", &["nan.obj"]),
        ("normals = \"back.obj\"", &["back.obj", "no normal is seen"]),
        ("normals = \"cut.stl\"", &["cut.stl", "promised"]),
        ("normals = \"short.stl\"", &["short.stl"]),
        ("normals = \"cut.ply\"", &["cut.ply"]),
        ("normals = \"foreign.ply\"", &["foreign.ply"]),
        ("normals = \"huge.ply\"", &["huge.ply", "promised"]),
        ("normals = \"cut.png\"", &["cut.png"]),
        ("normals = \"foreign.png\"", &["foreign.png"]),
        ("normals = \"huge.png\"", &["huge.png"]),
        ("normals = \"n.png\"\nmask = \"small.png\"", &["small.png", "8 x 8"]),
        ("normals = \"n.png\"\nmask = \"black.png\"", &["n.png", "no normal is seen"]),
        ("normals = \"away.png\"", &["away.png", "pixel 0, 0"]),
        ("normals = \"sphere\"\nmask = \"n.png\"", &["mask"]),
        ("normals = \"sphere\"\ndensity = \"cos(a)\"", &["density"]),
        ("normals = \"slant-density\"", &["density"]),
        ("normals = \"slant-density\"\ndensity = \"cos(\"", &["cos("]),
        ("normals = \"slant-density\"\ndensity = \"1e308 cos(a)\"", &["is no formula"]),
        ("normals = \"slant-density\"\ndensity = \"1e999*cos(a)\"", &["is inf", "finite"]),
        ("normals = \"slant-density\"\ndensity = \"cos(b)\"", &["variable `b`"]),
        ("normals = \"slant-density\"\ndensity = \"-1\"", &["density"]),
        ("normals = \"slant-density\"\ndensity = \"2^-a\"", &["parentheses"]),
        ("normals = \"slant-density\"\ndensity = \"1/(a-a)\"", &["density"]),
        ("normals = \"slant-density\"\ndensity = \"falls.csv\"", &["falls.csv:3:"]),
        ("normals = \"slant-density\"\ndensity = \"beyond.csv\"", &["beyond.csv:3:"]),
        ("normals = \"slant-density\"\ndensity = \"one.csv\"", &["one.csv"]),
        ("normals = \"slant-density\"\ndensity = \"nan.csv\"", &["nan.csv:3:"]),
        ("normals = \"weight.csv\"", &["weight.csv:2:", "negative"]),
        ("normals = \"weightless.csv\"", &["weightless.csv"]),
        ("normals = \"cube\"", &["cube"]),
    ] {
        folder.write("scene.toml", with_geometry(&format!("{geometry}\n")));
        assert_fails(&folder, "basis --scene scene.toml --out new.bin", words);
    }
}

#[test]
fn bad_weights() {
    let folder = Folder::new();
    for (weights, words) in [
        ("nobody = 2.0", "nobody"),
        ("light-1 = -1.0", "-1"),
        ("light-1 = nan", "NaN"),
        ("light-0 = 0.0\nlight-1 = 0.0\nlight-2 = 0.0", "weight 0"),
    ] {
        let text = scene("image-centered", 10, "[]");
        folder.write("scene.toml", format!("{text}[light.weights]\n{weights}\n"));
        assert_fails(&folder, "basis --scene scene.toml --out new.bin", &[words]);
    }
}
