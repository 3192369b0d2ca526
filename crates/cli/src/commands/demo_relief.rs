//! The relief of the demo: a medal with the florets of a sunflower inside a rim.

use eigenshade_cli::object::ObjectView;
use eigenshade_cli::picture::Pixel;
use std::f64::consts::PI;

/// Number of florets.
const FLORETS: usize = 55;
/// Radius of their field; that of the medal is 1.
const FIELD: f64 = 0.82;
/// Radius of the middle of the rim, and half its width.
const RIM: (f64, f64) = (0.925, 0.075);
/// The sine of the steepest slope.
const STEEPEST: f64 = 0.8;
/// Samples of a pixel in each direction.
const SAMPLES: usize = 4;

/// The medal in `size` pixels across; normals are averages over each pixel.
pub fn view(size: usize) -> ObjectView {
    let florets = florets();
    let mut view =
        ObjectView { width: size, height: size, pixels: Vec::new(), normals: Vec::new() };
    let steps = (size * SAMPLES) as f64;
    let place =
        |pixel: usize, sample: usize| 2.0 * ((pixel * SAMPLES + sample) as f64 + 0.5) / steps - 1.0;
    for row in 0..size {
        for column in 0..size {
            let samples = (0..SAMPLES * SAMPLES).filter_map(|sample| {
                let (x, y) = (place(column, sample % SAMPLES), -place(row, sample / SAMPLES));
                normal(&florets, x, y)
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

/// The centers of the florets, on a spiral that turns by the golden angle.
fn florets() -> Vec<[f64; 2]> {
    let golden = PI * (3.0 - 5.0_f64.sqrt());
    let center = |k: usize| {
        let radius = (FIELD - floret()) * ((k as f64 + 0.5) / FLORETS as f64).sqrt();
        let (sine, cosine) = (golden * k as f64).sin_cos();
        [radius * cosine, radius * sine]
    };
    (0..FLORETS).map(center).collect()
}

/// Radius of a floret, large enough that neighbors meet.
fn floret() -> f64 {
    1.1 * FIELD / (FLORETS as f64).sqrt()
}

/// The normal at a point of the medal.
fn normal(florets: &[[f64; 2]], x: f64, y: f64) -> Option<[f64; 3]> {
    let radius = x.hypot(y);
    let (middle, half) = RIM;
    if radius > middle + half {
        return None;
    }
    // The horizontal part of the normal, as a share of the steepest.
    let [x, y] = if radius > middle - half {
        let across = (radius - middle) / half;
        [x * across / radius, y * across / radius]
    } else {
        let offsets = florets.iter().map(|[a, b]| [(x - a) / floret(), (y - b) / floret()]);
        let nearest = offsets.min_by(|a, b| a[0].hypot(a[1]).total_cmp(&b[0].hypot(b[1])));
        nearest.filter(|[x, y]| x.hypot(*y) < 1.0).unwrap_or_default()
    };
    let (x, y) = (STEEPEST * x, STEEPEST * y);
    Some([x, y, (1.0 - x * x - y * y).sqrt()])
}
