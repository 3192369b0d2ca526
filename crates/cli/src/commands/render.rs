//! `eigenshade render`: draws a sphere, a mesh or a normal map, or makes a matcap.

use super::choices::Choices;
use super::drawing::Drawing;
use super::highlights::{HighlightInputs, estimate_note, needed};
use super::options::{
    Green, Inputs, Pose, Sources, TableChoice, WindowChoice, choice, count, exposure, input_file,
    sources, tolerance,
};
use clap::builder::TypedValueParser;
use clap::{Args, ValueEnum};
use eigenshade::Rgb;
use eigenshade::object::Matcap;
use eigenshade::screen::{Exposure, Tone};
use eigenshade_cli::messages::{Ringing, albedo_warning, dark_light_warning, print_message};
use eigenshade_cli::object::{Object, ObjectOptions, ObjectView, SIZE};
use eigenshade_cli::output;
use eigenshade_cli::picture_file::PictureFile;
use eigenshade_cli::table::rounding;
use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::evaluation::Evaluator;
use eigenshade_model::overflow;
use eigenshade_model::window::Window;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::picture::Development;
use eigenshade_shading::picture::Pixel;
use eigenshade_shading::presets::Source;
use eigenshade_shading::preview::Preview;
use eigenshade_shading::shader::{OwnedNormals, Shader, fault, fitted, of_higher_order};
use eigenshade_table::effect::Effects;
use eigenshade_table::{Table, wire};
use std::path::{Path, PathBuf};

/// Draw a sphere, a mesh or a normal map with a transparent background, or make a matcap
///
/// A PNG is in sRGB. Without --exposure, one pixel in a hundred is brighter than white in some
/// channel; where the median pixel would be darker than 0.12 of white, up to one in ten is. An .exr
/// holds linear irradiance times the exposure, multiplied by opacity. Without --normals, the
/// picture shows a sphere whatever the table's object is; a note says so if it is another.
#[derive(Args, Debug)]
pub struct Render {
    #[command(flatten)]
    pub(super) table: TableChoice,
    #[command(flatten)]
    pub(super) inputs: RenderInputs,
    /// What to draw: `sphere`, a normal map (.png), or a mesh (.obj, .stl, .ply, .glb, .gltf) from +z
    #[arg(short, long, visible_alias = "object", value_name = "OBJECT", default_value = "sphere")]
    pub(super) normals: PathBuf,
    /// Make a matcap: the texel at (u, v), v up, has the normal whose x and y are 2u - 1 and 2v -
    /// 1. three and blender are for engines that multiply normals by 0.495 and 0.496 instead of 1/2
    #[arg(long, value_name = "FOR", value_parser = engines(), num_args = 0..=1,
        require_equals = true, default_missing_value = "half", conflicts_with = "normals")]
    matcap: Option<f32>,
    /// Pixels across the longer side, 2 to 8192; a normal map can only shrink [default: 512, or all
    /// of a normal map]
    #[arg(short, long, value_name = "N", value_parser = count(2, 8192))]
    pub(super) size: Option<usize>,
    #[command(flatten)]
    pub(super) green: Green,
    #[command(flatten)]
    pub(super) pose: Pose,
    /// Number format
    #[arg(short, long, value_enum, default_value_t = Format::F32)]
    pub(super) format: Format,
    /// Draw a mesh with the shadows that it casts on itself, up to 512 pixels across and 256 by default.
    /// The light is harmonics alone, of all degrees that it has
    #[cfg(feature = "generate")]
    #[arg(long = "shadows", requires = "normals", conflicts_with_all = ["matcap",
        "format", "table", "components", "effects", "sources", "tolerance"])]
    has_shadows: bool,
    #[command(flatten)]
    pub(super) choices: Choices,
    /// Shade up to K small bright sources of the light by the material's gloss, for sharp
    /// highlights: 1, 2, 4, 8 or 16 of a shipped light, or 0. `auto` takes as few as the picture
    /// needs to be close on a screen, at most 8, by the errors of `docs/highlights.md`; none where
    /// they are not known: for a material without gloss (shipped materials in color have one, and
    /// so has a CSV with FILE.gloss.csv beside it, which `material` writes), for a light without
    /// sources, and with --effects [default: auto]
    #[arg(long, value_name = "K|auto", value_parser = sources, conflicts_with = "effects")]
    pub(super) sources: Option<Sources>,
    /// What `--sources auto` allows instead: the root mean square error of the picture, as a share of
    /// white, like 2e-2
    #[arg(long, value_name = "T", value_parser = tolerance)]
    pub(super) tolerance: Option<f64>,
    /// The factor from irradiance to what the tone curve shows, white being 1 [default: metered,
    /// and 1 for an .exr]
    #[arg(long, value_name = "E", value_parser = exposure)]
    pub(super) exposure: Option<Exposure>,
    /// Tone curve of a PNG [default: linear]
    #[arg(long, value_parser = tones())]
    pub(super) tone: Option<Tone>,
    /// Write the picture to this file, .png or .exr
    #[arg(short, long, value_name = "FILE")]
    pub(super) out: PathBuf,
}

/// The light and the material of a picture.
#[derive(Args, Debug)]
pub struct RenderInputs {
    /// Light: the name of a shipped one, a light CSV, or one light of a CSV
    #[arg(short, long, value_name = "NAME|FILE[:NAME]")]
    pub light: Source,
    /// Material: the name of a shipped one, a material CSV, or one material of a CSV [default: those
    /// of the object, if it has any]
    #[arg(short, long, value_name = "NAME|FILE[:NAME]")]
    pub material: Option<Source>,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum Format {
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

/// An object without a material.
pub fn no_material() -> Error {
    let what = "no material, and the object has none of its own";
    Error::new(what, "give --material NAME, or a .glb, .gltf, or .obj with its .mtl")
}

impl Render {
    pub fn run(self) -> Result<()> {
        let others = [self.normals.as_path(), self.table.path()].map(Path::to_path_buf);
        let RenderInputs { light, material } = &self.inputs;
        let of_material = material.as_ref().map(Source::material_files).unwrap_or_default();
        let inputs = [&others[..], &light.light_files(), &of_material].concat();
        output::refuse_collisions([&self.out], inputs)?;
        let file = PictureFile::of(&self.out)?;
        if file == PictureFile::Exr && self.tone.is_some() {
            let remedy = "leave --tone out, or write a .png";
            return Err(Error::new("an .exr has no tone curve", remedy).in_file(&self.out));
        }
        if let (Some(Sources::Most(_)), Some(_)) = (self.sources, self.tolerance) {
            let what = "--tolerance chooses the number of sources, which is given";
            return Err(Error::new(what, "leave one out, or give --sources auto"));
        }
        #[cfg(feature = "generate")]
        if let Some((object, asset)) = self.own_materials()? {
            return if self.has_shadows {
                self.run_own_shadowed(file, &object, asset)
            } else {
                self.run_own(file, &object, &asset)
            };
        }
        let material = material.clone().ok_or_else(no_material)?;
        let inputs = Inputs { light: light.clone(), material };
        #[cfg(feature = "generate")]
        if self.has_shadows {
            return self.run_shadowed(file, &inputs);
        }
        self.run_with(file, &inputs)
    }

    /// Draws an object in one material.
    fn run_with(&self, file: PictureFile, inputs: &Inputs) -> Result<()> {
        let Inputs { light, material } = inputs;
        let Lights { degree, entries } = light.lights()?;
        let lights = Lights { degree, entries: vec![light.only(entries)?] };
        let one = |order| -> Result<Materials> {
            let Materials { order, entries } = material.materials(order)?;
            Ok(Materials { order, entries: vec![material.only(entries)?] })
        };
        let mut materials = one(usize::MAX)?;
        let choice = self.table.or(DEFAULT_TABLE);
        let table = choice.read()?;
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
        let pair = (&lights, &materials);
        let all_effects = self.choices.has_all_effects();
        let (most, note_of_error) = match self.sources {
            _ if !all_effects => (0, None),
            Some(Sources::Most(most)) => (most, estimate_note(inputs, &table, pair, most)?),
            None | Some(Sources::Auto) => needed(inputs, &table, pair, self.tolerance)?,
        };
        let highlights = match most {
            0 => None,
            most => {
                let pair = (&mut lights, &materials);
                HighlightInputs::taken_out(inputs, &table, pair, most)?
            }
        };
        let sources = highlights.as_ref().map_or(0, HighlightInputs::count);
        let highlights = highlights.map(|inputs| inputs.turned(&self.choices));
        self.choices.rotate(&mut lights);
        let scene = Pair { table: &table, lights: &lights, materials: &materials, highlights };
        let window = match self.choices.window().unwrap_or(WindowChoice::Auto) {
            WindowChoice::Given(window) => window,
            // Parts of a picture may be dark.
            WindowChoice::Auto if !all_effects => Window::None,
            WindowChoice::Auto => scene.window(components, self.format, self.exposure)?,
        };
        let highlights = scene.highlights;
        for channel in &mut lights.entries[0].rgb {
            window.apply(channel);
        }
        let is_sphere = self.normals.as_os_str() == "sphere";
        let options = self.pose.options(self.size, self.green);
        let object = match self.matcap {
            Some(radius) => {
                let texels = Matcap::new(self.size.unwrap_or(SIZE)).map_err(fault)?;
                Object::Matcap(texels.with_radius(radius).map_err(fault)?)
            }
            None if is_sphere && options == ObjectOptions::of_size(self.size) => {
                Object::Sphere(self.size.unwrap_or(SIZE))
            }
            None => Object::View(ObjectView::read(input_file(&self.normals), options)?),
        };
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
                Format::F32 => scene.draw(components, effects, &object, &mut show),
                Format::F64 => scene.draw_in_f64(components, effects, &object, &mut show),
            }
        };
        let (exposure, is_opaque) = (self.exposure, self.matcap.is_some());
        let tone = self.tone.unwrap_or_default();
        let development = Development { exposure, tone, is_opaque };
        file.write(&self.out, object.size(), development, &mut draw)?;
        let mut ringing = Ringing::default();
        let pair = || overflow::pair(&lights.entries[0], &materials.entries[0]);
        ringing.record(pair, least, largest);
        let ringing = ringing.note().filter(|_| self.choices.has_all_effects() && !is_dark);
        let drawing = Drawing { table: choice.path(), components, sources, window };
        let drawn = (all_effects && !is_dark).then(|| drawing.to_string());
        #[cfg(feature = "generate")]
        let warnings = warnings.chain(match object {
            Object::View(_) if sources > 0 => {
                super::shadows::warning(&self.normals, &options.view())?
            }
            _ => None,
        });
        let notes = drawn.into_iter().chain(warnings).chain(ringing);
        notes.chain(note_of_error).for_each(print_message);
        Ok(())
    }
}

/// The table that the runtime contains.
const DEFAULT_TABLE: &str = "sphere";

/// One light on one material.
pub struct Pair<'a> {
    pub highlights: Option<HighlightInputs>,
    pub table: &'a Table,
    pub lights: &'a Lights,
    pub materials: &'a Materials,
}

/// Pixels that are shaded together.
const BAND: usize = 1 << 16;
/// Pixels whose eigenimages are in memory together.
const BAND_IN_F64: usize = 1 << 12;

impl Pair<'_> {
    /// The window of the light for a whole picture of these components.
    pub fn window(
        &self,
        components: usize,
        format: Format,
        exposure: Option<Exposure>,
    ) -> Result<Window> {
        let highlights = self.highlights.as_ref().map(HighlightInputs::shaded).transpose()?;
        let (light, material) = (&self.lights.entries[0], &self.materials.entries[0]);
        let channels = [0, 1, 2].map(|c: usize| (&light.rgb[c][..], &material.rgb[c][..]));
        let window = match format {
            Format::F32 => {
                let basis = OwnedBasis::new(self.table)?;
                let mut shader = Shader::new(basis.basis().map_err(fault)?, components)
                    .with_transfers(basis.transfers());
                Preview::new(&mut shader, highlights.as_ref()).window(&channels, exposure)
            }
            Format::F64 => {
                let evaluator = Evaluator::new(self.table).with_components(components);
                Preview::in_f64(&evaluator, highlights.as_ref()).window(&channels, exposure)
            }
        };
        window.map_err(|error| error.of(overflow::pair(light, material)))
    }

    /// Calls `show` with each pixel of an object and its irradiance, in f32.
    fn draw(
        &self,
        components: usize,
        effects: Effects,
        object: &Object,
        show: &mut dyn FnMut(Pixel, Rgb<f32>),
    ) -> Result<()> {
        let basis = OwnedBasis::new(self.table)?;
        let mut shader = Shader::new(basis.basis().map_err(fault)?, components)
            .with_transfers(basis.transfers())
            .with_effects(effects)?;
        let (light, material) = (&self.lights.entries[0], &self.materials.entries[0]);
        let highlights = self.highlights.as_ref().map(HighlightInputs::shaded).transpose()?;
        let mut all = object.pixels();
        loop {
            let (pixels, normals): (Vec<Pixel>, Vec<_>) = all.by_ref().take(BAND).unzip();
            if pixels.is_empty() {
                return Ok(());
            }
            let normals = OwnedNormals::new(&normals);
            let [r, g, b] = shader.color(light, material, &normals)?;
            let colors = r.into_iter().zip(g).zip(b).map(|((r, g), b)| Rgb::new(r, g, b));
            let mut colors: Vec<Rgb<f32>> = colors.collect();
            if let Some(highlights) = &highlights {
                highlights.add_slice(normals.view()?, &mut colors).map_err(fault)?;
            }
            for (pixel, color) in pixels.into_iter().zip(colors) {
                show(pixel, color);
            }
        }
    }

    /// [`draw`](Self::draw) in f64.
    fn draw_in_f64(
        &self,
        components: usize,
        effects: Effects,
        object: &Object,
        show: &mut dyn FnMut(Pixel, Rgb<f32>),
    ) -> Result<()> {
        let evaluator = Evaluator::new(self.table).with_components(components);
        let evaluator = evaluator.with_effects(effects)?;
        let (light, material) = (&self.lights.entries[0], &self.materials.entries[0]);
        let named = |error: Error| error.of(overflow::pair(light, material));
        let d = |c: usize| evaluator.project(&light.rgb[c], &material.rgb[c]).map_err(named);
        let d = [d(0)?, d(1)?, d(2)?];
        let highlights = self.highlights.as_ref().map(HighlightInputs::in_f64);
        let mut all = object.pixels();
        loop {
            let (pixels, normals): (Vec<Pixel>, Vec<_>) = all.by_ref().take(BAND_IN_F64).unzip();
            if pixels.is_empty() {
                return Ok(());
            }
            let eigenimages = evaluator.eigenimages(&normals);
            let channel = |c: usize| {
                let image = eigenimages.reconstruct(&d[c]);
                overflow::checked(image, &light.rgb[c], &material.rgb[c]).map_err(named)
            };
            let rgb = [channel(0)?, channel(1)?, channel(2)?];
            for (k, (pixel, normal)) in pixels.into_iter().zip(normals).enumerate() {
                let lit = highlights.as_ref().map_or([0.0; 3], |of| of.irradiance(normal));
                show(pixel, [0, 1, 2].map(|c: usize| (rgb[c][k] + lit[c]) as f32).into());
            }
        }
    }
}
