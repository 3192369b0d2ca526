//! Broken and hostile files: one line that says what is wrong, and never a panic.

use crate::support::{png, read, square};
use eigenshade_generator::object::surface::View;
use eigenshade_testing::glb::Glb;
use std::time::{Duration, Instant};

/// The longest time to refuse a file.
const REFUSAL: Duration = Duration::from_secs(10);

fn error(bytes: &[u8]) -> String {
    let error = read(&[("a.glb", bytes)], 16, &View::default()).0.expect_err("an error");
    assert!(error.contains("a.glb") && error.lines().count() == 1, "{error}");
    error
}

#[test]
fn files_cut_short() {
    let mut glb = Glb::sphere(2);
    glb.images = vec![png([2, 2], |_, _| [9; 4])];
    glb.material = r#""pbrMetallicRoughness":{"baseColorTexture":{"index":0}}"#.to_owned();
    // With joints, a morph target and a sparse accessor.
    let skinned = include_bytes!("../../../fuzz/readers/seeds/read_glb/skinned");
    for bytes in [glb.bytes(), skinned.to_vec()] {
        for end in (0..bytes.len() - 4).step_by(3) {
            error(&bytes[..end]);
        }
        // Every byte of the JSON changed: an error or a picture.
        for place in 20..bytes.len().min(1800) {
            for byte in [b'9', b'-', b'"', 0] {
                let mut changed = bytes.clone();
                changed[place] = byte;
                let _ = read(&[("a.glb", &changed)], 8, &View::default());
            }
        }
    }
}

#[test]
fn wrong_numbers() {
    let with = |change: &dyn Fn(&mut Glb)| {
        let mut glb = Glb::square();
        change(&mut glb);
        error(&glb.bytes())
    };
    assert!(with(&|glb| glb.indices[1] = 4).contains("corner 4 does not exist: there are 4"));
    assert!(with(&|glb| glb.positions[1][0] = f32::NAN).contains("not finite"));
    assert!(with(&|glb| glb.positions[1][0] = f32::INFINITY).contains("not finite"));
    assert!(with(&|glb| glb.indices.truncate(0)).contains("glTF"));
    let factor = r#""pbrMetallicRoughness":{"metallicFactor":1.5}"#;
    let found = with(&|glb| glb.material = factor.to_owned());
    assert!(found.contains("material 0 has a factor of 1.5, not in [0, 1]"), "{found}");
    let far = r#""pbrMetallicRoughness":{"baseColorTexture":{"index":7}}"#;
    assert!(with(&|glb| glb.material = far.to_owned()).contains("no valid glTF file"));
    let required = r#""extensionsUsed":["KHR_draco_mesh_compression"],"extensionsRequired":["KHR_draco_mesh_compression"],"#;
    assert!(
        with(&|glb| glb.extra = required.to_owned())
            .contains("it requires the extension KHR_draco_mesh_compression")
    );
    let children = r#","children":[0]"#;
    assert!(with(&|glb| glb.node = children.to_owned()).contains("cycle"));
    // Without an area.
    let line = with(&|glb| glb.positions.iter_mut().for_each(|at| at[1] = 0.0));
    assert!(line.contains("nothing of it is seen"), "{line}");
}

/// Normals, tangents and texture coordinates that are none.
#[test]
fn degenerate_attributes() {
    let mut glb =
        square(r#""normalTexture":{"index":0}"#, vec![png([4, 4], |_, _| [204, 128, 230, 255])]);
    for coordinates in [[[0.5; 2]; 4], [[f32::NAN, 1e38]; 4], [[0.0, 0.0]; 4]] {
        glb.coordinates = coordinates.to_vec();
        let (texels, _) = read(&[("a.glb", &glb.bytes())], 16, &View::default());
        let texels = texels.expect("a picture");
        assert!(texels.texels.iter().all(|texel| texel.normal.iter().all(|x| x.is_finite())));
    }
    glb.normals = vec![[f32::NAN; 3], [0.0; 3], [0.0, 0.0, -1.0], [0.0, 0.0, 1.0]];
    let (texels, warning) = read(&[("a.glb", &glb.bytes())], 16, &View::default());
    assert!(texels.is_ok() && warning.contains("are replaced: 5"), "{warning}");
}

#[test]
fn what_is_ignored_is_named() {
    let material = r#""emissiveFactor":[1,0,0],"alphaMode":"BLEND","extensions":{"KHR_materials_clearcoat":{"clearcoatFactor":1}}"#;
    let mut glb = square(material, Vec::new());
    glb.extra = r#""extensionsUsed":["KHR_materials_clearcoat"],"#.to_owned();
    let (texels, warning) = read(&[("a.glb", &glb.bytes())], 16, &View::default());
    assert!(texels.is_ok());
    assert_eq!(
        warning,
        "extensions that may change its look are ignored: KHR_materials_clearcoat\nignored: emitted \
         light, transparency (opacity from 1/2 on is drawn, and the rest is a hole)"
    );
}

/// A texture that claims to be huge, and meshes of more triangles than are read.
#[test]
fn bombs() {
    let material = r#""pbrMetallicRoughness":{"baseColorTexture":{"index":0}}"#;
    let start = Instant::now();
    let mut picture = png([8, 8], |_, _| [9; 4]);
    picture[16..24].copy_from_slice(&[0, 0, 0x40, 0, 0, 0, 0x40, 0]);
    // The checksum of a header that claims 16384 x 16384.
    let checksum = crc32fast::hash(&picture[12..29]).to_be_bytes();
    picture[29..33].copy_from_slice(&checksum);
    let found = error(&square(material, vec![picture]).bytes());
    assert!(found.contains("16384 x 16384 pixels in"), "{found}");
    let mut many = Glb::square();
    many.indices = [0, 1, 2].repeat(500_001);
    assert!(error(&many.bytes()).contains("it has 500001 triangles, too many to read"));
    assert!(start.elapsed() < REFUSAL, "{:?}", start.elapsed());
}

/// Half a million triangles are read.
#[test]
fn the_largest_mesh() {
    let start = Instant::now();
    let mut glb = Glb::sphere(350);
    glb.normals.clear();
    let count = glb.indices.len() / 3;
    assert!((489_000..500_000).contains(&count), "{count}");
    let (texels, warnings) = read(&[("a.glb", &glb.bytes())], 64, &View::default());
    assert!(texels.is_ok() && warnings.is_empty(), "{warnings}");
    println!("{count} triangles: {:.1?}", start.elapsed());
}
