//! `eigenshade render`: draws a sphere.

use super::options::{FileEntry, Memory, count};
use clap::{Args, ValueEnum};
use eigenshade::Scalar;
use eigenshade_cli::messages::print_message;
use eigenshade_cli::messages::{Ringing, albedo_warning};
use eigenshade_cli::output;
use eigenshade_cli::picture::{SphereView, exposure, srgb, write_png};
use eigenshade_cli::presets;
use eigenshade_cli::table::{self, rounding};
use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::error::Result;
use eigenshade_shading::overflow;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader, fault, fitted, of_higher_order};
use eigenshade_shading::shipped;
use eigenshade_table::scene::Geometry;
use eigenshade_table::{Table, wire};
use std::path::{Path, PathBuf};

/// The share of the picture's values that the exposure leaves unclipped.
const UNCLIPPED: f64 = 0.99;

/// Draw a sphere as an sRGB PNG with a transparent background
///
/// The exposure is chosen so that one value in a hundred clips. The picture shows a sphere
/// whatever the table's object is; a note says so if it is another.
#[derive(Args, Debug)]
pub struct Render {
    /// The table [default: the shipped one]
    #[arg(value_name = "B.bin")]
    table: Option<PathBuf>,
    /// The name of a shipped light, or a light CSV and the light's name, which is optional if the
    /// file has one light
    #[arg(long, value_name = "NAME|FILE[:NAME]")]
    light: String,
    /// The name of a shipped material, or a material CSV and the material's name, which is optional
    /// if the file has one material
    #[arg(long, value_name = "NAME|FILE[:NAME]")]
    material: String,
    /// Pixels across, 2 to 8192
    #[arg(long, value_name = "N", default_value = "512", value_parser = count(2, 8192))]
    size: usize,
    /// Number format
    #[arg(long, value_enum, default_value_t = Format::F32)]
    format: Format,
    /// Write the picture to this file
    #[arg(long, value_name = "F.png")]
    out: PathBuf,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Format {
    F64,
    F32,
}

impl Render {
    pub fn run(self, memory: Memory) -> Result<()> {
        let (light, material) = (FileEntry::new(&self.light), FileEntry::new(&self.material));
        let inputs = [&light.path, &material.path].into_iter().chain(&self.table);
        output::refuse_collisions([&self.out], inputs)?;
        let table = match &self.table {
            Some(path) => table::read(memory.file(path))?,
            None => table::decode(shipped::TABLE)?,
        };
        let Lights { degree, entries } = presets::lights(memory.file(&light.path))?;
        let lights = Lights { degree, entries: vec![light.find_in(entries)?] };
        let Materials { order, entries } = presets::materials(memory.file(&material.path))?;
        let materials = Materials { order, entries: vec![material.find_in(entries)?] };
        let higher = of_higher_order(&material.path, order, table.gram.order);
        let rounded = match self.format {
            Format::F32 => rounding::warning(&table, wire::Format::F32),
            Format::F64 => None,
        };
        let warnings = [higher, albedo_warning(&materials), rounded].into_iter().flatten();
        let (lights, materials) = fitted(&table, &lights, &materials);
        let view = SphereView::new(self.size);
        let image = match self.format {
            Format::F32 => shaded::<f32>(&table, &lights, &materials, &view),
            Format::F64 => shaded::<f64>(&table, &lights, &materials, &view),
        }?;
        let values: Vec<f64> = image.iter().flatten().copied().collect();
        let least = values.iter().copied().fold(f64::INFINITY, f64::min);
        let largest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let mut ringing = Ringing::default();
        let pair = || overflow::pair(&lights.entries[0], &materials.entries[0]);
        ringing.record(pair, least, largest);
        let exposure = exposure(values, UNCLIPPED);
        let mut bytes = vec![0; 4 * self.size * self.size];
        for (k, pixel) in view.pixels.iter().enumerate() {
            let start = 4 * (pixel.row * self.size + pixel.column);
            for (channel, byte) in image.iter().zip(&mut bytes[start..]) {
                *byte = srgb(exposure * channel[k]);
            }
            bytes[start + 3] = (255.0 * pixel.coverage).round() as u8;
        }
        write_png(&self.out, self.size, self.size, &bytes)?;
        let note = self.table.and_then(|path| note(&path, &table.scene.geometry));
        note.into_iter().chain(warnings).chain(ringing.note()).for_each(print_message);
        Ok(())
    }
}

/// The three channels of the first light on the first material.
fn shaded<S: Scalar + Into<f64>>(
    table: &Table,
    lights: &Lights,
    materials: &Materials,
    view: &SphereView,
) -> Result<[Vec<f64>; 3]> {
    let basis = OwnedBasis::<S>::new(table);
    let mut shader =
        Shader::new(basis.any().map_err(fault)?, table.count()).with_transfers(basis.transfers());
    let normals = OwnedNormals::new(&view.normals);
    let light = (lights.degree, &lights.entries[0]);
    let image = shader.color(light, (materials.order, &materials.entries[0]), &normals)?;
    Ok(image.map(|channel| channel.into_iter().map(Into::into).collect()))
}

/// A note if the table at `path` is of another object than a sphere.
fn note(path: &Path, geometry: &Geometry) -> Option<String> {
    if geometry.normals == "sphere" {
        return None;
    }
    let density = geometry.density.as_ref().map(|density| format!(" {density}"));
    Some(format!(
        "note: the picture shows a sphere; {} was made for the object `{}{}`, and its components \
         are the best for that object, not for a sphere; use `shade` for the normals of the object",
        path.display(),
        geometry.normals,
        density.unwrap_or_default(),
    ))
}
