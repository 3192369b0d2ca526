//! Objects with shadows under given lights.

use crate::directions::{FINE, cells};
use crate::material::Material;
use crate::pixels::Pixels;
use crate::transport::{Surroundings, transports};
use crate::visibility::Occluders;
use crate::weights::Columns;
use eigenshade_generator::object::surface::Surface;
use eigenshade_model::error::Result;
use eigenshade_model::parallel::Progress;
use faer::Mat;

/// How many times light is reflected between parts of an object before it reaches a pixel. Where the
/// others cover three quarters of what a part sees, and reflect 0.8 of the light, 0.2 % of the reflected
/// light is left.
pub const BOUNCES: usize = 12;

/// The pixels of an object, seen from +z, under some lights.
pub struct Lit {
    /// The column and row of each pixel that shows the object, and its coverage of 255.
    pub pixels: Vec<([usize; 2], u8)>,
    /// For each part of the material the irradiances, a row for each pixel and a column for each light.
    pub irradiances: Vec<Mat<f32>>,
}

impl Lit {
    /// Draws a surface on each part of a material. `radiance` gives the lights in a direction, always as
    /// many; if these are the harmonics up to a degree, transports that are known are exact.
    ///
    /// Up to four points of a pixel take 4,096 rays in turns, and the BRDF is integrated over 16,384
    /// directions.
    ///
    /// # Errors
    ///
    /// As [`Pixels::new`].
    pub fn new(
        surface: &Surface,
        size: usize,
        degree: Option<usize>,
        radiance: impl Fn([f64; 3]) -> Vec<f64>,
        parts: &[Material<'_>],
        progress: &impl Progress,
    ) -> Result<Self> {
        let pixels = Pixels::new(surface, size)?;
        let occluders = Occluders::new(&surface.facets);
        let lights: Vec<Vec<f64>> =
            cells(FINE).into_iter().map(|(direction, _)| radiance(direction)).collect();
        let count = lights.first().map_or(0, Vec::len);
        let lights = Mat::from_fn(lights.len(), count, |row, column| lights[row][column] as f32);
        let around = Surroundings { occluders: &occluders, bounces: BOUNCES };
        let light = Columns { degree, all: lights.as_ref() };
        let irradiances = transports(&pixels.points(), Some(around), parts, light, progress);
        Ok(Self { pixels: pixels.covered, irradiances })
    }
}
