//! `eigenshade list`: the shipped lights and materials.

use clap::Args;
use eigenshade_cli::output;
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::error::Result;
use eigenshade_shading::shipped;
use serde::Serialize;

/// List the shipped lights and materials
///
/// The options --light and --material take these names in place of a file. Writes the CSV
/// `kind,name,size,color,error_9_7,error_12_12`: size is the degree of a light or the order of a
/// material, and color is `rgb` or `gray`. The errors are those of the material's pictures at
/// degree 9 and order 7 and at 12 and 12 against direct integration of its BRDF: rms as a share of
/// the peak, the median over 18 maps. They are empty for lights, and for materials that were
/// measured in few directions.
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
    error_12_12: Option<f64>,
}

impl List {
    pub fn run(self) -> Result<()> {
        let Lights { degree, entries: lights } = shipped::lights()?;
        let Materials { order, entries: materials } = shipped::named_materials()?;
        let row = |(kind, size, entry): (&'static str, usize, Named)| {
            let color = if entry.is_gray() { "gray" } else { "rgb" };
            let [error_9_7, error_12_12] = shipped::ERROR_SIZES.map(|size| {
                let error = shipped::total_error(&entry.name, size)?;
                (kind == "material").then_some(error.median)
            });
            Row { kind, name: entry.name, size, color, error_9_7, error_12_12 }
        };
        let lights = lights.into_iter().map(|entry| ("light", degree, entry));
        let materials = materials.into_iter().map(|entry| ("material", order, entry));
        let rows: Vec<Row> = lights.chain(materials).map(row).collect();
        output::write_records(None, self.json, &rows)
    }
}
