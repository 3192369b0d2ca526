//! Objects with shadows beside those without, docs/shadows.png.

use super::inputs;
use eigenshade::Rgb;
use eigenshade::screen::{Display, Tone};
use eigenshade_cli::picture::Canvas;
use eigenshade_model::error::Result;
use eigenshade_shading::picture::write_png;
use report::shadows::{Shown, shown};
use std::path::Path;

/// Pixels across an object, and their scale.
const SIZE: usize = 128;
const SCALE: usize = 2;

/// Each row: the shape, the material and the map, and a color.
type Subject = ((&'static str, &'static str, &'static str), [f64; 3]);
const ROWS: [Subject; 2] = [
    (("coin", "metal 0.5", "venice"), [1.0, 0.77, 0.34]),
    (("knot", "plastic 0.3", "apartment"), [0.9, 0.35, 0.2]),
];

static DISPLAY: Display = Display::new(Tone::Linear);

pub fn picture(out: &Path) -> Result<()> {
    let side = SIZE * SCALE;
    let mut canvas = Canvas::new(3 * side, ROWS.len() * side, [0; 3]);
    for (row, (subject, color)) in ROWS.into_iter().enumerate() {
        let Shown { pixels, convex, direct, of_runtime } =
            shown(subject, color, SIZE, &inputs().join("maps"))?;
        for (k, ([x, y], coverage)) in pixels.into_iter().enumerate() {
            let word = of_runtime[y * SIZE + x];
            let level = |shift: u32, most: u16| {
                (u32::from(word >> shift & most) * 255 / u32::from(most)) as u8
            };
            let exposed = |color: Rgb<f32>| <[u8; 3]>::from(DISPLAY.rgb888(color));
            let coverage = f64::from(coverage) / 255.0;
            let three = [
                (exposed(convex[k]), coverage),
                ([level(11, 31), level(5, 63), level(0, 31)], 1.0),
                (exposed(direct[k]), coverage),
            ];
            for (column, (color, coverage)) in three.into_iter().enumerate() {
                for (i, j) in (0..SCALE).flat_map(|i| (0..SCALE).map(move |j| (i, j))) {
                    let left = column * side + x * SCALE + i;
                    canvas.blend(left, row * side + y * SCALE + j, color, coverage);
                }
            }
        }
    }
    write_png(out, canvas.width, canvas.height, &canvas.bytes)
}
