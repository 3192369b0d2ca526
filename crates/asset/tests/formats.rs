//! The kinds of files: glTF with buffers beside it or in itself, `.obj` with `.mtl`, `.ply` with
//! colors.

use crate::support::{at, drawn, png, read};
use eigenshade_asset::asset::Asset;
use eigenshade_asset::texels::Texels;
use eigenshade_generator::object::surface::View;
use eigenshade_model::srgb::linear;
use eigenshade_testing::glb::{FLOAT, Glb, floats};

/// Base 64.
fn base64(bytes: &[u8]) -> String {
    use base64::Engine;
    base64::engine::general_purpose::STANDARD.encode(bytes)
}

fn good(files: &[(&str, &[u8])]) -> Texels {
    let (texels, warnings) = read(files, 24, &View::default());
    assert_eq!(warnings, "");
    texels.expect("a picture")
}

#[test]
fn buffers_beside_the_file_and_in_it() {
    let mut glb = Glb::sphere(8);
    glb.material = r#""pbrMetallicRoughness":{"baseColorTexture":{"index":0}}"#.to_owned();
    glb.images = vec![png([4, 4], |column, row| [60 * column as u8, 60 * row as u8, 9, 255])];
    let expected = drawn(&glb, 24);
    let (json, bytes) = glb.parts(r#","uri":"my%20numbers.bin""#);
    let files = [("a.gltf", json.as_bytes()), ("my numbers.bin", &bytes)];
    assert_eq!(good(&files), expected);
    let uri = format!(r#","uri":"data:application/octet-stream;base64,{}""#, base64(&bytes));
    assert_eq!(good(&[("a.gltf", glb.parts(&uri).0.as_bytes())]), expected);
    // A texture beside it.
    let picture = std::mem::take(&mut glb.images);
    glb.extra = r#""images":[{"uri":"t.png"}],"textures":[{"source":0}],"#.to_owned();
    assert_eq!(good(&[("a.glb", &glb.bytes()), ("t.png", &picture[0])]), expected);
    let (missing, _) = read(&[("a.glb", &glb.bytes())], 24, &View::default());
    let missing = missing.expect_err("no texture");
    assert!(missing.contains("t.png") && missing.lines().count() == 1, "{missing}");
}

/// A mirrored node has its triangles the other way round, and is drawn as a mesh that is mirrored.
#[test]
fn nodes_place_meshes() {
    let mut glb = Glb::sphere(12);
    glb.positions.iter_mut().for_each(|[x, ..]| *x = if *x > 0.0 { 2.0 * *x } else { *x });
    glb.normals.clear();
    let expected = drawn(&glb, 40);
    let mut mirrored = glb.clone();
    mirrored.positions.iter_mut().for_each(|[x, ..]| *x = -*x);
    mirrored
        .indices
        .as_chunks_mut()
        .0
        .iter_mut()
        .for_each(|corners: &mut [u32; 3]| corners.swap(1, 2));
    mirrored.node = r#","scale":[-3,3,3],"translation":[5,-7,2]"#.to_owned();
    let found = drawn(&mirrored, 40);
    // Coordinates are rounded elsewhere, so that some samples at the outline differ.
    let area = |texels: &Texels| texels.pixels.iter().map(|pixel| pixel.coverage).sum::<f64>();
    assert!((area(&found) / area(&expected) - 1.0).abs() < 2e-3);
    for (column, row) in [(10, 20), (20, 10), (30, 24)] {
        let [found, expected] =
            [&found, &expected].map(|one| at(one, column, row).expect("a texel"));
        let apart = found.normal.iter().zip(expected.normal).map(|(a, b)| (a - b).abs());
        assert!(apart.fold(0.0, f64::max) < 0.01, "{found:?} {expected:?}");
    }
}

/// A sphere by one joint, as if its node were placed so, whatever its own node says.
#[test]
fn joints_place_skinned_meshes() {
    let mut expected = Glb::sphere(12);
    expected.node = r#","scale":[2,1,1]"#.to_owned();
    let bind = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -5, 0, 0, 1].map(|x: i8| f32::from(x));
    let corners = expected.positions.len();
    let joints: Vec<u8> =
        [0u16, 7, 0, 0].repeat(corners).iter().flat_map(|x| x.to_le_bytes()).collect();
    let skinned = Glb {
        accessors: vec![
            (FLOAT, "MAT4", floats(&bind)),
            (5123, "VEC4", joints),
            (FLOAT, "VEC4", floats(&[0.5, 0.0, 0.0, 0.0].repeat(corners))),
        ],
        attributes: r#","JOINTS_0":1,"WEIGHTS_0":2"#.to_owned(),
        node: r#","skin":0"#.to_owned(),
        nodes: r#",{"scale":[2,1,1],"translation":[10,0,0]}"#.to_owned(),
        extra: r#""skins":[{"joints":[1],"inverseBindMatrices":0}],"#.to_owned(),
        ..Glb::sphere(12)
    };
    assert_eq!(drawn(&skinned, 32), drawn(&expected, 32));
    let elsewhere =
        Glb { node: r#","skin":0,"translation":[9,9,9]"#.to_owned(), ..skinned.clone() };
    assert_eq!(drawn(&elsewhere, 32), drawn(&expected, 32));
    // A joint that does not exist.
    let mut broken = skinned;
    broken.accessors[1].2[0] = 3;
    let (error, _) = read(&[("a.glb", &broken.bytes())], 9, &View::default());
    let error = error.expect_err("a joint");
    assert!(error.contains("joint 3 does not exist: its skin has 1"), "{error}");
}

/// One side of a square follows a joint of its own: the square is half as long again.
#[test]
fn corners_follow_their_joints() {
    let joints: Vec<u8> =
        [0u16, 1, 1, 0].iter().flat_map(|k| [*k, 0, 0, 0]).flat_map(u16::to_le_bytes).collect();
    let skinned = Glb {
        accessors: vec![
            (5123, "VEC4", joints),
            (FLOAT, "VEC4", floats(&[1.0, 0.0, 0.0, 0.0].repeat(4))),
        ],
        attributes: r#","JOINTS_0":0,"WEIGHTS_0":1"#.to_owned(),
        node: r#","skin":0"#.to_owned(),
        nodes: r#",{},{"translation":[1,0,0]}"#.to_owned(),
        extra: r#""skins":[{"joints":[1,2]}],"#.to_owned(),
        ..Glb::square()
    };
    let mut expected = Glb::square();
    expected.positions.iter_mut().for_each(|[x, ..]| *x += if *x > 0.0 { 1.0 } else { 0.0 });
    assert_eq!(drawn(&skinned, 32), drawn(&expected, 32));
}

/// Morph targets by their default weights; also sparse ones.
#[test]
fn morph_targets_have_their_weights() {
    let mut expected = Glb::square();
    expected.positions[2][0] += 0.5;
    let moved = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let morphed = Glb {
        accessors: vec![(FLOAT, "VEC3", floats(&moved)), (FLOAT, "VEC3", floats(&[9.0; 12]))],
        primitive: r#","targets":[{"POSITION":0},{"POSITION":1}]"#.to_owned(),
        node: r#","weights":[0.5,0]"#.to_owned(),
        ..Glb::square()
    };
    assert_eq!(drawn(&morphed, 32), drawn(&expected, 32));
    // The same target with one corner that moves.
    let mut sparse = morphed.clone();
    sparse.accessors[1] = (FLOAT, "VEC3", floats(&[1.0, 0.0, 0.0]));
    sparse.accessors.push((5125, "SCALAR", 2u32.to_le_bytes().to_vec()));
    sparse.primitive = r#","targets":[{"POSITION":0}]"#.to_owned();
    let (json, bytes) = sparse.parts(r#","uri":"a.bin""#);
    let whole = r#"{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"}"#;
    let part = r#"{"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":1,"indices":{"bufferView":2,"componentType":5125},"values":{"bufferView":1}}}"#;
    assert!(json.contains(whole), "{json}");
    let json = json.replacen(whole, part, 1);
    assert_eq!(good(&[("a.gltf", json.as_bytes()), ("a.bin", &bytes)]), drawn(&expected, 24));
    let animated =
        Glb { extra: r#""animations":[{"channels":[],"samplers":[]}],"#.to_owned(), ..morphed };
    let (_, warnings) = read(&[("a.glb", &animated.bytes())], 9, &View::default());
    assert_eq!(warnings, "ignored: animations (the object is drawn at rest)");
}

#[test]
fn wavefront_files_with_materials() {
    let obj = "mtllib a.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 1\nvt 0 1\n\
        usemtl left\nf 1/1 3/2 4/3\nusemtl right\nf 1 2 3\n";
    let mtl = "newmtl left\nKd 1 1 1\nmap_Kd t.png\nNs 250\n\nnewmtl right\nKd 0.1 0.2 0.3\nPr 0.7\nPm 1\n";
    let picture = png([8, 8], |_, row| if row < 4 { [188, 0, 0, 255] } else { [0, 188, 0, 255] });
    let texels = good(&[("a.obj", obj.as_bytes()), ("a.mtl", mtl.as_bytes()), ("t.png", &picture)]);
    let half = linear(188.0 / 255.0) as f32;
    let [left, right] =
        [(4, 3), (20, 18)].map(|(column, row)| at(&texels, column, row).expect("a texel"));
    assert!((left.matte[0] - 0.96 * half).abs() < 1e-6 && left.matte[1] == 0.0, "{left:?}");
    assert!((left.roughness - 0.5).abs() < 1e-6, "{left:?}");
    assert_eq!((right.matte, right.roughness), ([0.0; 3], 0.7));
    for (found, expected) in right.reflectance.iter().zip([0.1, 0.2, 0.3]) {
        assert!((found - expected).abs() < 1e-6, "{right:?}");
    }
    for (obj, mtl, expected) in [
        (obj.replace("right", "wrong"), mtl, "`wrong` is in none of its .mtl files"),
        (obj.to_owned(), "newmtl left\nKd x\n", "no complete MTL"),
        (obj.to_owned(), "newmtl left\nKd 2 0 0\nnewmtl right\n", "not in [0, 1]"),
        (obj.replace("a.mtl", "b.mtl"), mtl, "b.mtl"),
        (obj.replace("4/3", "4/9"), mtl, "`4/9` is not one of its 3 texture coordinates"),
    ] {
        let files = [("a.obj", obj.as_bytes()), ("a.mtl", mtl.as_bytes()), ("t.png", &picture[..])];
        let error = read(&files, 24, &View::default()).0.expect_err(expected);
        assert!(error.contains(expected) && error.lines().count() == 1, "{error}");
    }
}

/// Bytes are in sRGB, floating-point numbers are linear.
#[test]
fn polygon_files_with_colors() {
    for (kind, color, expected) in [
        ("uchar", "188 0 255", [linear(188.0 / 255.0), 0.0, 1.0]),
        ("float", "0.5 0 1", [0.5, 0.0, 1.0]),
    ] {
        let channels = ["red", "green", "blue"].map(|name| format!("property {kind} {name}\n"));
        let ply = format!(
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
             property float z\n{}element face 1\nproperty list uchar int vertex_indices\nend_header\n\
             0 0 0 {color}\n1 0 0 {color}\n0 1 0 {color}\n3 0 1 2\n",
            channels.concat()
        );
        let texel = at(&good(&[("a.ply", ply.as_bytes())]), 6, 16).expect("a texel");
        for (found, expected) in texel.matte.iter().zip(expected) {
            assert!((f64::from(*found) - 0.96 * expected).abs() < 1e-6, "{texel:?}");
        }
        assert_eq!(texel.roughness, 1.0);
    }
}

/// A file without materials is none of these.
#[test]
fn files_without_materials() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.obj");
    std::fs::write(&path, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").expect("a file");
    assert!(Asset::read(&path.into()).expect("a mesh").is_none());
}
