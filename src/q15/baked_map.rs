//! Baked maps of `i16` texels, for machines without floating-point hardware. Look-ups use integers.

use super::{Exposure, MapPoint, Q15};
use crate::bake::{check_size, four};
use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::scene::Scene;

/// Range of a map's exponent, for peak irradiances from 2^-60 to 2^60.
const EXPONENTS: core::ops::RangeInclusive<i32> = -75..=45;

/// The largest texel.
const MOST: usize = 32_767;

/// One image baked into N x N integers, the rounded texels of a
/// [`BakedMap`](crate::object::BakedMap): irradiance = texel x 2^exponent.
///
/// The exponent is the smallest one with which the largest texel fits. Texels are rounded to 2^-15
/// to 2^-16 of the largest texel, and a look-up rounds twice more.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BakedMap<B> {
    size: u16,
    exponent: i32,
    texels: B,
}

impl<C> Scene<'_, C> {
    /// Bakes the scene into N x N integers, in a buffer of length N².
    ///
    /// ```
    /// # #[cfg(feature = "baked")] {
    /// use eigenshade::{Light, Material, Normal, q15, sphere};
    ///
    /// let light = Light::new(&[3.5, 0.0, 1.0, 0.0])?;
    /// let scene = sphere::collapse(&sphere::project(&light, &Material::new(&[2.0])?)?);
    /// let map = scene.bake_integers_into(32, [0; 32 * 32])?;
    /// let point = q15::MapPoint::of(q15::Normal::new(0, 3, 4)?);
    /// let irradiance = map.bilinear(point) as f32 * 2_f32.powi(map.exponent());
    /// assert!((irradiance - scene.shade(Normal::new(0.0, 3.0, 4.0)?)).abs() < 1e-2);
    /// # }
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// Cost: shading at most 6 N² + 12 N pixels, in two passes, since the scale must be known first.
    ///
    /// # Errors
    ///
    /// [`Error::Size`] unless N is 2 to 4096, [`Error::Length`] if the buffer has another length,
    /// [`Error::NotFinite`] with the index of the first texel that is infinite or NaN,
    /// [`Error::Saturated`] if a texel is 2^60 or more.
    pub fn bake_integers_into<B: AsMut<[i16]>>(
        &self,
        size: usize,
        mut texels: B,
    ) -> Result<BakedMap<B>, Error>
    where
        C: AsRef<[f32]>,
    {
        check_size(size)?;
        let to = texels.as_mut();
        Error::check(Argument::Texels, size * size, to.len())?;
        let (mut largest, mut fault) = (0.0, None);
        self.each_texel(size, |index, value: f32| {
            if !value.is_finite() {
                fault = fault.or(Some(index));
            }
            let value = if value < 0.0 { -value } else { value };
            largest = if value > largest { value } else { largest };
        });
        if let Some(index) = fault {
            return Err(Error::NotFinite { argument: Argument::Texels, index });
        }
        let (exponent, scale) = scale(largest);
        if largest * scale > (MOST as f32) {
            return Err(Error::Saturated { argument: Argument::Texels });
        }
        to.fill(0);
        self.each_texel(size, |index, value: f32| {
            if let Some(texel) = to.get_mut(index) {
                *texel = rounded(value * scale);
            }
        });
        Ok(BakedMap { size: size as u16, exponent, texels })
    }
}

/// The smallest exponent with which a number fits into `i16`, and 2^-exponent.
fn scale(largest: f32) -> (i32, f32) {
    let (half, most) = (0.5, (MOST as f32));
    let (mut exponent, mut scale) = (0, 1.0);
    while largest * scale > most && exponent < *EXPONENTS.end() {
        (exponent, scale) = (exponent + 1, scale * half);
    }
    while (largest + largest) * scale <= most && exponent > *EXPONENTS.start() {
        (exponent, scale) = (exponent - 1, scale + scale);
    }
    (exponent, scale)
}

fn rounded(value: f32) -> i16 {
    let half = 0.5;
    let size = |value: f32| i16::try_from((value + half) as usize).unwrap_or(i16::MAX);
    if value < 0.0 { -size(-value) } else { size(value) }
}

impl<B: AsRef<[i16]>> BakedMap<B> {
    /// Creates a map from N x N texels that were baked before.
    ///
    /// # Errors
    ///
    /// [`Error::Size`] unless N is 2 to 4096, [`Error::Length`] unless there are N² texels.
    pub fn new(size: usize, exponent: i32, texels: B) -> Result<Self, Error> {
        check_size(size)?;
        Error::check(Argument::Texels, size * size, texels.as_ref().len())?;
        Ok(Self { size: size as u16, exponent, texels })
    }

    /// The number of texels per side, N.
    #[must_use]
    pub const fn size(&self) -> usize {
        self.size as usize
    }

    /// The exponent: irradiance = value x 2^exponent.
    #[must_use]
    pub const fn exponent(&self) -> i32 {
        self.exponent
    }

    /// The texels, row by row from v = -1 upward, each row from u = -1 to the right.
    #[must_use]
    pub fn texels(&self) -> &[i16] {
        self.texels.as_ref()
    }

    /// The irradiance at a point times 2^-exponent, interpolated between the four texels around it.
    ///
    /// Compared with a [`BakedMap`](crate::object::BakedMap) of the same size, the rms error grows by at
    /// most 4e-5 of the peak. `firmware/counts.csv` lists the cost: `baked_point`, and `baked`
    /// starting from a Q15 normal.
    #[inline]
    #[must_use]
    pub fn bilinear(&self, point: MapPoint) -> i32 {
        let (column, across) = self.cell(point.u);
        let (row, up) = self.cell(point.v);
        let Some(texels) = four(self.texels.as_ref(), self.size(), row, column) else { return 0 };
        let (Some(&[a, b]), Some(&[c, d])) = (texels.first_chunk(), texels.last_chunk()) else {
            return 0;
        };
        let below = between(a.into(), b.into(), across);
        let above = between(c.into(), d.into(), across);
        between(below, above, up)
    }

    /// The index of the texel before a coordinate, and the way from it to the next in Q15.
    #[inline]
    fn cell(&self, x: Q15) -> (usize, i32) {
        let place = self.place(x);
        #[expect(clippy::cast_possible_wrap, reason = "below 2^15")]
        let way = (u32::from(place as u16) >> 1) as i32;
        ((place >> 16) as usize, way)
    }

    /// A coordinate in units of texels, times 2^16: below (N - 1) 2^16, and below 2^28.
    #[inline]
    fn place(&self, x: Q15) -> u32 {
        let place = (i32::from(x.0) + (1 << 15)).cast_unsigned();
        place.wrapping_mul(u32::from(self.size).wrapping_sub(1))
    }
}

/// a + (b - a) `way`, rounded, with `way` in Q15. a and b have 16 bits, so no product exceeds
/// 2^31 - 2^16.
#[inline]
fn between(a: i32, b: i32, way: i32) -> i32 {
    a + (((b - a) * way + (1 << 14)) >> 15)
}

impl<C> Rgb<Scene<'_, C>> {
    /// [`Scene::bake_integers_into`] in each channel; the same errors.
    ///
    /// ```
    /// # #[cfg(feature = "presets")] {
    /// use eigenshade::presets::{light::LOBBY, material::GOLD_METALLIC_PAINT};
    /// use eigenshade::{Q15, Rgb, q15, sphere};
    ///
    /// let scene = sphere::color::scene(LOBBY, GOLD_METALLIC_PAINT)?;
    /// let map = scene.bake_integers_into(32, Rgb::gray([0; 32 * 32]))?;
    /// let exposure = map.exposure_by_factor(1.5)?;
    /// let color = exposure.of(map.bilinear(q15::MapPoint::new(Q15(0), Q15(0))));
    /// assert!(color.r > color.b);
    /// # }
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    pub fn bake_integers_into<B: AsMut<[i16]>>(
        &self,
        size: usize,
        texels: Rgb<B>,
    ) -> Result<Rgb<BakedMap<B>>, Error>
    where
        C: AsRef<[f32]>,
    {
        let channels = self.each_ref().zip(texels);
        channels.try_map(|(scene, texels)| scene.bake_integers_into(size, texels))
    }
}

impl<B: AsRef<[i16]>> Rgb<BakedMap<B>> {
    /// [`BakedMap::bilinear`] in each channel.
    #[inline]
    #[must_use]
    pub fn bilinear(&self, point: MapPoint) -> Rgb<i32> {
        self.each_ref().map(|map| map.bilinear(point))
    }

    /// The exposure that multiplies the irradiances of the mantissas by a factor, channel by
    /// channel; errors as [`Exposure::new`].
    pub fn exposure_by_factor(&self, factor: f32) -> Result<Rgb<Exposure>, Error> {
        self.each_ref().try_map(|map| Exposure::new(factor, map.exponent()))
    }
}
