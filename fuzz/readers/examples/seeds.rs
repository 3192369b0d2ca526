//! Writes the readers' seed corpora: `cargo run -p eigenshade-fuzz-readers --example seeds`.
//! A small file of each kind that is read.

use eigenshade_fuzz_readers::{LIGHTS, MATERIALS};
use eigenshade_generator::scene_file;
use eigenshade_table::encode;
use exr::prelude::{Encoding, Image, SpecificChannels, WritableImage};
use png::{BitDepth, ColorType};
use std::path::Path;

const CORNERS: [[f32; 3]; 4] = [[0., 0., 1.], [1., 0., 0.], [-0.5, 0.8, 0.], [-0.5, -0.8, 0.]];
const FACETS: [[usize; 3]; 3] = [[0, 1, 2], [0, 2, 3], [0, 3, 1]];
const SCENE: &str = "[geometry]\nnormals = \"sphere\"\n[light]\ndegree = 1\ndatabase = \
     \"lights.csv\"\nrotation = \"any\"\n[material]\norder = 0\ndatabase = \"materials.csv\"\n\
     [basis]\ncriterion = \"image-centered\"\ncomponents = 3\n";

fn main() {
    let floats: Vec<u8> = (0..24u8).flat_map(|k| f32::from(k).to_le_bytes()).collect();
    put("pfm", "rgb", [b"PF\n4 2\n-1.0\n", &floats[..]].concat());
    put("pfm", "gray", [b"Pf\n4 2\n-1.0\n", &floats[..32]].concat());
    let radiance =
        |width: usize| format!("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X {width}\n");
    put("hdr", "flat", [radiance(4).as_bytes(), &[128, 64, 32, 129].repeat(4)].concat());
    let runs: Vec<u8> = [[136, 128], [136, 64], [136, 32], [136, 129]].concat();
    put("hdr", "runs", [radiance(8).as_bytes(), &[2, 2, 0, 8], &runs].concat());
    for (name, encoding) in [
        ("plain", Encoding::UNCOMPRESSED),
        ("runs", Encoding::FAST_LOSSLESS),
        ("zip", Encoding::SMALL_LOSSLESS),
    ] {
        let texels = SpecificChannels::rgb(|at: exr::math::Vec2<usize>| {
            (at.x() as f32, at.y() as f32, 1.0f32)
        });
        let image = Image::from_encoded_channels((4, 2), encoding, texels);
        let mut bytes = std::io::Cursor::new(Vec::new());
        image.write().to_buffered(&mut bytes).expect("a map");
        put("exr", name, bytes.into_inner());
    }
    for (name, color, depth, bytes) in [
        ("rgb8", ColorType::Rgb, BitDepth::Eight, 24),
        ("rgb16", ColorType::Rgb, BitDepth::Sixteen, 48),
        ("gray8", ColorType::Grayscale, BitDepth::Eight, 8),
        ("rgba8", ColorType::Rgba, BitDepth::Eight, 32),
    ] {
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, 4, 2);
        encoder.set_color(color);
        encoder.set_depth(depth);
        let mut writer = encoder.write_header().expect("a header");
        writer.write_image_data(&vec![200; bytes]).expect("an image");
        writer.finish().expect("a file");
        put("png", name, file);
    }
    meshes();
    lists();
    let header: Vec<u8> = [90i32, 90, 180].into_iter().flat_map(i32::to_le_bytes).collect();
    put("merl", "header", [&[0][..], &header].concat());
    put("merl", "gray", [&[1][..], &header, &30f64.to_le_bytes()].concat());
    for (name, text) in [
        ("sphere", "cos(a)"),
        ("number", "1.5e-3"),
        ("all", "-(a^2)*sin(a)/(1+exp(a))+2.5E2%3"),
        ("constant", "PI - a"),
    ] {
        put("formula", name, text);
    }
    let folder = std::env::temp_dir().join(format!("eigenshade-seeds-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    let files = [("lights.csv", LIGHTS), ("materials.csv", MATERIALS), ("scene.toml", SCENE)];
    files.iter().for_each(|(name, text)| std::fs::write(folder.join(name), text).expect("a file"));
    let table = scene_file::load(folder.join("scene.toml")).and_then(|scene| scene.build());
    let table = encode(&table.expect("a table"));
    put("bin", "payload", [&[0], &table[24..]].concat());
    put("bin", "table", table);
    std::fs::remove_dir_all(&folder).expect("a folder");
}

fn meshes() {
    let text = |numbers: &[f32]| numbers.iter().map(f32::to_string).collect::<Vec<_>>().join(" ");
    let corners: String = CORNERS.iter().map(|one| format!("v {}\n", text(one))).collect();
    let faces: String =
        FACETS.iter().map(|[a, b, c]| format!("f {} {} {}\n", a + 1, b + 1, c + 1)).collect();
    put("obj", "tent", corners + &faces);
    let facet = |facet: &[usize; 3]| {
        let corners = facet.iter().map(|&k| format!("vertex {}\n", text(&CORNERS[k])));
        let corners: String = corners.collect();
        format!("facet normal 0 0 0\nouter loop\n{corners}endloop\nendfacet\n")
    };
    let facets: String = FACETS.iter().map(facet).collect();
    put("stl", "text", format!("solid tent\n{facets}endsolid tent\n"));
    let mut binary = vec![0; 80];
    binary.extend((FACETS.len() as u32).to_le_bytes());
    for facet in FACETS {
        binary.extend([0; 12]);
        binary.extend(facet.iter().flat_map(|&k| CORNERS[k]).flat_map(f32::to_le_bytes));
        binary.extend([0; 2]);
    }
    put("stl", "binary", binary);
    let head = |format: &str| {
        format!(
            "ply\nformat {format} 1.0\nelement vertex 4\nproperty float x\nproperty float y\n\
             property float z\nelement face 3\nproperty list uchar int vertex_indices\nend_header\n"
        )
    };
    let corners: String = CORNERS.iter().map(|one| text(one) + "\n").collect();
    let faces: String = FACETS.iter().map(|[a, b, c]| format!("3 {a} {b} {c}\n")).collect();
    put("ply", "text", head("ascii") + &corners + &faces);
    for (name, format, little) in
        [("little", "binary_little_endian", true), ("big", "binary_big_endian", false)]
    {
        let mut binary = head(format).into_bytes();
        let long = |word: u32, to: &mut Vec<u8>| {
            to.extend(if little { word.to_le_bytes() } else { word.to_be_bytes() });
        };
        CORNERS.iter().flatten().for_each(|x| long(x.to_bits(), &mut binary));
        for facet in FACETS {
            binary.push(3);
            facet.iter().for_each(|&k| long(k as u32, &mut binary));
        }
        put("ply", name, binary);
    }
}

fn lists() {
    for (kind, name, text) in [
        (0, "lights", LIGHTS),
        (1, "materials", MATERIALS),
        (2, "normals", "x,y,z\n0,0,1\n0.6,0,0.8\n"),
        (3, "facets", "x,y,z,weight\n0,0,1,1\n0.6,0,0.8,0.5\n"),
        (4, "measured", "theta_i,phi_i,theta_r,phi_r,r,g,b\n0.1,0,0.2,0,1,1,0.5\n"),
        (5, "slants", "slant,density\n0,1\n0.7,0.5\n1.5,0\n"),
    ] {
        put("csv", name, [&[kind], text.as_bytes()].concat());
    }
    put("toml", "scene", SCENE);
    let density = "normals = \"slant-density\"\ndensity = \"cos(a)\"";
    put("toml", "density", SCENE.replace("normals = \"sphere\"", density));
    put(
        "toml",
        "materials",
        "[[material]]\nname = \"a\"\nmodel = \"ggx\"\nroughness = 0.4\nf0 = [1, 0.5, 0]\n\
         [[material]]\nname = \"b\"\nmodel = \"oren-nayar\"\nsigma = 0.3\nalbedo = 0.5\n",
    );
}

fn put(reader: &str, name: &str, bytes: impl AsRef<[u8]>) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("seeds").join(format!("read_{reader}"));
    std::fs::create_dir_all(&folder).expect("a folder");
    std::fs::write(folder.join(name), bytes).expect("a seed");
}
