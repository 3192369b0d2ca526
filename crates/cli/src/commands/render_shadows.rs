//! `eigenshade render --shadows`.

use super::options::{Inputs, WindowChoice, input_file};
use super::render::Render;
use super::shadows::{Parts, drawn};
use eigenshade::Rgb;
use eigenshade_cli::messages::{albedo_warning, dark_light_warning, print_message};
use eigenshade_cli::picture_file::PictureFile;
use eigenshade_model::database::Lights;
use eigenshade_model::error::Result;
use eigenshade_model::special::spherical_harmonic;
use eigenshade_shading::picture::{Development, Pixel};
use eigenshade_shadows::lit::Lit;

/// Pixels across an object.
const SIZE: usize = 256;

impl Render {
    /// Draws an object with its shadows.
    pub fn run_shadowed(&self, picture: PictureFile, inputs: &Inputs) -> Result<()> {
        let Inputs { light, material } = inputs;
        let Lights { degree, entries } = light.lights()?;
        let mut lights = Lights { degree, entries: vec![light.only(entries)?] };
        self.choices.rotate(&mut lights);
        if let Some(WindowChoice::Given(window)) = self.choices.window() {
            lights.entries[0].rgb.iter_mut().for_each(|channel| window.apply(channel));
        }
        let (parts, materials) = Parts::of(material)?;
        let file = input_file(&self.normals);
        let options = self.pose.options(self.size, self.green);
        options.check(&file)?;
        let size = self.size.unwrap_or(SIZE);
        let light = &lights.entries[0].rgb;
        let radiance = |direction| {
            let harmonics = spherical_harmonic::all(lights.degree, direction);
            let of_channel =
                |light: &Vec<f64>| harmonics.iter().zip(light).map(|(y, l)| y * l).sum();
            light.iter().map(of_channel).collect()
        };
        let lit = drawn(&file, &options.view(), size, &parts, |surface, parts, progress| {
            Lit::new(surface, size, None, radiance, parts, progress)
        })?;
        let irradiance = |pixel: usize, channel: usize| {
            let parts = lit.irradiances.iter().zip(&parts.shares);
            parts.map(|(part, share)| part[(pixel, channel)] * share[channel] as f32).sum::<f32>()
        };
        let mut draw = |show: &mut dyn FnMut(Pixel, Rgb<f32>)| {
            for (k, ([column, row], coverage)) in lit.pixels.iter().copied().enumerate() {
                let coverage = f64::from(coverage) / 255.0;
                let pixel = Pixel { column, row, coverage, is_inside: coverage >= 0.5 };
                show(pixel, Rgb::from([0, 1, 2].map(|channel| irradiance(k, channel))));
            }
            Ok(())
        };
        let (exposure, tone) = (self.exposure, self.tone.unwrap_or_default());
        let development = Development { exposure, tone, is_opaque: false };
        picture.write(&self.out, [size; 2], development, &mut draw)?;
        print_message(format_args!("drawn with shadows, light of degree {}", lights.degree));
        let warnings = [albedo_warning(&materials), dark_light_warning(&lights)];
        warnings.into_iter().flatten().for_each(print_message);
        Ok(())
    }
}
