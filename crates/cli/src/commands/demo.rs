//! `eigenshade demo`: draws the shipped materials under the shipped lights.

use super::demo_relief;
use super::demo_sheet::{self, Column, Row, title};
use super::options::{Memory, TableChoice, count};
use clap::Args;
use eigenshade_cli::messages::print_message;
use eigenshade_cli::object::ObjectView;
use eigenshade_cli::output;
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::output::writable;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader, fault, fitted};
use eigenshade_shading::shipped;
use serde::Serialize;
use std::fs;
use std::path::{Path, PathBuf};

/// Draw a relief and spheres of measured materials under captured lights
///
/// Writes demo.png, computed in f32.
#[derive(Args, Debug)]
pub struct Demo {
    #[command(flatten)]
    table: TableChoice,
    /// Folder for the picture; created if needed
    #[arg(short, long, value_name = "DIR")]
    out: PathBuf,
    /// Pixels across each object, 16 to 512
    #[arg(short, long, value_name = "N", default_value = "160", value_parser = count(16, 512))]
    size: usize,
    /// Print the name of the picture as a JSON object
    #[arg(long)]
    json: bool,
}

#[derive(Serialize)]
struct Answer {
    files: [String; 1],
}

impl Demo {
    pub fn run(self, memory: Memory) -> Result<()> {
        fs::create_dir_all(&self.out).map_err(|error| Error::io(&self.out, &error))?;
        let file = self.out.join("demo.png");
        writable(&file)?;
        let table = self.table.read(memory)?;
        let (lights, materials) = shown()?;
        let (lights, materials) = fitted(&table, &lights, &materials);
        let basis = OwnedBasis::<f32>::new(&table);
        let components = table.count();
        let mut shader =
            Shader::new(basis.any().map_err(fault)?, components).with_transfers(basis.transfers());
        self.draw(&file, &mut shader, &lights, &materials)?;
        let file = file.display().to_string();
        if self.json {
            return output::write_json(None, &Answer { files: [file] });
        }
        print_message(file);
        Ok(())
    }

    fn draw(
        &self,
        file: &Path,
        shader: &mut Shader<'_, f32>,
        lights: &Lights,
        materials: &Materials,
    ) -> Result<()> {
        let (relief, sphere) = (demo_relief::view(self.size), ObjectView::sphere(self.size));
        // The most metallic material, which is the last, is also that of the relief.
        let metal = materials.entries.last().map(|material| (material, &relief));
        let spheres = materials.entries.iter().map(|material| (material, &sphere));
        let shown: Vec<(&Named, &ObjectView)> = metal.into_iter().chain(spheres).collect();
        let mut rows = Vec::new();
        for light in &lights.entries {
            let mut images = Vec::new();
            for (material, view) in &shown {
                let normals = OwnedNormals::new(&view.normals);
                images.push(shader.color(light, material, &normals)?);
            }
            rows.push(Row { title: title(&light.name), images });
        }
        let column = |(material, view): (&Named, _)| Column { title: title(&material.name), view };
        let columns: Vec<Column<'_>> = shown.into_iter().map(column).collect();
        demo_sheet::draw(file, &columns, &rows)
    }
}

/// The shipped lights and materials of the picture.
fn shown() -> Result<(Lights, Materials)> {
    let lights = shipped::lights()?;
    let materials = shipped::named_materials(7)?;
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
