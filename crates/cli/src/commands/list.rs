//! `eigenshade list`: the shipped lights and materials.

use clap::Args;
use eigenshade_cli::output::{self, Rows};
use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::error::Result;
use eigenshade_shading::shipped;

/// List the shipped lights and materials
///
/// Each command takes one of these names in place of a file. Writes the CSV `kind,name,size,color`:
/// size is the degree of a light or the order of a material, and color is `rgb` or `gray`.
#[derive(Args, Debug)]
pub struct List {}

impl List {
    pub fn run() -> Result<()> {
        let Lights { degree, entries: lights } = shipped::lights()?;
        let Materials { order, entries: materials } = shipped::named_materials()?;
        let kinds = [("light", degree, lights), ("material", order, materials)];
        output::write(None, |out| {
            let mut rows = Rows::new(out, ["kind", "name", "size", "color"])?;
            for (kind, size, entries) in &kinds {
                for entry in entries {
                    let color = if entry.is_gray() { "gray" } else { "rgb" };
                    rows.row([*kind, &entry.name, &size.to_string(), color])?;
                }
            }
            rows.finish()
        })
    }
}
