//! Three channels of anything: lights, materials, transfers, images and pixels.

use crate::bake::{BakedMap, MapPoint};
use crate::buffer::{Buffer, copied};
use crate::error::{Argument, Error};
use crate::light::{Light, Window};
use crate::material::Material;
use crate::normal::Normal;
use crate::q15;
use crate::scene::Scene;
use core::ops::Add;

/// Red, green and blue: three lights, three materials, three irradiances.
///
/// A module of a table has the steps from light to pixel for three channels at once, such as
/// `sphere::color::scene`. The steps take an `Rgb`, or one light or material for all three
/// channels.
///
/// ```
/// use eigenshade::{Light, Rgb};
///
/// let warm = Rgb::new([3.5], [3.0], [2.5]);
/// let light = warm.each_ref().try_map(|channel| Light::new(channel))?;
/// assert_eq!(light.r.coefficients(), [3.5]);
/// assert_eq!(warm.map(|[mean]| mean / 0.5), Rgb::from([7.0, 6.0, 5.0]));
/// # Ok::<(), eigenshade::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rgb<T> {
    /// The red channel.
    pub r: T,
    /// The green channel.
    pub g: T,
    /// The blue channel.
    pub b: T,
}

impl<T> Rgb<T> {
    /// The three channels.
    #[inline]
    pub const fn new(r: T, g: T, b: T) -> Self {
        Self { r, g, b }
    }

    /// References to the channels.
    #[inline]
    pub const fn each_ref(&self) -> Rgb<&T> {
        Rgb::new(&self.r, &self.g, &self.b)
    }

    /// Applies a function to each channel.
    #[inline(always)]
    pub fn map<U>(self, mut function: impl FnMut(T) -> U) -> Rgb<U> {
        Rgb::new(function(self.r), function(self.g), function(self.b))
    }

    /// Applies a function to each channel, up to the first error.
    #[inline(always)]
    pub fn try_map<U, E>(self, mut function: impl FnMut(T) -> Result<U, E>) -> Result<Rgb<U>, E> {
        Ok(Rgb::new(function(self.r)?, function(self.g)?, function(self.b)?))
    }

    /// Pairs of channels.
    #[inline]
    pub fn zip<U>(self, other: Rgb<U>) -> Rgb<(T, U)> {
        Rgb::new((self.r, other.r), (self.g, other.g), (self.b, other.b))
    }
}

impl<T: Copy> Rgb<T> {
    /// The same in all three channels.
    #[inline]
    pub const fn gray(value: T) -> Self {
        Self::new(value, value, value)
    }
}

/// The sum in each channel, such as of a scene and its [`Highlights`](crate::Highlights).
impl<T: Add> Add for Rgb<T> {
    type Output = Rgb<T::Output>;

    #[inline]
    fn add(self, other: Self) -> Self::Output {
        self.zip(other).map(|(one, other)| one + other)
    }
}

impl<T> From<[T; 3]> for Rgb<T> {
    #[inline]
    fn from([r, g, b]: [T; 3]) -> Self {
        Self { r, g, b }
    }
}

impl<T> From<Rgb<T>> for [T; 3] {
    #[inline]
    fn from(Rgb { r, g, b }: Rgb<T>) -> Self {
        [r, g, b]
    }
}

impl<'a, T> From<&'a T> for Rgb<&'a T> {
    #[inline]
    fn from(gray: &'a T) -> Self {
        Self::gray(gray)
    }
}

impl<'a, T> From<&'a Rgb<T>> for Rgb<&'a T> {
    #[inline]
    fn from(color: &'a Rgb<T>) -> Self {
        color.each_ref()
    }
}

macro_rules! gray {
    ($($type:ty)*) => {
        $(
            impl<'a> From<$type> for Rgb<$type> {
                #[inline]
                fn from(gray: $type) -> Self {
                    Self::gray(gray)
                }
            }
        )*
    };
}
gray! { Light<'a> Material<'a> q15::Light<'a> q15::Material<'a> }

impl Rgb<Light<'_>> {
    /// [`Light::truncated`] in each channel.
    #[must_use]
    pub fn truncated(self, degree: usize) -> Self {
        self.map(|light| light.truncated(degree))
    }

    /// [`Light::windowed`] in each channel; the same errors.
    pub fn windowed<const N: usize>(&self, window: Window) -> Result<Rgb<Buffer<f32, N>>, Error> {
        self.each_ref().try_map(|light| light.windowed::<N>(window))
    }
}

impl<const N: usize> Rgb<Buffer<f32, N>> {
    /// The lights in these buffers; errors as [`Light::from_finite`].
    pub fn lights(&self) -> Result<Rgb<Light<'_>>, Error> {
        self.each_ref().try_map(|channel| Light::from_finite(channel))
    }

    /// The materials in these buffers; errors as [`Material::from_finite`].
    pub fn materials(&self) -> Result<Rgb<Material<'_>>, Error> {
        self.each_ref().try_map(|channel| Material::from_finite(channel))
    }
}

impl<const N: usize, const O: usize> Rgb<q15::MaterialBuffer<N, O>> {
    /// The materials in these buffers; errors as [`q15::Material::new`].
    pub fn materials(&self) -> Result<Rgb<q15::Material<'_>>, Error> {
        self.each_ref().try_map(q15::MaterialBuffer::material)
    }
}

impl Material<'_> {
    /// This material in a color: its coefficients times each channel. `N` is at least the number of
    /// coefficients.
    ///
    /// ```
    /// use eigenshade::Material;
    ///
    /// let red = Material::new(&[2.0, -0.5])?.tint::<2>([0.9, 0.2, 0.1])?;
    /// assert_eq!(red.materials()?.g.coefficients(), [0.4, -0.1]);
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Capacity`] if `N` is too small; [`Error::NotFinite`] with the index of the first
    /// channel of the color that is infinite or NaN.
    pub fn tint<const N: usize>(&self, color: [f32; 3]) -> Result<Rgb<Buffer<f32, N>>, Error> {
        Rgb::gray(*self).tint(color)
    }
}

impl Rgb<Material<'_>> {
    /// [`Material::tint`] in each channel, such as of a preset: a gray material in a color, or one
    /// in color with another balance. The same errors.
    pub fn tint<const N: usize>(&self, color: [f32; 3]) -> Result<Rgb<Buffer<f32, N>>, Error> {
        Error::check_finite(Argument::Color, &color)?;
        self.zip(Rgb::from(color)).try_map(|(material, factor)| {
            copied(Argument::Material, material.coefficients().iter().map(|&from| factor * from))
        })
    }
}

impl<C> Rgb<Scene<'_, C>> {
    /// [`Scene::shade`] in each channel.
    #[inline]
    #[must_use]
    pub fn shade(&self, normal: Normal) -> Rgb<f32>
    where
        C: AsRef<[f32]>,
    {
        self.each_ref().map(|scene| scene.shade(normal))
    }

    /// [`Scene::bake`] in each channel; the same errors.
    pub fn bake<const T: usize>(&self, size: usize) -> Result<Rgb<BakedMap<Buffer<f32, T>>>, Error>
    where
        C: AsRef<[f32]>,
    {
        self.each_ref().try_map(|scene| scene.bake(size))
    }

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
    ) -> Result<Rgb<q15::BakedMap<B>>, Error>
    where
        C: AsRef<[f32]>,
    {
        let channels = self.each_ref().zip(texels);
        channels.try_map(|(scene, texels)| scene.bake_integers_into(size, texels))
    }
}

impl<B: AsRef<[f32]>> Rgb<BakedMap<B>> {
    /// [`BakedMap::bilinear`] in each channel.
    #[inline]
    #[must_use]
    pub fn bilinear(&self, point: MapPoint) -> Rgb<f32> {
        self.each_ref().map(|map| map.bilinear(point))
    }
}

impl<B: AsRef<[i16]>> Rgb<q15::BakedMap<B>> {
    /// [`q15::BakedMap::bilinear`] in each channel.
    #[inline]
    #[must_use]
    pub fn bilinear(&self, point: q15::MapPoint) -> Rgb<i32> {
        self.each_ref().map(|map| map.bilinear(point))
    }

    /// The exposure that multiplies the irradiances of the mantissas by a factor, channel by
    /// channel; errors as [`q15::Exposure::new`].
    pub fn exposure_by_factor(&self, factor: f32) -> Result<Rgb<q15::Exposure>, Error> {
        self.each_ref().try_map(|map| q15::Exposure::new(factor, map.exponent()))
    }
}

impl<M: Copy + PartialEq> Rgb<M> {
    /// The one material of a gray object: all channels have the same coefficients.
    #[doc(hidden)]
    #[inline]
    pub fn as_gray(self) -> Option<M> {
        (self.r == self.g && self.r == self.b).then_some(self.r)
    }
}
