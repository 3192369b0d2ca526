//! Light as spherical harmonic coefficients L_l^m of (4).

use crate::error::{Argument, Error};
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
    /// Creates a light from its coefficients. Their number determines the degree.
    ///
    /// The values are not checked. A coefficient that is not finite spoils more of an image than
    /// its own mode; [`checked`](Self::checked) rejects it.
    ///
    /// ```
    /// use eigenshade::{Argument, Error, Light};
    ///
    /// // The same from everywhere, and more from the camera.
    /// assert_eq!(Light::new(&[3.5, 0.0, 1.0, 0.0])?.degree(), 1);
    /// let refused = Error::Count { argument: Argument::Light, found: 3 };
    /// assert_eq!(Light::new(&[3.5, 0.0, 1.0]), Err(refused));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Count`] unless there are (degree + 1)² coefficients for some degree.
    #[inline]
    pub const fn new(coefficients: &'a [S]) -> Result<Self, Error> {
        match degree(coefficients.len()) {
            Ok(degree) => Ok(Self { degree, coefficients }),
            Err(error) => Err(error),
        }
    }

    /// [`new`](Self::new) for coefficients that arrive at run time: all of them must be finite.
    ///
    /// # Errors
    ///
    /// The same as for `new`; [`Error::NotFinite`] with the index of the first coefficient that is
    /// infinite or NaN.
    pub fn checked(coefficients: &'a [S]) -> Result<Self, Error>
    where
        S: Scalar,
    {
        let light = Self::new(coefficients)?;
        Error::check_finite(Argument::Light, coefficients)?;
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

/// The degree of a light with this number of coefficients.
///
/// Inlined, so that a length known at compile time costs nothing. A new light is a few hundred
/// instructions; counting up to the usual degrees would add a tenth to them.
#[inline(always)]
pub(crate) const fn degree(found: usize) -> Result<usize, Error> {
    match found {
        1 => Ok(0),
        4 => Ok(1),
        9 => Ok(2),
        16 => Ok(3),
        25 => Ok(4),
        36 => Ok(5),
        49 => Ok(6),
        64 => Ok(7),
        81 => Ok(8),
        100 => Ok(9),
        121 => Ok(10),
        144 => Ok(11),
        169 => Ok(12),
        _ => counted(found),
    }
}

/// [`degree`] for any number.
#[cold]
const fn counted(found: usize) -> Result<usize, Error> {
    let (mut degree, mut count) = (0, 1);
    while count < found {
        degree += 1;
        count += 2 * degree + 1;
    }
    if count == found { Ok(degree) } else { Err(Error::Count { argument: Argument::Light, found }) }
}
