//! The relief of the demo: a medal with curved flutes inside a round rim.

use eigenshade_cli::object::ObjectView;
use eigenshade_shading::picture::Pixel;
use std::f64::consts::PI;

/// Radius of the field inside the rim; that of the medal is 1.
const FIELD: f64 = 0.82;
/// Radius of the middle of the rim, half its width, and its height.
const RIM: (f64, f64, f64) = (0.91, 0.085, 0.06);
/// Number of flutes, how far they wind in radians, and their height.
const FLUTES: (f64, f64, f64) = (7.0, 6.0, 0.07);
/// The steepest slope that is drawn.
const STEEPEST: f64 = 1.6;
/// Step of the differences that give the slope.
const STEP: f64 = 1e-4;
/// Samples of a pixel in each direction.
const SAMPLES: usize = 4;

/// The medal in `size` pixels across; normals are averages over each pixel.
pub fn view(size: usize) -> ObjectView {
    let mut view =
        ObjectView { width: size, height: size, pixels: Vec::new(), normals: Vec::new() };
    let steps = (size * SAMPLES) as f64;
    let place =
        |pixel: usize, sample: usize| 2.0 * ((pixel * SAMPLES + sample) as f64 + 0.5) / steps - 1.0;
    for row in 0..size {
        for column in 0..size {
            let samples = (0..SAMPLES * SAMPLES).filter_map(|sample| {
                let (x, y) = (place(column, sample % SAMPLES), -place(row, sample / SAMPLES));
                normal(x, y)
            });
            let (sum, count) = samples.fold(([0.0; 3], 0), |(sum, count), normal| {
                ([0, 1, 2].map(|k| sum[k] + normal[k]), count + 1)
            });
            if count > 0 {
                let length = sum.iter().map(|one: &f64| one * one).sum::<f64>().sqrt();
                let coverage = f64::from(count) / (SAMPLES * SAMPLES) as f64;
                view.pixels.push(Pixel { column, row, coverage, is_inside: coverage >= 0.5 });
                view.normals.push(sum.map(|one| one / length));
            }
        }
    }
    view
}

fn normal(x: f64, y: f64) -> Option<[f64; 3]> {
    if x.hypot(y) > 1.0 {
        return None;
    }
    let slope = |plus: f64, minus: f64| (plus - minus) / (2.0 * STEP);
    let along_x = slope(height(x + STEP, y), height(x - STEP, y));
    let along_y = slope(height(x, y + STEP), height(x, y - STEP));
    let steepness = along_x.hypot(along_y);
    let scale = if steepness > STEEPEST { STEEPEST / steepness } else { 1.0 };
    let length = 1.0_f64.hypot(scale * steepness);
    Some([-scale * along_x / length, -scale * along_y / length, 1.0 / length])
}

fn height(x: f64, y: f64) -> f64 {
    let (radius, angle) = (x.hypot(y), y.atan2(x));
    if radius < FIELD {
        let (count, winding, height) = FLUTES;
        return height * (PI * radius / FIELD).sin() * (count * angle + winding * radius).cos();
    }
    let (middle, half, height) = RIM;
    height * (1.0 - ((radius - middle) / half).powi(2)).max(0.0).sqrt()
}
