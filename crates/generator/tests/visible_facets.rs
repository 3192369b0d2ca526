//! Meshes: which part of each facet the camera sees, against known areas and against rays
//! through every facet.

use crate::shapes::{Triangle, cone, cup, ellipsoid, file, rectangle, torus, turned};
use eigenshade_generator::object::facet::Facet;
use eigenshade_generator::object::mesh;
use eigenshade_generator::object::picture::Picture;
use eigenshade_generator::object::surface::View;
use eigenshade_generator::object::visibility::seen_shares;
use eigenshade_model::error::Error;
use std::f64::consts::PI;
use std::time::{Duration, Instant};

/// Area of facets that nothing hides, in a picture of a few units: the same products, in another
/// order.
const WHOLE_FACETS: f64 = 2e-15;

/// Area seen of facets partly hidden, of the longer side of the box times the length of their
/// outlines and cuts: the diagonal of a sample of 1/1024, which is the bound; errors of both signs
/// leave a fiftieth of it.
const VISIBLE_AREA: f64 = 1.4 / 1024.0;

/// A torus of 200 x 100 facets against the smooth one, of its picture: chords of a circle of 100,
/// (2π/100)²/6, and of 200; samples where it hides itself.
const FACETED_TORUS: f64 = 1.5e-3;

/// Moments of visible normals against 200 x 200 rays, of the picture: edges of length
/// some tens in 200, their errors of both signs.
const RAYS: f64 = 3e-3;

/// The same of facets as small as the samples, in addition: outlines and cuts some ten pictures
/// long, times a sample, their errors of both signs.
const SMALL_FACETS: f64 = 0.4;

/// Slivers that are all cut alike, of their area: sixteen points stand for each, a tenth
/// of its area apart at most.
const SLIVERS_ALIKE: f64 = 0.1;

/// Slivers cut along a diagonal, of their area: the errors of each one's points sum to nothing
/// over its length, and the cut is 1.4 long, with a sample of 2/1024 in width.
const SLIVERS: f64 = 4e-4;

/// Samples across, as the reader takes them.
const SAMPLES: usize = 1024;

/// What a stack of ten thousand facets may take: some ten times what it takes.
const STACK: Duration = Duration::from_secs(20);

/// Visible area of each triangle's projection.
fn seen(triangles: &[Triangle]) -> Vec<f64> {
    seen_by(triangles, SAMPLES)
}

fn seen_by(triangles: &[Triangle], samples: usize) -> Vec<f64> {
    let facets: Vec<Facet> = triangles.iter().filter_map(|corners| Facet::new(*corners)).collect();
    assert_eq!(facets.len(), triangles.len(), "a triangle without area");
    let shares = seen_shares(&facets, samples);
    shares.iter().zip(&facets).map(|(share, facet)| share * facet.projected_area).collect()
}

/// The projection of each triangle that faces the camera, 0 for others.
fn whole(triangles: &[Triangle]) -> Vec<f64> {
    let area = |[a, b, c]: &Triangle| {
        0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
    };
    triangles.iter().map(|corners| area(corners).max(0.0)).collect()
}

/// 1, n and the products of n's components, summed with these areas.
fn moments(triangles: &[Triangle], areas: &[f64]) -> Vec<f64> {
    let mut sums = vec![0.0; 10];
    for ([a, b, c], area) in triangles.iter().zip(areas) {
        let (u, v) = ([0, 1, 2].map(|k| b[k] - a[k]), [0, 1, 2].map(|k| c[k] - a[k]));
        let cross = |i: usize, j: usize| u[i] * v[j] - u[j] * v[i];
        let n = [cross(1, 2), cross(2, 0), cross(0, 1)];
        let length = n.iter().map(|x| x * x).sum::<f64>().sqrt();
        let [x, y, z] = n.map(|x| x / length);
        let values = [1.0, x, y, z, x * x, x * y, x * z, y * y, y * z, z * z];
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
fn apart(triangles: &[Triangle], ours: &[f64], theirs: &[f64]) -> f64 {
    let (ours, theirs) = (moments(triangles, ours), moments(triangles, theirs));
    let most = ours.iter().zip(&theirs).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
    most / theirs[0]
}

#[test]
fn a_square_before_another() {
    for slope in [0.0, 0.3, -2.0] {
        let mut triangles = rectangle([0.0, 1.0], [0.0, 1.0], 0.0, 0.0).to_vec();
        triangles.extend(rectangle([0.3, 1.4], [0.2, 1.25], 5.0, slope));
        let seen = seen(&triangles);
        let (behind, before) = (seen[0] + seen[1], seen[2] + seen[3]);
        let expected = 1.0 - 0.7 * 0.8;
        println!("{slope}: {:e}", (behind - expected) / 1.4);
        assert!((before - 1.1 * 1.05).abs() < WHOLE_FACETS, "{before}");
        // 1.5 of cuts, twice an outline of 3.4, in a box of 1.4.
        let allowed = VISIBLE_AREA * 8.3;
        assert!((behind - expected).abs() < allowed, "{behind} for {expected}");
    }
}

/// What faces away hides, and what is coincident or touches does not.
#[test]
fn back_faces_hide_and_sheets_do_not() {
    let back = |triangles: [Triangle; 2]| triangles.map(|[a, b, c]| [a, c, b]);
    let below = rectangle([0.0, 1.0], [0.0, 1.0], 0.0, 0.2);
    let lid = back(rectangle([-0.5, 1.5], [-0.5, 1.5], 1.0, -0.1));
    assert_eq!(seen(&[below, lid].concat()), [0.0; 4]);
    let sheet = seen(&[below, back(below)].concat());
    assert_eq!(sheet, whole(&[below, back(below)].concat()));
    // The corners of the other side in another order and rounded otherwise.
    let near = back(below).map(|[a, b, c]| [b, c, a].map(|p| p.map(|x| f64::from(x as f32))));
    let sheet = seen(&[below, near].concat());
    assert_eq!(sheet, whole(&[below, near].concat()));
}

/// Nothing of a convex object is hidden: every facet keeps its exact area.
#[test]
fn convex_objects_are_seen_whole() {
    let single = |triangles: Vec<Triangle>| -> Vec<Triangle> {
        let round = |p: [f64; 3]| p.map(|x| f64::from(x as f32));
        triangles.into_iter().map(|corners| corners.map(round)).collect()
    };
    for angles in [[0.0, 0.0], [0.5 * PI, 0.0], [0.4, 1.1], [2.0, 1e-9]] {
        for (name, triangles) in [
            ("ellipsoid", turned(ellipsoid([24, 48]), angles)),
            ("fine ellipsoid", turned(ellipsoid([60, 120]), angles)),
            ("in f32", single(turned(ellipsoid([24, 48]), angles))),
            ("cone", turned(cone(64), angles)),
            ("needle", turned(cone(500), angles)),
        ] {
            let ours = seen(&triangles);
            for (number, (ours, whole)) in ours.iter().zip(whole(&triangles)).enumerate() {
                let apart = (ours - whole).abs();
                let what = format!("{name}, {angles:?}: {number}: {ours} of {whole}");
                assert!(apart < WHOLE_FACETS, "{what}");
            }
        }
    }
}

/// A torus seen from the side: its picture is a stadium.
#[test]
fn a_torus_from_the_side() {
    let r = 0.4;
    let triangles = turned(torus([200, 100], r), [0.5 * PI, 0.0]);
    let ours: f64 = seen(&triangles).iter().sum();
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
        let rays = by_rays(&triangles, 200);
        let ours = apart(&triangles, &seen(&triangles), &rays);
        let all = apart(&triangles, &whole(&triangles), &rays);
        println!("{name}: {ours:.1e}, all facets {all:.1e}");
        assert!(ours < RAYS, "{name}: {ours:e}");
        for samples in [16, 32, 64] {
            let ours = apart(&triangles, &seen_by(&triangles, samples), &rays);
            println!("{name}, {samples} samples: {:.2}", ours * samples as f64);
            assert!(ours < RAYS + SMALL_FACETS / samples as f64, "{name}, {samples}: {ours:e}");
        }
        let hides = name != "cup from below";
        assert!(!hides || all > 10.0 * RAYS, "{name}: {all:e} without");
    }
}

#[test]
fn the_order_of_facets_means_nothing() {
    let triangles = turned(torus([60, 30], 0.4), [1.2, 0.3]);
    let expected = seen(&triangles);
    let count = triangles.len();
    // 7 and 3600 have no factor in common.
    let order: Vec<usize> = (0..count).map(|k| (7 * k + 11) % count).collect();
    let shuffled: Vec<Triangle> = order.iter().map(|&k| triangles[k]).collect();
    let found = seen(&shuffled);
    assert!(order.iter().zip(&found).all(|(&k, found)| *found == expected[k]));
    // Corners from another one on: to rounding.
    let rolled: Vec<Triangle> = triangles.iter().map(|[a, b, c]| [*c, *a, *b]).collect();
    let largest = expected.iter().copied().fold(0.0, f64::max);
    let apart = |(a, b): (&f64, &f64)| (a - b).abs() > WHOLE_FACETS * largest;
    assert_eq!(seen(&rolled).iter().zip(&expected).filter(|pair| apart(*pair)).count(), 0);
}

/// Facets thinner than a sample, along the rows, across and aslant, half of them behind
/// something.
#[test]
fn slivers() {
    let slivers = 2500;
    let square = rectangle([0.0, 1.0], [0.0, 1.0], 0.0, 0.0);
    let strips = |at: &dyn Fn(f64, f64) -> [f64; 3]| {
        let of = |k: usize| {
            let [low, high] = [k, k + 1].map(|k| k as f64 / slivers as f64);
            let (a, b, c, d) = (at(0.0, low), at(1.0, low), at(1.0, high), at(0.0, high));
            [[a, b, c], [a, c, d]]
        };
        (0..slivers).flat_map(of).collect::<Vec<Triangle>>()
    };
    let along = strips(&|u, v| [u, v, 0.0]);
    let across = strips(&|u, v| [1.0 - v, u, 0.0]);
    let aslant = strips(&|u, v| [u, 0.5 * (u + v), 0.1 * u]);
    for (name, strips) in [("along", along), ("across", across), ("aslant", aslant)] {
        let alone = seen(&strips);
        assert_eq!(alone, whole(&strips), "{name}: nothing hides them");
        let total: f64 = alone.iter().sum();
        // Cut alike by upright edges; or along the diagonal, each elsewhere.
        for (left, right, slant, allowed) in
            [(0.1, 0.6, 0.0, SLIVERS_ALIKE), (-1.0, 0.0, 1.0, SLIVERS)]
        {
            let over = |x: f64, y: f64| [x + slant * y, y, 1.0];
            let (a, b) = (over(left, -0.01), over(right, -0.01));
            let (c, d) = (over(right, 1.01), over(left, 1.01));
            let both = [&strips[..], &[[a, b, c], [a, c, d]]].concat();
            let left: f64 = seen(&both)[..strips.len()].iter().sum();
            let apart = left / total - 0.5;
            println!("{name}, slant {slant}: {apart:e}");
            assert!(apart.abs() < allowed, "{name}, slant {slant}: {apart:e}");
        }
        // All behind a square, but for what stands out of it.
        let both = [&strips[..], &square.map(|t| t.map(|[x, y, _]| [x, y, 1.0]))].concat();
        let hidden: f64 = seen(&both)[..strips.len()].iter().sum();
        assert_eq!(hidden, 0.0, "{name}");
    }
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
        let seen = seen(&stack);
        let taken = start.elapsed();
        println!("slope {slope}: {taken:.1?}");
        let top = (0..sheets).position(|k| k * 1999 % sheets == sheets - 1).expect("a sheet");
        for (number, (seen, whole)) in seen.iter().zip(whole(&stack)).enumerate() {
            assert_eq!(*seen, if number / 2 == top { whole } else { 0.0 }, "facet {number}");
        }
        // Sample by sample, a minute.
        assert!(taken < STACK, "{taken:?}");
    }
}

/// The reader leaves out what is hidden: the same facets from a file.
#[test]
fn a_mesh_file_has_visible_normals() {
    let triangles = turned(torus([40, 20], 0.4), [1.2, 0.3]);
    let folder = tempfile::tempdir().expect("a folder");
    let path = file(folder.path(), &triangles);
    let pairs = mesh::read(&path).expect("a mesh");
    let ours = seen(&triangles);
    assert_eq!(pairs.len(), ours.iter().filter(|area| **area > 0.0).count());
    let total: f64 = ours.iter().sum();
    let read: f64 = pairs.iter().map(|(_, weight)| weight).sum();
    let sum = |axis: usize| pairs.iter().map(|(n, w)| w / read * n[axis]).sum::<f64>();
    let expected = moments(&triangles, &ours);
    for axis in 0..3 {
        let apart = (sum(axis) - expected[axis + 1] / total).abs();
        assert!(apart < WHOLE_FACETS, "{axis}: {apart:e}");
    }
}

/// The errors of a mesh file of these triangles: of its normals, and of pictures of several sizes.
fn errors(triangles: &[Triangle]) -> Vec<Option<String>> {
    let folder = tempfile::tempdir().expect("a folder");
    let path = file(folder.path(), triangles);
    let text = |error: Error| error.to_string().split_once(": ").expect("a path").1.to_owned();
    let pictures =
        [2, 7, 40, 250].map(|size| Picture::of_mesh(&path, size, &View::default()).err().map(text));
    [mesh::read(&path).err().map(text)].into_iter().chain(pictures).collect()
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
