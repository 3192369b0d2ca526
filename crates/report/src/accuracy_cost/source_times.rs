//! The highlights of small sources to be timed, alone as on the boards: pixels and a new light.

use super::images::Work;
use super::settings::Format;
use super::times::{PIXELS, hemisphere};
use eigenshade::{Gloss, Highlights, Rgb, Rotation, Source, q15};
use eigenshade_model::error::{Error, Result};
use eigenshade_shading::integer_shader;
use eigenshade_shading::shader::{OwnedNormals, fault};
use eigenshade_table::highlights::SHIPPED_SOURCES;
use std::f32::consts::TAU;
use std::hint::black_box;

type Integers = q15::Highlights<i32, SHIPPED_SOURCES>;

/// The normals that the sources shine on.
pub struct Lit {
    normals: OwnedNormals,
    quantized: Vec<q15::Normal>,
}

impl Lit {
    pub fn new() -> Result<Self> {
        let normals = hemisphere(PIXELS);
        let quantized = integer_shader::normals(&normals)?;
        Ok(Self { normals: OwnedNormals::new(&normals), quantized })
    }

    /// Adds the highlights of `count` sources to all pixels, and makes those of a new light: in f32
    /// in color, from sources that are turned; in Q15 in one channel, from stored constants.
    pub fn works(&self, format: Format, count: usize) -> Result<[Work<'_>; 2]> {
        let sources = (0..count).map(|number| lamp(number).map_err(fault));
        let sources = sources.collect::<Result<Vec<_>>>()?;
        let highlights = reflected(&sources).map_err(fault)?;
        match format {
            Format::F32 => {
                let normals = self.normals.view()?;
                let mut out = vec![Rgb::gray(0.0); normals.len()];
                let pixels = move || {
                    black_box(highlights.add_slice(black_box(normals), &mut out).is_ok());
                    black_box(&out);
                };
                let rotation = Rotation::from_quaternion([0.1, 0.2, 0.3, 1.0]).map_err(fault)?;
                let mut turned = sources.clone();
                let light = move || {
                    for (to, from) in turned.iter_mut().zip(black_box(&sources)) {
                        *to = from.turned(rotation);
                    }
                    black_box(&reflected(&turned));
                };
                Ok([Box::new(pixels), Box::new(light)])
            }
            Format::Q15 => {
                let stored = Integers::quantize(&highlights, -15).map_err(fault)?;
                let (of_pixels, mut out) = (stored.clone(), vec![0; self.quantized.len()]);
                let pixels = move || {
                    let normals = black_box(&self.quantized);
                    black_box(of_pixels.add_slice(normals, &mut out).is_ok());
                    black_box(&out);
                };
                let light = move || {
                    let (exponent, square) = (stored.exponent(), stored.alpha_square());
                    let again = Integers::stored(exponent, square, black_box(stored.lobes()));
                    black_box(&again.map(|one| one.aligned(black_box(-14))));
                };
                Ok([Box::new(pixels), Box::new(light)])
            }
            _ => Err(Error::new("no pixel in this format adds sources", "take f32 or q15")),
        }
    }
}

/// One of the sources, around the camera: nearly all normals face all of them.
fn lamp(number: usize) -> std::result::Result<Source, eigenshade::Error> {
    let (sine, cosine) = (TAU * number as f32 / SHIPPED_SOURCES as f32).sin_cos();
    let direction = [0.2 * cosine, 0.2 * sine, 0.96_f32.sqrt()];
    Source::new(direction, [1.0, 0.9, 0.8], 0.05)
}

fn reflected(
    sources: &[Source],
) -> std::result::Result<Highlights<SHIPPED_SOURCES>, eigenshade::Error> {
    let gloss = Gloss::metallic_roughness([1.0, 0.78, 0.34], 1.0, 0.3)?;
    Highlights::new(&gloss, sources)
}
