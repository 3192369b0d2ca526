//! Objects other than the sphere, through the command line.

mod support;

#[path = "../../../tests/tolerances/mod.rs"]
mod tolerances;

use eigenshade_cli::owned_basis::OwnedBasis;
use std::f64::consts::{PI, TAU};
use std::fmt::Write;
use support::{Folder, assert_fails, numbers, rows, scene};

const PAIR: &str = "--lights lights.csv --materials materials.csv --normals normals.csv";

/// The small scene with another `[geometry]`, every component.
fn with_geometry(geometry: &str) -> String {
    let text = scene("image-centered", 10_000, "[]");
    text.replace("normals = \"sphere\"\n", geometry)
}

/// A folder with the table of this geometry.
fn table(geometry: &str, files: &[(&str, Vec<u8>)]) -> Folder {
    let folder = Folder::new();
    for (name, bytes) in files {
        folder.write(name, bytes);
    }
    folder.write("scene.toml", with_geometry(geometry));
    folder.ok("basis --scene scene.toml --out b.bin");
    folder
}

fn shaded(folder: &Folder, options: &str) -> Vec<f64> {
    numbers(
        &rows(&folder.ok(&format!("shade b.bin {PAIR} {options}")), "light,material,normal,r,g,b"),
        3,
    )
}

/// Eigenvalues but for the constant's empty one.
fn eigenvalues(folder: &Folder) -> Vec<f64> {
    let text = folder.ok("eigenvalues b.bin");
    let rows = rows(&text, "criterion,index,m,eigenvalue");
    rows[1..].iter().map(|row| row[3].parse().expect("a number")).collect()
}

/// Largest |a - b|, of the largest |b|.
fn apart(a: &[f64], b: &[f64]) -> f64 {
    let peak = b.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    a.iter().zip(b).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs())) / peak
}

fn luminance(colours: &[f64]) -> Vec<f64> {
    let of = |[r, g, b]: &[f64; 3]| 0.2126 * r + 0.7152 * g + 0.0722 * b;
    colours.as_chunks().0.iter().map(of).collect()
}

/// An ellipsoid: corners, and triangles counterclockwise seen from outside.
fn ellipsoid() -> (Vec<[f64; 3]>, Vec<[usize; 3]>) {
    let (rings, around) = (24, 48);
    let mut corners = Vec::new();
    for ring in 0..=rings {
        let (sine, cosine) = (PI * f64::from(ring) / f64::from(rings)).sin_cos();
        for k in 0..around {
            let (y, x) = (TAU * f64::from(k) / f64::from(around)).sin_cos();
            corners.push([sine * x, 0.7 * sine * y, 1.3 * cosine]);
        }
    }
    let mut triangles = Vec::new();
    let at = |ring: i32, k: i32| (ring * around + k % around) as usize;
    for ring in 0..rings {
        for k in 0..around {
            let (a, b) = (at(ring, k), at(ring, k + 1));
            let (c, d) = (at(ring + 1, k), at(ring + 1, k + 1));
            // Those at the poles have no area.
            triangles.extend([[a, c, b], [b, c, d]]);
        }
    }
    (corners, triangles)
}

fn obj() -> String {
    let (corners, triangles) = ellipsoid();
    let mut text = String::new();
    for [x, y, z] in corners {
        writeln!(text, "v {x} {y} {z}").expect("text");
    }
    for [a, b, c] in triangles {
        writeln!(text, "f {} {} {}", a + 1, b + 1, c + 1).expect("text");
    }
    text
}

fn ply() -> String {
    let (corners, triangles) = ellipsoid();
    let mut text = format!(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\n\
         property double z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
        corners.len(),
        triangles.len()
    );
    for [x, y, z] in corners {
        writeln!(text, "{x} {y} {z}").expect("text");
    }
    for [a, b, c] in triangles {
        writeln!(text, "3 {a} {b} {c}").expect("text");
    }
    text
}

fn stl() -> Vec<u8> {
    let (corners, triangles) = ellipsoid();
    let mut bytes = vec![0; 80];
    bytes.extend((triangles.len() as u32).to_le_bytes());
    for triangle in triangles {
        bytes.extend([0; 12]);
        for corner in triangle {
            bytes.extend(corners[corner].iter().flat_map(|&x| (x as f32).to_le_bytes()));
        }
        bytes.extend([0; 2]);
    }
    bytes
}

/// The facets of the ellipsoid, as a list of normals with weights.
fn facets() -> String {
    let (corners, triangles) = ellipsoid();
    let mut text = "x,y,z,weight\n".to_owned();
    for [a, b, c] in triangles {
        let [a, b, c] = [corners[a], corners[b], corners[c]];
        let (u, v) = ([0, 1, 2].map(|k| b[k] - a[k]), [0, 1, 2].map(|k| c[k] - a[k]));
        let cross = |i: usize, j: usize| u[i] * v[j] - u[j] * v[i];
        let (x, y, z) = (cross(1, 2), cross(2, 0), cross(0, 1));
        // Facets seen edge on are rounding.
        if z > 1e-12 {
            writeln!(text, "{x},{y},{z},{z}").expect("text");
        }
    }
    text
}

#[test]
fn a_mesh_is_the_list_of_its_facets() {
    let listed = table("normals = \"facets.csv\"\n", &[("facets.csv", facets().into())]);
    let expected = eigenvalues(&listed);
    for (name, bytes, allowed) in [
        ("m.obj", obj().into_bytes(), tolerances::SAME_MESH),
        ("m.ply", ply().into_bytes(), tolerances::SAME_MESH),
        ("m.stl", stl(), tolerances::SAME_MESH_F32),
    ] {
        let mesh = table(&format!("normals = \"{name}\"\n"), &[(name, bytes)]);
        let found = eigenvalues(&mesh);
        let found = apart(&found, &expected);
        println!("{name}: {found:e}");
        assert!(found < allowed, "{name}: {found:e}");
    }
}

/// A disc of a sphere's normals, a pixel each.
fn normal_map(bits: png::BitDepth) -> Vec<u8> {
    let size = 64u32;
    let mut samples = Vec::new();
    for row in 0..size {
        for column in 0..size {
            let at = |k: u32| (f64::from(k) + 0.5) / f64::from(size) * 2.0 - 1.0;
            let (x, y) = (at(column), -at(row));
            let square = 1.0 - x * x - y * y;
            let alpha = if square > 0.0 { 1.0 } else { 0.0 };
            let z = square.max(0.0).sqrt();
            samples.extend([(x + 1.0) / 2.0, (y + 1.0) / 2.0, (z + 1.0) / 2.0, alpha]);
        }
    }
    encode(size, png::ColorType::Rgba, bits, &samples)
}

fn encode(size: u32, colour: png::ColorType, bits: png::BitDepth, samples: &[f64]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, size, size);
    encoder.set_color(colour);
    encoder.set_depth(bits);
    let data: Vec<u8> = match bits {
        png::BitDepth::Sixteen => {
            let word = |value: &f64| ((value * 65_535.0).round() as u16).to_be_bytes();
            samples.iter().flat_map(word).collect()
        }
        _ => samples.iter().map(|value| (value * 255.0).round() as u8).collect(),
    };
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(&data).expect("an image");
    writer.finish().expect("an end");
    bytes
}

#[test]
fn a_normal_map_of_a_sphere_is_nearly_the_sphere() {
    let sphere = table("normals = \"sphere\"\n", &[]);
    let expected = eigenvalues(&sphere);
    for (bits, allowed) in [
        (png::BitDepth::Eight, tolerances::NORMAL_MAP),
        (png::BitDepth::Sixteen, tolerances::NORMAL_MAP),
    ] {
        let folder = table("normals = \"n.png\"\n", &[("n.png", normal_map(bits))]);
        let found = apart(&eigenvalues(&folder), &expected);
        println!("{bits:?}: {found:e}");
        assert!(found < allowed, "{bits:?}: {found:e}");
    }
}

/// A mask leaves a piece to the right and above, as unlike its mirror images as can be:
/// under light that does not turn, as a list of those normals.
#[test]
fn a_mask_hides_normals() {
    let counts = |row: i32, column: i32| column >= 32 && row < 24;
    let map = normal_map(png::BitDepth::Sixteen);
    let mask: Vec<f64> =
        (0..64 * 64).map(|k| f64::from(u8::from(counts(k / 64, k % 64)))).collect();
    let mask = encode(64, png::ColorType::Grayscale, png::BitDepth::Eight, &mask);
    let captured = |geometry: &str, files: &[(&str, Vec<u8>)]| {
        let folder = Folder::new();
        for (name, bytes) in files {
            folder.write(name, bytes);
        }
        let text = with_geometry(geometry).replace("\"any\"", "\"none\"");
        folder.write("scene.toml", text);
        folder.ok("basis --scene scene.toml --out b.bin");
        eigenvalues(&folder)
    };
    let list = |[sx, sy]: [f64; 2]| {
        let mut text = "x,y,z\n".to_owned();
        for row in 0..64 {
            for column in 0..64 {
                let at = |k: i32| (f64::from(k) + 0.5) / 32.0 - 1.0;
                let (x, y) = (at(column), -at(row));
                let square = 1.0 - x * x - y * y;
                if square > 0.0 && counts(row, column) {
                    writeln!(text, "{},{},{}", sx * x, sy * y, square.sqrt()).expect("text");
                }
            }
        }
        captured("normals = \"piece.csv\"\n", &[("piece.csv", text.into())])
    };
    let masked = captured(
        "normals = \"n.png\"\nmask = \"mask.png\"\n",
        &[("n.png", map), ("mask.png", mask)],
    );
    let found = apart(&masked, &list([1.0, 1.0]));
    println!("{found:e}");
    assert!(found < tolerances::SIXTEEN_BITS, "{found:e}");
    for mirrored in [[-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]] {
        let found = apart(&masked, &list(mirrored));
        assert!(found > 100.0 * tolerances::SIXTEEN_BITS, "{mirrored:?}: {found:e}");
    }
}

/// The sphere's density as a formula and as a table is the sphere; all components give
/// the direct sum for every object.
#[test]
fn every_object_shades_as_the_direct_sum() {
    let steps = (0..=400).map(|k| {
        let a = 0.5 * PI * f64::from(k) / 400.0;
        format!("{a},{}\n", a.cos().max(0.0))
    });
    let table_of_slants = format!("slant,density\n{}", steps.collect::<String>());
    let sphere = eigenvalues(&table("normals = \"sphere\"\n", &[]));
    for (geometry, files) in [
        ("normals = \"slant-density\"\ndensity = \"cos(a)\"\n", vec![]),
        (
            "normals = \"slant-density\"\ndensity = \"d.csv\"\n",
            vec![("d.csv", table_of_slants.into_bytes())],
        ),
        ("normals = \"facets.csv\"\n", vec![("facets.csv", facets().into_bytes())]),
    ] {
        let folder = table(geometry, &files);
        let found = apart(&eigenvalues(&folder), &sphere);
        println!("{geometry:?}: eigenvalues {found:e}");
        if geometry.contains("cos(a)") {
            assert!(found < tolerances::GENERAL_SPHERE, "{found:e}");
        } else if geometry.contains("d.csv") {
            assert!(found < tolerances::TABULATED_DENSITY, "{found:e}");
        }
        let truth = shaded(&folder, "--method modes");
        for method in ["polynomial", "eigen"] {
            let found = apart(&shaded(&folder, &format!("--method {method} --format f64")), &truth);
            println!("{geometry:?}, {method}: {found:e}");
            assert!(found < tolerances::GENERAL_PICTURES, "{method}: {found:e}");
            let found = apart(&shaded(&folder, &format!("--method {method}")), &truth);
            println!("{geometry:?}, {method}, f32: {found:e}");
            assert!(found < tolerances::ALL_COMPONENTS_F32, "{method}: {found:e}");
        }
        folder.ok("basis --scene scene.toml --check b.bin");
    }
}

/// A pixel of an object costs what one of a sphere with as many azimuths costs: the
/// polynomials are no longer.
#[test]
fn a_pixel_costs_what_it_costs_on_a_sphere() {
    let length = |geometry: &str, files: &[(&str, Vec<u8>)]| {
        let folder = Folder::new();
        for (name, bytes) in files {
            folder.write(name, bytes);
        }
        let text = with_geometry(geometry).replace("1e-12", "1e-7");
        folder.write("scene.toml", text);
        folder.ok("basis --scene scene.toml --out b.bin");
        let bytes = std::fs::read(folder.path("b.bin")).expect("a table");
        let owned = OwnedBasis::<f32>::new(&eigenshade_table::decode(&bytes).expect("a table"));
        owned.basis().expect("a basis").scene_len()
    };
    let sphere = length("normals = \"sphere\"\n", &[]);
    let object = length("normals = \"facets.csv\"\n", &[("facets.csv", facets().into())]);
    println!("{object} numbers, of a sphere {sphere}");
    assert!(object <= sphere, "{object} numbers, of a sphere {sphere}");
}

/// A leading minus is weaker than a power.
#[test]
fn formulas_are_read_as_written() {
    let of = |density: &str| {
        eigenvalues(&table(&format!("normals = \"slant-density\"\ndensity = \"{density}\"\n"), &[]))
    };
    for (short, explicit) in [("exp(-a^2)", "exp(0-a*a)"), ("2 - -a^2", "2+a*a")] {
        let found = apart(&of(short), &of(explicit));
        assert!(found < tolerances::SAME_MESH, "{short}: {found:e}");
    }
    let found = apart(&of("exp(-a^2)"), &of("exp(a^2)"));
    assert!(found > tolerances::NORMAL_MAP, "{found:e}");
}

/// Light that does not turn, or turns about the vertical axis, has its own components,
/// which give the same pictures.
#[test]
fn light_that_does_not_turn() {
    for criterion in ["image-centered", "standard"] {
        let mut seen = Vec::new();
        for rotation in ["any", "vertical", "none"] {
            let folder = Folder::new();
            let text = scene(criterion, 10_000, "[]");
            // Exposures as they are: an image at another one differs from the mean image
            // by more than the database's images do.
            let rotated = format!("rotation = \"{rotation}\"\nnormalise = \"none\"");
            let rotated = text.replace("rotation = \"any\"", &rotated);
            folder.write("scene.toml", rotated);
            folder.ok("basis --scene scene.toml --out b.bin");
            let truth = shaded(&folder, "--method modes");
            // As captured, a few lights span no more than their luminance, which the
            // statistics are of; turned lights span every channel.
            let ours = shaded(&folder, "--method polynomial --format f64");
            let found = match rotation {
                "none" => apart(&luminance(&ours), &luminance(&truth)),
                _ => apart(&ours, &truth),
            };
            println!("{criterion}, {rotation}: {found:e}");
            assert!(found < tolerances::ALL_COMPONENTS, "{criterion}, {rotation}: {found:e}");
            let values = folder.ok("eigenvalues b.bin");
            assert!(!seen.contains(&values), "{rotation} is no other statistics");
            seen.push(values);
        }
    }
}

#[test]
fn bad_objects() {
    let folder = Folder::new();
    folder.write("cut.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
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
