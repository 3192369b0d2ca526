//! `eigenshade render`: draws a sphere, a mesh or a normal map, or makes a matcap.

use super::choices::Choices;
use super::highlights::{HighlightInputs, sharpness_note, within};
use super::options::{
    Green, Inputs, Memory, Sources, TableChoice, choice, count, exposure, sources, tolerance,
};
use clap::builder::TypedValueParser;
use clap::{Args, ValueEnum};
use eigenshade::{Effects, Exposure, Matcap, Rgb, Scalar, Tolerance, Tone};
use eigenshade_cli::messages::{Ringing, albedo_warning, dark_light_warning, print_message};
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
/// channel. An .exr holds linear irradiance times the exposure, multiplied by opacity. Without
/// --normals, the picture shows a sphere whatever the table's object is; a note says so if it is
/// another.
#[derive(Args, Debug)]
pub struct Render {
    #[command(flatten)]
    table: TableChoice,
    #[command(flatten)]
    inputs: Inputs,
    /// What to draw: `sphere`, a normal map (.png), or a mesh (.obj, .stl, .ply) from +z
    #[arg(short, long, value_name = "NORMALS", default_value = "sphere")]
    normals: PathBuf,
    /// Make a matcap: the texel at (u, v), v up, has the normal whose x and y are 2u - 1 and 2v -
    /// 1. three and blender are for engines that multiply normals by 0.495 and 0.496 instead of 1/2
    #[arg(long, value_name = "FOR", value_parser = engines(), num_args = 0..=1,
        require_equals = true, default_missing_value = "half", conflicts_with = "normals")]
    matcap: Option<f32>,
    /// Pixels across the longer side, 2 to 8192; a normal map can only shrink [default: 512, or all
    /// of a normal map]
    #[arg(short, long, value_name = "N", value_parser = count(2, 8192))]
    size: Option<usize>,
    #[command(flatten)]
    green: Green,
    /// Number format
    #[arg(short, long, value_enum, default_value_t = Format::F32)]
    format: Format,
    #[command(flatten)]
    choices: Choices,
    /// Shade up to K small bright sources of the light by the material's gloss, for sharp
    /// highlights: 1, 2, 4, 8 or 16 of a shipped light. `auto` takes as few as --tolerance allows
    /// and, without --table, the table `color` or `pbr` with which a pixel takes the fewest
    /// multiply-adds, for pictures of all components without a window. Needs a shipped material in
    /// color, or a CSV with FILE.gloss.csv beside it, which `material` writes
    #[arg(long, value_name = "K|auto", value_parser = sources, conflicts_with = "effects")]
    sources: Option<Sources>,
    /// What `--sources auto` allows: the root mean square error of the picture, as a share of the
    /// peak, or decibels below it, like 1e-2 or 40dB [default: 1e-2]
    #[arg(long, value_name = "T", value_parser = tolerance, requires = "sources")]
    tolerance: Option<Tolerance<f64>>,
    /// The factor from irradiance to what the tone curve shows, white being 1 [default: metered,
    /// and 1 for an .exr]
    #[arg(long, value_name = "E", value_parser = exposure)]
    exposure: Option<Exposure>,
    /// Tone curve of a PNG [default: linear]
    #[arg(long, value_parser = tones())]
    tone: Option<Tone>,
    /// Write the picture to this file, .png or .exr
    #[arg(short, long, value_name = "FILE")]
    out: PathBuf,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Format {
    F64,
    F32,
}

/// The radius of a matcap for an engine.
fn engines() -> impl TypedValueParser<Value = f32> {
    choice([("half", "", 1.0), ("three", "", Matcap::THREE_JS), ("blender", "", Matcap::BLENDER)])
}

fn tones() -> impl TypedValueParser<Value = Tone> {
    choice([
        ("linear", "Clipped at white", Tone::Linear),
        ("reinhard", "Reinhard's, white at 16", Tone::Reinhard),
        ("filmic", "A fit to the ACES curve", Tone::Filmic),
    ])
}

impl Render {
    pub fn run(self, memory: Memory) -> Result<()> {
        let inputs = self.inputs.files(&[&self.normals, self.table.path()]);
        output::refuse_collisions([&self.out], inputs)?;
        let Inputs { light, material } = &self.inputs;
        let file = PictureFile::of(&self.out)?;
        if file == PictureFile::Exr && self.tone.is_some() {
            let remedy = "leave --tone out, or write a .png";
            return Err(Error::new("an .exr has no tone curve", remedy).in_file(&self.out));
        }
        let Lights { degree, entries } = light.lights(memory.of_file())?;
        let lights = Lights { degree, entries: vec![light.only(entries)?] };
        let one = |order| -> Result<Materials> {
            let Materials { order, entries } = material.materials(order, memory.of_file())?;
            Ok(Materials { order, entries: vec![material.only(entries)?] })
        };
        let mut materials = one(usize::MAX)?;
        let (choice, most) = self.chosen(&lights, &materials, memory)?;
        let table = choice.read(memory)?;
        if material.is_shipped() {
            materials = one(table.gram.order)?;
        }
        self.choices.check_rotation(&table)?;
        let components = self.choices.components(&table, choice.path())?;
        let effects = self.choices.effects(&table)?;
        let higher = of_higher_order(material.named(), materials.order, table.gram.order);
        let rounded = rounding::warning(&table, wire::NumberFormat::F32);
        let rounded = rounded.filter(|_| matches!(self.format, Format::F32));
        let dark = dark_light_warning(&lights);
        let is_dark = dark.is_some();
        let warnings = [higher, albedo_warning(&materials), dark, rounded].into_iter().flatten();
        let (mut lights, materials) = fitted(&table, &lights, &materials);
        let highlights = match most {
            Some(most) => {
                let pair = (&mut lights, &materials);
                HighlightInputs::taken_out(&self.inputs, &table, pair, most, memory)?
            }
            None => None,
        };
        let sources = highlights.as_ref().map_or(0, HighlightInputs::count);
        let highlights = highlights.map(|inputs| inputs.turned(&self.choices));
        self.choices.change(&mut lights);
        let is_sphere = self.normals.as_os_str() == "sphere";
        let object = match self.matcap {
            Some(radius) => {
                let texels = Matcap::new(self.size.unwrap_or(SIZE)).map_err(fault)?;
                Object::Matcap(texels.with_radius(radius).map_err(fault)?)
            }
            None if is_sphere && !self.green.is_flipped => {
                Object::Sphere(self.size.unwrap_or(SIZE))
            }
            None => {
                let file = memory.file(&self.normals);
                Object::View(ObjectView::read(file, self.size, self.green.is_flipped)?)
            }
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
        let tone = self.tone.unwrap_or_default();
        let development = Development { exposure, tone, is_opaque };
        file.write(&self.out, object.size(), development, &mut draw)?;
        let mut ringing = Ringing::default();
        let pair = || overflow::pair(&lights.entries[0], &materials.entries[0]);
        ringing.record(pair, least, largest);
        let note = note(choice.path(), &table.scene.geometry).filter(|_| is_sphere);
        let ringing = ringing.note().filter(|_| self.choices.has_all_effects() && !is_dark);
        let pair = (&lights, &materials);
        let sharp = sharpness_note(&self.inputs, &table, pair, sources, memory)?;
        let whole = if self.choices.is_partial() {
            "; this is for a picture of all components, without a window"
        } else {
            ""
        };
        let sharp = sharp.filter(|_| effects == Effects::ALL).map(|note| note + whole);
        note.into_iter().chain(warnings).chain(ringing).chain(sharp).for_each(print_message);
        Ok(())
    }

    /// The table, and the most sources if there may be any.
    fn chosen(
        &self,
        lights: &Lights,
        materials: &Materials,
        memory: Memory,
    ) -> Result<(TableChoice, Option<usize>)> {
        let given = || self.table.or("color");
        let tolerance = match self.tolerance {
            None => WITHIN,
            Some(Tolerance::OfPeak(share)) => share,
            Some(Tolerance::Decibels(decibels)) => 10_f64.powf(-f64::from(decibels) / 20.0),
            Some(_) => return Err(Error::new("this tolerance is not supported", "give a share")),
        };
        match (self.sources, self.tolerance) {
            (Some(Sources::Most(_)), Some(_)) => {
                let remedy = "leave one out, or give --sources auto";
                Err(Error::new("--tolerance chooses the number of sources, which is given", remedy))
            }
            (Some(Sources::Most(most)), None) => Ok((given(), Some(most))),
            (None, _) => Ok((given(), None)),
            (Some(Sources::Auto), _) if self.choices.is_partial() => {
                let remedy = "leave --components and --window out, or give a number: --sources 4";
                Err(Error::new("--sources auto is for whole pictures", remedy))
            }
            (Some(Sources::Auto), _) => {
                let light = (lights.entries[0].name.as_str(), lights.degree);
                let material = (materials.entries[0].name.as_str(), materials.order);
                let pair = (light, material);
                let (table, most) = within(tolerance, &self.inputs, &self.table, pair, memory)?;
                Ok((table, Some(most)))
            }
        }
    }
}

/// What `--sources auto` allows by default.
const WITHIN: f64 = 1e-2;

/// One light on one material.
struct Pair<'a> {
    highlights: Option<HighlightInputs>,
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
        let (light, material) = (&self.lights.entries[0], &self.materials.entries[0]);
        let highlights = self.highlights.as_ref().map(HighlightInputs::shaded::<S>).transpose()?;
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
         are the best for that object, not for a sphere; draw the object with `render --normals \
         OBJECT`, or `shade` its normals",
        path.display(),
        geometry.normals,
        density.unwrap_or_default(),
    ))
}
