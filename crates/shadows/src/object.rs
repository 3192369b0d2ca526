//! Objects with shadows: the pixels of a picture and their transports.

use crate::directions::{FINE, cells};
use crate::eigenimages::eigenimages;
use crate::light_root::{LightRoot, Turns};
use crate::material::Material;
use crate::packed::{Compression, packed};
use crate::pixels::Pixels;
use crate::transport::{BATCH, transports};
use crate::visibility::Occluders;
use eigenshade_generator::object::surface::Surface;
use eigenshade_model::database::Lights;
use eigenshade_model::error::Result;
use eigenshade_model::parallel::Progress;
use eigenshade_model::special::spherical_harmonic;
use faer::Mat;

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
    /// The transports of the pixels of a surface on each part of a material.
    ///
    /// Up to four points of a pixel take 4,096 rays in turns, and the BRDF is integrated over 16,384
    /// directions. Memory: 4 (degree + 1)² bytes for each pixel and part, and 65 KB for each of 64
    /// pixels and each core.
    ///
    /// # Errors
    ///
    /// As [`Pixels::new`].
    pub fn new(
        surface: &Surface,
        size: usize,
        degree: usize,
        parts: &[Material<'_>],
        progress: &impl Progress,
    ) -> Result<Self> {
        let pixels = Pixels::new(surface, size)?;
        let occluders = Occluders::new(&surface.facets);
        let harmonics: Vec<Vec<f64>> = cells(FINE)
            .into_iter()
            .map(|(direction, _)| spherical_harmonic::all(degree, direction))
            .collect();
        let light = Mat::from_fn(harmonics.len(), (degree + 1).pow(2), |row, column| {
            harmonics[row][column] as f32
        });
        let points = pixels.points();
        let transports = transports(&points, Some(&occluders), parts, light.as_ref(), progress);
        Ok(Self { size, degree, pixels: pixels.covered, transports })
    }

    /// The most steps that [`new`](Self::new) reports to its progress.
    #[must_use]
    pub fn steps(size: usize) -> usize {
        (size * size).div_ceil(BATCH)
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

    /// The file of the runtime's `ShadowedObject`, for lights like these that turn.
    ///
    /// # Errors
    ///
    /// As [`LightRoot::new`], or if no singular values are found.
    pub fn packed(
        &self,
        lights: &Lights,
        turns: Turns,
        shares: &[[f64; 3]],
        compression: Compression,
    ) -> Result<Vec<u8>> {
        let root = LightRoot::new(&lights.truncated(self.degree), turns)?;
        let parts: Vec<_> = self.transports.iter().map(Mat::as_ref).collect();
        let images = eigenimages(&parts, &vec![1.0; parts.len()], &root, RANK)?;
        let (file, _) = packed(&images, self.degree, self.size, &self.pixels, shares, compression);
        Ok(file.encode())
    }
}
