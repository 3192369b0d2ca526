//! Three channels of anything: lights, materials, transfers, images and pixels.

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

impl<M: Copy + PartialEq> Rgb<M> {
    /// The one material of a gray object: all channels have the same coefficients.
    #[doc(hidden)]
    #[inline]
    pub fn as_gray(self) -> Option<M> {
        (self.r == self.g && self.r == self.b).then_some(self.r)
    }
}
