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
        ("binary solid and more", longer),
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
