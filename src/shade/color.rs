//! Shades many normals in three channels.

use super::tile::{self, Room, TILE};
use super::{BLOCK, SPECIAL, Way};
use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::invariant::part_mut;
use crate::normal::{Normal, Normals};
use crate::scene::{Descent, Scene};

/// Normals that are shaded in one channel before the next: whole tiles and blocks of every target,
/// few enough to stay in the L1 cache.
const CHUNK: usize = if SPECIAL { 640 } else { 4 * BLOCK };
const _: () = assert!(CHUNK.is_multiple_of(BLOCK) && (!SPECIAL || CHUNK.is_multiple_of(TILE)));

impl<B> Rgb<&Scene<'_, B>> {
    /// [`Rgb::shade_slice`] of the scenes.
    #[doc(hidden)]
    pub fn shade_slice(self, normals: Normals<'_>, irradiance: &mut [Rgb<f32>]) -> Result<(), Error>
    where
        B: AsRef<[f32]>,
    {
        Error::check(Argument::Normals, normals.len(), irradiance.len())?;
        let ways = self.map(|scene| Way::of(scene.descent()));
        match [ways.r, ways.g, ways.b] {
            [Way::Constant(r), Way::Constant(g), Way::Constant(b)] if SPECIAL => {
                irradiance.fill(Rgb::new(r, g, b));
            }
            [Way::NineTerms(r), Way::NineTerms(g), Way::NineTerms(b)] if SPECIAL => {
                let nine_terms = Rgb::new(r, g, b);
                let axes = normals.x.iter().zip(normals.y).zip(normals.z);
                for (color, ((&x, &y), &z)) in irradiance.iter_mut().zip(axes) {
                    let normal = Normal { x, y, z };
                    *color = nine_terms.each_ref().map(|nine_terms| nine_terms.shade(normal));
                }
            }
            [Way::Tiles(r), Way::Tiles(g), Way::Tiles(b)] => {
                let rest = by_tiles([r, g, b], normals, irradiance);
                return by_chunks(&ways, rest.0, rest.1);
            }
            _ => return by_chunks(&ways, normals, irradiance),
        }
        Ok(())
    }
}

/// Shades each channel of a tile of normals before the next tile. The channels share the first step.
/// Returns what is less than a tile.
#[inline(never)]
fn by_tiles<'n, 'i>(
    polynomials: [Descent<'_>; 3],
    normals: Normals<'n>,
    irradiance: &'i mut [Rgb<f32>],
) -> (Normals<'n>, &'i mut [Rgb<f32>]) {
    let (mut room, mut planes) = (Room::new(), Rgb::gray([0.0; TILE]));
    let [(x, x_rest), (y, y_rest), (z, z_rest)] =
        [normals.x, normals.y, normals.z].map(<[f32]>::as_chunks::<TILE>);
    let (colors, rest) = irradiance.as_chunks_mut::<TILE>();
    for (((x, y), z), colors) in x.iter().zip(y).zip(z).zip(colors) {
        tile::arguments(z, &mut room);
        let Rgb { r, g, b } = &mut planes;
        for (polynomials, plane) in polynomials.into_iter().zip([r, g, b]) {
            tile::tile(polynomials, [x, y], &mut room, plane);
        }
        write(&planes, colors);
    }
    (Normals { x: x_rest, y: y_rest, z: z_rest }, rest)
}

/// Shades each channel of a chunk of normals before the next chunk.
#[inline(never)]
fn by_chunks(
    ways: &Rgb<Way<'_>>,
    normals: Normals<'_>,
    irradiance: &mut [Rgb<f32>],
) -> Result<(), Error> {
    let (mut room, mut planes) = (Room::new(), Rgb::gray([0.0; CHUNK]));
    let mut shade = |normals: Normals<'_>, planes: &mut Rgb<[f32; CHUNK]>| {
        let all = ..normals.len();
        let Rgb { r, g, b } = planes;
        for (way, plane) in [(&ways.r, r), (&ways.g, g), (&ways.b, b)] {
            way.shade(normals, &mut room, part_mut(plane, all))?;
        }
        Ok::<_, Error>(())
    };
    let [(x, x_rest), (y, y_rest), (z, z_rest)] =
        [normals.x, normals.y, normals.z].map(<[f32]>::as_chunks::<CHUNK>);
    let (colors, rest) = irradiance.as_chunks_mut::<CHUNK>();
    for (((x, y), z), colors) in x.iter().zip(y).zip(z).zip(colors) {
        shade(Normals { x, y, z }, &mut planes)?;
        write(&planes, colors);
    }
    shade(Normals { x: x_rest, y: y_rest, z: z_rest }, &mut planes)?;
    write(&planes, rest);
    Ok(())
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
