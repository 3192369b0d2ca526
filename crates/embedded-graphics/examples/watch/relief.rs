//! Makes the normals of a watch: its relief, which is a guilloché and two hands on a hub, and its
//! dial. Lengths are in pixels of the small watch, and scale with the relief.

use super::face::{Face, SMALL};
use eigenshade::Normal;
use eigenshade::object::NormalMap;
use eigenshade_embedded_graphics::Dial;

/// The radius of the guilloché in pixels.
const RADIUS: f64 = 36.5;

/// Length and half the width of the hands in pixels, and their angles in degrees from 12 o'clock:
/// it is 9 minutes past 10.
const HANDS: [(f64, f64, f64); 2] = [(21.0, 4.2, 304.5), (32.0, 3.4, 54.0)];

/// The radius of the hub in pixels.
const HUB: f64 = 6.0;

/// The codes of the relief.
pub fn codes(face: &Face) -> Vec<[u8; 2]> {
    let side = face.relief;
    let pixels = (0..side).flat_map(|row| (0..side).map(move |column| (column, row)));
    let middle = 0.5 * f64::from(side) - 0.5;
    let scale = f64::from(SMALL.relief) / f64::from(side);
    pixels
        .map(|(column, row)| {
            let [x, y] = [f64::from(column) - middle, middle - f64::from(row)];
            match covered([x, y], scale) {
                cover if cover <= 0.0 => NormalMap::BACKGROUND,
                cover if cover < 1.0 => at_the_rim([x, y], cover, scale),
                _ => code(scale * x, scale * y),
            }
        })
        .collect()
}

/// The codes of the dial around the relief.
pub fn dial(face: &Face) -> Vec<[u8; 2]> {
    let size = face.size;
    let mut codes = vec![[0; 2]; (size * size) as usize];
    Dial::codes(size, face.bezel, face.mark, &mut codes).expect("a size that is drawn");
    // What the relief hides is not drawn.
    let first = (size - face.relief) / 2;
    for (index, code) in self::codes(face).into_iter().enumerate() {
        let [column, row] = [index as u32 % face.relief, index as u32 / face.relief];
        if code[0] != NormalMap::BACKGROUND[0] {
            codes[((first + row) * size + first + column) as usize] = NormalMap::BACKGROUND;
        }
    }
    codes
}

/// How much of a pixel is inside the radius: above 0 and below 1 for a pixel in part.
fn covered([x, y]: [f64; 2], scale: f64) -> f64 {
    RADIUS / scale - x.hypot(y) + 0.5
}

/// The code of a pixel that is covered in part: the normal of the neighbor toward the center.
fn at_the_rim([x, y]: [f64; 2], cover: f64, scale: f64) -> [u8; 2] {
    let [left, below] = [x, y].map(|along| (along / x.hypot(y)).round());
    if covered([x - left, y - below], scale) >= 1.0 {
        NormalMap::edge_code((255.0 * cover) as u8, [-left as i8, below as i8])
    } else if cover < 0.5 {
        NormalMap::BACKGROUND
    } else {
        code(scale * x, scale * y)
    }
}

/// The code of a pixel, right and up of the center.
fn code(x: f64, y: f64) -> [u8; 2] {
    let slopes = if x.hypot(y) < HUB {
        round([x / HUB, y / HUB])
    } else if let Some(slopes) = HANDS.into_iter().rev().find_map(|hand| on_hand(hand, x, y)) {
        slopes
    } else {
        let step = 1e-3;
        [
            (height(x - step, y) - height(x + step, y)) / (2.0 * step),
            (height(x, y - step) - height(x, y + step)) / (2.0 * step),
        ]
    };
    let [x, y] = slopes.map(|slope| slope as f32);
    NormalMap::code(Normal::new(x, y, 1.0).expect("it faces the camera"))
}

/// The guilloché's height in pixels: twelve twisted petals, and a rounded rim.
fn height(x: f64, y: f64) -> f64 {
    let (distance, angle) = (x.hypot(y), y.atan2(x));
    let petals = (12.0 * angle + 0.09 * distance).cos() * distance / RADIUS;
    let rim = (distance - RADIUS + 4.0).max(0.0) / 4.0;
    1.3 * petals - 3.0 * rim * rim
}

/// The slopes of a hand with a round cross-section, if it covers the point.
fn on_hand((length, half_width, angle): (f64, f64, f64), x: f64, y: f64) -> Option<[f64; 2]> {
    let (sine, cosine) = angle.to_radians().sin_cos();
    let (along, across) = (x * sine + y * cosine, (x * cosine - y * sine) / half_width);
    // It tapers toward its end.
    let across = across / (1.0 - 0.5 * along / length);
    let is_inside = (0.0..length).contains(&along) && across.abs() < 1.0;
    is_inside.then(|| round([across * cosine, -across * sine]))
}

/// The slopes of a half circle or sphere at a point of the unit circle; at most 2.
fn round([x, y]: [f64; 2]) -> [f64; 2] {
    let up = (1.0 - x * x - y * y).max(0.2).sqrt();
    [x / up, y / up]
}
