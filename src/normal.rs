//! Normals: unit vectors on the camera's side, z >= 0.
//!
//! The polynomials of a pixel are valid for z in \[0, 1\]. Outside, polynomials leave their range,
//! longer ones faster. Interpolated normals, and normals of 8-bit maps, can lie outside along an
//! object's outline. When normals are scaled to length 1, which happens once for each, such normals
//! are moved to the rim. Loops over pixels use normals as they are.

use crate::error::{Argument, Error};
use crate::mathematics;

/// One visible unit normal: x to the right, y up, z toward the camera.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Normal {
    pub(crate) x: f32,
    pub(crate) y: f32,
    pub(crate) z: f32,
}

impl Normal {
    /// The normal in the direction (x, y, z), whose length may be from 1e-18 to 1e18.
    ///
    /// A normal that points away from the camera by at most 1/8 is moved to the rim: z becomes 0,
    /// and x and y are scaled to length 1.
    ///
    /// ```
    /// use eigenshade::{Error, Normal};
    ///
    /// // A pixel of a normal map, of 8 bits a channel.
    /// let [x, y, z] = [218, 127, 218u8].map(|c| 2.0 * f32::from(c) - 255.0);
    /// let [x, y, z] = Normal::new(x, y, z)?.components();
    /// assert!((x * x + y * y + z * z - 1.0).abs() < 1e-6);
    /// assert_eq!(Normal::new(0.8, 0.6, -0.1)?.components()[2], 0.0);
    /// assert_eq!(Normal::new(0.8, 0.6, -0.2), Err(Error::Hidden));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Normal`] if a component is not finite, or the square of the length is below 1e-37
    /// or not finite; [`Error::Hidden`] if z < -1/8 after scaling.
    pub fn new(x: f32, y: f32, z: f32) -> Result<Self, Error> {
        Self { x, y, z }.visible(mathematics::inverse_root)
    }

    /// [`new`](Self::new) by the reciprocal root of the crate `micromath`, a handful of instructions:
    /// the length is off by up to 3.5 %, and a pixel of chrome in a studio by up to a fifth of the
    /// peak, as its polynomials are steep. The same errors.
    #[cfg(feature = "micromath")]
    pub fn approximate(x: f32, y: f32, z: f32) -> Result<Self, Error> {
        Self { x, y, z }.visible(micromath::F32Ext::invsqrt)
    }

    /// This vector scaled to length 1, and moved to the rim if it points away by at most 1/8.
    #[inline]
    fn visible(self, inverse_root: impl Fn(f32) -> f32) -> Result<Self, Error> {
        let unit = self.scaled(&inverse_root)?;
        if unit.z >= 0.0 {
            Ok(unit)
        } else if unit.z >= -0.125 {
            Self { z: 0.0, ..unit }.scaled(&inverse_root)
        } else {
            Err(Error::Hidden)
        }
    }

    #[inline]
    fn scaled(self, inverse_root: impl Fn(f32) -> f32) -> Result<Self, Error> {
        let square = self.x * self.x + self.y * self.y + self.z * self.z;
        // The square of a shorter vector has too few bits left.
        if !(square.is_finite() && square >= 1e-37) {
            return Err(Error::Normal);
        }
        let scale = inverse_root(square);
        Ok(Self { x: self.x * scale, y: self.y * scale, z: self.z * scale })
    }

    /// The components x, y and z.
    #[must_use]
    pub fn components(self) -> [f32; 3] {
        [self.x, self.y, self.z]
    }
}

/// Many normals, stored component by component.
///
/// The normals are used as they are: each must be a unit vector with z in \[0, 1\], as
/// [`new`](Self::new) checks. Normals of a mesh or a map must pass through
/// [`normalized`](Self::normalized) first.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Normals<'a> {
    pub(crate) x: &'a [f32],
    pub(crate) y: &'a [f32],
    pub(crate) z: &'a [f32],
}

impl<'a> Normals<'a> {
    /// The normals with these components, as they are. Each must have unit length to within one
    /// part in 2,000.
    ///
    /// ```
    /// use eigenshade::{Error, Normals};
    ///
    /// assert_eq!(Normals::new(&[0.0, 0.6], &[0.0, 0.0], &[1.0, 0.8])?.len(), 2);
    /// let longer = Normals::new(&[0.0, 0.6], &[0.0, 0.0], &[1.0, 0.9]);
    /// assert_eq!(longer, Err(Error::Normals { index: 1 }));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// Cost: three products for each normal.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless all three slices have the same length; [`Error::Normals`] with the
    /// index of the first normal whose length is not 1 or whose z is below 0.
    pub fn new(x: &'a [f32], y: &'a [f32], z: &'a [f32]) -> Result<Self, Error> {
        let normals = Self::from_unit(x, y, z)?;
        let most = 1e-3;
        let is_unit = |Normal { x, y, z }: Normal| {
            let off = x * x + y * y + z * z - 1.0;
            z >= 0.0 && off <= most && off >= -most
        };
        match normals.iter().position(|normal| !is_unit(normal)) {
            None => Ok(normals),
            Some(index) => Err(Error::Normals { index }),
        }
    }

    /// [`new`](Self::new) in a constant, or without a pass over the normals: the caller promises
    /// unit vectors with z in \[0, 1\]. Any other vector has a meaningless irradiance, but does not
    /// affect the other normals.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless all three slices have the same length.
    pub const fn from_unit(x: &'a [f32], y: &'a [f32], z: &'a [f32]) -> Result<Self, Error> {
        match (
            Error::check(Argument::Normals, x.len(), y.len()),
            Error::check(Argument::Normals, x.len(), z.len()),
        ) {
            (Ok(()), Ok(())) => Ok(Self { x, y, z }),
            (Err(error), _) | (_, Err(error)) => Err(error),
        }
    }

    /// The normals in the directions of these vectors. Each vector is scaled in place, and moved to
    /// the rim if it points away from the camera by at most 1/8, as by
    /// [`Normal::new`].
    ///
    /// A component rounded to 8 bits, as in a normal map, is off by up to 0.4 %. For the shipped
    /// lights on the shipped materials, the rms error from the rounded directions is 0.1 % of the
    /// peak in the median and 0.22 % at worst; without scaling it is 0.29 %.
    ///
    /// Cost: a root and nine products for each normal.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless all three slices have the same length; [`Error::Normals`] with the
    /// index of the first vector that [`Normal::new`] rejects. The vectors before it are then
    /// scaled; that vector and those after it are unchanged.
    pub fn normalized(x: &'a mut [f32], y: &'a mut [f32], z: &'a mut [f32]) -> Result<Self, Error> {
        Normals::from_unit(&*x, &*y, &*z)?;
        let vectors = x.iter_mut().zip(y.iter_mut()).zip(z.iter_mut());
        for (index, ((x, y), z)) in vectors.enumerate() {
            let unit = Normal::new(*x, *y, *z);
            (*x, *y, *z) = unit.map_err(|_| Error::Normals { index })?.components().into();
        }
        Ok(Self { x, y, z })
    }

    /// Iterates over the normals.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Normal> + use<'a> {
        let components = self.x.iter().zip(self.y).zip(self.z);
        components.map(|((&x, &y), &z)| Normal { x, y, z })
    }

    /// Number of normals.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.x.len()
    }

    /// Whether there are no normals.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.x.is_empty()
    }
}
