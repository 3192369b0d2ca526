//! Objects other than the sphere: their files, their pictures, and notes about them.

use crate::support::files::{
    built, eigenvalues, ellipsoid, facets, gray_png, normal_map, obj, ply, square_png, stl, table,
    with_geometry,
};
use crate::support::{
    Folder, NEW_BASIS, assert_contains, assert_fails, assert_near, difference, scene,
};
use crate::tolerances;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_testing::fixtures;
use png::{BitDepth, ColorType};
use std::f64::consts::PI;

/// Eigenvalues of a density that is linear between 401 slants, relative to the largest. Chords of a
/// cosine are too low by the same share everywhere, which normalization removes; the rest decreases
/// with the fourth power of the step of 4e-3.
const TABULATED_DENSITY: f64 = 9e-11;

fn luminance(colors: &[f64]) -> Vec<f64> {
    let of = |[r, g, b]: &[f64; 3]| 0.2126 * r + 0.7152 * g + 0.0722 * b;
    colors.as_chunks().0.iter().map(of).collect()
}

/// The sphere's density as a formula and as a table gives the sphere's eigenvalues; all components
/// of every object give the direct sum.
#[test]
fn every_object_shades_as_the_direct_sum() {
    let steps = (0..=400).map(|k| {
        let a = 0.5 * PI * f64::from(k) / 400.0;
        format!("{a},{}\n", a.cos().max(0.0))
    });
    let table_of_slants = format!("slant,density\n{}", steps.collect::<String>());
    let sphere = eigenvalues(&Folder::with_table());
    let files = [("d.csv", table_of_slants.into_bytes()), ("facets.csv", facets().into_bytes())];
    for (geometry, allowed) in [
        ("normals = \"slant-density\"\ndensity = \"cos(a)\"\n", tolerances::GENERAL_SPHERE),
        ("normals = \"slant-density\"\ndensity = \"d.csv\"\n", TABULATED_DENSITY),
        // Another shape has other eigenvalues.
        ("normals = \"facets.csv\"\n", f64::INFINITY),
    ] {
        let folder = table(geometry, &files);
        assert_near(geometry, &eigenvalues(&folder), &sphere, allowed);
        let reference = folder.shaded("--method modes");
        for method in ["polynomial", "eigen"] {
            for (format, allowed) in
                [("f64", tolerances::GENERAL_PICTURES), ("f32", tolerances::ALL_COMPONENTS_F32)]
            {
                let shaded = folder.shaded(&format!("--method {method} --format {format}"));
                assert_near(
                    &format!("{geometry}, {method}, {format}"),
                    &shaded,
                    &reference,
                    allowed,
                );
            }
        }
        folder.ok("basis --scene scene.toml --check b.bin");
    }
}

/// A pixel of an object costs no more than one of a sphere with as many azimuths: the polynomials
/// are not longer.
#[test]
fn a_pixel_costs_no_more_than_on_a_sphere() {
    let length = |geometry: &str, files: &[(&str, Vec<u8>)]| {
        let folder = built(&with_geometry(geometry).replace("1e-12", "1e-7"), files);
        let owned = OwnedBasis::new(&folder.table("b.bin")).expect("a table for f32");
        owned.basis().expect("a basis").scene_len()
    };
    let sphere = length("normals = \"sphere\"\n", &[]);
    let object = length("normals = \"facets.csv\"\n", &[("facets.csv", facets().into())]);
    println!("{object} numbers, of a sphere {sphere}");
    assert!(object <= sphere, "{object} numbers, of a sphere {sphere}");
}

/// Fixed light, and light that rotates about the vertical axis, have their own components, which
/// give the same pictures.
#[test]
fn fixed_light() {
    for criterion in ["image-centered", "standard"] {
        let mut seen = Vec::new();
        for rotation in ["any", "vertical", "none"] {
            let text = scene(criterion, 10_000, "[]");
            // Not normalized, because the difference of a picture at another exposure from the mean
            // image is not in the span of the database.
            let rotated = format!("rotation = \"{rotation}\"\nnormalize = \"none\"");
            let folder = built(&text.replace("rotation = \"any\"", &rotated), &[]);
            let reference = folder.shaded("--method modes");
            // The statistics are of the luminance. A few fixed lights span no more than it; rotated
            // lights span every channel.
            let ours = folder.shaded("--method polynomial --format f64");
            let [found, expected] = match rotation {
                "none" => [luminance(&ours), luminance(&reference)],
                _ => [ours, reference],
            };
            let what = format!("{criterion}, {rotation}");
            assert_near(&what, &found, &expected, tolerances::ALL_COMPONENTS);
            let values = folder.ok("eigenvalues --table b.bin");
            assert!(!seen.contains(&values), "{rotation}: the same statistics as before");
            seen.push(values);
        }
    }
}

/// Eigenvalues of one mesh from two files, relative to the largest: the same facets in f64.
const SAME_MESH: f64 = 1e-14;

/// As [`SAME_MESH`], with corners in f32.
const SAME_MESH_F32: f64 = 4e-7;

/// Eigenvalues of a sphere from a normal map of 64 x 64, relative to the largest: its rim is
/// jagged, because a pixel is 3 % of the radius.
const NORMAL_MAP: f64 = 0.03;

/// Eigenvalues over normals of 16 bits, relative to the largest.
const SIXTEEN_BITS: f64 = 3e-5;

#[test]
fn a_mesh_is_the_list_of_its_facets() {
    let listed = table("normals = \"facets.csv\"\n", &[("facets.csv", facets().into())]);
    let expected = eigenvalues(&listed);
    for (name, bytes, allowed) in [
        ("m.obj", obj().into_bytes(), SAME_MESH),
        ("m.ply", ply().into_bytes(), SAME_MESH),
        ("m.stl", stl(), SAME_MESH_F32),
    ] {
        let mesh = table(&format!("normals = \"{name}\"\n"), &[(name, bytes)]);
        assert_near(name, &eigenvalues(&mesh), &expected, allowed);
    }
}

#[test]
fn a_normal_map_of_a_sphere_is_nearly_the_sphere() {
    let expected = eigenvalues(&Folder::with_table());
    for bits in [BitDepth::Eight, BitDepth::Sixteen] {
        let folder = table("normals = \"n.png\"\n", &[("n.png", normal_map(bits))]);
        assert_near(&format!("{bits:?}"), &eigenvalues(&folder), &expected, NORMAL_MAP);
    }
}

/// A mask that leaves a piece at the upper right, which differs from its mirror images: under fixed
/// light, the same as a list of those normals.
#[test]
fn a_mask_hides_normals() {
    let mask: Vec<u8> =
        (0..64 * 64).map(|k| if k % 64 >= 32 && k / 64 < 24 { 255 } else { 0 }).collect();
    let captured = |geometry: &str, files: &[(&str, Vec<u8>)]| {
        eigenvalues(&built(&with_geometry(geometry).replace("\"any\"", "\"none\""), files))
    };
    // The mask has the columns with x > 0 and the rows with y > 1/4.
    let mut piece = fixtures::disc(64);
    piece.retain(|[x, y, _]| *x > 0.0 && *y > 0.25);
    let list = |[sx, sy]: [f64; 2]| {
        let rows = piece.iter().map(|[x, y, z]| format!("{},{},{z}\n", sx * x, sy * y));
        let text = format!("x,y,z\n{}", rows.collect::<String>());
        captured("normals = \"piece.csv\"\n", &[("piece.csv", text.into())])
    };
    let masked = captured(
        "normals = \"n.png\"\nmask = \"mask.png\"\n",
        &[("n.png", normal_map(BitDepth::Sixteen)), ("mask.png", gray_png(64, 64, &mask))],
    );
    assert_near("the list", &masked, &list([1.0, 1.0]), SIXTEEN_BITS);
    for mirrored in [[-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]] {
        let found = difference(&masked, &list(mirrored));
        assert!(found > 100.0 * SIXTEEN_BITS, "{mirrored:?}: {found:e}");
    }
}

/// A leading minus binds less tightly than a power.
#[test]
fn formulas_are_read_as_written() {
    let of = |density: &str| {
        eigenvalues(&table(&format!("normals = \"slant-density\"\ndensity = \"{density}\"\n"), &[]))
    };
    for (short, explicit) in [("exp(-a^2)", "exp(0-a*a)"), ("2 - -a^2", "2+a*a")] {
        assert_near(short, &of(short), &of(explicit), SAME_MESH);
    }
    let found = difference(&of("exp(-a^2)"), &of("exp(a^2)"));
    assert!(found > NORMAL_MAP, "{found:e}");
}

/// `render` draws a sphere whatever the table's object is, and a note says so.
#[test]
fn a_picture_of_another_object_has_a_note() {
    let render = "render -t b.bin --light lights.csv:light-0 --material materials.csv:material-0 \
                  --size 16 --out p.png";
    let shown = "; draw the object with `render --normals OBJECT`";
    for (geometry, name) in [
        ("normals = \"facets.csv\"\n", Some("`facets.csv`")),
        ("normals = \"slant-density\"\ndensity = \"cos(a)\"\n", Some("`slant-density cos(a)`")),
        ("normals = \"sphere\"\n", None),
    ] {
        let folder = table(geometry, &[("facets.csv", facets().into())]);
        let message = folder.notes(render);
        match name {
            Some(name) => {
                assert!(message.starts_with("note: ") && message.lines().count() == 1, "{message}");
                assert_contains(&message, &[name, "sphere", "b.bin", shown]);
            }
            None => assert_eq!(message, ""),
        }
    }
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
        ("after blanks", format!("\u{feff}\n \t{text}\n\n").into_bytes()),
        ("nameless", text.replace(" egg", "").into_bytes()),
        ("Windows line ends", text.replace('\n', "\r\n").into_bytes()),
        ("two solids", (solid("a b", halves.0) + &solid("c", halves.1)).into_bytes()),
        ("not UTF-8", [&b"solid \xe9\n"[..], &text.as_bytes()[10..]].concat()),
        ("binary solid", binary.clone()),
        ("binary SOLID", upper),
        ("bytes after the last facet", longer),
    ] {
        let found = eigenvalues(&table("normals = \"m.stl\"\n", &[("m.stl", bytes)]));
        assert_near(name, &found, &expected, SAME_MESH_F32);
    }
    let folder = Folder::new();
    folder.write("scene.toml", with_geometry("normals = \"m.stl\"\n"));
    for (bytes, fragments) in [
        (text.as_bytes()[..text.len() / 2].to_vec(), "endsolid"),
        (text.replacen("vertex", "corner", 1).into_bytes(), "corner"),
        (text.replacen("vertex", "vertex nan", 1).into_bytes(), "vertex"),
        (b"solid".to_vec(), "endsolid"),
        (b"solid\nendsolid\n".to_vec(), "no triangle"),
        (binary[..5000].to_vec(), "promise"),
    ] {
        folder.write("m.stl", bytes);
        assert_fails(&folder, NEW_BASIS, &["m.stl", fragments]);
    }
}

/// `basis` and `read` agree on which pixels of a normal map are background and which are errors.
#[test]
fn normal_maps_have_one_rule() {
    let folder = table("normals = \"sphere\"\n", &[]);
    folder.write("scene.toml", with_geometry("normals = \"n.png\"\n"));
    folder.write("masked.toml", with_geometry("normals = \"n.png\"\nmask = \"mask.png\"\n"));
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
    // The number of pixels without a normal, according to the table and to `read`.
    let without = || {
        folder.ok("basis --scene scene.toml --out object.bin");
        let general = folder.table("object.bin").general;
        let message = folder.messages(read);
        std::fs::remove_file(folder.path("new.csv")).expect("an answer");
        let report = message.split("left out: ").nth(1).and_then(|rest| rest.split(' ').next());
        let report: usize = report.and_then(|count| count.parse().ok()).expect("a count");
        [size * size - general.expect("an object").normals, report]
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
        assert_eq!(without(), [expected; 2], "{name}");
    }
    folder.write("n.png", map([0.7, 0.5, 0.1, 1.0]));

    for command in [NEW_BASIS, read] {
        assert_fails(&folder, command, &["n.png", "pixel 0, 0", "away"]);
    }
    folder.ok("basis --scene masked.toml --out new.bin");
    folder.ok(&format!("{read} --mask mask.png"));
}
