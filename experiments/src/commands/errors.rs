//! `experiments errors`: a table against direct integration.

use super::command_line;
use clap::Args;
use eigenshade_cli::messages::{print_message, progress_bar};
use eigenshade_cli::output::{self, Rows, write_error};
use eigenshade_cli::table;
use eigenshade_cli::table::recorded_errors::{COLUMNS, Stamp};
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::light::projection::named_maps;
use eigenshade_generator::material;
use eigenshade_generator::material::brdf::{Measure, Projected, Surface};
use eigenshade_generator::material::files::Source;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::coefficient_csv::read_lights;
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_table::Table;
use experiments::light_tree::LightTree;
use experiments::numbers::median;
use experiments::reference::{self, Reference};
use experiments::sheet::fields;
use std::path::{Path, PathBuf};

/// Degrees at which the direct sum is shown beside the table; the order is the same.
const OTHERS: [usize; 2] = [16, 24];

/// Compares a table with direct integration of materials under maps
///
/// The reference has no truncation: it uses the BRDF as a function and each texel as a patch of
/// constant radiance, without harmonics; distant texels are integrated in blocks. The error is the
/// rms over a sphere's normals and the channels, relative to the largest irradiance. For each
/// material the CSV gives the median and the worst error over the maps: of the table with all its
/// components, of the direct sum at its degree and order, and at 16, 16 and 24, 24 as far as the
/// lights reach. The sides of the maps must be multiples of 8. Figures below 0.001 are below the
/// verified accuracy of the integration. The last two columns identify the table, so that `basis`
/// recognizes errors of another one.
#[derive(Args, Debug)]
pub struct Errors {
    /// Table
    #[arg(value_name = "B.bin")]
    table: PathBuf,
    /// Light CSV, with the light of every map under the map's name
    #[arg(long, value_name = "FILE")]
    lights: PathBuf,
    /// Maps (.exr, .hdr, .pfm) of the same size, or folders of maps
    #[arg(long, value_name = "MAP", required = true)]
    maps: Vec<PathBuf>,
    /// Materials given as functions: .toml of formulas, MERL .binary, or folders of them
    #[arg(long, value_name = "PATH", required = true)]
    materials: Vec<PathBuf>,
    /// Write the CSV to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

impl Errors {
    pub fn run(self) -> Result<()> {
        let named = named_maps(&self.maps)?;
        let materials = self.materials.iter().flat_map(|path| material::files::files(path));
        let maps = named.iter().map(|(_, map)| map.clone());
        let inputs = [self.table.clone(), self.lights.clone()].into_iter().chain(maps);
        output::refuse_collisions(&self.out, inputs.chain(materials))?;
        let table = self.table()?;
        let (degree, order) = (table.gram.degree, table.gram.order);
        let lights = read_lights(file(&self.lights), None)?;
        let lights = reference::named(&lights, named.iter().map(|(name, _)| name.as_str()))
            .map_err(|error| error.in_file(&self.lights))?;
        if lights.degree < degree {
            let found = lights.degree;
            let what = format!("the lights have degree {found}, the table has degree {degree}");
            return Err(Error::new(what, "give lights of the table's degree").in_file(&self.lights));
        }
        let surfaces = self.surfaces()?;
        let maps = named.iter().map(|(_, path)| EnvironmentMap::from_path(file(path)));
        let maps = LightTree::new(&maps.collect::<Result<Vec<_>>>()?)?;
        let others = OTHERS.into_iter().filter(|&size| size <= lights.degree);
        let sums: Vec<_> = [(degree, order)].into_iter().chain(others.map(|s| (s, s))).collect();
        let orders: Vec<usize> = sums.iter().map(|&(_, order)| order).collect();
        let stamp = Stamp::of(&table);
        output::write(self.out.as_deref(), |out| {
            if self.out.is_some() {
                writeln!(out, "# {}", command_line()).map_err(write_error)?;
            }
            let mut rows = Rows::new(out, COLUMNS)?;
            for surface in &surfaces {
                let name = &surface.name;
                let reference = Reference::new(surface, &maps, &progress_bar("normals", 0));
                if let Some(black) = reference.black() {
                    let what = format!("`{name}` is black under `{}`", named[black].0);
                    return Err(Error::new(what, "leave it out: its images have no peak"));
                }
                let mut row = |degree: usize, order: usize, components: String, errors: &[f64]| {
                    let worst = (0..errors.len()).max_by(|&a, &b| errors[a].total_cmp(&errors[b]));
                    let worst = worst.unwrap_or_default();
                    let (middle, most, map) = (median(errors), errors[worst], &named[worst].0);
                    print_message(format_args!(
                        "{name} {degree}, {order} {components}: median {middle:.2e}, worst {most:.2e} ({map})"
                    ));
                    let [middle, most] = [middle, most].map(|error| format!("{error:.6}"));
                    let found = fields(&[name, &degree, &order, &components, &middle, &most, map]);
                    let normals = reference.sphere.normals.len();
                    let of_run = fields(&[&normals, &stamp.scene, &stamp.energy]);
                    rows.row([found, of_run].concat())
                };
                let components = table.count().to_string();
                row(degree, order, components, &reference.of_table(&lights, &table)?)?;
                let projected = surface.project_orders(&orders, Measure::Projected);
                for (&size, Projected { material, .. }) in sums.iter().zip(&projected) {
                    let errors = reference.of_sum(&lights, size, material);
                    row(size.0, size.1, String::new(), &errors)?;
                }
            }
            rows.finish()
        })
    }

    fn table(&self) -> Result<Table> {
        let table = table::read(file(&self.table))?;
        let (what, remedy) = if table.general.is_some() || !table.has_projection() {
            let what = "it is not a complete table of a sphere under light that turns freely";
            (what, "make one: only such tables are compared with direct integration")
        } else if !table.effects().is_all() || !table.scene.effects.color {
            let what = "it lacks effects or color, which direct integration has";
            (what, "use a table of all effects, in color")
        } else {
            return Ok(table);
        };
        Err(Error::new(what, remedy).in_file(&self.table))
    }

    fn surfaces(&self) -> Result<Vec<Surface>> {
        let mut surfaces = Vec::new();
        for path in &self.materials {
            for source in material::files::read(file(path))? {
                match source {
                    Source::Surface(surface) => surfaces.push(surface),
                    Source::Measured(measured) => {
                        let what = format!("`{}` is measured at points only", measured.name);
                        return Err(Error::new(what, "give formulas or MERL files").in_file(path));
                    }
                }
            }
        }
        Ok(surfaces)
    }
}

/// Maps of 4k by 2k exceed the limit for a user's files.
fn file(path: impl AsRef<Path>) -> InputFile {
    InputFile::new(path)
}
