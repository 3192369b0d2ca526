//! Light: spherical harmonic coefficients L_l^m of (4).

use crate::error::{Error, What};
use crate::index::light;
use crate::scalar::Scalar;

/// One channel of distant light: (degree + 1)² coefficients in radiance, in the
/// order of [`index::light`](crate::index::light).
///
/// The harmonics carry the Condon-Shortley phase, z points to the camera, x to
/// the right, y up. Coefficients in the graphics convention are these times
/// [`graphics_sign`](crate::index::light::graphics_sign).
///
/// An image is linear in its light. In `f32` keep coefficients near 1, and scale the image
/// where it is shown: with a light at 1e-30 the shipped table's coefficients and pixels are
/// as exact, but products of its pixels, and components weaker than 1e-8 of the strongest,
/// are subnormal, which many processors take long for. A power of two changes no bit.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Light<'a, S> {
    degree: usize,
    coefficients: &'a [S],
}

impl<'a, S> Light<'a, S> {
    /// The light of these coefficients. They are taken as they are: one that is not
    /// finite spoils more of an image than its own mode. [`checked`](Self::checked) refuses it.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless there are (degree + 1)² of them.
    pub const fn new(degree: usize, coefficients: &'a [S]) -> Result<Self, Error> {
        match Error::check(What::Light, light::count(degree), coefficients.len()) {
            Ok(()) => Ok(Self { degree, coefficients }),
            Err(error) => Err(error),
        }
    }

    /// [`new`](Self::new), of finite coefficients alone: for what arrives at run time.
    ///
    /// # Errors
    ///
    /// As there; [`Error::NotFinite`] of the first coefficient that is infinite or NaN.
    pub fn checked(degree: usize, coefficients: &'a [S]) -> Result<Self, Error>
    where
        S: Scalar,
    {
        let light = Self::new(degree, coefficients)?;
        Error::check_finite(What::Light, coefficients)?;
        Ok(light)
    }

    /// The same light without what lies above `degree`; a light of no more than
    /// that degree stays as it is.
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
