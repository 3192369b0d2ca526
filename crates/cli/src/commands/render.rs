//! `eigenshade render`: draws a sphere, a mesh or a normal map, or makes a matcap.

use super::choices::Choices;
use super::gleam::Gleam;
use super::options::{Inputs, Memory, TableChoice, count, positive};
use clap::{Args, ValueEnum};
use eigenshade::{Effects, Matcap, Rgb, Scalar, Tone};
use eigenshade_cli::messages::print_message;
use eigenshade_cli::messages::{Ringing, albedo_warning};
use eigenshade_cli::object::{Object, ObjectView, SIZE};
use eigenshade_cli::output;
use eigenshade_cli::picture::Pixel;
use eigenshade_cli::picture_file::{Development, PictureFile};
use eigenshade_cli::table::rounding;
use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::error::{Error, Result};
use eigenshade_shading::overflow;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader, fault, fitted, of_higher_order};
use eigenshade_table::scene::Geometry;
use eigenshade_table::{Table, wire};
use std::path::{Path, PathBuf};

/// Draw a sphere, a mesh or a normal map with a transparent background, or make a matcap
///
/// A PNG is in sRGB. Without --exposure, one pixel in a hundred is brighter than white in some
/// channel. An .exr holds linear irradiance times the exposure, multiplied by opacity. The picture
/// shows a sphere whatever the table's object is; a note says so if it is another.
#[derive(Args, Debug)]
pub struct Render {
    #[command(flatten)]
    table: TableChoice,
    #[command(flatten)]
    inputs: Inputs,
    /// What to draw: `sphere`, a normal map (.png), or a mesh (.obj, .stl, .ply) from +z
    #[arg(short, long, value_name = "NORMALS", default_value = "sphere")]
    normals: PathBuf,
    /// Make a matcap: the texel at (u, v), v up, has the normal whose x and y are 2u - 1 and 2v - 1.
    /// three and blender are for engines that multiply normals by 0.495 and 0.496 instead of 1/2
    #[arg(long, value_name = "FOR", value_enum, num_args = 0..=1, require_equals = true,
        default_missing_value = "half", conflicts_with = "normals")]
    matcap: Option<Engine>,
    /// Pixels across the longer side, 2 to 8192; a normal map can only shrink [default: 512, or all
    /// of a normal map]
    #[arg(short, long, value_name = "N", value_parser = count(2, 8192))]
    size: Option<usize>,
    /// Number format
    #[arg(short, long, value_enum, default_value_t = Format::F32)]
    format: Format,
    #[command(flatten)]
    choices: Choices,
    /// Shade up to K small bright sources of the light by the material's gloss, for sharp highlights:
    /// 1, 2, 4 or 8 of a shipped light. Needs a shipped material in color
    #[arg(long, value_name = "K", value_parser = count(1, 32), conflicts_with = "effects")]
    sources: Option<usize>,
    /// The factor from irradiance to what the tone curve shows, white being 1 [default: metered,
    /// and 1 for an .exr]
    #[arg(long, value_name = "E", value_parser = positive, allow_hyphen_values = true)]
    exposure: Option<f32>,
    /// Tone curve of a PNG [default: linear]
    #[arg(long, value_enum)]
    tone: Option<Curve>,
    /// Write the picture to this file, .png or .exr
    #[arg(short, long, value_name = "FILE")]
    out: PathBuf,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Format {
    F64,
    F32,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Engine {
    Half,
    Three,
    Blender,
}

impl Engine {
    fn radius(self) -> f32 {
        match self {
            Self::Half => 1.0,
            Self::Three => Matcap::THREE_JS,
            Self::Blender => Matcap::BLENDER,
        }
    }
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
        let Inputs { light, material } = &self.inputs;
        let inputs = [self.table.path(), light.path(), material.path(), &self.normals];
        output::refuse_collisions([&self.out], inputs)?;
        let file = PictureFile::of(&self.out)?;
        if file == PictureFile::Exr && self.tone.is_some() {
            let remedy = "leave --tone out, or write a .png";
            return Err(Error::new("an .exr has no tone curve", remedy).in_file(&self.out));
        }
        let table = self.table.read(memory)?;
        self.choices.check_rotation(&table)?;
        let components = self.choices.components(&table, self.table.path())?;
        let effects = self.choices.effects(&table)?;
        let Lights { degree, entries } = light.lights(memory.of_file())?;
        let lights = Lights { degree, entries: vec![light.only(entries)?] };
        let Materials { order, entries } = material.materials(memory.of_file())?;
        let materials = Materials { order, entries: vec![material.only(entries)?] };
        let higher = of_higher_order(material.path(), order, table.gram.order);
        let rounded = match self.format {
            Format::F32 => rounding::warning(&table, wire::Format::F32),
            Format::F64 => None,
        };
        let warnings = [higher, albedo_warning(&materials), rounded].into_iter().flatten();
        let (mut lights, materials) = fitted(&table, &lights, &materials);
        let highlights = match self.sources {
            Some(most) => Gleam::taken_out(&self.inputs, &mut lights, most, memory)?,
            None => None,
        };
        let highlights = highlights.map(|gleam| gleam.turned(&self.choices));
        self.choices.change(&mut lights);
        let is_sphere = self.normals.as_os_str() == "sphere";
        let object = match self.matcap {
            Some(engine) => Object::Matcap(self.size.unwrap_or(SIZE), engine.radius()),
            None if is_sphere => Object::Sphere(self.size.unwrap_or(SIZE)),
            None => Object::View(ObjectView::read(memory.file(&self.normals), self.size)?),
        };
        let [width, height] = object.size();
        memory.file(&self.out).admit_pixels((width * height) as u64, file.bytes_per_pixel(), 0)?;
        let scene = Pair { table: &table, lights: &lights, materials: &materials, highlights };
        let (mut least, mut largest) = (f64::INFINITY, f64::NEG_INFINITY);
        let mut draw = |show: &mut dyn FnMut(Pixel, Rgb<f32>)| {
            let mut show = |pixel, color: Rgb<f32>| {
                for value in <[f32; 3]>::from(color).map(f64::from) {
                    (least, largest) = (least.min(value), largest.max(value));
                }
                show(pixel, color);
            };
            match self.format {
                Format::F32 => scene.draw::<f32>(components, effects, &object, &mut show),
                Format::F64 => scene.draw::<f64>(components, effects, &object, &mut show),
            }
        };
        let (exposure, is_opaque) = (self.exposure, self.matcap.is_some());
        let tone = self.tone.map_or(Tone::Linear, Tone::from);
        let development = Development { exposure, tone, is_opaque };
        file.write(&self.out, object.size(), development, &mut draw)?;
        let mut ringing = Ringing::default();
        let pair = || overflow::pair(&lights.entries[0], &materials.entries[0]);
        ringing.record(pair, least, largest);
        let note = note(self.table.path(), &table.scene.geometry).filter(|_| is_sphere);
        let ringing = ringing.note().filter(|_| self.choices.has_all_effects());
        let sharp = material.error_note(table.gram.order);
        note.into_iter().chain(warnings).chain(ringing).chain(sharp).for_each(print_message);
        Ok(())
    }
}

/// One light on one material.
struct Pair<'a> {
    highlights: Option<Gleam>,
    table: &'a Table,
    lights: &'a Lights,
    materials: &'a Materials,
}

/// Pixels that are shaded together.
const BAND: usize = 1 << 16;

impl Pair<'_> {
    /// Calls `show` with each pixel of an object and its irradiance.
    fn draw<S: Scalar + Into<f64>>(
        &self,
        components: usize,
        effects: Effects,
        object: &Object,
        show: &mut dyn FnMut(Pixel, Rgb<f32>),
    ) -> Result<()> {
        let basis = OwnedBasis::<S>::new(self.table);
        let mut shader = Shader::new(basis.any().map_err(fault)?, components)
            .with_transfers(basis.transfers())
            .with_effects(effects)?;
        let light = (self.lights.degree, &self.lights.entries[0]);
        let material = (self.materials.order, &self.materials.entries[0]);
        let highlights = self.highlights.as_ref().map(Gleam::shaded::<S>).transpose()?;
        let mut all = object.pixels();
        loop {
            let (pixels, normals): (Vec<Pixel>, Vec<_>) = all.by_ref().take(BAND).unzip();
            if pixels.is_empty() {
                return Ok(());
            }
            let normals = OwnedNormals::new(&normals);
            let [r, g, b] = shader.color(light, material, &normals)?;
            let colors = r.into_iter().zip(g).zip(b).map(|((r, g), b)| Rgb::new(r, g, b));
            let mut colors: Vec<Rgb<S>> = colors.collect();
            if let Some(highlights) = &highlights {
                highlights.add_slice(normals.view()?, &mut colors).map_err(fault)?;
            }
            for (pixel, color) in pixels.into_iter().zip(colors) {
                show(pixel, color.map(|channel| channel.into() as f32));
            }
        }
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
