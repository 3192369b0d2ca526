//! Pictures of objects in their own materials.

use crate::asset::Asset;
use crate::texels::{Covered, Texels};
use eigenshade::screen::{Exposure, Tone};
use eigenshade::{Effect, Highlights, Rgb};
use eigenshade_generator::object::surface::View;
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::rotation::Rotation;
use eigenshade_model::source::Source as SmallSource;
use eigenshade_model::window::Window;
use eigenshade_model::{highlights as model, shipped};
use eigenshade_shading::estimate::{Estimate, Estimates};
use eigenshade_shading::highlights::{gloss, source};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::picture::{Development, Pixel};
use eigenshade_shading::presets::Source;
use eigenshade_shading::preview::Preview;
use eigenshade_shading::shader::{Shader, fault, fitted};
use eigenshade_shading::textured::{Texel, irradiance};
use eigenshade_table::Table;
use eigenshade_table::effect::Effects;
use std::path::Path;

/// The largest order of the series of glTF's materials.
const MOST_ORDER: usize = 12;

/// The most sources that are taken without being asked for.
const MOST: usize = 8;

/// How a picture is drawn.
#[derive(Clone, Copy, Debug)]
pub struct Settings<'a> {
    /// Pixels across and down, 2 to 4096.
    pub size: usize,
    /// How the object is looked at.
    pub view: View,
    /// The table, in color; without, the shipped one of glTF's materials, `pbr`.
    pub table: Option<&'a Table>,
    /// The components of the table that are used; without, all.
    pub components: Option<usize>,
    /// The effects that are drawn.
    pub effects: Effects,
    /// The rotation of the light.
    pub rotation: Option<Rotation>,
    /// The most sources of the light that are shaded on their own; without, as few as a picture
    /// needs to be close on a screen, at most 8.
    pub sources: Option<usize>,
    /// The error that these sources may leave instead, rms as a share of white.
    pub tolerance: Option<f64>,
    /// The window of the light; without, the weakest that leaves no dark rings.
    pub window: Option<Window>,
    /// The factor from irradiance to what the tone curve shows; without, it is metered.
    pub exposure: Option<Exposure>,
    /// The tone curve.
    pub tone: Tone,
}

impl Default for Settings<'_> {
    /// 512 pixels, and everything as the picture needs it.
    fn default() -> Self {
        Self {
            size: 512,
            view: View::default(),
            table: None,
            components: None,
            effects: Effects::ALL,
            rotation: None,
            sources: None,
            tolerance: None,
            window: None,
            exposure: None,
            tone: Tone::default(),
        }
    }
}

/// A square picture of an object.
#[derive(Clone, Debug)]
pub struct Picture {
    /// Pixels across and down.
    pub size: usize,
    /// The pixels that the object covers, each with its irradiance.
    pub pixels: Vec<(Pixel, Rgb<f32>)>,
    /// The number of sources that were shaded on their own.
    pub sources: usize,
    /// The window of the light.
    pub window: Window,
    /// A note if the picture is not close on a screen.
    pub note: Option<String>,
    development: Development,
}

impl Picture {
    /// Draws an object under a light.
    ///
    /// # Errors
    ///
    /// Those of [`Texels::of`]; if the light cannot be read or has several entries; and if the table
    /// has no color, or cannot draw the light and these effects.
    pub fn of(
        file: &InputFile,
        asset: &Asset,
        light: &Source,
        settings: &Settings<'_>,
    ) -> Result<Self> {
        let shipped = match settings.table {
            Some(_) => None,
            None => Some(shipped_table()?),
        };
        let scene = match settings.table.or(shipped.as_ref()) {
            Some(table) => Scene { table, light, settings },
            None => return Err(Error::new("no table", "give one")),
        };
        if !scene.table.scene.effects.color {
            let what = "the table has no color, and an object's materials do";
            return Err(Error::new(what, "use --table pbr"));
        }
        let texels = Texels::of(file, asset, settings.size, &settings.view)?;
        scene.draw(&file.path().display().to_string(), &texels)
    }

    /// How its irradiances become pixels of a file.
    #[must_use]
    pub fn development(&self) -> Development {
        self.development
    }

    /// Writes it in sRGB with opacity.
    ///
    /// # Errors
    ///
    /// If the file, its folder or the disk fails.
    pub fn write_png(&self, path: impl AsRef<Path>) -> Result<()> {
        let size = [self.size; 2];
        self.development.write_png(path.as_ref(), size, &mut |show| self.draw(show))
    }

    /// Calls its argument with each pixel and its irradiance.
    ///
    /// # Errors
    ///
    /// None.
    pub fn draw(&self, show: &mut dyn FnMut(Pixel, Rgb<f32>)) -> Result<()> {
        self.pixels.iter().for_each(|(pixel, color)| show(*pixel, *color));
        Ok(())
    }
}

fn shipped_table() -> Result<Table> {
    eigenshade_table::decode(shipped::PBR)
        .map_err(|error| Error::new(error.to_string(), "report it").in_file("tables/pbr.bin"))
}

/// A light and a table.
struct Scene<'a> {
    table: &'a Table,
    light: &'a Source,
    settings: &'a Settings<'a>,
}

impl Scene<'_> {
    fn draw(&self, name: &str, texels: &Texels) -> Result<Picture> {
        let Settings { effects, rotation, exposure, tone, .. } = *self.settings;
        let Lights { degree, entries } = self.light.lights()?;
        let lights = Lights { degree, entries: vec![self.light.only(entries)?] };
        let smooth = smooth(&texels.texels);
        let order = self.table.gram.order.min(MOST_ORDER);
        let material = Named { name: name.to_owned(), rgb: smooth.material(order)? };
        let materials = Materials { order, entries: vec![material] };
        let (mut lights, materials) = fitted(self.table, &lights, &materials);
        let (mut sources, note) = self.sources_of(&lights, (name, &smooth))?;
        model::take_out(&mut lights.entries[0].rgb, lights.degree, &sources);
        if let Some(rotation) = rotation {
            let matrix = rotation.matrix();
            sources.iter_mut().for_each(|source| *source = source.turned(matrix));
            for channel in &mut lights.entries[0].rgb {
                *channel = rotation.turn(degree.min(lights.degree), channel);
            }
        }
        let components = self.settings.components.unwrap_or(usize::MAX);
        let basis = OwnedBasis::new(self.table)?;
        let mut shader =
            Shader::new(basis.any().map_err(fault)?, components).with_transfers(basis.transfers());
        let window = match self.settings.window {
            Some(window) => window,
            // Parts of a picture may be dark.
            None if !effects.is_all() => Window::None,
            None => {
                let lamps = sources.iter().map(source).collect::<Result<Vec<_>>>()?;
                let gloss = gloss(&smooth.gloss())?;
                let lamps = match &lamps[..] {
                    [] => None,
                    lamps => Some(Highlights::new(&gloss, lamps).map_err(fault)?),
                };
                let (light, material) = (&lights.entries[0], &materials.entries[0]);
                let channels = [0, 1, 2].map(|c: usize| (&light.rgb[c][..], &material.rgb[c][..]));
                Preview::new(&mut shader, lamps.as_ref()).window(&channels, exposure)?
            }
        };
        for channel in &mut lights.entries[0].rgb {
            window.apply(channel);
        }
        let mut shader = shader.with_effects(effects)?;
        let colors = irradiance(&mut shader, &lights.entries[0], order, &texels.texels, &sources)?;
        Ok(Picture {
            size: texels.size,
            pixels: pixels(texels, &colors),
            sources: sources.len(),
            window,
            note,
            development: Development { exposure, tone, is_opaque: false },
        })
    }

    /// The sources of the light: those that the smooth parts of an object need to be close, or as
    /// many as are asked for. With a note if the picture is not close even so.
    fn sources_of(
        &self,
        lights: &Lights,
        (name, smooth): (&str, &Texel),
    ) -> Result<(Vec<SmallSource>, Option<String>)> {
        let (table, of_light) = (self.table, &lights.entries[0].name);
        if !self.settings.effects.is_all() || !table.effects().has(Effect::Gloss) {
            return Ok((Vec::new(), None));
        }
        let (gloss, size) = (smooth.gloss(), (lights.degree, table.gram.order));
        let (estimates, within) =
            (Estimates::under(self.light, of_light)?, self.settings.tolerance);
        let estimate = match self.settings.sources {
            Some(most) => Estimate { sources: most, ..estimates.of(size, &gloss, most) },
            None => {
                let most = if estimates.is_of_the_light() { MOST } else { 0 };
                estimates.fewest(size, &gloss, within, most)
            }
        };
        let note = estimates.note(name, size, &gloss, estimate, within);
        let sources = match estimate.sources {
            0 => Vec::new(),
            most => self.light.sources(of_light, most)?,
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
        (covered.pixel(), sum)
    };
    texels.pixels.iter().map(pixel).collect()
}
