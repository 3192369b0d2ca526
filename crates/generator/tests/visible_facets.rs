//! Meshes: what the camera sees of their facets, against known areas and against rays through every
//! facet.

use crate::shapes::{Triangle, cone, cup, file, rectangle, torus, turned};
use eigenshade_generator::object::facet::CONTACT;
use eigenshade_generator::object::mesh;
use eigenshade_generator::object::picture::Picture;
use eigenshade_generator::object::points::{Point, points};
use eigenshade_generator::object::surface::View;
use eigenshade_model::error::Error;
use eigenshade_model::inputs::input_file::InputFile;
use std::f64::consts::PI;
use std::time::{Duration, Instant};

/// A torus of 200 x 100 facets against the smooth one, of its picture: chords of a circle of 100,
/// (2π/100)²/6, and of 200; samples where it hides itself.
const FACETED_TORUS: f64 = 1.5e-3;

/// Moments of visible normals against 200 x 200 rays, of the picture: edges of length
/// some tens in 200, their errors of both signs.
const RAYS: f64 = 3e-3;

/// Samples across.
const SAMPLES: usize = 1024;

/// What a stack of ten thousand facets may take: some ten times what it takes.
const STACK: Duration = Duration::from_secs(20);

/// The points of these triangles that the camera sees, and their unit.
fn shown(triangles: &[Triangle], samples: usize) -> (Vec<Point>, f64) {
    let folder = tempfile::tempdir().expect("a folder");
    let file = InputFile::from(file(folder.path(), triangles));
    let flat = View { is_flat: true, ..View::default() };
    let surface = mesh::surface(&file, &flat).expect("a mesh");
    let unit =
        triangles.as_flattened().as_flattened().iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    (points(&surface, samples, 1), unit)
}

/// 1, n and the products of n's components, summed over the picture.
fn seen(triangles: &[Triangle], samples: usize) -> [f64; 10] {
    let corners = triangles.as_flattened();
    let side = |axis: usize| {
        let along = || corners.iter().map(|corner| corner[axis]);
        along().fold(f64::NEG_INFINITY, f64::max) - along().fold(f64::INFINITY, f64::min)
    };
    // A margin of half a sample.
    let sample = side(0).max(side(1)) / (samples - 1) as f64;
    let mut sums = [0.0; 10];
    for point in shown(triangles, samples).0 {
        let products = products(point.facet);
        sums.iter_mut().zip(products).for_each(|(sum, value)| *sum += sample * sample * value);
    }
    sums
}

/// 1, n and the products of n's components.
fn products([x, y, z]: [f64; 3]) -> [f64; 10] {
    [1.0, x, y, z, x * x, x * y, x * z, y * y, y * z, z * z]
}

/// The projection of each triangle that faces the camera, 0 for others.
fn whole(triangles: &[Triangle]) -> Vec<f64> {
    let area = |[a, b, c]: &Triangle| {
        0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
    };
    triangles.iter().map(|corners| area(corners).max(0.0)).collect()
}

/// 1, n and the products of n's components, summed with these areas.
fn moments(triangles: &[Triangle], areas: &[f64]) -> [f64; 10] {
    let mut sums = [0.0; 10];
    for ([a, b, c], area) in triangles.iter().zip(areas) {
        let (u, v) = ([0, 1, 2].map(|k| b[k] - a[k]), [0, 1, 2].map(|k| c[k] - a[k]));
        let cross = |i: usize, j: usize| u[i] * v[j] - u[j] * v[i];
        let n = [cross(1, 2), cross(2, 0), cross(0, 1)];
        let length = n.iter().map(|x| x * x).sum::<f64>().sqrt();
        let values = products(n.map(|x| x / length));
        sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += area * value);
    }
    sums
}

/// The visible area of each triangle by rays along -z, `count` across the box: the first
/// facet that each meets, if it faces the camera (Möller and Trumbore).
fn by_rays(triangles: &[Triangle], count: usize) -> Vec<f64> {
    let all = || triangles.iter().flatten();
    let [left, right] = [0, 1].map(|axis| all().map(|p| p[axis]).fold(f64::INFINITY, f64::min));
    let [x_side, y_side] = [(0, left), (1, right)]
        .map(|(axis, least)| all().map(|p| p[axis]).fold(f64::NEG_INFINITY, f64::max) - least);
    let cross = |u: [f64; 3], v: [f64; 3]| {
        [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    };
    let dot = |u: [f64; 3], v: [f64; 3]| u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    let less = |u: [f64; 3], v: [f64; 3]| [u[0] - v[0], u[1] - v[1], u[2] - v[2]];
    let along = [0.0, 0.0, -1.0];
    let mut areas = vec![0.0; triangles.len()];
    for k in 0..count * count {
        // Rows are shifted against each other, so that edges along them do not beat.
        let row = (k / count) as f64;
        let shift = (row * 0.618_033_988_75).fract();
        let x = left + x_side * ((k % count) as f64 + shift) / count as f64;
        let origin = [x, right + y_side * (row + 0.5) / count as f64, 1e3];
        let mut first = (f64::INFINITY, None);
        for (number, [a, b, c]) in triangles.iter().enumerate() {
            let (one, two) = (less(*b, *a), less(*c, *a));
            let p = cross(along, two);
            let determinant = dot(one, p);
            let from = less(origin, *a);
            let u = dot(from, p) / determinant;
            let q = cross(from, one);
            let v = dot(along, q) / determinant;
            let distance = dot(two, q) / determinant;
            if u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance < first.0 {
                first = (distance, Some((number, determinant > 0.0)));
            }
        }
        if let (_, Some((number, true))) = first {
            areas[number] += x_side * y_side / (count * count) as f64;
        }
    }
    areas
}

/// Largest difference of the moments, of the visible area.
fn apart(ours: &[f64; 10], theirs: &[f64; 10]) -> f64 {
    let most = ours.iter().zip(theirs).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
    most / theirs[0]
}

/// A torus seen from the side: its picture is a stadium.
#[test]
fn a_torus_from_the_side() {
    let r = 0.4;
    let triangles = turned(torus([200, 100], r), [0.5 * PI, 0.0]);
    let [ours, ..] = seen(&triangles, SAMPLES);
    let whole: f64 = whole(&triangles).iter().sum();
    let stadium = 4.0 * r + PI * r * r;
    println!("{:e}, all facets {:e}", ours / stadium - 1.0, whole / stadium - 1.0);
    assert!((ours / stadium - 1.0).abs() < FACETED_TORUS, "{ours} {stadium}");
    assert!(whole > 1.1 * stadium, "{whole}: nothing to hide");
}

/// A torus and a cup from several sides, by rays through every facet.
#[test]
fn what_rays_meet() {
    for (name, triangles) in [
        ("torus", turned(torus([40, 20], 0.4), [1.2, 0.3])),
        ("torus from the side", turned(torus([40, 20], 0.4), [0.5 * PI, 0.2])),
        ("cup", turned(cup(48), [-0.7, 0.4])),
        ("cup from below", turned(cup(48), [-2.3, 0.4])),
    ] {
        let rays = moments(&triangles, &by_rays(&triangles, 200));
        let ours = apart(&seen(&triangles, SAMPLES), &rays);
        let all = apart(&moments(&triangles, &whole(&triangles)), &rays);
        println!("{name}: {ours:.1e}, all facets {all:.1e}");
        assert!(ours < RAYS, "{name}: {ours:e}");
        let hides = name != "cup from below";
        assert!(!hides || all > 10.0 * RAYS, "{name}: {all:e} without");
    }
}

/// What faces away hides, and what is coincident or touches does not.
#[test]
fn back_faces_hide_and_sheets_do_not() {
    let back = |triangles: [Triangle; 2]| triangles.map(|[a, b, c]| [a, c, b]);
    let below = rectangle([0.0, 1.0], [0.0, 1.0], 0.0, 0.2);
    let beside = rectangle([2.0, 4.0], [0.0, 1.0], 0.0, 0.2);
    let [alone, ..] = seen(&[below, beside].concat(), SAMPLES);
    let lid = back(rectangle([0.0, 1.0], [0.0, 1.0], 1.0, -0.1));
    let [hidden, ..] = seen(&[below, beside, lid].concat(), SAMPLES);
    assert!((hidden / alone - 2.0 / 3.0).abs() < FACETED_TORUS, "{hidden} of {alone}");
    let [sheet, ..] = seen(&[below, beside, back(below)].concat(), SAMPLES);
    assert_eq!(sheet, alone);
}

/// Thousands of sheets that fill the picture, one behind the other and in any order, level or
/// aslant: what lies behind takes no time to speak of.
#[test]
fn stacks_of_large_facets() {
    let sheets = 5000;
    for slope in [0.0, 0.5] {
        // 1999 and 5000 have no factor in common.
        let level = |k: usize| f64::from((k * 1999 % sheets) as u32) / 100.0;
        let stack: Vec<Triangle> =
            (0..sheets).flat_map(|k| rectangle([0.0, 1.0], [0.0, 1.0], level(k), slope)).collect();
        let start = Instant::now();
        let (points, scale) = shown(&stack, SAMPLES);
        let taken = start.elapsed();
        println!("slope {slope}: {taken:.1?}");
        let top = f64::from(sheets as u32 - 1) / 100.0;
        for point in &points {
            let [x, _, z] = point.position.map(|axis| axis * scale);
            assert!((z - slope * x - top).abs() < CONTACT * top, "{point:?}");
        }
        // Sample by sample, a minute.
        assert!(taken < STACK, "{taken:?}");
    }
}

/// The errors of a mesh file of these triangles: of its normals, and of pictures of several sizes.
fn errors(triangles: &[Triangle]) -> Vec<Option<String>> {
    let folder = tempfile::tempdir().expect("a folder");
    let path = file(folder.path(), triangles);
    let text = |error: Error| error.to_string().split_once(": ").expect("a path").1.to_owned();
    let pictures =
        [2, 7, 40, 250].map(|size| Picture::of_mesh(&path, size, &View::default()).err().map(text));
    let surface = mesh::surface(&InputFile::from(path.as_path()), &View::default());
    let surface = surface.err().map(|error| error.in_file(&path)).map(text);
    std::iter::once(surface).chain(pictures).collect()
}

/// Closed meshes with their corners the wrong way round are refused at every size, and open ones
/// are drawn up to half from behind.
#[test]
fn meshes_that_face_away_are_errors() {
    let back = |triangles: &[Triangle]| -> Vec<Triangle> {
        triangles.iter().map(|[a, b, c]| [*a, *c, *b]).collect()
    };
    let away = "most of what the camera at +z sees of it faces away; reverse the order of the \
                corners, or turn it";
    for (name, triangles) in [
        ("torus", torus([40, 20], 0.4)),
        ("torus aslant", turned(torus([60, 30], 0.4), [1.2, 0.3])),
        ("torus from the side", turned(torus([40, 20], 0.4), [0.5 * PI, 0.2])),
        ("cup", turned(cup(48), [-0.7, 0.4])),
        ("box", turned(torus([4, 4], 0.4), [0.3, 0.2])),
        ("needle", turned(cone(50), [0.5 * PI, 0.7])),
    ] {
        assert_eq!(errors(&triangles), vec![None; 5], "{name}");
        assert_eq!(errors(&back(&triangles)), vec![Some(away.to_owned()); 5], "{name} reversed");
    }
    let front = rectangle([0.0, 1.0], [0.0, 1.0], 0.0, 0.2);
    for (wide, error) in [(0.5, None), (1.0, None), (3.0, Some(away.to_owned()))] {
        let behind = back(&rectangle([1.0, 1.0 + wide], [0.0, 1.0], 0.0, 0.2));
        assert_eq!(errors(&[&front[..], &behind].concat()), vec![error; 5], "{wide}");
    }
    // Two sides of a sheet.
    let sheet = [&front[..], &back(&front)].concat();
    assert_eq!(errors(&sheet), vec![None; 5]);
}

#[test]
fn slivers_are_thinner_than_a_sample() {
    let sliver = [[0.0, 0.0, 0.0], [1000.0, 0.0, 0.0], [0.0, 0.001, 0.0]];
    let found = errors(&[sliver]);
    assert_eq!(found[0], None);
    for (error, samples) in found[1..].iter().zip([8, 28, 160, 1000]) {
        let expected = format!("it is thinner than a sample, 1/{samples} of the picture; ");
        assert!(error.as_ref().is_some_and(|error| error.starts_with(&expected)), "{error:?}");
    }
    let edge_on = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    let found = errors(&[edge_on]);
    let expected = "no facet of it faces the camera";
    assert!(found[1..].iter().flatten().all(|error| error.starts_with(expected)), "{found:?}");
}
