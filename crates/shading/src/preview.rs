//! A coarse picture of a sphere, which meters an exposure and chooses a window before the picture
//! itself is drawn.

use crate::shader::{Lit, OwnedNormals, Shader, fault};
use eigenshade::screen::{Exposure, Meter};
use eigenshade::{Highlights, Rgb};
use eigenshade_model::error::Result;
use eigenshade_model::evaluation::Evaluator;
use eigenshade_model::window::Window;
use eigenshade_table::Table;
use eigenshade_table::highlights::MAX_SOURCES;
use std::f64::consts::PI;

/// The number of normals.
const COUNT: usize = 512;

/// Shades a sphere at normals whose pixels are spread evenly over its picture.
pub struct Preview<'s> {
    image: Image<'s>,
    highlights: Option<&'s Highlights<MAX_SOURCES>>,
    normals: OwnedNormals,
}

/// The irradiances of the normals, in one channel.
type Image<'s> = Box<dyn FnMut(Lit<'_>, &OwnedNormals) -> Result<Vec<f32>> + 's>;

impl<'s> Preview<'s> {
    /// A preview by this shader, with highlights if there are any.
    pub fn new(
        shader: &'s mut Shader<'_>,
        highlights: Option<&'s Highlights<MAX_SOURCES>>,
    ) -> Self {
        let image: Image<'s> =
            Box::new(|(light, material), normals| shader.polynomial(light, material, normals));
        Self { image, highlights, normals: OwnedNormals::new(&normals()) }
    }

    /// A preview in f64, for tables that only f64 draws.
    pub fn in_f64(
        evaluator: &'s Evaluator<&Table>,
        highlights: Option<&'s Highlights<MAX_SOURCES>>,
    ) -> Self {
        let normals = normals();
        let eigenimages = evaluator.eigenimages(&normals);
        let image: Image<'s> = Box::new(move |(light, material), _| {
            let image = eigenimages.reconstruct(&evaluator.project(light, material)?);
            Ok(image.into_iter().map(|irradiance| irradiance as f32).collect())
        });
        Self { image, highlights, normals: OwnedNormals::new(&normals) }
    }

    fn colors(&mut self, channels: &[Lit<'_>; 3]) -> Result<Vec<Rgb<f32>>> {
        let [r, g, b] = channels.map(|lit| (self.image)(lit, &self.normals));
        let colors = r?.into_iter().zip(g?).zip(b?).map(|((r, g), b)| Rgb::new(r, g, b));
        let mut colors: Vec<Rgb<f32>> = colors.collect();
        if let Some(highlights) = self.highlights {
            highlights.add_slice(self.normals.view()?, &mut colors).map_err(fault)?;
        }
        Ok(colors)
    }

    /// The metered exposure of the channels of a light, each on that of a material.
    ///
    /// # Errors
    ///
    /// As the shader.
    pub fn exposure(&mut self, channels: &[Lit<'_>; 3]) -> Result<Exposure> {
        Ok(metered(&self.colors(channels)?))
    }

    /// The weakest window of the light without dark rings under an exposure, or the metered one.
    ///
    /// # Errors
    ///
    /// As the shader.
    pub fn window(
        &mut self,
        channels: &[Lit<'_>; 3],
        exposure: Option<Exposure>,
    ) -> Result<Window> {
        let plain = self.colors(channels)?;
        let exposure = exposure.unwrap_or_else(|| metered(&plain));
        let darkest = |colors: &[Rgb<f32>]| {
            let exposed = colors.iter().flat_map(|&color| <[f32; 3]>::from(exposure.of(color)));
            f64::from(exposed.fold(f32::INFINITY, f32::min))
        };
        let degree = channels[0].0.len().isqrt().saturating_sub(1);
        let mut failed = None;
        let window = Window::weakest(degree, |window: Window| {
            if window == Window::None {
                return darkest(&plain);
            }
            let lights = channels.map(|(light, _)| {
                let mut light = light.to_vec();
                window.apply(&mut light);
                light
            });
            let windowed = [0, 1, 2].map(|c: usize| (&lights[c][..], channels[c].1));
            self.colors(&windowed).map_or_else(
                |error| {
                    failed = Some(error);
                    0.0
                },
                |colors| darkest(&colors),
            )
        });
        failed.map_or(Ok(window), Err)
    }
}

fn normals() -> Vec<[f64; 3]> {
    let normal = |k: usize| {
        let square = (k as f64 + 0.5) / COUNT as f64;
        // A spiral by the golden angle.
        let (sine, cosine) = (k as f64 * PI * (3.0 - 5_f64.sqrt())).sin_cos();
        [square.sqrt() * cosine, square.sqrt() * sine, (1.0 - square).sqrt()]
    };
    (0..COUNT).map(normal).collect()
}

/// The metered exposure of a picture; 1 if it is black. A meter reaches from 2^-16 to 2^16, so the
/// picture is metered with its peak at 1.
fn metered(colors: &[Rgb<f32>]) -> Exposure {
    let peak = colors.iter().map(|color| color.largest()).fold(0.0, f32::max);
    let scale = peak.recip();
    if !scale.is_normal() {
        return Exposure::default();
    }
    let mut meter = Meter::default();
    colors.iter().for_each(|color| meter.add(color.map(|channel| scale * channel)));
    let exposure = meter.exposure().map(|exposure| Exposure::new(scale * exposure.factor()));
    exposure.and_then(std::result::Result::ok).unwrap_or_default()
}
