//! `eigenshade list`: the shipped lights and materials.

use clap::Args;
use eigenshade_cli::output::{self, Rows};
use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::error::Result;
use eigenshade_shading::shipped;

const COLUMNS: [&str; 6] = ["kind", "name", "size", "color", "error_9_7", "error_12_12"];

/// The degrees and orders of the errors.
const SIZES: [(usize, usize); 2] = [(9, 7), (12, 12)];

/// List the shipped lights and materials
///
/// Each command takes one of these names in place of a file. Writes the CSV
/// `kind,name,size,color,error_9_7,error_12_12`: size is the degree of a light or the order of a
/// material, and color is `rgb` or `gray`. The errors are those of the material's pictures at degree
/// 9 and order 7 and at 12 and 12 against direct integration of its BRDF: rms as a share of the
/// peak, the median over 18 maps. They are empty for lights, and for materials that were measured
/// in few directions.
#[derive(Args, Debug)]
pub struct List {}

impl List {
    pub fn run() -> Result<()> {
        let Lights { degree, entries: lights } = shipped::lights()?;
        let Materials { order, entries: materials } = shipped::named_materials()?;
        let kinds = [("light", degree, lights), ("material", order, materials)];
        output::write(None, |out| {
            let mut rows = Rows::new(out, COLUMNS)?;
            for (kind, size, entries) in &kinds {
                for entry in entries {
                    let color = if entry.is_gray() { "gray" } else { "rgb" };
                    let [at_9_7, at_12_12] = SIZES.map(|size| match *kind {
                        "material" => shipped::total_error(&entry.name, size)
                            .map_or(String::new(), |error| format!("{:.4}", error.median)),
                        _ => String::new(),
                    });
                    let size = size.to_string();
                    rows.row([*kind, &entry.name, &size, color, &at_9_7, &at_12_12])?;
                }
            }
            rows.finish()
        })
    }
}
