//! `eigenshade render`: draws a sphere.

use super::choices::Choices;
use super::options::{FileEntry, Memory, count, format, positive};
use clap::{Args, ValueEnum};
use eigenshade::{Display, Effects, Meter, Rgb, Scalar, Tone};
use eigenshade_cli::messages::print_message;
use eigenshade_cli::messages::{Ringing, albedo_warning};
use eigenshade_cli::output;
use eigenshade_cli::picture::{SphereView, write_png};
use eigenshade_cli::presets;
use eigenshade_cli::table::{self, rounding};
use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::error::Result;
use eigenshade_shading::format::Format;
use eigenshade_shading::overflow;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader, fault, fitted, of_higher_order};
use eigenshade_shading::shipped;
use eigenshade_table::Table;
use eigenshade_table::scene::Geometry;
use std::path::{Path, PathBuf};

/// The share of the picture's pixels that the exposure leaves unclipped.
const UNCLIPPED: f32 = 0.99;

/// Draw a sphere as an sRGB PNG with a transparent background
///
/// Without --exposure, one pixel in a hundred is brighter than white in some channel. The picture
/// shows a sphere whatever the table's object is; a note says so if it is another.
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
    #[arg(long, default_value = "f32", value_parser = format(is_float))]
    format: Format,
    #[command(flatten)]
    choices: Choices,
    /// The factor from irradiance to what the tone curve shows, white being 1 [default: metered]
    #[arg(long, value_name = "E", value_parser = positive, allow_hyphen_values = true)]
    exposure: Option<f32>,
    /// Tone curve
    #[arg(long, value_enum, default_value_t = Curve::Linear)]
    tone: Curve,
    /// Write the picture to this file
    #[arg(long, value_name = "F.png")]
    out: PathBuf,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Curve {
    /// Clipped at white
    Linear,
    /// Reinhard's, white at 16
    Reinhard,
    /// A fit to the ACES curve
    Filmic,
}

/// Pictures are drawn in floats.
fn is_float(format: &Format) -> bool {
    matches!(*format, Format::F64 | Format::F32)
}

impl From<Curve> for Tone {
    fn from(curve: Curve) -> Self {
        match curve {
            Curve::Linear => Self::Linear,
            Curve::Reinhard => Self::Reinhard,
            Curve::Filmic => Self::Filmic,
        }
    }
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
        self.choices.check_rotation(&table)?;
        let path = self.table.as_deref().unwrap_or(Path::new("the shipped table"));
        let (components, effects) =
            (self.choices.components(&table, path)?, self.choices.effects(&table)?);
        let Lights { degree, entries } = presets::lights(memory.file(&light.path))?;
        let lights = Lights { degree, entries: vec![light.find_in(entries)?] };
        let Materials { order, entries } = presets::materials(memory.file(&material.path))?;
        let materials = Materials { order, entries: vec![material.find_in(entries)?] };
        let higher = of_higher_order(&material.path, order, table.gram.order);
        let rounded = self.format.of_table().and_then(|one| rounding::warning(&table, one));
        let warnings = [higher, albedo_warning(&materials), rounded].into_iter().flatten();
        let (mut lights, materials) = fitted(&table, &lights, &materials);
        self.choices.change(&mut lights);
        let view = SphereView::new(self.size);
        let scene = Pair { table: &table, lights: &lights, materials: &materials };
        let image = match self.format {
            Format::F64 => scene.shaded::<f64>(components, effects, &view),
            Format::Table(_) => scene.shaded::<f32>(components, effects, &view),
        }?;
        let values = || image.iter().flat_map(|&pixel| <[f32; 3]>::from(pixel)).map(f64::from);
        let mut ringing = Ringing::default();
        let pair = || overflow::pair(&lights.entries[0], &materials.entries[0]);
        let (least, largest) = (values().reduce(f64::min), values().reduce(f64::max));
        ringing.record(pair, least.unwrap_or_default(), largest.unwrap_or_default());
        let mut meter = Meter::default();
        image.iter().for_each(|&pixel| meter.add(pixel));
        let exposure = self.exposure.or_else(|| meter.exposure(UNCLIPPED)).unwrap_or(1.0);
        let display = Display::new(self.tone.into());
        let mut bytes = vec![0; 4 * self.size * self.size];
        for (&color, pixel) in image.iter().zip(&view.pixels) {
            let Rgb { r, g, b } = display.rgb888(color.exposed(exposure));
            let start = 4 * (pixel.row * self.size + pixel.column);
            let opacity = (255.0 * pixel.coverage).round() as u8;
            bytes[start..start + 4].copy_from_slice(&[r, g, b, opacity]);
        }
        write_png(&self.out, self.size, self.size, &bytes)?;
        let note = self.table.and_then(|path| note(&path, &table.scene.geometry));
        let ringing = ringing.note().filter(|_| self.choices.has_all_effects());
        note.into_iter().chain(warnings).chain(ringing).for_each(print_message);
        Ok(())
    }
}

/// One light on one material.
struct Pair<'a> {
    table: &'a Table,
    lights: &'a Lights,
    materials: &'a Materials,
}

impl Pair<'_> {
    /// The irradiances of the picture's pixels.
    fn shaded<S: Scalar + Into<f64>>(
        &self,
        components: usize,
        effects: Effects,
        view: &SphereView,
    ) -> Result<Vec<Rgb<f32>>> {
        let basis = OwnedBasis::<S>::new(self.table);
        let mut shader = Shader::new(basis.any().map_err(fault)?, components)
            .with_transfers(basis.transfers())
            .with_effects(effects)?;
        let normals = OwnedNormals::new(&view.normals);
        let light = (self.lights.degree, &self.lights.entries[0]);
        let material = (self.materials.order, &self.materials.entries[0]);
        let [r, g, b] = shader.color(light, material, &normals)?;
        let pixels = r.into_iter().zip(g).zip(b).map(|((r, g), b)| [r, g, b]);
        Ok(pixels.map(|pixel| pixel.map(|channel| channel.into() as f32).into()).collect())
    }
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
