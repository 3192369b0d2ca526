//! `eigenshade demo`: draws the shipped materials under the shipped lights.

use super::demo_sheet::{self, Trial};
use super::options::count;
use clap::Args;
use eigenshade_cli::messages::{print_message, progress_bar};
use eigenshade_cli::output::{self, Rows, exact};
use eigenshade_cli::picture::SphereView;
use eigenshade_cli::table;
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::output::writable;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader, fault, fitted};
use eigenshade_shading::{reference_image, shipped};
use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;
use std::time::Instant;

/// The number of timings, of which the shortest counts.
const TIMINGS: usize = 5;

/// Draw spheres of measured materials under captured lights, with their errors
///
/// Writes demo.png and demo.csv, and prints the numbers: the share of the image's energy about its
/// mean that the components keep, the rms and the largest error relative to the image's peak, and
/// nanoseconds per pixel in three channels. The pictures are computed in f32 with the components
/// with which `render` draws; the reference is the sum over all modes of the table's degree and
/// order in f64.
#[derive(Args, Debug)]
pub struct Demo {
    /// Folder for the files; created if needed
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Pixels across each sphere, 16 to 512
    #[arg(long, value_name = "N", default_value = "128", value_parser = count(16, 512))]
    size: usize,
}

impl Demo {
    pub fn run(self) -> Result<()> {
        fs::create_dir_all(&self.out).map_err(|error| Error::io(&self.out, &error))?;
        let [picture, sheet] = ["demo.png", "demo.csv"].map(|name| self.out.join(name));
        writable(&picture)?;
        writable(&sheet)?;
        let table = table::decode(shipped::COLOR)?;
        let (lights, materials) = shown()?;
        let (lights, materials) = fitted(&table, &lights, &materials);
        let view = SphereView::new(self.size);
        let progress = progress_bar("reference", view.normals.len());
        let reference = reference_image::images(&lights, &materials, &view.normals, &progress);
        progress.finish_and_clear();

        let basis = OwnedBasis::<f32>::new(&table);
        let components = table.count();
        let mut shader = Shader::new(basis.any().map_err(fault)?, components);
        let normals = OwnedNormals::new(&view.normals);
        let mut trials = Vec::new();
        for light in &lights.entries {
            for material in &materials.entries {
                let (of_light, of_material) = ((lights.degree, light), (materials.order, material));
                let ours = shader.color(of_light, of_material, &normals)?;
                let ours = (0..view.normals.len())
                    .map(|k| ours.each_ref().map(|channel| f64::from(channel[k])))
                    .collect();
                let reference = reference.iter().map(|of_pairs| of_pairs[trials.len()]).collect();
                let names = [&light.name, &material.name].map(Clone::clone);
                let mut trial = Trial::new(names, components, ours, reference, &view);
                trial.nanoseconds = time(&mut shader, of_light, of_material, &normals)?;
                trials.push(trial);
            }
        }
        demo_sheet::draw(&picture, &view, &trials, materials.entries.len())?;
        output::write(Some(&sheet), |out| rows(&trials, out))?;
        output::write_all(None, aligned(&trials))?;
        print_message(format_args!("{} and {}", picture.display(), sheet.display()));
        Ok(())
    }
}

/// The shipped lights and materials of the picture.
fn shown() -> Result<(Lights, Materials)> {
    let lights = shipped::lights()?;
    let materials = shipped::named_materials()?;
    let entries = chosen(lights.entries, &shipped::SHOWN_LIGHTS)?;
    let lights = Lights { degree: lights.degree, entries };
    let entries = chosen(materials.entries, &shipped::SHOWN_MATERIALS)?;
    Ok((lights, Materials { order: materials.order, entries }))
}

fn chosen(entries: Vec<Named>, names: &[&str]) -> Result<Vec<Named>> {
    let find = |name: &&str| entries.iter().find(|entry| entry.name == **name).cloned();
    let missing = |name: &&str| {
        Error::new(format!("the shipped data have no `{name}`"), "build the program again")
    };
    names.iter().map(|name| find(name).ok_or_else(|| missing(name))).collect()
}

/// Nanoseconds of shading a pixel in three channels: the shortest of a few timings.
fn time(
    shader: &mut Shader<'_, f32>,
    (degree, light): (usize, &Named),
    (order, material): (usize, &Named),
    normals: &OwnedNormals<f32>,
) -> Result<f64> {
    let normals = normals.view()?;
    let mut irradiance = vec![0.0; normals.len()];
    let mut total = 0.0;
    for (light, material) in light.rgb.iter().zip(&material.rgb) {
        shader.project((degree, light), (order, material))?;
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

fn rows(trials: &[Trial], out: &mut dyn std::io::Write) -> Result<()> {
    let mut rows = Rows::new(
        out,
        ["light", "material", "components", "energy_kept", "rms_error", "max_error", "nanoseconds"],
    )?;
    for trial in trials {
        let [light, material] = trial.names.clone();
        let numbers = [trial.energy_kept, trial.rms_error, trial.max_error, trial.nanoseconds];
        let fields = [light, material, trial.components.to_string()];
        rows.row(fields.into_iter().chain(numbers.map(exact)))?;
    }
    rows.finish()
}

fn aligned(trials: &[Trial]) -> String {
    let wide = |which: usize| trials.iter().map(|trial| trial.names[which].len()).max();
    let (light, material) = (wide(0).unwrap_or(0).max(5), wide(1).unwrap_or(0).max(8));
    let mut text = format!(
        "{:light$}  {:material$}  components  energy kept  rms error  max error  ns/pixel\n",
        "light", "material"
    );
    for trial in trials {
        let [name, of] = &trial.names;
        let _ = writeln!(
            text,
            "{name:light$}  {of:material$}  {:>10}  {:>11.7}  {:>9.1e}  {:>9.1e}  {:>8.1}",
            trial.components,
            trial.energy_kept,
            trial.rms_error,
            trial.max_error,
            trial.nanoseconds
        );
    }
    text
}
