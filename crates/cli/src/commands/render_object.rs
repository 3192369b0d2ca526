//! `eigenshade render` of an object with materials of its own.

use super::highlights::HighlightInputs;
use super::options::{Sources, WindowChoice, input_file};
use super::render::{Drawing, Format, Pair, Render};
use eigenshade::screen::Exposure;
use eigenshade::{Effect, Rgb};
use eigenshade_asset::asset::Asset;
use eigenshade_asset::texels::{Covered, Texels};
use eigenshade_cli::estimate::{Estimate, Estimates};
use eigenshade_cli::messages::{dark_light_warning, print_message, spinner};
use eigenshade_cli::object::{SIZE, pixel_of};
use eigenshade_cli::picture::Pixel;
use eigenshade_cli::picture_file::{Development, PictureFile};
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::highlights as model;
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::source::Source;
use eigenshade_model::window::Window;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{Shader, fault, fitted};
use eigenshade_shading::textured::{Texel, irradiance};
use eigenshade_table::Table;

/// The table of pictures of glTF's materials.
const TABLE: &str = "pbr";

/// The largest order of the series of glTF's materials.
const MOST_ORDER: usize = 12;

/// The most sources that are taken without being asked for.
const MOST: usize = 8;

impl Render {
    /// The object to draw, if it has materials of its own and no other is asked for.
    pub fn own_materials(&self) -> Result<Option<(InputFile, Asset)>> {
        if self.inputs.material.is_some() {
            return Ok(None);
        }
        let file = input_file(&self.normals);
        Ok(Asset::read(&file)?.map(|asset| (file, asset)))
    }

    /// Draws an object with its own materials.
    pub fn run_own(&self, picture: PictureFile, file: &InputFile, asset: &Asset) -> Result<()> {
        if matches!(self.format, Format::F64) {
            let what = "an object's own materials are drawn in f32";
            return Err(Error::new(what, "leave --format out, or give a --material"));
        }
        let texels = {
            let progress = spinner("reading the object");
            let options = self.pose.options(self.size, self.green);
            options.check(file)?;
            let texels = Texels::of(file, asset, self.size.unwrap_or(SIZE), &options.view())?;
            progress.finish_and_clear();
            texels
        };
        let choice = self.table.or(TABLE);
        let table = choice.read()?;
        if !table.scene.effects.color {
            let what = "the table has no color, and an object's materials do";
            return Err(Error::new(what, "use --table pbr").in_file(choice.path()));
        }
        self.choices.check_rotation(&table)?;
        let components = self.choices.components(&table, choice.path())?;
        let effects = self.choices.effects(&table)?;
        let light = &self.inputs.light;
        let Lights { degree, entries } = light.lights()?;
        let lights = Lights { degree, entries: vec![light.only(entries)?] };
        let dark = dark_light_warning(&lights);
        let smooth = smooth(&texels.texels);
        let order = table.gram.order.min(MOST_ORDER);
        let name = file.path().display().to_string();
        let materials = Materials {
            order,
            entries: vec![Named { name: name.clone(), rgb: smooth.material(order)? }],
        };
        let (mut lights, materials) = fitted(&table, &lights, &materials);
        let (sources, note) = self.sources_of(&table, &lights, (&name, &smooth))?;
        model::take_out(&mut lights.entries[0].rgb, lights.degree, &sources);
        let sources: Vec<Source> =
            sources.iter().map(|source| self.choices.turned(source)).collect();
        self.choices.rotate(&mut lights);
        let window = match self.choices.window().unwrap_or(WindowChoice::Auto) {
            WindowChoice::Given(window) => window,
            WindowChoice::Auto if !self.choices.has_all_effects() => Window::None,
            WindowChoice::Auto => {
                let highlights = HighlightInputs::new(smooth.gloss(), sources.clone());
                let highlights = Some(highlights).filter(|_| !sources.is_empty());
                let pair =
                    Pair { table: &table, lights: &lights, materials: &materials, highlights };
                pair.window(components, Format::F32, self.exposure)?
            }
        };
        for channel in &mut lights.entries[0].rgb {
            window.apply(channel);
        }
        let basis = OwnedBasis::new(&table)?;
        let mut shader = Shader::new(basis.any().map_err(fault)?, components)
            .with_transfers(basis.transfers())
            .with_effects(effects)?;
        let colors = irradiance(&mut shader, &lights.entries[0], order, &texels.texels, &sources)?;
        let pixels = pixels(&texels, &colors);
        let mut draw = |show: &mut dyn FnMut(Pixel, Rgb<f32>)| {
            pixels.iter().for_each(|(pixel, color)| show(*pixel, *color));
            Ok(())
        };
        let tone = self.tone.unwrap_or_default();
        let exposure: Option<Exposure> = self.exposure;
        let development = Development { exposure, tone, is_opaque: false };
        picture.write(&self.out, [texels.size; 2], development, &mut draw)?;
        let drawing = Drawing { table: choice.path(), components, sources: sources.len(), window };
        print_message(drawing);
        dark.into_iter().chain(note).for_each(print_message);
        Ok(())
    }

    /// The sources of the light: those that the smooth parts of an object need to be close, or as
    /// many as are asked for. With a note if the picture is not close even so.
    fn sources_of(
        &self,
        table: &Table,
        lights: &Lights,
        (name, smooth): (&str, &Texel),
    ) -> Result<(Vec<Source>, Option<String>)> {
        let (light, of_light) = (&self.inputs.light, &lights.entries[0].name);
        if !self.choices.has_all_effects() || !table.effects().has(Effect::Gloss) {
            return Ok((Vec::new(), None));
        }
        let (gloss, size) = (smooth.gloss(), (lights.degree, table.gram.order));
        let estimates = Estimates::under(light, of_light)?;
        let estimate = match self.sources {
            Some(Sources::Most(most)) => {
                Estimate { sources: most, ..estimates.of(size, &gloss, most) }
            }
            None | Some(Sources::Auto) => {
                let most = if estimates.is_of_the_light() { MOST } else { 0 };
                estimates.fewest(size, &gloss, self.tolerance, most)
            }
        };
        let note = estimates.note(name, size, &gloss, estimate, self.tolerance);
        let sources = match estimate.sources {
            0 => Vec::new(),
            most => light.sources(of_light, most)?,
        };
        Ok((sources, note))
    }
}

/// The mean of texels, with a roughness that one in twenty is below.
fn smooth(texels: &[Texel]) -> Texel {
    let mut roughness: Vec<f32> = texels.iter().map(|texel| texel.roughness).collect();
    let place = roughness.len() / 20;
    let (_, least, _) = roughness.select_nth_unstable_by(place, f32::total_cmp);
    Texel { roughness: *least, ..Texel::mean(texels) }
}

/// The pixels, each with the mean color of its texels.
fn pixels(texels: &Texels, colors: &[Rgb<f32>]) -> Vec<(Pixel, Rgb<f32>)> {
    let mut shown = colors.iter().zip(&texels.shares);
    let pixel = |covered: &Covered| {
        let mut sum = Rgb::gray(0.0);
        for (color, share) in shown.by_ref().take(covered.texels) {
            sum = sum + color.map(|channel| share * channel);
        }
        (pixel_of(covered), sum)
    };
    texels.pixels.iter().map(pixel).collect()
}
