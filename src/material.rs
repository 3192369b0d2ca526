//! Material as Koenderink-van Doorn coefficients b_op^q of (7).

use crate::error::{Error, What};
use crate::index::material;
use crate::scalar::Scalar;

/// One channel of an isotropic BRDF: its coefficients in 1/sr, in the order of
/// [`index::material`](crate::index::material).
///
/// The azimuth in (8) is φ_i - φ_r, so zero is backscatter.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Material<'a, S> {
    order: usize,
    coefficients: &'a [S],
}

impl<'a, S> Material<'a, S> {
    /// Creates a material from its coefficients, without checking their values. A coefficient that
    /// is not finite spoils more of an image than its own mode; [`checked`](Self::checked) rejects
    /// it.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless there are [`index::material::count`](crate::index::material::count)
    /// coefficients.
    pub const fn new(order: usize, coefficients: &'a [S]) -> Result<Self, Error> {
        match Error::check(What::Material, material::count(order), coefficients.len()) {
            Ok(()) => Ok(Self { order, coefficients }),
            Err(error) => Err(error),
        }
    }

    /// [`new`](Self::new) for coefficients that arrive at run time: all of them must be finite.
    ///
    /// # Errors
    ///
    /// The same as for `new`; [`Error::NotFinite`] with the index of the first coefficient that is
    /// infinite or NaN.
    pub fn checked(order: usize, coefficients: &'a [S]) -> Result<Self, Error>
    where
        S: Scalar,
    {
        let material = Self::new(order, coefficients)?;
        Error::check_finite(What::Material, coefficients)?;
        Ok(material)
    }

    /// This material without the orders above `order`. A material of that order or less is returned
    /// unchanged.
    #[must_use]
    pub fn truncated(self, order: usize) -> Self {
        match self.coefficients.get(..material::count(order)) {
            Some(coefficients) if order < self.order => Self { order, coefficients },
            _ => self,
        }
    }

    /// Largest order o.
    #[must_use]
    pub const fn order(&self) -> usize {
        self.order
    }

    /// All coefficients.
    #[must_use]
    pub const fn coefficients(&self) -> &'a [S] {
        self.coefficients
    }
}
