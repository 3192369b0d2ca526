//! Shades many normals at a time, in loops that the compiler can vectorize.

use super::{LARGE, block};
use crate::checked_slice::{padded, part_mut};
use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::normal::{Normal, Normals};
use crate::scene::{Descent, Scene};

/// Normals in one block: enough to keep the vector registers of the target busy.
const BLOCK: usize = if cfg!(target_feature = "avx512f") {
    64
} else if cfg!(target_feature = "avx2") {
    32
} else if cfg!(target_arch = "x86_64") {
    20
} else if cfg!(any(target_arch = "aarch64", target_feature = "simd128")) {
    16
} else {
    SCALAR
};

/// Normals in one block without vector registers.
const SCALAR: usize = 4;

/// Whether [`shade_normals`] is faster than [`Rgb::shade_slice`]: the target has no vectors.
pub const ONE_BY_ONE: bool = BLOCK == SCALAR;

impl<B> Scene<'_, B> {
    /// Writes the irradiance of each normal into `irradiance`.
    ///
    /// The sums have the same order as in [`shade`](Self::shade), so the results agree to the last
    /// bit. With WebAssembly's `relaxed-simd`, `shade` of a generated table may differ in the last
    /// bits.
    ///
    /// ```
    /// # #[cfg(feature = "baked")] {
    /// use eigenshade::{Light, Material, Normals, sphere};
    ///
    /// let light = Light::new(&[3.5, 0.0, 1.0, 0.0])?;
    /// let scene = sphere::collapse(&sphere::project(&light, &Material::new(&[2.0])?)?);
    /// let mut irradiance = [0.0; 2];
    /// let normals = Normals::new(&[0.0, 0.6], &[0.0, 0.0], &[1.0, 0.8])?;
    /// scene.shade_slice(normals, &mut irradiance)?;
    /// assert!(irradiance[0] > irradiance[1]);
    /// # }
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless `irradiance` and `normals` have the same length.
    pub fn shade_slice(&self, normals: Normals<'_>, irradiance: &mut [f32]) -> Result<(), Error>
    where
        B: AsRef<[f32]>,
    {
        Error::check(Argument::Normals, normals.len(), irradiance.len())?;
        blocks(self.descent(), normals, irradiance);
        Ok(())
    }
}

/// Shades normals block by block.
#[inline(never)]
fn blocks(polynomials: Descent<'_>, normals: Normals<'_>, irradiance: &mut [f32]) {
    let block = if LARGE { block::<BLOCK> } else { one_block };
    let [(x, x_rest), (y, y_rest), (z, z_rest)] =
        [normals.x, normals.y, normals.z].map(<[f32]>::as_chunks::<BLOCK>);
    let (out, out_rest) = irradiance.as_chunks_mut::<BLOCK>();
    for (((x, y), z), out) in x.iter().zip(y).zip(z).zip(out) {
        *out = block(polynomials, x, y, z);
    }
    if !out_rest.is_empty() {
        let [x, y, z] = [padded(x_rest), padded(y_rest), padded(z_rest)];
        for (out, value) in out_rest.iter_mut().zip(block(polynomials, &x, &y, &z)) {
            *out = value;
        }
    }
}

/// [`block`], compiled once per program, for targets where code must be small.
#[inline(never)]
fn one_block(
    polynomials: Descent<'_>,
    x: &[f32; BLOCK],
    y: &[f32; BLOCK],
    z: &[f32; BLOCK],
) -> [f32; BLOCK] {
    block(polynomials, x, y, z)
}

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

/// Shades normals one by one.
///
/// # Errors
///
/// [`Error::Length`] unless `irradiance` and `normals` have the same length.
#[inline(always)]
pub fn shade_each<N: Copy, I>(
    normals: &[N],
    irradiance: &mut [I],
    shade: impl Fn(N) -> I,
) -> Result<(), Error> {
    Error::check(Argument::Normals, normals.len(), irradiance.len())?;
    for (irradiance, &normal) in irradiance.iter_mut().zip(normals) {
        *irradiance = shade(normal);
    }
    Ok(())
}

/// [`shade_each`] of normals in three slices; the same errors.
#[inline(always)]
pub fn shade_normals<I>(
    normals: Normals<'_>,
    irradiance: &mut [I],
    shade: impl Fn(Normal) -> I,
) -> Result<(), Error> {
    Error::check(Argument::Normals, normals.len(), irradiance.len())?;
    let axes = normals.x.iter().zip(normals.y).zip(normals.z);
    for (irradiance, ((&x, &y), &z)) in irradiance.iter_mut().zip(axes) {
        *irradiance = shade(Normal { x, y, z });
    }
    Ok(())
}

#[cfg(test)]
#[expect(clippy::indexing_slicing, clippy::unwrap_used, reason = "a test may panic")]
mod tests {
    use super::*;

    /// Covers every way in which a slice is shaded, also for polynomials of azimuth 0 only.
    #[test]
    fn slices_of_any_shape_are_shaded_as_their_normals() {
        let numbers: [f32; 200] =
            core::array::from_fn(|k| ((7 * k % 19) as f32 - 9.0) / (1 + k % 5) as f32);
        let [mut x, mut y, mut z] = [[0.0f32; 300]; 3];
        for (k, ((x, y), z)) in x.iter_mut().zip(&mut y).zip(&mut z).enumerate() {
            *z = (k as f32 + 0.5) / 300.0;
            let sine = libm::sqrtf(1.0 - *z * *z);
            (*x, *y) = (sine * libm::cosf(2.4 * k as f32), sine * libm::sinf(2.4 * k as f32));
        }
        for lengths in [
            &[][..],
            &[1],
            &[5],
            &[9],
            &[20],
            &[3, 2],
            &[2, 3, 1, 1],
            &[8, 8, 8],
            &[0, 0, 4],
            &[9, 1],
            &[14, 14, 13, 12],
            &[20, 18, 3],
            &[19, 17, 3],
        ] {
            let scene = Scene::of(lengths, &numbers);
            for count in [0, 1, 63, 64, 127, 128, 300] {
                let normals = Normals::from_unit(&x[..count], &y[..count], &z[..count]);
                let mut irradiance = [f32::NAN; 300];
                let shaded = scene.shade_slice(normals.unwrap(), &mut irradiance[..count]);
                assert_eq!(shaded, Ok(()));
                for k in 0..count {
                    let normal = Normal { x: x[k], y: y[k], z: z[k] };
                    assert_eq!(scene.shade(normal), irradiance[k], "{lengths:?}, {k} of {count}");
                }
            }
        }
    }
}
