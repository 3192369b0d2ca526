//! The errors of the demo: its spheres against the direct sum, with times.

use super::demo_sheet::{BACKGROUND, BRIGHT, DIM, text_height, title};
use eigenshade_cli::messages::progress_bar;
use eigenshade_cli::picture::{
    Canvas, SphereView, TextHeight, exposure, srgb, text_width, write_png,
};
use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::error::Result;
use eigenshade_shading::reference_image;
use eigenshade_shading::shader::{Lit, OwnedNormals, Shader, fault};
use serde::Serialize;
use std::fmt::Write;
use std::path::Path;
use std::time::Instant;

/// The number of timings, of which the shortest counts.
const TIMINGS: usize = 5;
/// Factor by which differences are shown.
const MAGNIFIED: f64 = 10.0;
/// The share of a light's values that its exposure leaves unclipped.
const UNCLIPPED: f64 = 0.98;

/// The errors of one light on one material.
#[derive(Serialize)]
pub struct Errors {
    light: String,
    material: String,
    components: usize,
    /// 1 - energy of the difference / energy of the reference about its mean.
    energy_kept: f64,
    /// Root mean square of the difference, as a share of the reference's peak.
    rms_error: f64,
    /// Largest difference, as a share of the reference's peak.
    max_error: f64,
    /// Nanoseconds a pixel, in three channels.
    nanoseconds: f64,
}

/// Errors, and r, g and b of every pixel, of our image and of the reference.
pub struct Trial {
    pub errors: Errors,
    ours: Vec<[f64; 3]>,
    reference: Vec<[f64; 3]>,
}

/// Every light on every material, ordered by light.
pub fn trials(
    shader: &mut Shader<'_, f32>,
    components: usize,
    (lights, materials): (&Lights, &Materials),
    view: &SphereView,
) -> Result<Vec<Trial>> {
    let progress = progress_bar("reference", view.normals.len());
    let reference = reference_image::images(lights, materials, &view.normals, &progress);
    progress.finish_and_clear();
    let normals = OwnedNormals::new(&view.normals);
    let mut trials = Vec::new();
    for light in &lights.entries {
        for material in &materials.entries {
            let channel = |c: usize| -> Lit<'_> {
                ((lights.degree, &light.rgb[c]), (materials.order, &material.rgb[c]))
            };
            let ours =
                shader.color((lights.degree, light), (materials.order, material), &normals)?;
            let ours = (0..view.normals.len())
                .map(|k| ours.each_ref().map(|channel| f64::from(channel[k])))
                .collect();
            let reference = reference.iter().map(|of_pairs| of_pairs[trials.len()]).collect();
            let nanoseconds = time(shader, [0, 1, 2].map(channel), &normals)?;
            let names = [&light.name, &material.name];
            trials.push(Trial::new(names, components, nanoseconds, [ours, reference], view));
        }
    }
    Ok(trials)
}

/// Nanoseconds of shading a pixel in three channels: the shortest of a few timings.
fn time(
    shader: &mut Shader<'_, f32>,
    channels: [Lit<'_>; 3],
    normals: &OwnedNormals<f32>,
) -> Result<f64> {
    let normals = normals.view()?;
    let mut irradiance = vec![0.0; normals.len()];
    let mut total = 0.0;
    for (light, material) in channels {
        shader.project(light, material)?;
        let scene = shader.scene()?;
        let mut shortest = f64::INFINITY;
        for _ in 0..TIMINGS {
            let start = Instant::now();
            scene.shade_slice(normals, &mut irradiance).map_err(fault)?;
            std::hint::black_box(&mut irradiance);
            shortest = shortest.min(start.elapsed().as_secs_f64());
        }
        total += shortest;
    }
    Ok(1e9 * total / normals.len() as f64)
}

/// The errors as text in columns.
pub fn aligned(trials: &[Trial]) -> String {
    let wide = |of: fn(&Errors) -> &String| trials.iter().map(|one| of(&one.errors).len()).max();
    let light = wide(|errors| &errors.light).unwrap_or(0).max(5);
    let material = wide(|errors| &errors.material).unwrap_or(0).max(8);
    let mut text = format!(
        "{:light$}  {:material$}  components  energy kept  rms error  max error  ns/pixel\n",
        "light", "material"
    );
    for Trial { errors: one, .. } in trials {
        let _ = writeln!(
            text,
            "{:light$}  {:material$}  {:>10}  {:>11.7}  {:>9.1e}  {:>9.1e}  {:>8.1}",
            one.light,
            one.material,
            one.components,
            one.energy_kept,
            one.rms_error,
            one.max_error,
            one.nanoseconds
        );
    }
    text
}

impl Trial {
    /// Measures the errors over the pixels inside the disc, whose normals have the
    /// density cos(α)/π; the peak is that of all pixels, the rim included.
    fn new(
        [light, material]: [&String; 2],
        components: usize,
        nanoseconds: f64,
        [ours, reference]: [Vec<[f64; 3]>; 2],
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
        let errors = Errors {
            light: light.clone(),
            material: material.clone(),
            components,
            energy_kept: 1.0 - residual / energy,
            rms_error: (residual / (3.0 * count)).sqrt() / peak,
            max_error: worst / peak,
            nanoseconds,
        };
        Self { errors, ours, reference }
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
        layout.heading(&mut canvas, left, &title(&of_light[0].errors.light));
        let values = of_light.iter().flat_map(|trial| trial.reference.iter().flatten().copied());
        let exposure = exposure(values.collect(), UNCLIPPED);
        for (row, trial) in of_light.iter().enumerate() {
            let top = layout.top + row * layout.row;
            if column == 0 {
                layout.name(&mut canvas, top, &title(&trial.errors.material));
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
            let error = format!("rms {:.0e}", trial.errors.rms_error);
            let under = (left + 2 * layout.step + view.size / 2, top + view.size);
            canvas.centered_text(under, layout.text, DIM, &error);
        }
    }
    write_png(path, canvas.width, canvas.height, &canvas.bytes)
}

/// The layout, in pixels.
struct Layout {
    size: usize,
    text: TextHeight,
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
        let text = text_height(size);
        let line = text.val();
        let margin = 2 * line;
        let of = trials.iter().take(rows).map(|one| text_width(text, &title(&one.errors.material)));
        let step = size + size / 16;
        Self {
            size,
            text,
            margin,
            left: 2 * margin + of.max().unwrap_or(0),
            top: margin + 3 * line,
            step,
            group: 3 * step + margin,
            row: size + 3 * line / 2,
        }
    }

    /// The light's name, and the labels below it.
    fn heading(&self, canvas: &mut Canvas, left: usize, name: &str) {
        let middle = |place: usize| left + place * self.step + self.size / 2;
        canvas.centered_text((middle(1), self.margin), self.text, BRIGHT, name);
        let difference = format!("difference x {MAGNIFIED}");
        for (place, text) in ["ours", "reference", &difference].into_iter().enumerate() {
            let under = self.margin + 3 * self.text.val() / 2;
            canvas.centered_text((middle(place), under), self.text, DIM, text);
        }
    }

    fn name(&self, canvas: &mut Canvas, top: usize, name: &str) {
        let row = top + (self.size - self.text.val()) / 2;
        canvas.text((self.margin, row), self.text, BRIGHT, name);
    }
}
