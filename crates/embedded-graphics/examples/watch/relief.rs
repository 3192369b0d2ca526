//! Makes the relief of a watch, which is a guilloché and two hands on a hub, and the dial around.
//! Lengths are in pixels of the small watch, and scale with the relief.

use super::face::Face;
use eigenshade::object::NormalMap;
use eigenshade_embedded_graphics::Dial;
use std::f64::consts::{PI, TAU};
use std::fmt::Write as _;

/// The radius of the guilloché: its picture has a margin of half a pixel.
pub const RADIUS: f64 = 36.5;

/// The hands, of 9 minutes past 10.
const HANDS: [Hand; 2] = [
    Hand { length: 21.0, half_width: 4.2, edge: 3.5, angle: 304.5 },
    Hand { length: 32.0, half_width: 3.4, edge: 4.5, angle: 54.0 },
];

/// The radius of the hub, and the height of its edge.
const HUB: [f64; 2] = [6.0, 5.0];

/// A hand: half a cone with a round end, on walls.
struct Hand {
    length: f64,
    /// At the hub; it is half of that at the other end.
    half_width: f64,
    /// The height of its edge.
    edge: f64,
    /// In degrees from 12 o'clock.
    angle: f64,
}

/// The relief as an OBJ file, seen from +z.
pub fn mesh() -> String {
    let mut mesh = Mesh::default();
    mesh.sheet([720, 148], |around, out| {
        let [x, y] = polar(around, RADIUS * out);
        [x, y, height(x, y)]
    });
    let [radius, edge] = HUB;
    mesh.sheet([96, 44], |around, out| {
        let [out, up, down] = arch(out);
        let [x, y] = polar(around, radius * out);
        [x, y, edge + radius * up - down]
    });
    HANDS.iter().for_each(|hand| mesh.sheet([88, 120], |across, along| hand.at(across, along)));
    mesh.text
}

/// The codes of the dial around the relief.
pub fn dial(face: &Face) -> Vec<[u8; 2]> {
    let size = face.size;
    let mut codes = vec![[0; 2]; (size * size) as usize];
    Dial::codes(size, face.bezel, face.mark, &mut codes).expect("a size that is drawn");
    // The relief hides whole pixels.
    let radius = 0.5 * f64::from(face.relief - 1);
    for (index, code) in codes.iter_mut().enumerate() {
        let place = [index as u32 % size, index as u32 / size].map(f64::from);
        // The corner that is farthest from the middle.
        let [x, y] = place.map(|place| (place + 0.5 - 0.5 * f64::from(size)).abs() + 0.5);
        if x.hypot(y) < radius {
            *code = NormalMap::BACKGROUND;
        }
    }
    codes
}

/// An OBJ file.
#[derive(Default)]
struct Mesh {
    text: String,
    corners: usize,
}

impl Mesh {
    /// Adds a grid of cells; `at` maps the unit square to the surface.
    fn sheet(&mut self, [across, along]: [usize; 2], at: impl Fn(f64, f64) -> [f64; 3]) {
        let part = |number: usize, of: usize| number as f64 / of as f64;
        let first = self.corners + 1;
        for (row, column) in (0..=along).flat_map(|row| (0..=across).map(move |one| (row, one))) {
            let [x, y, z] = at(part(column, across), part(row, along));
            let _ = writeln!(self.text, "v {x:.4} {y:.4} {z:.4}");
        }
        for (row, column) in (0..along).flat_map(|row| (0..across).map(move |one| (row, one))) {
            let near = first + row * (across + 1) + column;
            let far = near + across + 1;
            let _ = writeln!(self.text, "f {near} {far} {} {}", far + 1, near + 1);
        }
        self.corners += (across + 1) * (along + 1);
    }
}

/// The guilloché's height: twelve twisted petals, and a rounded rim.
fn height(x: f64, y: f64) -> f64 {
    let (distance, angle) = (x.hypot(y), y.atan2(x));
    let petals = (12.0 * angle + 0.09 * distance).cos() * distance / RADIUS;
    let rim = (distance - RADIUS + 4.0).max(0.0) / 4.0;
    1.3 * petals - 3.0 * rim * rim
}

/// A point at a distance from the middle, in a part of a turn from +x.
fn polar(around: f64, distance: f64) -> [f64; 2] {
    let (sine, cosine) = (TAU * around).sin_cos();
    [distance * cosine, distance * sine]
}

/// A quarter of a circle of radius 1 and a wall below: from the top, at 0, to the foot of the wall,
/// at 1 or -1. How far a point is outward, up, and down the wall.
fn arch(part: f64) -> [f64; 3] {
    let part = 1.1 * part;
    let (sine, cosine) = (0.5 * PI * part.clamp(-1.0, 1.0)).sin_cos();
    [sine, cosine, 80.0 * (part.abs() - 1.0).max(0.0)]
}

impl Hand {
    /// A point of the hand: from its right to its left, and from the hub to its end.
    fn at(&self, across: f64, along: f64) -> [f64; 3] {
        let end = 0.5 * self.half_width;
        let part = 1.2 * along;
        let (sine, cosine) = (0.5 * PI * (5.0 * (part - 1.0)).max(0.0)).sin_cos();
        let along = (self.length - end) * part.min(1.0) + end * sine;
        let half_width = (self.half_width - end * part.min(1.0)) * cosine;
        let [left, up, down] = arch(2.0 * across - 1.0);
        let left = half_width * left;
        let (sine, cosine) = self.angle.to_radians().sin_cos();
        let [x, y] = [along * sine - left * cosine, along * cosine + left * sine];
        [x, y, self.edge + half_width * up - down]
    }
}
