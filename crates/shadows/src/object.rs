//! Objects with shadows: the pixels of a picture and their transports.

use crate::directions::{FINE, cells};
use crate::eigenimages::{eigenimages, light_root};
use crate::material::Material;
use crate::packed::{Compression, packed};
use crate::transport::transports;
use crate::visibility::Occluders;
use eigenshade_generator::object::points::{Point, points};
use eigenshade_generator::object::surface::Surface;
use eigenshade_model::database::Lights;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::parallel::Progress;
use eigenshade_model::special::spherical_harmonic;
use faer::Mat;

/// Samples along each side of a pixel.
const SAMPLES: usize = 2;

/// The largest picture, in pixels across.
pub const MOST_SIDE: usize = 512;

/// The components of a packed object.
pub const RANK: usize = 64;

/// An object under any light of a degree, seen from +z.
pub struct Object {
    /// Pixels across and down.
    pub size: usize,
    /// The degree of the light.
    pub degree: usize,
    /// The column and row of each pixel that shows the object, and its coverage of 255.
    pub pixels: Vec<([usize; 2], u8)>,
    /// For each part of the material a matrix with a row for each pixel and a column for each
    /// coefficient of the light.
    pub transports: Vec<Mat<f32>>,
}

impl Object {
    /// The transports of the pixels of a surface in a picture with a margin of half a pixel.
    ///
    /// Each pixel has 2 x 2 samples, each of which looks along 4,096 rays, and the BRDF is integrated
    /// over 16,384 directions. Memory: 4 (degree + 1)² bytes for each pixel and part, and 65 KB for
    /// each of 64 pixels and each core.
    ///
    /// # Errors
    ///
    /// If the size is not 2 to [`MOST_SIDE`], or nothing is seen.
    pub fn new(
        surface: &Surface,
        size: usize,
        degree: usize,
        parts: &[Material<'_>],
        progress: &impl Progress,
    ) -> Result<Self> {
        if !(2..=MOST_SIDE).contains(&size) {
            let what = format!("an object with shadows {size} pixels wide");
            return Err(Error::new(what, format!("use 2 to {MOST_SIDE}")));
        }
        surface.check_front()?;
        let mut all = points(surface, size, SAMPLES);
        all.sort_by_key(|point| (point.pixel[1], point.pixel[0]));
        let seen: Vec<&[Point]> = all.chunk_by(|a, b| a.pixel == b.pixel).collect();
        if seen.is_empty() {
            let remedy = "turn it with --view or --rotate-object, or draw it larger";
            return Err(Error::new("nothing of it is seen", remedy));
        }
        let occluders = Occluders::new(&surface.facets);
        let fine = cells(FINE);
        let harmonics: Vec<Vec<f64>> =
            fine.iter().map(|(direction, _)| spherical_harmonic::all(degree, *direction)).collect();
        let light = Mat::from_fn(fine.len(), (degree + 1).pow(2), |row, column| {
            harmonics[row][column] as f32
        });
        let transports = transports(&seen, Some(&occluders), parts, light.as_ref(), progress);
        let coverage = |points: &&[Point]| {
            let share = points.len() as f64 / (SAMPLES * SAMPLES) as f64;
            (points[0].pixel, (255.0 * share).round() as u8)
        };
        Ok(Self { size, degree, pixels: seen.iter().map(coverage).collect(), transports })
    }

    /// The number of batches that [`new`](Self::new) reports to its progress, for a square picture.
    #[must_use]
    pub fn batches(size: usize) -> usize {
        (size * size).div_ceil(64)
    }

    /// The irradiance of each pixel under a channel of a light, with these shares of the parts.
    #[must_use]
    pub fn irradiance(&self, light: &[f64], shares: &[f64]) -> Vec<f32> {
        let mut sums = vec![0.0; self.pixels.len()];
        for (transport, share) in self.transports.iter().zip(shares) {
            for (row, sum) in sums.iter_mut().enumerate() {
                let products = transport.row(row).iter().zip(light);
                *sum += share * products.map(|(a, b)| f64::from(*a) * b).sum::<f64>();
            }
        }
        sums.into_iter().map(|sum| sum as f32).collect()
    }

    /// The file of the runtime's `ShadowedObject`, for lights like these that turn freely.
    ///
    /// # Errors
    ///
    /// If a light is dark, or no eigenvalues are found.
    pub fn packed(
        &self,
        lights: &Lights,
        shares: &[[f64; 3]],
        compression: Compression,
    ) -> Result<Vec<u8>> {
        let root = light_root(&lights.truncated(self.degree))?;
        let parts: Vec<_> = self.transports.iter().map(Mat::as_ref).collect();
        let images = eigenimages(&parts, &vec![1.0; parts.len()], &root, RANK)?;
        let (file, _) = packed(&images, self.degree, self.size, &self.pixels, shares, compression);
        Ok(file.encode())
    }
}
