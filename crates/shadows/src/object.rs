//! Objects with shadows: the pixels of a picture and their transports.

use crate::eigenimages::eigenimages;
use crate::light_root::{LightRoot, Turns};
use crate::lit::Lit;
use crate::material::Material;
use crate::packed::{Compression, packed};
use crate::transport::BATCH;
use eigenshade_generator::object::surface::Surface;
use eigenshade_model::database::Lights;
use eigenshade_model::error::Result;
use eigenshade_model::parallel::Progress;
use eigenshade_model::special::spherical_harmonic;
use eigenshade_table::light;
use faer::Mat;

/// The components of a packed object.
pub const RANK: usize = 64;

/// The standard deviation of the heat kernel that smooths the light of a packed object, in radians:
/// lamps ring less, also those that the object hides.
const SPREAD: f64 = 0.06;

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
    /// directions. A pixel that sees all is exact, within the rounding of f32, if the material is a
    /// series. The surface reflects light as a matte one of the albedo of each part, up to
    /// [`BOUNCES`](crate::lit::BOUNCES) times: each part is a material by itself. Memory: 4 (degree + 1)²
    /// bytes for each pixel and part, and 82 KB for each part, each of 64 pixels and each core.
    ///
    /// # Errors
    ///
    /// As [`Lit::new`].
    pub fn new(
        surface: &Surface,
        size: usize,
        degree: usize,
        parts: &[Material<'_>],
        progress: &impl Progress,
    ) -> Result<Self> {
        let harmonics = |direction| spherical_harmonic::all(degree, direction);
        let Lit { pixels, irradiances: transports } =
            Lit::new(surface, size, Some(degree), harmonics, parts, progress)?;
        Ok(Self { size, degree, pixels, transports })
    }

    /// This object in light that is smoothed by a heat kernel of 0.06 rad: degree l has a factor
    /// exp(-l (l + 1) 0.06² / 2).
    #[must_use]
    pub fn smoothed(&self) -> Self {
        Self {
            pixels: self.pixels.clone(),
            transports: self.transports.iter().map(|one| smoothed(self.degree, one)).collect(),
            ..*self
        }
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

    /// The file of the runtime's `ShadowedObject`, for [`smoothed`](Self::smoothed) lights like these that
    /// turn.
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
        let Self { transports, .. } = self.smoothed();
        let parts: Vec<_> = transports.iter().map(Mat::as_ref).collect();
        let images = eigenimages(&parts, &vec![1.0; parts.len()], &root, RANK)?;
        let (file, _) = packed(&images, self.degree, self.size, &self.pixels, shares, compression);
        Ok(file.encode())
    }
}

/// Transports of light of a degree that is smoothed.
pub(crate) fn smoothed(degree: usize, transports: &Mat<f32>) -> Mat<f32> {
    let factors: Vec<f32> = light::indices(degree)
        .map(|(l, _)| (-0.5 * SPREAD * SPREAD * (l * (l + 1)) as f64).exp() as f32)
        .collect();
    Mat::from_fn(transports.nrows(), factors.len(), |row, k| factors[k] * transports[(row, k)])
}
