//! `eigenshade project`: writes the coefficients of images in a table's eigenimages.

use super::options::{Destination, Inputs, TableChoice, count};
use clap::Args;
use eigenshade_cli::messages::{albedo_warning, print_message};
use eigenshade_cli::output::{self, Rows, exact};
use eigenshade_cli::table;
use eigenshade_model::error::Result;
use eigenshade_model::evaluation::Evaluator;
use eigenshade_model::overflow;
use eigenshade_shading::shader::{fitted, of_higher_order};

/// Project every light on every material onto a table's components
///
/// Writes the CSV `light,material,component,r,g,b`: d = U^T M c in f64, channel by channel. Degrees
/// and orders beyond the table's are dropped; lower ones are used as they are.
#[derive(Args, Debug)]
pub struct Project {
    #[command(flatten)]
    table: TableChoice,
    #[command(flatten)]
    inputs: Inputs,
    /// Only the first K components
    #[arg(long, value_name = "K", value_parser = count(1, u64::from(u16::MAX)))]
    components: Option<usize>,
    #[command(flatten)]
    out: Destination,
}

impl Project {
    pub fn run(self) -> Result<()> {
        output::refuse_collisions(&self.out.path, self.inputs.files(&[self.table.path()]))?;
        let table = self.table.read()?;
        let components = table::components(&table, self.components, self.table.path())?;
        let lights = self.inputs.light.lights()?;
        let materials = self.inputs.material.materials(table.gram.order)?;
        let higher =
            of_higher_order(self.inputs.material.named(), materials.order, table.gram.order);
        let warnings = higher.into_iter().chain(albedo_warning(&materials));
        let (lights, materials) = fitted(&table, &lights, &materials);
        let evaluator = Evaluator::new(&table).with_components(components);
        output::write(self.out.path.as_deref(), |out| {
            let header = ["light", "material", "component", "r", "g", "b"];
            let mut rows = Rows::new(out, header)?;
            for light in &lights.entries {
                for material in &materials.entries {
                    let channel = |c: usize| -> Result<Vec<f64>> {
                        let (of_light, of_material) = (&light.rgb[c], &material.rgb[c]);
                        evaluator
                            .project(of_light, of_material)
                            .and_then(|d| overflow::checked(d, of_light, of_material))
                            .map_err(|error| error.of(overflow::pair(light, material)))
                    };
                    let (red, green, blue) = (channel(0)?, channel(1)?, channel(2)?);
                    for (index, ((r, g), b)) in red.iter().zip(&green).zip(&blue).enumerate() {
                        let [r, g, b] = [r, g, b].map(|value| exact(*value));
                        rows.row([&light.name, &material.name, &index.to_string(), &r, &g, &b])?;
                    }
                }
            }
            rows.finish()
        })?;
        warnings.for_each(print_message);
        Ok(())
    }
}
