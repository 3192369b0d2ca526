//! Objects that shadow themselves, by formulas: a coin, a dial, a knot, a head, a gear and a bowl.

use eigenshade_generator::object::mesh_data::Mesh;
use std::f64::consts::{PI, TAU};

/// A name and an object.
pub type Shape = (&'static str, fn() -> Mesh);

/// The objects.
pub const SHAPES: [Shape; 6] = [
    ("coin", coin),
    ("dial", dial),
    ("knot", knot),
    ("head", head),
    ("gear", gear),
    ("bowl", bowl),
];

/// Points along each side of a height field.
const SIDE: usize = 481;

/// A smooth step from 0 to 1.
fn step(from: f64, to: f64, x: f64) -> f64 {
    let t = ((x - from) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// A round cap of height 1 over |x| < 1.
fn cap(x: f64) -> f64 {
    (1.0 - x * x).max(0.0).sqrt()
}

/// A disc of radius 0.98 with this height at each point.
fn disc(height: impl Fn(f64, f64) -> f64) -> Mesh {
    let at = |k: usize| 2.0 * k as f64 / (SIDE - 1) as f64 - 1.0;
    let mut mesh = Mesh::default();
    for j in 0..SIDE {
        for i in 0..SIDE {
            mesh.corners.push([at(i), at(j), height(at(i), at(j))]);
        }
    }
    for j in 0..SIDE - 1 {
        for i in 0..SIDE - 1 {
            let first = (j * SIDE + i) as u32;
            let [a, b, c, d] = [first, first + 1, first + 1 + SIDE as u32, first + SIDE as u32];
            let inside = [a, b, c, d]
                .iter()
                .all(|&k| mesh.corners[k as usize][0].hypot(mesh.corners[k as usize][1]) < 0.98);
            if inside {
                mesh.triangles.extend([[a, b, c], [a, c, d]]);
            }
        }
    }
    mesh
}

/// A raised rim, a star in the middle and letters between.
fn coin() -> Mesh {
    disc(|x, y| {
        let (radius, angle) = (x.hypot(y), y.atan2(x));
        let rim = 0.14 * cap((radius - 0.88) / 0.1);
        let star = 0.2 * cap(radius / (0.36 + 0.15 * (5.0 * angle + 0.3).cos()));
        let letter = (angle / TAU * 24.0).rem_euclid(24.0);
        let width = 0.28 + 0.12 * (7.0 * letter.floor()).sin();
        let across = (1.0 - ((radius - 0.66) / 0.075).powi(4)).max(0.0).sqrt();
        let letters = 0.075 * across * cap((letter.fract() - 0.5) / width);
        rim.max(star).max(letters)
    })
}

/// A dial with a raised ring, bars at the hours, two hands and a sunk dial of seconds.
fn dial() -> Mesh {
    disc(|x, y| {
        let (radius, angle) = (x.hypot(y), y.atan2(x));
        let hour = (angle / (PI / 6.0)).round();
        let within = angle - hour * PI / 6.0;
        let (along, across) = (radius * within.cos(), radius * within.sin());
        let half = if hour.rem_euclid(3.0) == 0.0 { 0.045 } else { 0.028 };
        let bar = (0.86 - along).min(along - 0.64).min(half - across.abs());
        let mut height = (0.1 * step(0.9, 0.94, radius)).max(0.07 * step(-0.008, 0.016, bar));
        for (turn, length, half, top) in [(1.1, 0.52, 0.05, 0.1), (2.6, 0.72, 0.032, 0.14)] {
            let (sine, cosine) = f64::sin_cos(turn);
            let (along, across) = (x * cosine + y * sine, y * cosine - x * sine);
            let taper = half * (1.0 - 0.5 * along.clamp(0.0, length) / length);
            let hand = (length - along).min(along + 0.14).min(taper - across.abs());
            height = height.max(top * step(-0.006, 0.02, hand));
        }
        height = height.max(0.18 * cap(radius / 0.09));
        let sunk = 0.05 * step(0.2, 0.17, x.hypot(y + 0.38));
        if height <= 1e-9 { -sunk } else { height }
    })
}

/// A mesh of two closed parameters, each from 0 to 1.
fn tube(around: usize, across: usize, at: impl Fn(f64, f64) -> [f64; 3]) -> Mesh {
    let mut mesh = Mesh::default();
    for i in 0..around {
        for j in 0..across {
            mesh.corners.push(at(i as f64 / around as f64, j as f64 / across as f64));
        }
    }
    let place = |i: usize, j: usize| (i % around * across + j % across) as u32;
    for i in 0..around {
        for j in 0..across {
            let [a, b, c, d] = [place(i, j), place(i + 1, j), place(i + 1, j + 1), place(i, j + 1)];
            mesh.triangles.extend([[a, c, b], [a, d, c]]);
        }
    }
    mesh
}

/// A trefoil.
fn knot() -> Mesh {
    let path = |t: f64| {
        let radius = 2.0 + (3.0 * t).cos();
        [radius * (2.0 * t).cos(), radius * (2.0 * t).sin(), 1.1 * (3.0 * t).sin()]
    };
    tube(800, 64, |u, v| {
        let t = TAU * u;
        let unit = |a: [f64; 3]| {
            let length = a.iter().map(|x| x * x).sum::<f64>().sqrt();
            a.map(|x| x / length)
        };
        let cross = eigenshade_model::vector::cross;
        let (center, next) = (path(t), path(t + 1e-4));
        let tangent = unit([0, 1, 2].map(|k: usize| next[k] - center[k]));
        let side = unit(cross(tangent, [center[0], center[1], 0.2]));
        let up = cross(side, tangent);
        let (sine, cosine) = (TAU * v).sin_cos();
        [0, 1, 2].map(|k: usize| (center[k] + 0.62 * (up[k] * cosine + side[k] * sine)) / 3.66)
    })
}

/// A sphere whose radius depends on the direction.
fn globe(rings: usize, radius: impl Fn([f64; 3]) -> [f64; 3]) -> Mesh {
    let mut mesh = Mesh::default();
    for i in 0..=rings {
        let (sine, cosine) = (PI * i as f64 / rings as f64).sin_cos();
        for j in 0..2 * rings {
            let (x, z) = (PI * j as f64 / rings as f64).sin_cos();
            mesh.corners.push(radius([sine * x, cosine, sine * z]));
        }
    }
    let place = |i: usize, j: usize| (i * 2 * rings + j % (2 * rings)) as u32;
    for i in 0..rings {
        for j in 0..2 * rings {
            let [a, b, c, d] = [place(i, j), place(i + 1, j), place(i + 1, j + 1), place(i, j + 1)];
            mesh.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    mesh
}

/// A head with nose, brows, eyes and ears, on a neck and shoulders.
fn head() -> Mesh {
    let bumps: [([f64; 3], f64, f64); 12] = [
        ([0.0, -0.12, 1.0], 0.17, 0.3),
        ([0.0, 0.02, 1.0], 0.12, 0.16),
        ([0.36, 0.18, 0.9], 0.2, -0.17),
        ([-0.36, 0.18, 0.9], 0.2, -0.17),
        ([0.36, 0.16, 0.9], 0.1, 0.07),
        ([-0.36, 0.16, 0.9], 0.1, 0.07),
        ([0.0, 0.42, 0.9], 0.28, 0.1),
        ([0.0, -0.78, 0.75], 0.25, 0.13),
        ([0.0, -0.46, 0.95], 0.13, 0.07),
        ([0.0, -0.55, 0.9], 0.07, -0.05),
        ([1.0, 0.0, 0.0], 0.17, 0.3),
        ([-1.0, 0.0, 0.0], 0.17, 0.3),
    ];
    let skull = |at: [f64; 3]| {
        let mut radius = 1.0;
        for (center, width, height) in bumps {
            let length = center.iter().map(|x| x * x).sum::<f64>().sqrt();
            let square: f64 = (0..3).map(|k| (at[k] - center[k] / length).powi(2)).sum();
            radius += height * (-square / (width * width)).exp();
        }
        let [x, y, z] = at;
        [0.46 * radius * x, 0.62 * radius * y + 0.3, 0.53 * radius * z]
    };
    let mut mesh = globe(160, skull);
    for part in [
        globe(60, |[x, y, z]| [0.26 * x, 0.55 * y - 0.45, 0.26 * z - 0.08]),
        globe(60, |[x, y, z]| [0.92 * x, 0.33 * y - 0.93, 0.36 * z - 0.05]),
    ] {
        let first = mesh.corners.len() as u32;
        mesh.corners.extend(part.corners);
        mesh.triangles.extend(part.triangles.iter().map(|corners| corners.map(|k| first + k)));
    }
    mesh
}

/// A wheel with twelve teeth, five holes and a hub.
fn gear() -> Mesh {
    disc(|x, y| {
        let (radius, angle) = (x.hypot(y), y.atan2(x));
        let tooth = step(-0.15, 0.15, (12.0 * angle).cos());
        let wheel = step(0.0, 0.03, 0.72 + 0.18 * tooth - radius);
        let spoke = (angle / TAU * 5.0).rem_euclid(1.0) - 0.5;
        let (along, across) =
            (radius * (TAU * spoke / 5.0).cos(), radius * (TAU * spoke / 5.0).sin());
        let hole = step(0.0, 0.03, 0.14 - (along - 0.42).hypot(across));
        let hub = step(0.0, 0.03, 0.16 - radius);
        0.25 * wheel * (1.0 - hole) + 0.1 * hub
    })
}

/// A bowl with a ball in it.
fn bowl() -> Mesh {
    disc(|x, y| {
        let radius = x.hypot(y);
        let wall = if radius < 0.85 {
            -0.6 * cap(radius / 0.85)
        } else {
            0.12 * cap((radius - 0.9) / 0.08)
        };
        let (dx, dy) = (x - 0.15, y + 0.1);
        let ball = -0.33 + 0.25 * cap(dx.hypot(dy) / 0.25);
        if dx.hypot(dy) < 0.25 { wall.max(ball) } else { wall }
    })
}
