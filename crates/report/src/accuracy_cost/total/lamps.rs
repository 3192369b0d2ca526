//! Pictures with small sources, by the runtime's own path: the sources are taken out of a light,
//! and their highlights are added to each pixel of the rest.

use crate::accuracy_cost::images::Shaded;
use crate::accuracy_cost::settings::{Format, Setting};
use crate::sphere::Picture;
use eigenshade::{Highlights, Light, Rgb, Source, q15};
use eigenshade_model::database::Named;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::source::{Gloss, NamedSources};
use eigenshade_shading::shader::{OwnedNormals, fault};
use eigenshade_shading::{highlights, integer_shader};
use eigenshade_table::highlights::MAX_SOURCES;
use eigenshade_table::light::count;

/// The highest degree of a light that sources are taken out of.
const DEGREE: usize = 16;

type Lobes = Highlights<MAX_SOURCES>;

/// Lights without some of their sources, and the normals that the sources shine on.
pub struct Lamps {
    format: Format,
    /// By light.
    rests: Vec<Rest>,
    normals: OwnedNormals,
    quantized: Vec<q15::Normal>,
}

/// A light without some of its sources.
struct Rest {
    rgb: [Vec<f64>; 3],
    sources: Vec<Source>,
}

impl Rest {
    fn new(
        light: &Named,
        degree: usize,
        sources: Option<&NamedSources>,
        most: usize,
    ) -> Result<Self> {
        let sources = sources.map_or(&[][..], |sources| sources.first(most));
        let sources = sources.iter().map(highlights::source).collect::<Result<Vec<_>>>()?;
        let rounded = |channel: &Vec<f64>| -> Vec<f32> {
            channel.iter().take(count(degree)).map(|&number| number as f32).collect()
        };
        let [r, g, b] = light.rgb.each_ref().map(rounded);
        let light = Rgb::new(&r, &g, &b).try_map(|channel| Light::new(channel));
        let rest = light.and_then(|light| light.residual::<{ count(DEGREE) }>(&sources));
        let Rgb { r, g, b } = rest.map_err(fault)?;
        let rgb = [r, g, b].map(|channel| channel.iter().copied().map(f64::from).collect());
        Ok(Self { rgb, sources })
    }
}

impl Lamps {
    pub fn new(
        setting: &Setting,
        lights: &[Named],
        sources: &[NamedSources],
        normals: &[[f64; 3]],
    ) -> Result<Self> {
        let rest = |light: &Named| {
            let of_light = sources.iter().find(|sources| sources.name == light.name);
            Rest::new(light, setting.recipe.degree, of_light, setting.sources)
        };
        Ok(Self {
            format: setting.format,
            rests: lights.iter().map(rest).collect::<Result<_>>()?,
            normals: OwnedNormals::new(normals),
            quantized: integer_shader::normals(normals)?,
        })
    }

    /// A light without its sources, by channel.
    pub fn rest(&self, light: usize) -> &[Vec<f64>; 3] {
        &self.rests[light].rgb
    }

    /// The picture of the rest of a light with the highlights of its sources.
    pub fn add(&self, light: usize, gloss: &Gloss, rest: &[Shaded; 3]) -> Result<Picture> {
        let gloss = highlights::gloss(gloss)?;
        let lobes = Lobes::new(&gloss, &self.rests[light].sources).map_err(fault)?;
        match self.format {
            Format::F32 => self.in_floats(&lobes, rest),
            Format::Q15 => self.in_integers(&lobes, rest),
            _ => Err(Error::new("no pixel in this format adds sources", "take f32 or q15")),
        }
    }

    fn in_floats(&self, lobes: &Lobes, rest: &[Shaded; 3]) -> Result<Picture> {
        let color = |k: usize| rest.each_ref().map(|channel| channel.irradiances[k] as f32).into();
        let mut colors: Vec<Rgb<f32>> = (0..self.quantized.len()).map(color).collect();
        lobes.add_slice(self.normals.view()?, &mut colors).map_err(fault)?;
        let channel = |of: fn(&Rgb<f32>) -> f32| {
            colors.iter().map(|color| f64::from(of(color))).collect::<Vec<f64>>()
        };
        Ok([channel(|color| color.r), channel(|color| color.g), channel(|color| color.b)])
    }

    fn in_integers(&self, lobes: &Lobes, rest: &[Shaded; 3]) -> Result<Picture> {
        let exponents = rest.each_ref().map(|channel| channel.exponent);
        let units = exponents.map(|exponent| 2f64.powi(exponent));
        type Quantized = q15::Highlights<Rgb<i32>, MAX_SOURCES>;
        let lobes = Quantized::quantize(lobes, Rgb::from(exponents)).map_err(fault)?;
        let mut picture = [const { Vec::new() }; 3];
        for (k, normal) in self.quantized.iter().enumerate() {
            let mantissa = |c: usize| (rest[c].irradiances[k] / units[c]) as i32;
            let Rgb { r, g, b } = lobes.add([0, 1, 2].map(mantissa).into(), *normal);
            for ((channel, sum), unit) in picture.iter_mut().zip([r, g, b]).zip(units) {
                channel.push(unit * f64::from(sum));
            }
        }
        Ok(picture)
    }
}
