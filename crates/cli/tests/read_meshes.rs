//! `eigenshade read` of pictures of meshes.

use crate::support::files::{
    Answer, answer, decoded, get, nearest, obj, ply, png, stl, with_image,
};
use crate::support::{Folder, assert_contains, assert_fails, assert_near};
use eigenshade_cli::object::{ObjectOptions, ObjectView};
use eigenshade_testing::glb::Glb;
use png::{BitDepth, ColorType};

/// d of a picture in f32, relative to the largest: 6e-8 times a condition number of thousands.
const IN_F32: f64 = 1e-3;

/// d by a normal map of 16 bits against d by the mesh itself, relative to the largest.
const OF_A_MAP: f64 = 0.02;

/// A mesh of a file, drawn in the light and the material of the folder.
fn drawn(folder: &Folder, object: &str, options: &str, out: &str) {
    folder.ok(&format!(
        "render --object {object} {options} --table b.bin --light light.csv --material material.csv \
         --sources 0 --window none --size 64 --out {out}"
    ));
}

/// What `read` finds, and its messages.
fn read(folder: &Folder, image: &str, normals: &str) -> (Answer, String) {
    let (text, messages) =
        folder.both(&format!("read {image} --normals {normals} --table b.bin --light-out l.csv"));
    (answer(&text), messages)
}

/// Light and material of a picture of a mesh come back from the mesh itself, and as from a normal
/// map of it.
#[test]
fn pictures_of_meshes_are_read() {
    let folder = with_image();
    let expected = folder.projected("--table b.bin --light light.csv --material material.csv");
    let glb = Glb {
        material: r#""pbrMetallicRoughness":{"baseColorFactor":[1,0,0,1]}"#.to_owned(),
        node: r#","scale":[1,0.7,1.3]"#.to_owned(),
        ..Glb::sphere(24)
    };
    for (name, bytes, options) in [
        ("m.obj", obj().into_bytes(), "--flat"),
        ("m.ply", ply().into_bytes(), "--view top"),
        ("m.stl", stl(), "--rotate-object 0.3,0.5,0.1"),
        ("m.glb", glb.bytes(), ""),
    ] {
        folder.write(name, bytes);
        drawn(&folder, name, options, "p.exr");
        let (found, messages) = read(&folder, "p.exr", &format!("{name} {options}"));
        assert_eq!(nearest(&found), "material-2", "{name}");
        let d = get(&found, "d", "least-squares").as_flattened();
        assert_near(name, d, &expected, IN_F32);
        let ignored = messages.contains("note: m.glb: its materials are ignored");
        assert_eq!(ignored, name == "m.glb", "{messages}");
    }
    let path = folder.path("m.glb");
    let view = ObjectView::read(path.into(), ObjectOptions::of_size(Some(64))).expect("a picture");
    let mut samples = vec![0u16; 4 * 64 * 64];
    for (pixel, normal) in view.pixels.iter().zip(view.normals) {
        let code = |c: f64| (32767.5 * (c + 1.0)).round() as u16;
        let [x, y, z] = normal.map(code);
        let opacity = if pixel.coverage < 1.0 { 0 } else { u16::MAX };
        samples[4 * (64 * pixel.row + pixel.column)..][..4].copy_from_slice(&[x, y, z, opacity]);
    }
    let bytes: Vec<u8> = samples.iter().flat_map(|sample| sample.to_be_bytes()).collect();
    folder.write("map.png", png([64, 64], BitDepth::Sixteen, ColorType::Rgba, &bytes));
    let [of_mesh, of_map] = ["m.glb", "map.png"].map(|name| read(&folder, "p.exr", name).0);
    assert_eq!(get(&of_map, "fit", "pixels"), get(&of_mesh, "fit", "pixels"));
    assert_eq!(nearest(&of_map), "material-2");
    let [of_mesh, of_map] =
        [&of_mesh, &of_map].map(|found| get(found, "d", "least-squares").as_flattened());
    assert_near("a normal map", of_map, of_mesh, OF_A_MAP);
}

/// In a longer picture, the mesh lies in the middle.
#[test]
fn meshes_lie_in_the_middle() {
    let folder = with_image();
    folder.write("m.obj", obj());
    drawn(&folder, "m.obj", "--exposure 0.1", "p.png");
    let (square, _) = read(&folder, "p.png", "m.obj");
    let (width, color, bytes) = decoded(&folder.path("p.png"));
    let margin = vec![0; 4 * 64 * 8];
    let longer = [&margin[..], &bytes, &margin].concat();
    folder.write("q.png", png([width, 80], BitDepth::Eight, color, &longer));
    let (found, messages) = read(&folder, "q.png", "m.obj");
    let note = "note: the image is 64 x 80, and the object fills the largest square in its middle";
    assert_contains(&messages, &[note]);
    assert_eq!(get(&found, "d", "least-squares"), get(&square, "d", "least-squares"));
    assert_fails(
        &folder,
        "read p.png --normals sphere --flat --table b.bin",
        &["--flat, --view and --rotate-object are for a mesh"],
    );
}
