//! Smooth normals of meshes: those of the file, and those from angles.

use eigenshade_generator::object::picture::{Picture, Shown};
use eigenshade_generator::object::surface::View;
use eigenshade_model::inputs::input_file::InputFile;
use std::cell::RefCell;
use std::fmt::Write;
use std::path::Path;

/// Degrees between the normals of a sphere of 512 triangles and the true ones at the same place,
/// rms over its picture: chords, whose points are a little inside the sphere, and the rim, where
/// the outline of the mesh is.
const SMOOTH_SPHERE: f64 = 1.5;

/// The same of its flat facets, at least.
const FLAT_SPHERE: f64 = 3.5;

/// A sphere of radius 1: an octahedron whose triangles are cut into four, thrice or twice.
fn sphere(cuts: usize) -> Vec<[[f64; 3]; 3]> {
    let unit = |p: [f64; 3]| {
        let length = p.iter().map(|x| x * x).sum::<f64>().sqrt();
        p.map(|x| x / length)
    };
    let mut triangles = Vec::new();
    for signs in 0..8 {
        let [x, y, z] = [1, 2, 4].map(|bit| if signs & bit == 0 { 1.0 } else { -1.0 });
        let [a, b, c] = [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]];
        triangles.push(if x * y * z > 0.0 { [a, b, c] } else { [a, c, b] });
    }
    for _ in 0..cuts {
        let middle = |a: [f64; 3], b: [f64; 3]| unit([0, 1, 2].map(|k| a[k] + b[k]));
        let cut = |[a, b, c]: [[f64; 3]; 3]| {
            let (d, e, f) = (middle(a, b), middle(b, c), middle(c, a));
            [[a, d, f], [d, b, e], [f, e, c], [d, e, f]]
        };
        triangles = triangles.into_iter().flat_map(cut).collect();
    }
    triangles
}

/// Triangles as an OBJ; the normal of a corner is its position.
fn obj(triangles: &[[[f64; 3]; 3]], has_normals: bool) -> String {
    let mut text = String::new();
    for (number, triangle) in triangles.iter().enumerate() {
        for [x, y, z] in triangle {
            writeln!(text, "v {x} {y} {z}\nvn {x} {y} {z}").expect("text");
        }
        let [a, b, c] = [1, 2, 3].map(|k| 3 * number + k);
        match has_normals {
            true => writeln!(text, "f {a}//{a} {b}//{b} {c}//{c}"),
            false => writeln!(text, "f {a} {b} {c}"),
        }
        .expect("text");
    }
    text
}

fn ply(triangles: &[[[f64; 3]; 3]]) -> String {
    let mut text = format!(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\n\
         property double z\nproperty float nx\nproperty float ny\nproperty float nz\n\
         element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        3 * triangles.len(),
        triangles.len()
    );
    for [x, y, z] in triangles.iter().flatten() {
        writeln!(text, "{x} {y} {z} {x} {y} {z}").expect("text");
    }
    for k in 0..triangles.len() {
        writeln!(text, "3 {} {} {}", 3 * k, 3 * k + 1, 3 * k + 2).expect("text");
    }
    text
}

fn stl(triangles: &[[[f64; 3]; 3]]) -> String {
    let mut text = "solid s\n".to_owned();
    for triangle in triangles {
        text.push_str("facet normal 0 0 1\nouter loop\n");
        for [x, y, z] in triangle {
            writeln!(text, "vertex {x} {y} {z}").expect("text");
        }
        text.push_str("endloop\nendfacet\n");
    }
    text + "endsolid s\n"
}

thread_local! {
    static WARNINGS: RefCell<Vec<String>> = const { RefCell::new(Vec::new()) };
}

/// The picture of a file of this text, and its warnings.
fn drawn(name: &str, text: &str, view: &View) -> (Result<Picture, String>, String) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join(name);
    std::fs::write(&path, text).expect("a file");
    let warn = |_: &Path, what: &str| WARNINGS.with_borrow_mut(|all| all.push(what.to_owned()));
    let file = InputFile::from(path).with_warnings(warn);
    let picture = Picture::of_mesh(file, 96, view).map_err(|error| error.to_string());
    (picture, WARNINGS.take().join("\n"))
}

fn good(name: &str, text: &str, view: &View) -> Picture {
    let (picture, warnings) = drawn(name, text, view);
    assert_eq!(warnings, "", "{name}");
    picture.expect(name)
}

/// Asserts that two pictures are the same up to rounding.
fn assert_same(found: &Picture, expected: &Picture) {
    let apart = |(one, other): (&Option<Shown>, &Option<Shown>)| match (one, other) {
        (None, None) => 0.0,
        (Some(one), Some(other)) if one.coverage == other.coverage => {
            let parts = one.normal.iter().zip(other.normal).map(|(a, b)| (a - b).abs());
            parts.fold(0.0, f64::max)
        }
        _ => f64::INFINITY,
    };
    assert_eq!(found.pixels.len(), expected.pixels.len());
    let most = found.pixels.iter().zip(&expected.pixels).map(apart).fold(0.0, f64::max);
    assert!(most < 1e-9, "{most:e}");
}

const FLAT: View =
    View { is_flat: true, rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] };

/// Degrees between the normals of a picture and those of a sphere, rms over the whole pixels.
fn off_sphere(picture: &Picture) -> f64 {
    let (radius, middle) = (0.5 * picture.width as f64 - 0.5, 0.5 * picture.width as f64);
    let (mut sum, mut count) = (0.0, 0.0);
    for (place, pixel) in picture.pixels.iter().enumerate() {
        let Some(shown) = pixel.filter(|shown| shown.coverage == 1.0) else { continue };
        let (row, column) = (place / picture.width, place % picture.width);
        let x = (column as f64 + 0.5 - middle) / radius;
        let y = (middle - row as f64 - 0.5) / radius;
        let z = (1.0 - x * x - y * y).max(0.0).sqrt();
        let chord = [x, y, z].iter().zip(shown.normal).map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
        sum += (2.0 * (0.5 * chord.sqrt()).asin()).to_degrees().powi(2);
        count += 1.0;
    }
    assert!(count > 0.7 * middle * middle * 4.0, "{count} pixels");
    f64::sqrt(sum / count)
}

/// A coarse sphere looks smooth, by the normals of its file and by angles alone, in every format.
#[test]
fn a_coarse_sphere_is_smooth() {
    let triangles = sphere(3);
    for (name, text) in [
        ("with.obj", obj(&triangles, true)),
        ("without.obj", obj(&triangles, false)),
        ("with.ply", ply(&triangles)),
        ("without.stl", stl(&triangles)),
    ] {
        let smooth = off_sphere(&good(name, &text, &View::default()));
        let flat = off_sphere(&good(name, &text, &FLAT));
        println!("{name}: {smooth:.2} degrees, flat {flat:.2}");
        assert!(smooth < SMOOTH_SPHERE && flat > FLAT_SPHERE, "{name}: {smooth}, flat {flat}");
    }
}

/// A box keeps its edges, as its facets meet at 90 degrees.
#[test]
fn a_box_stays_sharp() {
    let faces = "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    let corners = "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\n\
                   v -1 1 1\n";
    let (s, c) = 0.6_f64.sin_cos();
    let (t, d) = 0.5_f64.sin_cos();
    let rotation = [[c, 0.0, s], [t * s, d, -t * c], [-d * s, t, d * c]];
    let view = View { is_flat: false, rotation };
    let text = format!("{corners}{faces}");
    let sharp = good("box.obj", &text, &view);
    assert_same(&sharp, &good("box.obj", &text, &View { is_flat: true, ..view }));
    // With normals of the file that point to its corners it is round.
    let normals = corners.replace("v ", "vn ");
    let smooth = (1..9).fold(faces.replace('\n', " \n"), |text, k| {
        text.replace(&format!(" {k} "), &format!(" {k}//{k} "))
    });
    let smooth = format!("{corners}{normals}{smooth}");
    assert!(good("box.obj", &smooth, &view) != sharp);
}

/// Normals that are none, and those that point to the back, are replaced, and the rest is kept.
#[test]
fn wrong_normals_of_a_file() {
    let triangles = sphere(2);
    let expected = good("plain.obj", &obj(&triangles, false), &View::default());
    for normal in ["nan 0 0", "0 0 0", "inf 1 0", "1e999 0 0"] {
        let text = obj(&triangles, true);
        let lines = text.lines().map(|line| match line.starts_with("vn") {
            true => format!("vn {normal}\n"),
            false => format!("{line}\n"),
        });
        let (picture, warning) = drawn("wrong.obj", &lines.collect::<String>(), &View::default());
        assert_same(&picture.expect(normal), &expected);
        let count = 3 * triangles.len();
        assert!(warning.ends_with(&format!("of their facet are replaced: {count}")), "{warning}");
    }
    let back = obj(&triangles, true).replacen("vn 1 0 0", "vn -1 0 0", 1);
    let (picture, warning) = drawn("back.obj", &back, &View::default());
    assert!(picture.is_ok() && warning.ends_with("replaced: 1"), "{warning}");
    // One that does not exist is an error.
    for (from, to) in [("1//1", "1//9999"), ("1//1", "1//0"), ("1//1", "1//x"), ("1//1", "1//-9")] {
        let text = obj(&triangles, true).replacen(&format!("f {from}"), &format!("f {to}"), 1);
        let error = drawn("far.obj", &text, &View::default()).0.expect_err(to);
        assert!(error.contains(&format!("`{to}` is not one of its 384 normals")), "{error}");
    }
}

/// Triangles without area, and pairs of opposite sides, change nothing.
#[test]
fn degenerate_triangles() {
    let triangles = sphere(2);
    let plain = obj(&triangles, false);
    let expected = good("plain.obj", &plain, &View::default());
    let [a, b] = [1, 2];
    assert_same(&good("line.obj", &format!("{plain}f {a} {b} {a}\n"), &View::default()), &expected);
    let inner: String = (0..triangles.len()).fold(String::new(), |text, k| {
        let [a, b, c] = [1, 2, 3].map(|corner| 3 * k + corner);
        text + &format!("f {a} {c} {b}\n")
    });
    assert_same(&good("sheet.obj", &format!("{plain}{inner}"), &View::default()), &expected);
}

/// Views show the sides that their names promise, and rotation is that of the mesh.
#[test]
fn a_rotated_mesh() {
    let triangles = sphere(1);
    let rotation = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let turned: Vec<_> =
        triangles.iter().map(|corners| corners.map(|[x, y, z]| [1.5 * z, 0.7 * x, y])).collect();
    let plain: Vec<_> =
        triangles.iter().map(|corners| corners.map(|[x, y, z]| [0.7 * x, y, 1.5 * z])).collect();
    let view = View { is_flat: true, rotation };
    let expected = good("turned.obj", &obj(&turned, false), &FLAT);
    assert_same(&good("plain.obj", &obj(&plain, false), &view), &expected);
}
