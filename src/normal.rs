//! Normals: unit vectors toward the camera's side, z >= 0.

use crate::error::{Error, What};
use crate::mathematics::{Libm, Mathematics};
use crate::scalar::Scalar;

/// One visible unit normal: x to the right, y up, z toward the camera.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Normal<S> {
    pub(crate) x: S,
    pub(crate) y: S,
    pub(crate) z: S,
}

impl<S: Scalar> Normal<S> {
    /// The normal along (x, y, z), of any length from 1e-18 to 1e18.
    ///
    /// A normal that points away by no more than 1e-3 is laid on the rim.
    ///
    /// # Errors
    ///
    /// [`Error::Normal`] if a component is not finite, or the square of the length is
    /// below 1e-37 or not finite; [`Error::Hidden`] if z < -1e-3 after scaling.
    pub fn new(x: S, y: S, z: S) -> Result<Self, Error> {
        Self::with_mathematics::<Libm>(x, y, z)
    }

    /// [`new`](Self::new) with a root of one's choice.
    ///
    /// # Errors
    ///
    /// As there.
    pub fn with_mathematics<M: Mathematics<S>>(x: S, y: S, z: S) -> Result<Self, Error> {
        let unit = Self { x, y, z }.scaled::<M>()?;
        if unit.z >= S::ZERO {
            Ok(unit)
        } else if unit.z >= -S::from_f64(1e-3) {
            Self { z: S::ZERO, ..unit }.scaled::<M>()
        } else {
            Err(Error::Hidden)
        }
    }

    fn scaled<M: Mathematics<S>>(self) -> Result<Self, Error> {
        let square = self.x * self.x + self.y * self.y + self.z * self.z;
        // The square of a smaller one has too few bits left.
        if !(square.is_finite() && square >= S::from_f64(1e-37)) {
            return Err(Error::Normal);
        }
        let scale = M::inverse_root(square);
        Ok(Self { x: self.x * scale, y: self.y * scale, z: self.z * scale })
    }

    /// x, y and z.
    #[must_use]
    pub fn components(self) -> [S; 3] {
        [self.x, self.y, self.z]
    }
}

/// Many normals, component by component.
///
/// They are taken as they are: each must be a unit vector with z in \[0, 1\]. One
/// that is not gives a meaningless irradiance for itself alone.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Normals<'a, S> {
    pub(crate) x: &'a [S],
    pub(crate) y: &'a [S],
    pub(crate) z: &'a [S],
}

impl<'a, S> Normals<'a, S> {
    /// The normals of these components.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless all three have the same length.
    pub const fn new(x: &'a [S], y: &'a [S], z: &'a [S]) -> Result<Self, Error> {
        match (
            Error::check(What::Normals, x.len(), y.len()),
            Error::check(What::Normals, x.len(), z.len()),
        ) {
            (Ok(()), Ok(())) => Ok(Self { x, y, z }),
            (Err(error), _) | (_, Err(error)) => Err(error),
        }
    }

    /// One by one.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Normal<S>> + use<'a, S>
    where
        S: Copy,
    {
        let components = self.x.iter().zip(self.y).zip(self.z);
        components.map(|((&x, &y), &z)| Normal { x, y, z })
    }

    /// How many they are.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.x.len()
    }

    /// Whether there are none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.x.is_empty()
    }
}
