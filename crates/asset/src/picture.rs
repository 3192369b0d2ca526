//! Pictures of objects in their own materials.

use crate::asset::Asset;
use crate::texels::{Samples, Texels};
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
use eigenshade_shading::textured::{Blend, Texel, irradiance};
use eigenshade_table::Table;
use eigenshade_table::effect::Effects;
use std::ops::Range;
use std::path::Path;

/// The largest order of the series of glTF's materials.
const MOST_ORDER: usize = 12;

/// The most sources that are taken without being asked for.
const MOST: usize = 8;

/// Pixels whose texels are in memory together.
const BAND: usize = 1 << 20;

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
    /// The number of sources that were shaded on their own.
    pub sources: usize,
    /// The window of the light.
    pub window: Window,
    /// A note if the picture is not close on a screen.
    pub note: Option<String>,
    development: Development,
    pixels: Vec<Shown>,
}

/// A pixel that the object covers, and its irradiance.
#[derive(Clone, Copy, Debug)]
struct Shown {
    column: u16,
    row: u16,
    coverage: f32,
    color: Rgb<f32>,
}

impl Picture {
    /// Draws an object under a light.
    ///
    /// Memory: that of [`Texels::of`] without the texels, 20 bytes for each pixel, and at most 200 MB
    /// for texels, in bands of rows. Objects in more than one band are sampled twice.
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
        let shipped;
        let table = match settings.table {
            Some(table) => table,
            None => {
                shipped = shipped_table()?;
                &shipped
            }
        };
        if !table.scene.effects.color {
            let what = "the table has no color, and an object's materials do";
            return Err(Error::new(what, "use --table pbr"));
        }
        let samples = Samples::new(file, asset, settings.size, &settings.view)?;
        let scene = Scene { table, light, settings };
        scene.draw(&file.path().display().to_string(), &samples)
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
        self.development.write_png(path.as_ref(), size, &mut |show| {
            self.draw(show);
            Ok(())
        })
    }

    /// Calls its argument with each pixel and its irradiance.
    pub fn draw(&self, show: &mut dyn FnMut(Pixel, Rgb<f32>)) {
        for Shown { column, row, coverage, color } in &self.pixels {
            let [column, row] = [column, row].map(|place| usize::from(*place));
            let coverage = f64::from(*coverage);
            show(Pixel { column, row, coverage, is_inside: coverage >= 0.5 }, *color);
        }
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
    fn draw(&self, name: &str, samples: &Samples<'_>) -> Result<Picture> {
        let Settings { effects, rotation, exposure, tone, .. } = *self.settings;
        let Lights { degree, entries } = self.light.lights()?;
        let lights = Lights { degree, entries: vec![self.light.only(entries)?] };
        let size = self.settings.size;
        let bands: Vec<Range<usize>> = (0..size)
            .step_by((BAND / size).max(1))
            .map(|row| row..size.min(row + (BAND / size).max(1)))
            .collect();
        let (mut summary, mut first) = (Summary::default(), None);
        for rows in &bands {
            let texels = samples.rows(rows.clone());
            summary.add(&texels.texels);
            first = first.or(Some(texels));
        }
        let blend = Blend::of(summary.roughnesses.iter().copied())?;
        let smooth = summary.smooth()?;
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
        let mut shader = Shader::new(basis.basis().map_err(fault)?, components)
            .with_transfers(basis.transfers());
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
        let mut pixels = Vec::new();
        for rows in bands {
            let texels = first.take().unwrap_or_else(|| samples.rows(rows));
            let shown = (&blend, &texels.texels[..]);
            let colors = irradiance(&mut shader, &lights.entries[0], order, shown, &sources)?;
            add(&mut pixels, &texels, &colors);
        }
        Ok(Picture {
            size,
            pixels,
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

/// What chooses the sources and the window of a picture.
#[derive(Default)]
struct Summary {
    matte: [f64; 3],
    reflectance: [f64; 3],
    roughnesses: Vec<f32>,
}

impl Summary {
    fn add(&mut self, texels: &[Texel]) {
        for texel in texels {
            for c in 0..3 {
                self.matte[c] += f64::from(texel.matte[c]);
                self.reflectance[c] += f64::from(texel.reflectance[c]);
            }
            self.roughnesses.push(texel.roughness);
        }
    }

    /// The mean of the texels, with a roughness that one in twenty is below.
    fn smooth(mut self) -> Result<Texel> {
        let count = self.roughnesses.len();
        if count == 0 {
            return Err(Error::new("nothing of it is seen", "turn it with --view"));
        }
        let (_, roughness, _) = self.roughnesses.select_nth_unstable_by(count / 20, f32::total_cmp);
        let mean = |sum: f64| (sum / count as f64) as f32;
        Ok(Texel {
            normal: [0.0, 0.0, 1.0],
            matte: self.matte.map(mean),
            reflectance: self.reflectance.map(mean),
            metallic: 0.0,
            roughness: *roughness,
        })
    }
}

/// Adds pixels, each with the mean color of its texels.
fn add(pixels: &mut Vec<Shown>, texels: &Texels, colors: &[Rgb<f32>]) {
    let mut shown = colors.iter().zip(&texels.shares);
    pixels.extend(texels.pixels.iter().map(|covered| {
        let mut color = Rgb::gray(0.0);
        for (one, share) in shown.by_ref().take(covered.texels) {
            color = color + one.map(|channel| share * channel);
        }
        let [column, row] = [covered.column, covered.row].map(|place| place as u16);
        Shown { column, row, coverage: covered.coverage as f32, color }
    }));
}
