//! `eigenshade render --shadows`.

use super::options::{Inputs, WindowChoice, input_file};
use super::render::Render;
use super::shadows::{Parts, drawn, notes};
use eigenshade::Rgb;
use eigenshade_asset::asset::Asset;
use eigenshade_cli::messages::{albedo_warning, dark_light_warning, print_message, progress_bar};
use eigenshade_cli::picture_file::PictureFile;
use eigenshade_model::database::Lights;
use eigenshade_model::error::Result;
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::special::spherical_harmonic;
use eigenshade_shading::picture::{Development, Pixel};
use eigenshade_shading::presets::Source;
use eigenshade_shadows::lit::Lit;
use eigenshade_shadows::object::Object;
use eigenshade_shadows::textured::Textured;

/// Pixels across an object.
const SIZE: usize = 256;

impl Render {
    /// Draws an object in one material with its shadows.
    pub fn run_shadowed(&self, picture: PictureFile, inputs: &Inputs) -> Result<()> {
        let Inputs { light, material } = inputs;
        let lights = self.harmonics(light)?;
        let (parts, materials) = Parts::of(material)?;
        let file = input_file(&self.normals);
        let options = self.pose.options(self.size, self.green);
        options.check(&file)?;
        let size = self.size.unwrap_or(SIZE);
        let radiance = |direction| radiance(&lights, direction).to_vec();
        let lit = drawn(&file, &options.view(), size, &parts, |surface, parts, progress| {
            Lit::new(surface, size, None, radiance, parts, progress)
        })?;
        let irradiance = |pixel: usize, channel: usize| {
            let parts = lit.irradiances.iter().zip(&parts.shares);
            parts.map(|(part, share)| part[(pixel, channel)] * share[channel] as f32).sum::<f32>()
        };
        let irradiance = |pixel| [0, 1, 2].map(|channel| irradiance(pixel, channel));
        self.write_shadowed(&picture, size, &lit.pixels, irradiance)?;
        report(&lights, albedo_warning(&materials));
        Ok(())
    }

    /// Draws an object in its own materials with its shadows.
    pub fn run_own_shadowed(
        &self,
        picture: PictureFile,
        file: &InputFile,
        asset: Asset,
    ) -> Result<()> {
        let lights = self.harmonics(&self.inputs.light)?;
        let options = self.pose.options(self.size, self.green);
        options.check(file)?;
        let size = self.size.unwrap_or(SIZE);
        let object = Textured::new(file, asset, size, &options.view())?;
        let progress = progress_bar("pixels with shadows", Object::steps(size));
        let irradiances =
            object.irradiances(|direction| radiance(&lights, direction), &progress)?;
        self.write_shadowed(&picture, size, &object.pixels, |pixel| irradiances[pixel])?;
        report(&lights, notes(&object));
        Ok(())
    }

    /// The one light, rotated and with its window.
    fn harmonics(&self, light: &Source) -> Result<Lights> {
        let Lights { degree, entries } = light.lights()?;
        let mut lights = Lights { degree, entries: vec![light.only(entries)?] };
        self.choices.rotate(&mut lights);
        if let Some(WindowChoice::Given(window)) = self.choices.window() {
            lights.entries[0].rgb.iter_mut().for_each(|channel| window.apply(channel));
        }
        Ok(lights)
    }

    fn write_shadowed(
        &self,
        picture: &PictureFile,
        size: usize,
        pixels: &[([usize; 2], u8)],
        irradiance: impl Fn(usize) -> [f32; 3],
    ) -> Result<()> {
        let mut draw = |show: &mut dyn FnMut(Pixel, Rgb<f32>)| {
            for (k, ([column, row], coverage)) in pixels.iter().copied().enumerate() {
                let coverage = f64::from(coverage) / 255.0;
                let pixel = Pixel { column, row, coverage, is_inside: coverage >= 0.5 };
                show(pixel, Rgb::from(irradiance(k)));
            }
            Ok(())
        };
        let (exposure, tone) = (self.exposure, self.tone.unwrap_or_default());
        let development = Development { exposure, tone, is_opaque: false };
        picture.write(&self.out, [size; 2], development, &mut draw)
    }
}

/// The radiance of the light in three channels.
fn radiance(lights: &Lights, direction: [f64; 3]) -> [f64; 3] {
    let harmonics = spherical_harmonic::all(lights.degree, direction);
    let of_channel = |light: &Vec<f64>| harmonics.iter().zip(light).map(|(y, l)| y * l).sum();
    lights.entries[0].rgb.each_ref().map(of_channel)
}

fn report(lights: &Lights, notes: impl IntoIterator<Item = String>) {
    print_message(format_args!("drawn with shadows, light of degree {}", lights.degree));
    notes.into_iter().chain(dark_light_warning(lights)).for_each(print_message);
}
