//! Shades many normals in three channels.

use super::{BLOCK, SPECIAL};
use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::normal::Normals;
use crate::scalar::Scalar;
use crate::scene::Scene;
use crate::shade::tile::TILE;

/// Normals that are shaded in one channel before the next: whole tiles and blocks of every target,
/// few enough to stay in the L1 cache.
const CHUNK: usize = if SPECIAL { 5 * TILE } else { 4 * BLOCK };

impl<B> Rgb<&Scene<'_, B>> {
    /// [`Rgb::shade_slice`] of the scenes.
    #[doc(hidden)]
    pub fn shade_slice<S: Scalar>(
        self,
        normals: Normals<'_, S>,
        irradiance: &mut [Rgb<S>],
    ) -> Result<(), Error>
    where
        B: AsRef<[S]>,
    {
        Error::check(Argument::Normals, normals.len(), irradiance.len())?;
        let mut channels = Rgb::gray([S::ZERO; CHUNK]);
        let normals =
            normals.x.chunks(CHUNK).zip(normals.y.chunks(CHUNK)).zip(normals.z.chunks(CHUNK));
        for (((x, y), z), colors) in normals.zip(irradiance.chunks_mut(CHUNK)) {
            let normals = Normals { x, y, z };
            let each =
                [(self.r, &mut channels.r), (self.g, &mut channels.g), (self.b, &mut channels.b)];
            for (scene, channel) in each {
                scene.shade_slice(normals, channel.get_mut(..x.len()).unwrap_or_default())?;
            }
            let pixels = channels.r.iter().zip(&channels.g).zip(&channels.b);
            for (color, ((&r, &g), &b)) in colors.iter_mut().zip(pixels) {
                *color = Rgb::new(r, g, b);
            }
        }
        Ok(())
    }
}

impl<B> Rgb<Scene<'_, B>> {
    /// Writes the irradiance of each normal in each channel, for engines that interpolate between
    /// the vertices of a mesh. The numbers are those of [`Scene::shade_slice`] in each channel, to
    /// the last bit.
    ///
    /// ```
    /// # #[cfg(feature = "presets")] {
    /// use eigenshade::presets::{light::PARK, material::DARK_RED_PAINT};
    /// use eigenshade::{Normals, Rgb, sphere};
    ///
    /// let scene = sphere::color::scene(PARK, DARK_RED_PAINT)?;
    /// let mut colors = [Rgb::gray(0.0); 2];
    /// let vertices = Normals::new(&[0.0, 0.6], &[0.0, 0.0], &[1.0, 0.8])?;
    /// scene.shade_slice(vertices, &mut colors)?;
    /// assert!(colors[0].r > colors[0].b);
    /// # }
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// Cost: that of [`Scene::shade_slice`] in each channel, and three copies for each normal.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless `irradiance` and `normals` have the same length.
    pub fn shade_slice<S: Scalar>(
        &self,
        normals: Normals<'_, S>,
        irradiance: &mut [Rgb<S>],
    ) -> Result<(), Error>
    where
        B: AsRef<[S]>,
    {
        self.each_ref().shade_slice(normals, irradiance)
    }
}
