//! `eigenshade list`: the shipped lights and materials.

use clap::Args;
use eigenshade_cli::output;
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::error::Result;
use eigenshade_model::shipped;
use eigenshade_table::material;
use serde::Serialize;

/// List the shipped lights and materials
///
/// The options --light and --material take these names in place of a file. Writes the CSV
/// `kind,name,size,color` and, for degree 9 with order 7 and for 12 with 12,
/// `mean_9_7,mean_most_9_7,p95_9_7,p95_most_9_7`: size is the degree of a light or the highest order
/// of a material, and color is `rgb` or `gray`. The other columns are the screen errors of the
/// material's pictures as `render` draws them, with up to 8 sources, against direct integration of
/// its BRDF under 18 maps: CIEDE2000, the mean over the pixels and what 95 of 100 pixels do not
/// exceed, each the median over the maps and what 95 of 100 maps do not exceed. A mean of 1 with 95
/// of 100 pixels within 2 is not visible, 2 and 5 are close. The columns are empty for lights, and
/// for materials that were measured in few directions.
#[derive(Args, Debug)]
pub struct List {
    /// Write a JSON array of objects
    #[arg(long)]
    json: bool,
}

/// The most sources that `render` takes by itself.
const SOURCES: usize = 8;

#[derive(Serialize)]
struct Row {
    kind: &'static str,
    name: String,
    size: usize,
    color: &'static str,
    mean_9_7: Option<f64>,
    mean_most_9_7: Option<f64>,
    p95_9_7: Option<f64>,
    p95_most_9_7: Option<f64>,
    mean_12_12: Option<f64>,
    mean_most_12_12: Option<f64>,
    p95_12_12: Option<f64>,
    p95_most_12_12: Option<f64>,
}

impl List {
    pub fn run(self) -> Result<()> {
        let Lights { degree, entries: lights } = shipped::lights()?;
        let Materials { entries: materials, .. } = shipped::named_materials(usize::MAX)?;
        let row = |(kind, size, entry): (&'static str, usize, Named)| {
            let color = if entry.is_gray() { "gray" } else { "rgb" };
            let errors = shipped::ERROR_SIZES.map(|size| {
                shipped::total_error(&entry.name, size, SOURCES).filter(|_| kind == "material")
            });
            let [low, high] = errors;
            Row {
                kind,
                name: entry.name,
                size,
                color,
                mean_9_7: low.map(|error| error.median.mean),
                mean_most_9_7: low.map(|error| error.most.mean),
                p95_9_7: low.map(|error| error.median.p95),
                p95_most_9_7: low.map(|error| error.most.p95),
                mean_12_12: high.map(|error| error.median.mean),
                mean_most_12_12: high.map(|error| error.most.mean),
                p95_12_12: high.map(|error| error.median.p95),
                p95_most_12_12: high.map(|error| error.most.p95),
            }
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
