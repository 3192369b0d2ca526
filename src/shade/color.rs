//! Shades many normals in three channels.

use super::{BLOCK, LARGE, blocks};
use crate::checked_slice::part_mut;
use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::normal::Normals;
use crate::scene::Scene;

/// Normals that are shaded in one channel before the next: whole blocks, few enough to stay in the
/// L1 cache.
const CHUNK: usize = if LARGE { 10 * BLOCK } else { 4 * BLOCK };

impl<B> Rgb<&Scene<'_, B>> {
    /// [`Rgb::shade_slice`] of the scenes.
    #[doc(hidden)]
    #[inline(never)]
    pub fn shade_slice(self, normals: Normals<'_>, irradiance: &mut [Rgb<f32>]) -> Result<(), Error>
    where
        B: AsRef<[f32]>,
    {
        Error::check(Argument::Normals, normals.len(), irradiance.len())?;
        let mut planes = Rgb::gray([0.0; CHUNK]);
        let mut shade = |normals: Normals<'_>, colors: &mut [Rgb<f32>]| {
            let Rgb { r, g, b } = &mut planes;
            for (scene, plane) in [(self.r, r), (self.g, g), (self.b, b)] {
                blocks(scene.descent(), normals, part_mut(plane, ..normals.len()));
            }
            write(&planes, colors);
        };
        let [(x, x_rest), (y, y_rest), (z, z_rest)] =
            [normals.x, normals.y, normals.z].map(<[f32]>::as_chunks::<CHUNK>);
        let (colors, rest) = irradiance.as_chunks_mut::<CHUNK>();
        for (((x, y), z), colors) in x.iter().zip(y).zip(z).zip(colors) {
            shade(Normals { x, y, z }, colors);
        }
        shade(Normals { x: x_rest, y: y_rest, z: z_rest }, rest);
        Ok(())
    }
}

#[inline(always)]
fn write<const N: usize>(planes: &Rgb<[f32; N]>, colors: &mut [Rgb<f32>]) {
    let pixels = planes.r.iter().zip(&planes.g).zip(&planes.b);
    for (color, ((&r, &g), &b)) in colors.iter_mut().zip(pixels) {
        *color = Rgb::new(r, g, b);
    }
}

impl<B> Rgb<Scene<'_, B>> {
    /// Writes the irradiance of each normal in each channel, for engines that interpolate between
    /// the vertices of a mesh. The numbers equal [`Scene::shade_slice`] in each channel, to the
    /// last bit.
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
    /// Cost: less than [`Scene::shade_slice`] in each channel and a loop that writes three planes as
    /// pixels, and no memory for the planes.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless `irradiance` and `normals` have the same length.
    pub fn shade_slice(
        &self,
        normals: Normals<'_>,
        irradiance: &mut [Rgb<f32>],
    ) -> Result<(), Error>
    where
        B: AsRef<[f32]>,
    {
        self.each_ref().shade_slice(normals, irradiance)
    }
}
