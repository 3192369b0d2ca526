//! Light as spherical harmonic coefficients L_l^m of (4).

use crate::error::{Error, What};
use crate::index::light;
use crate::scalar::Scalar;

/// One channel of distant light: (degree + 1)² coefficients in units of radiance, in the order of
/// [`index::light`](crate::index::light).
///
/// The harmonics include the Condon-Shortley phase. z points to the camera, x to the right, y up.
/// To convert coefficients to the graphics convention, multiply them by
/// [`graphics_sign`](crate::index::light::graphics_sign).
///
/// An image is linear in its light. In `f32`, keep coefficients near 1 and scale the image when it
/// is displayed. With a light at 1e-30, the coefficients and pixels of the shipped table are just
/// as exact, but products of its pixels, and components weaker than 1e-8 of the strongest, are
/// subnormal, which is slow on many processors. Scaling by a power of two changes no bit.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Light<'a, S> {
    degree: usize,
    coefficients: &'a [S],
}

impl<'a, S> Light<'a, S> {
    /// Creates a light from its coefficients, without checking their values. A coefficient that is
    /// not finite spoils more of an image than its own mode; [`checked`](Self::checked) rejects it.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless there are (degree + 1)² coefficients.
    pub const fn new(degree: usize, coefficients: &'a [S]) -> Result<Self, Error> {
        match Error::check(What::Light, light::count(degree), coefficients.len()) {
            Ok(()) => Ok(Self { degree, coefficients }),
            Err(error) => Err(error),
        }
    }

    /// [`new`](Self::new) for coefficients that arrive at run time: all of them must be finite.
    ///
    /// # Errors
    ///
    /// The same as for `new`; [`Error::NotFinite`] with the index of the first coefficient that is
    /// infinite or NaN.
    pub fn checked(degree: usize, coefficients: &'a [S]) -> Result<Self, Error>
    where
        S: Scalar,
    {
        let light = Self::new(degree, coefficients)?;
        Error::check_finite(What::Light, coefficients)?;
        Ok(light)
    }

    /// This light without the degrees above `degree`. A light of that degree or less is returned
    /// unchanged.
    #[must_use]
    pub fn truncated(self, degree: usize) -> Self {
        match self.coefficients.get(..light::count(degree)) {
            Some(coefficients) if degree < self.degree => Self { degree, coefficients },
            _ => self,
        }
    }

    /// Largest degree l.
    #[must_use]
    pub const fn degree(&self) -> usize {
        self.degree
    }

    /// All coefficients.
    #[must_use]
    pub const fn coefficients(&self) -> &'a [S] {
        self.coefficients
    }
}
