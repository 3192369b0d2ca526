//! Mesh files of every spelling: comments, line ends, polygons of any shape, and files cut short.

use eigenshade_generator::object::mesh;
use eigenshade_generator::object::surface::View;
use eigenshade_model::error::Result;
use eigenshade_model::inputs::input_file::InputFile;
use std::cell::RefCell;

/// The error of an area, for polygons in a square of side 1 whose corners are rounded to f32.
const ROUNDED: f64 = 1e-6;

/// Normals and projected areas of the facets that face the camera in a file of this text.
fn read(name: &str, text: impl AsRef<[u8]>) -> Result<Vec<([f64; 3], f64)>> {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join(name);
    std::fs::write(&path, text).expect("a file");
    faces(&path.into())
}

fn faces(file: &InputFile) -> Result<Vec<([f64; 3], f64)>> {
    let facets = mesh::surface(file, &View { is_flat: true, ..View::default() })?.facets;
    let facing = facets.iter().filter(|facet| facet.projected_area > 0.0);
    Ok(facing.map(|facet| (facet.normal, facet.projected_area)).collect())
}

#[test]
fn comments_end_with_their_line() {
    let plain = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let expected = read("plain.obj", plain).expect("a mesh");
    assert_eq!(expected.len(), 1);
    for text in [
        &format!("# saved in C:\\models\\\n{plain}"),
        &plain.replace("1 2 3", "1 2 3 # top"),
        &plain.replace("1 2 3", "1 2 3# top \\"),
        &plain.replace("1 2 3", "1 \\\n2 \\\n3 # top"),
        &plain.replace("v 1 0 0", "v 1 0 0 # right"),
    ] {
        assert_eq!(read("with.obj", text).as_ref(), Ok(&expected), "{text}");
    }
}

#[test]
fn lines_end_in_any_way() {
    let text = "# a corner\nv 0 0 0\nv 1 0 0\n\nv 0 1 \\\n0\nf 1 2 3\n";
    let expected = read("plain.obj", text).expect("a mesh");
    assert_eq!(expected.len(), 1);
    for end in ["\r", "\r\n"] {
        let text = text.replace('\n', end);
        assert_eq!(read("with.obj", &text).as_ref(), Ok(&expected), "{end:?}");
        // Blank lines count, so that messages name the line that an editor shows.
        let wrong = text.replace("f 1 2 3", "f 1 2 4");
        let error = read("wrong.obj", &wrong).expect_err("no such corner").to_string();
        assert!(error.contains("line 7"), "{end:?}: {error}");
    }
    // Longer than the buffer of a reader.
    let long = format!("#{}\r\n{text}", "-".repeat(20_000));
    assert_eq!(read("long.obj", &long).as_ref(), Ok(&expected));
}

/// Warnings about a file.
fn warnings(name: &str, bytes: &[u8]) -> String {
    thread_local! {
        static WARNINGS: RefCell<Vec<String>> = const { RefCell::new(Vec::new()) };
    }
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join(name);
    std::fs::write(&path, bytes).expect("a file");
    let file = InputFile::from(path)
        .with_warnings(|_, what| WARNINGS.with_borrow_mut(|all| all.push(what.to_owned())));
    faces(&file).expect("a mesh");
    WARNINGS.take().join("\n")
}

/// A byte order mark in front of a text is no part of it.
#[test]
fn byte_order_marks_are_skipped() {
    let corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nf 1 2 3\nf 3 2 4\n";
    for (name, text) in [
        ("a.obj", corners.to_owned()),
        ("a.obj", format!("# made by hand\n{corners}")),
        ("a.ply", ply(&ARROW, &[0, 1, 2, 3, 4])),
        ("a.stl", TEXT_STL.to_owned()),
    ] {
        let expected = read(name, &text).expect("a mesh");
        assert_eq!(read(name, format!("\u{feff}{text}")), Ok(expected), "{name}");
        let utf_16: Vec<u8> =
            format!("\u{feff}{text}").encode_utf16().flat_map(u16::to_le_bytes).collect();
        let error = read(name, utf_16).expect_err("UTF-16").to_string();
        assert!(name == "a.stl" || error.contains("UTF-16 text; save it as a UTF-8"), "{error}");
    }
}

const TEXT_STL: &str = "solid one\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n\
    vertex 0 1 0\nendloop\nendfacet\nendsolid one\n";

/// The normals of facets are not used, whatever they are.
#[test]
fn normals_of_facets_are_not_read() {
    let expected = read("a.stl", TEXT_STL).expect("a mesh");
    for normal in ["nan nan nan", "-nan(ind) 0 0", "1.#QNAN 0 0", "1e999 0 0"] {
        let text = TEXT_STL.replace("normal 0 0 1", &format!("normal {normal}"));
        assert_eq!(read("a.stl", text).as_ref(), Ok(&expected), "{normal}");
    }
    let facet = [f32::NAN; 3].into_iter().chain([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
    let facet: Vec<u8> = facet.flat_map(f32::to_le_bytes).chain([0; 2]).collect();
    let binary = [&[0; 80][..], &[1, 0, 0, 0], &facet].concat();
    assert_eq!(read("a.stl", &binary).as_ref(), Ok(&expected));
    assert_eq!(warnings("a.stl", &binary), "");
    // Bytes that follow are no facet.
    let tail = [&binary[..], b"tail\n"].concat();
    assert_eq!(read("a.stl", &tail).as_ref(), Ok(&expected));
    assert_eq!(warnings("a.stl", &tail), "bytes after its last facet are ignored: 5");
    let error = read("a.stl", [&binary[..], &facet].concat()).expect_err("one more").to_string();
    assert!(error.contains("134 bytes promised by its header, 184 found"), "{error}");
}

/// Numbers of text as C prints and scans them, and lines without any.
#[test]
fn polygon_files_of_every_spelling() {
    let plain = ply(&ARROW, &[0, 1, 2, 3, 4]);
    let expected = read("a.ply", &plain).expect("a mesh");
    let (head, body) = plain.split_once("end_header\n").expect("a header");
    let body = body.replace("0.5 0.25", ".5 +.25");
    let spelled = body.replace("1 0 0\n", "1. 0e0 -0.\n\n  \n");
    for text in [
        format!("{head}end_header\n\n{spelled}"),
        plain.replace('\n', "\r\n"),
        // Normals are not used, and may be none.
        format!("{head}end_header\n{body}")
            .replace("property float z\n", "property float z\nproperty float nx\n")
            .replace(" 0\n", " 0 nan\n"),
    ] {
        assert_eq!(read("a.ply", &text).as_ref(), Ok(&expected), "{text}");
    }
    for (from, to, what) in [
        (
            "0.5 0.25",
            "0.5 x",
            "row 4 of 5 of element `vertex`: it is not a complete PLY file (`x` is",
        ),
        ("0.5 0.25 0", "0.5 0.25", "(it has too few numbers)"),
        ("0.5 0.25 0", "0.5 0.25 0 9", "(`9` follows its last number)"),
        ("5 0 1 2", "5 0 1.5 2", "corner 1.5 does not exist"),
        ("5 0 1 2", "5 0 1 -2", "corner -2 does not exist"),
    ] {
        let error = read("a.ply", plain.replace(from, to)).expect_err(what).to_string();
        assert!(error.contains(what), "{error}");
    }
}

/// Strips of triangles are their triangles, in text and in binary.
#[test]
fn strips_of_triangles() {
    let corners = "0 0 0\n1 0 0\n0 1 0\n1 1 1\n0 2 0\n";
    let head = |facets: &str| {
        format!(
            "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n\
             property float z\n{facets}\nend_header\n{corners}"
        )
    };
    let faces = "element face 4\nproperty list uchar int vertex_indices";
    let faces = head(faces) + "3 0 1 2\n3 2 1 3\n3 2 3 4\n3 0 1 2\n";
    let expected = read("a.ply", faces).expect("a mesh");
    assert_eq!(expected.len(), 4);
    let list = "element tristrips 1\nproperty list int int vertex_indices";
    let strips = head(list) + "10 0 1 2 3 4 -1 0 1 2 -1\n";
    assert_eq!(read("a.ply", &strips).as_ref(), Ok(&expected));
    let [header, _] = strips.split_inclusive("end_header\n").collect::<Vec<_>>()[..] else {
        panic!("no header")
    };
    let numbers = corners.split_whitespace().map(|word| word.parse::<f32>().expect("a number"));
    let numbers: Vec<u8> = numbers.flat_map(f32::to_le_bytes).collect();
    let list = [10i32, 0, 1, 2, 3, 4, -1, 0, 1, 2, -1].map(i32::to_le_bytes).concat();
    let header = header.replace("ascii", "binary_little_endian");
    let binary = [header.as_bytes(), &numbers, &list].concat();
    assert_eq!(read("a.ply", &binary).as_ref(), Ok(&expected));
    assert_eq!(warnings("a.ply", &binary), "");
    let tail = [&binary[..], b"\n"].concat();
    assert_eq!(warnings("a.ply", &tail), "bytes after its last element are ignored");
}

#[test]
fn free_form_surfaces_are_said_to_be_ignored() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\ncstype bspline\nsurf 0 1 0 1 1 2 3\nend\n";
    let expected = "free-form surfaces are ignored: 1; export them as triangles";
    assert_eq!(warnings("a.obj", text.as_bytes()), expected);
}

/// Names and comments may be in any encoding.
#[test]
fn texts_that_are_not_utf_8() {
    let plain = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let named = [&b"# caf\xe9\no \xe9\n"[..], plain.as_bytes()].concat();
    assert_eq!(read("named.obj", named), Ok(read("plain.obj", plain).expect("a mesh")));
    let plain = ply(&ARROW, &[0, 1, 2, 3, 4]);
    let (start, rest) = plain.split_once("element").expect("a header");
    let comment = &b"comment end_header caf\xe9\nelement"[..];
    let named = [start.as_bytes(), comment, rest.as_bytes()].concat();
    assert_eq!(read("named.ply", named), Ok(read("plain.ply", &plain).expect("a mesh")));
}

/// A text PLY of corners in a plane and one face.
fn ply(corners: &[[f64; 2]], face: &[usize]) -> String {
    let words = |numbers: &[usize]| numbers.iter().map(|k| format!(" {k}")).collect::<String>();
    let rows: String = corners.iter().map(|[x, y]| format!("{x} {y} 0\n")).collect();
    format!(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\n\
         property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\
         {rows}{}{}\n",
        corners.len(),
        face.len(),
        words(face)
    )
}

/// The same as an OBJ, with its corners after the face.
fn obj(corners: &[[f64; 2]], face: &[usize]) -> String {
    let words: String = face.iter().map(|k| format!(" {}", k + 1)).collect();
    let rows: String = corners.iter().map(|[x, y]| format!("v {x} {y} 0\n")).collect();
    format!("f{words}\n{rows}")
}

const ARROW: [[f64; 2]; 5] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.5, 0.25], [0.0, 1.0]];

/// Facets cover a polygon once, whichever of its corners comes first.
#[test]
fn polygons_are_covered_once() {
    let square = [[0.0, 0.0], [0.5, 0.0], [1.0, 0.0], [1.0, 1.0], [0.1, 1.0], [0.0, 1.0]];
    // On a line up to the rounding of f32.
    let rounded = [[0.0, 0.0], [0.3, 1e-7], [0.6, 2e-7], [0.7, -1e-7], [1.0, 0.0], [1.0, 1.0]];
    for (corners, area) in
        [(&ARROW[..], 0.625), (&ARROW[..4], 0.375), (&square, 1.0), (&rounded, 0.5)]
    {
        for first in 0..corners.len() {
            let face: Vec<usize> = (first..corners.len()).chain(0..first).collect();
            for (name, text) in [("a.ply", ply(corners, &face)), ("a.obj", obj(corners, &face))] {
                let facets = read(name, &text).expect(name);
                let found: f64 = facets.iter().map(|(_, area)| area).sum();
                assert!((found - area).abs() < ROUNDED, "{name}, {face:?}: {found}");
            }
        }
    }
    // Polygons without an area have no facets, and are no errors.
    let line = [[0.0, 0.0], [0.1, 0.3], [0.2, 0.6], [0.3, 0.9]];
    assert_eq!(read("a.obj", obj(&line, &[0, 2, 1, 3])), Ok(Vec::new()));
}

/// A fan from the first corner, as long as it covers the polygon.
#[test]
fn convex_polygons_begin_at_their_first_corner() {
    // Warped, so that each triangle has a normal of its own.
    let corners = "v 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\n";
    for (quad, triangles) in [("1 2 3 4", "f 1 2 3\nf 1 3 4"), ("2 3 4 1", "f 2 3 4\nf 2 4 1")] {
        let ours = read("quad.obj", format!("{corners}f {quad}\n")).expect("a quad");
        let theirs = read("two.obj", format!("{corners}{triangles}\n")).expect("triangles");
        assert_eq!(ours, theirs, "{quad}");
    }
}

#[test]
fn polygons_without_a_fan_are_errors() {
    let star: Vec<[f64; 2]> = (0..12)
        .map(|k| {
            let radius = [1.0, 0.2][k % 2];
            let (y, x) = (f64::from(k as u32) * std::f64::consts::TAU / 12.0).sin_cos();
            [radius * x, radius * y]
        })
        .collect();
    let crossed = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]];
    for corners in [&star[..], &crossed] {
        let face: Vec<usize> = (0..corners.len()).collect();
        for (name, text, place) in [
            ("a.ply", ply(corners, &face), "row 1 of 1 of element `face`: "),
            ("a.obj", obj(corners, &face), "line 1: "),
        ] {
            let error = read(name, &text).expect_err("no fan").to_string();
            let expected = format!(
                "{place}a face of {} corners, and no fan of triangles covers it; triangulate the \
                 mesh, and export it again",
                corners.len()
            );
            assert!(error.ends_with(&expected), "{error}");
        }
    }
}

/// Every beginning of a polygon file is refused; one that is as long as the header promises at
/// least, in words that name the place.
#[test]
fn polygon_files_cut_short() {
    let text = ply(&ARROW, &[0, 1, 2, 3, 4]);
    let body = text.find("end_header\n").expect("a header") + "end_header\n".len();
    let header = text[..body].replace("ascii", "binary_little_endian");
    let numbers = ARROW.iter().flat_map(|[x, y]| [*x as f32, *y as f32, 0.0]);
    let list = [&[5][..], &[0i32, 1, 2, 3, 4].map(i32::to_le_bytes).concat()].concat();
    let binary = [header.into_bytes(), numbers.flat_map(f32::to_le_bytes).collect(), list].concat();
    let start_of_binary = binary.len() - 5 * 12 - 21;
    // The text is whole without its last line end.
    for (bytes, body, end) in
        [(text.as_bytes(), body, text.len() - 1), (&binary, start_of_binary, binary.len())]
    {
        let facets = read("whole.ply", &bytes[..end]).expect("a mesh");
        assert_eq!(facets.len(), 3);
        for end in 0..end {
            let error = read("cut.ply", &bytes[..end]).expect_err("cut").to_string();
            if end < body + 30 {
                continue;
            }
            let is_located = error.contains(" of 5 of element `vertex`: it is not a complete PLY")
                || error.contains("row 1 of 1 of element `face`: it is not a complete PLY");
            assert!(is_located && error.contains("(it ends too early); export"), "{error}");
        }
    }
}
