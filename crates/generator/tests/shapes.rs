//! Meshes of triangles with known shapes, and files of them.

use std::f64::consts::TAU;
use std::fmt::Write;
use std::path::{Path, PathBuf};

pub type Triangle = [[f64; 3]; 3];

/// A rectangle, toward the camera, at z = height + slope x.
pub fn rectangle(x: [f64; 2], y: [f64; 2], height: f64, slope: f64) -> [Triangle; 2] {
    let at = |x: f64, y: f64| [x, y, height + slope * x];
    let [a, b, c, d] = [at(x[0], y[0]), at(x[1], y[0]), at(x[1], y[1]), at(x[0], y[1])];
    [[a, b, c], [a, c, d]]
}

/// A surface over two cyclic or open parameters; the outside is where d/du x d/dv points.
fn surface(
    [nu, nv]: [usize; 2],
    [cyclic_u, cyclic_v]: [bool; 2],
    at: impl Fn(f64, f64) -> [f64; 3],
) -> Vec<Triangle> {
    let step =
        |k: usize, n: usize, cyclic: bool| (if cyclic { k % n } else { k }) as f64 / n as f64;
    let corner = |i: usize, j: usize| at(step(i, nu, cyclic_u), step(j, nv, cyclic_v));
    let mut triangles = Vec::new();
    for i in 0..nu {
        for j in 0..nv {
            let (a, b) = (corner(i, j), corner(i + 1, j));
            let (c, d) = (corner(i + 1, j + 1), corner(i, j + 1));
            let distinct = |[p, q, r]: &Triangle| p != q && q != r && r != p;
            triangles.extend([[a, b, c], [a, c, d]].into_iter().filter(distinct));
        }
    }
    triangles
}

/// Turned about x, then about y.
pub fn turned(triangles: Vec<Triangle>, [first, second]: [f64; 2]) -> Vec<Triangle> {
    let ((s, c), (t, d)) = (first.sin_cos(), second.sin_cos());
    let turn = |[x, y, z]: [f64; 3]| {
        let (y, z) = (c * y - s * z, s * y + c * z);
        [d * x + t * z, y, d * z - t * x]
    };
    triangles.into_iter().map(|corners| corners.map(turn)).collect()
}

/// A torus about z of radii 1 and r.
pub fn torus(n: [usize; 2], r: f64) -> Vec<Triangle> {
    surface(n, [true, true], |u, v| {
        let ((t, p), (b, a)) = ((TAU * u).sin_cos(), (TAU * v).sin_cos());
        [(1.0 + r * a) * p, (1.0 + r * a) * t, r * b]
    })
}

/// A cup about z, open above, with a wall and a bottom: a closed profile turned about z.
pub fn cup(around: usize) -> Vec<Triangle> {
    let profile = [[0.0, -1.0], [0.7, -1.0], [1.0, 1.0], [0.8, 1.0], [0.55, -0.8], [0.0, -0.8]];
    surface([around, 5], [true, false], |u, v| {
        let (y, x) = (TAU * u).sin_cos();
        let [r, z] = profile[(5.0 * v).round() as usize];
        // One point at the axis, whatever the angle.
        if r > 0.0 { [r * x, r * y, z] } else { [0.0, 0.0, z] }
    })
}

pub fn cone(around: usize) -> Vec<Triangle> {
    let profile = [[0.0, -1.0], [0.7, -1.0], [0.0, 1.0]];
    surface([around, 2], [true, false], |u, v| {
        let (y, x) = (TAU * u).sin_cos();
        let [r, z] = profile[(2.0 * v).round() as usize];
        if r > 0.0 { [r * x, r * y, z] } else { [0.0, 0.0, z] }
    })
}

/// A mesh file of these triangles in a folder.
pub fn file(folder: &Path, triangles: &[Triangle]) -> PathBuf {
    let path = folder.join("mesh.obj");
    let mut text = String::new();
    for [x, y, z] in triangles.iter().flatten() {
        writeln!(text, "v {x} {y} {z}\nvn 0 0 1").expect("text");
    }
    for k in 0..triangles.len() {
        let [a, b, c] = [3 * k + 1, 3 * k + 2, 3 * k + 3];
        writeln!(text, "f {a}//{a} {b}//{b} {c}//{c}").expect("text");
    }
    std::fs::write(&path, text).expect("a file");
    path
}
