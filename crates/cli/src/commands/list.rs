//! `eigenshade list`: the shipped lights and materials.

use clap::Args;
use eigenshade_cli::output;
use eigenshade_index::material;
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::error::Result;
use eigenshade_shading::shipped;
use serde::Serialize;

/// List the shipped lights and materials
///
/// The options --light and --material take these names in place of a file. Writes the CSV
/// `kind,name,size,color,error_9_7,worst_9_7,error_12_12,worst_12_12`: size is the degree of a
/// light or the highest order of a material, and color is `rgb` or `gray`. The errors are those of
/// the material's pictures at degree 9 and order 7 and at 12 and 12 against direct integration of
/// its BRDF: rms as a share of the peak, the median over 18 maps and the worst map's. They are empty
/// for lights, and for materials that were measured in few directions. `render` prints a note if the
/// worst map's is above 0.05, or a pixel is off by 0.6 of the peak.
#[derive(Args, Debug)]
pub struct List {
    /// Write a JSON array of objects
    #[arg(long)]
    json: bool,
}

#[derive(Serialize)]
struct Row {
    kind: &'static str,
    name: String,
    size: usize,
    color: &'static str,
    error_9_7: Option<f64>,
    worst_9_7: Option<f64>,
    error_12_12: Option<f64>,
    worst_12_12: Option<f64>,
}

impl List {
    pub fn run(self) -> Result<()> {
        let Lights { degree, entries: lights } = shipped::lights()?;
        let Materials { entries: materials, .. } = shipped::named_materials(usize::MAX)?;
        let row = |(kind, size, entry): (&'static str, usize, Named)| {
            let color = if entry.is_gray() { "gray" } else { "rgb" };
            let errors = shipped::ERROR_SIZES
                .map(|size| shipped::total_error(&entry.name, size).filter(|_| kind == "material"));
            let [error_9_7, error_12_12] = errors.map(|error| Some(error?.median));
            let [worst_9_7, worst_12_12] = errors.map(|error| Some(error?.worst));
            let name = entry.name;
            Row { kind, name, size, color, error_9_7, worst_9_7, error_12_12, worst_12_12 }
        };
        let lights = lights.into_iter().map(|entry| ("light", degree, entry));
        let materials = materials.into_iter().map(|entry| ("material", order(&entry), entry));
        let rows: Vec<Row> = lights.chain(materials).map(row).collect();
        output::write_records(None, self.json, &rows)
    }
}

/// The highest order with a coefficient.
fn order(material: &Named) -> usize {
    let coefficients = material.rgb.iter().map(|channel| {
        channel.iter().rposition(|&coefficient| coefficient != 0.0).unwrap_or_default()
    });
    let last = coefficients.max().unwrap_or_default();
    (0..).find(|&order| material::count(order) > last).unwrap_or_default()
}
