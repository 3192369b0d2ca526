//! One image of the demo against its reference, and the picture of all images.

use eigenshade_cli::picture::{Canvas, LETTER, SphereView, exposure, srgb, text_width, write_png};
use eigenshade_model::error::Result;
use std::path::Path;

/// Factor by which differences are shown.
const MAGNIFIED: f64 = 10.0;
/// The share of a light's values that its exposure leaves unclipped.
const UNCLIPPED: f64 = 0.98;

const BACKGROUND: [u8; 3] = [24, 25, 28];
const BRIGHT: [u8; 3] = [226, 226, 222];
const DIM: [u8; 3] = [138, 140, 146];

/// One light on one material: r, g and b of every pixel, of our image and of the reference, and
/// their difference.
pub struct Trial {
    /// The light, and the material.
    pub names: [String; 2],
    /// The number of components.
    pub components: usize,
    /// 1 - energy of the difference / energy of the reference about its mean.
    pub energy_kept: f64,
    /// Root mean square of the difference, as a share of the reference's peak.
    pub rms_error: f64,
    /// Largest difference, as a share of the reference's peak.
    pub max_error: f64,
    /// Nanoseconds a pixel.
    pub nanoseconds: f64,
    ours: Vec<[f64; 3]>,
    reference: Vec<[f64; 3]>,
}

impl Trial {
    /// Measures the errors over the pixels inside the disc, whose normals have the
    /// density cos(α)/π; the peak is that of all pixels, the rim included.
    pub fn new(
        names: [String; 2],
        components: usize,
        ours: Vec<[f64; 3]>,
        reference: Vec<[f64; 3]>,
        view: &SphereView,
    ) -> Self {
        let peak = reference.iter().flatten().fold(0.0, |most: f64, value| most.max(value.abs()));
        let inside = |image: &[[f64; 3]]| -> Vec<[f64; 3]> {
            let pixels = view.pixels.iter().zip(image).filter(|(pixel, _)| pixel.is_inside);
            pixels.map(|(_, rgb)| *rgb).collect()
        };
        let (found, expected) = (inside(&ours), inside(&reference));
        let count = expected.len() as f64;
        let means = [0, 1, 2].map(|c| expected.iter().map(|rgb| rgb[c]).sum::<f64>() / count);
        let (mut residual, mut energy, mut worst) = (0.0, 0.0, 0.0f64);
        for (ours, reference) in found.iter().zip(&expected) {
            for ((ours, reference), mean) in ours.iter().zip(reference).zip(means) {
                residual += (ours - reference).powi(2);
                energy += (reference - mean).powi(2);
                worst = worst.max((ours - reference).abs());
            }
        }
        Self {
            names,
            components,
            energy_kept: 1.0 - residual / energy,
            rms_error: (residual / (3.0 * count)).sqrt() / peak,
            max_error: worst / peak,
            nanoseconds: 0.0,
            ours,
            reference,
        }
    }
}

/// Draws one row for each material, and for each light our image, the reference and the difference.
/// The trials are ordered by light, with `rows` materials each.
pub fn draw(path: &Path, view: &SphereView, trials: &[Trial], rows: usize) -> Result<()> {
    let layout = Layout::new(view.size, trials, rows);
    let columns = trials.len() / rows;
    let width = layout.left + columns * layout.group + layout.margin;
    let height = layout.top + rows * layout.row + layout.margin;
    let mut canvas = Canvas::new(width, height, BACKGROUND);
    for (column, of_light) in trials.chunks(rows).enumerate() {
        let left = layout.left + column * layout.group;
        layout.heading(&mut canvas, left, &title(&of_light[0].names[0]));
        let values = of_light.iter().flat_map(|trial| trial.reference.iter().flatten().copied());
        let exposure = exposure(values.collect(), UNCLIPPED);
        for (row, trial) in of_light.iter().enumerate() {
            let top = layout.top + row * layout.row;
            if column == 0 {
                layout.name(&mut canvas, top, &title(&trial.names[1]));
            }
            let difference: Vec<[f64; 3]> = trial
                .ours
                .iter()
                .zip(&trial.reference)
                .map(|(a, b)| [0, 1, 2].map(|c| MAGNIFIED * (a[c] - b[c]).abs()))
                .collect();
            for (place, image) in
                [&trial.ours, &trial.reference, &difference].into_iter().enumerate()
            {
                let left = left + place * layout.step;
                for (pixel, rgb) in view.pixels.iter().zip(image) {
                    let color = rgb.map(|value| srgb(exposure * value));
                    canvas.blend(left + pixel.column, top + pixel.row, color, pixel.coverage);
                }
            }
            let error = format!("rms {:.2} %", 100.0 * trial.rms_error);
            let under = top + view.size + LETTER / 2;
            let middle = left + 2 * layout.step + view.size / 2;
            layout.centered(&mut canvas, middle, under, DIM, &error);
        }
    }
    write_png(path, canvas.width, canvas.height, &canvas.bytes)
}

/// A name without its leading number and its hyphens.
fn title(name: &str) -> String {
    let title = name.trim_start_matches(|letter: char| letter.is_ascii_digit() || letter == '-');
    let title = if title.is_empty() { name } else { title };
    title.replace('-', " ")
}

/// The layout, in pixels.
struct Layout {
    size: usize,
    scale: usize,
    margin: usize,
    left: usize,
    top: usize,
    /// From one sphere of a group to the next.
    step: usize,
    /// From one light to the next.
    group: usize,
    /// From one material to the next.
    row: usize,
}

impl Layout {
    fn new(size: usize, trials: &[Trial], rows: usize) -> Self {
        let scale = (size / 128).max(1);
        let margin = 3 * LETTER * scale;
        let names =
            trials.iter().take(rows).map(|trial| text_width(scale, &title(&trial.names[1])));
        let step = size + size / 16;
        Self {
            size,
            scale,
            margin,
            left: 2 * margin + names.max().unwrap_or(0),
            top: margin + 6 * LETTER * scale,
            step,
            group: 3 * step + margin,
            row: size + 3 * LETTER * scale,
        }
    }

    fn centered(&self, canvas: &mut Canvas, middle: usize, top: usize, color: [u8; 3], text: &str) {
        let left = middle.saturating_sub(text_width(self.scale, text) / 2);
        canvas.text(left, top, self.scale, color, text);
    }

    /// The light's name, and the labels below it.
    fn heading(&self, canvas: &mut Canvas, left: usize, name: &str) {
        let half = self.size / 2;
        let middle = left + self.step + half;
        let start = middle.saturating_sub(text_width(2 * self.scale, name) / 2);
        canvas.text(start, self.margin, 2 * self.scale, BRIGHT, name);
        let difference = format!("difference x {MAGNIFIED}");
        for (place, text) in ["ours", "reference", &difference].into_iter().enumerate() {
            let middle = left + place * self.step + half;
            self.centered(canvas, middle, self.top - 2 * LETTER * self.scale, DIM, text);
        }
    }

    fn name(&self, canvas: &mut Canvas, top: usize, name: &str) {
        let row = top + self.size / 2 - self.scale * LETTER / 2;
        canvas.text(self.margin, row, self.scale, BRIGHT, name);
    }
}
