//! `eigenshade render --shadows`.

use super::options::{Inputs, WindowChoice, input_file};
use super::render::Render;
use super::shadows::{Parts, object};
use eigenshade::Rgb;
use eigenshade_cli::messages::{albedo_warning, dark_light_warning, print_message};
use eigenshade_cli::picture_file::PictureFile;
use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::error::Result;
use eigenshade_shading::picture::{Development, Pixel};

/// Pixels across an object.
const SIZE: usize = 256;

/// The largest degree of the light.
const DEGREE: usize = 12;

impl Render {
    /// Draws an object with its shadows.
    pub fn run_shadowed(&self, picture: PictureFile, inputs: &Inputs) -> Result<()> {
        let Inputs { light, material } = inputs;
        let Lights { degree, entries } = light.lights()?;
        let mut lights =
            Lights { degree, entries: vec![light.only(entries)?] }.truncated(degree.min(DEGREE));
        self.choices.rotate(&mut lights);
        if let Some(WindowChoice::Given(window)) = self.choices.window() {
            lights.entries[0].rgb.iter_mut().for_each(|channel| window.apply(channel));
        }
        let Materials { order, entries } = material.materials(DEGREE)?;
        let materials = Materials { order, entries: vec![material.only(entries)?] };
        let parts = Parts::of(material)?;
        let file = input_file(&self.normals);
        let options = self.pose.options(self.size, self.green);
        options.check(&file)?;
        let size = self.size.unwrap_or(SIZE);
        let object = object(&file, &options.view(), size, lights.degree, &parts)?;
        let channels: [Vec<f32>; 3] = [0, 1, 2].map(|c: usize| {
            let shares: Vec<f64> = parts.shares.iter().map(|share| share[c]).collect();
            object.irradiance(&lights.entries[0].rgb[c], &shares)
        });
        let mut draw = |show: &mut dyn FnMut(Pixel, Rgb<f32>)| {
            for (k, ([column, row], coverage)) in object.pixels.iter().copied().enumerate() {
                let coverage = f64::from(coverage) / 255.0;
                let pixel = Pixel { column, row, coverage, is_inside: coverage >= 0.5 };
                show(pixel, Rgb::from([0, 1, 2].map(|c: usize| channels[c][k])));
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
