//! Objects with shadows under given lights.

use crate::directions::{FINE, cells};
use crate::material::Material;
use crate::pixels::Pixels;
use crate::transport::transports;
use crate::visibility::Occluders;
use eigenshade_generator::object::surface::Surface;
use eigenshade_model::error::Result;
use eigenshade_model::parallel::Progress;
use faer::Mat;

/// The pixels of an object, seen from +z, under some lights.
pub struct Lit {
    /// The column and row of each pixel that shows the object, and its coverage of 255.
    pub pixels: Vec<([usize; 2], u8)>,
    /// For each part of the material the irradiances, a row for each pixel and a column for each light.
    pub irradiances: Vec<Mat<f32>>,
}

impl Lit {
    /// Draws a surface on each part of a material. `radiance` gives the lights in a direction, always as
    /// many.
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
        let points = pixels.points();
        let irradiances = transports(&points, Some(&occluders), parts, lights.as_ref(), progress);
        Ok(Self { pixels: pixels.covered, irradiances })
    }
}
