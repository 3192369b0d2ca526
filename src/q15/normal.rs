//! Normals in fixed point.

use super::Q15;
use super::arithmetic::BITS;
use crate::error::Error;

/// One visible unit normal: x to the right, y up, z >= 0 toward the camera. The components are
/// fractions of 2^15.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Normal {
    pub(crate) x: Q15,
    pub(crate) y: Q15,
    pub(crate) z: Q15,
}

impl Normal {
    /// The normal with these components, as they are. The length must be 1 to within one part in
    /// 2,000, because sums of integers could overflow. [`new`](Self::new) scales a vector of any
    /// length.
    ///
    /// # Errors
    ///
    /// [`Error::NotUnit`] if the length is not 1, [`Error::Hidden`] if z < 0.
    #[inline]
    pub const fn from_unit(x: Q15, y: Q15, z: Q15) -> Result<Self, Error> {
        const ONE: u32 = 1 << (2 * BITS);
        let (a, b, c) = (x.0.unsigned_abs(), y.0.unsigned_abs(), z.0.unsigned_abs());
        let (a, b, c) = (a as u32, b as u32, c as u32);
        let square = a * a + b * b + c * c;
        if square < ONE - ONE / 1_000 || square > ONE + ONE / 1_000 {
            Err(Error::NotUnit)
        } else if z.0 < 0 {
            Err(Error::Hidden)
        } else {
            Ok(Self { x, y, z })
        }
    }

    /// The normal in the direction (x, y, z), integers of any scale. The vector is scaled to length
    /// 1, with an error of at most one unit in each component.
    ///
    /// A vector that points away from the camera by no more than 1/8 is moved to the rim. For an
    /// 8-bit normal map, pass 2c - 255 for each channel c.
    ///
    /// Cost: a root and three divisions in 64 bits, suitable for reading maps but not for each
    /// pixel.
    ///
    /// ```
    /// use eigenshade::q15::Normal;
    /// use eigenshade::{Error, Q15};
    ///
    /// let [x, y, z] = [218, 127, 218].map(|c| 2 * c - 255);
    /// assert_eq!(Normal::new(x, y, z)?.components(), [23_170, -128, 23_170].map(Q15));
    /// assert_eq!(Normal::new(4, 3, 0)?, Normal::new(400, 300, -50)?);
    /// assert_eq!(Normal::new(4, 3, -1), Err(Error::Hidden));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Normal`] if all three components are 0, [`Error::Hidden`] if z < -1/8 after
    /// scaling.
    pub fn new(x: i32, y: i32, z: i32) -> Result<Self, Error> {
        let sizes = [x, y, z].map(|c| u64::from(c.max(-i32::MAX).unsigned_abs()));
        let [a, b, c] = sizes;
        // The largest component gets 31 bits, so the squares sum to less than 2^64.
        let shift = (a | b | c).leading_zeros() - 33;
        let [xx, yy, zz] = sizes.map(|size| (size << shift) * (size << shift));
        let length = (xx + yy + zz).isqrt();
        let is_behind = z < 0;
        if is_behind && c << (shift + 3) > length {
            return Err(Error::Hidden);
        }
        let (c, length) = if is_behind { (0, (xx + yy).isqrt()) } else { (c, length) };
        let scaled = |component: i32, size: u64| {
            let rounded = ((size << (shift + BITS)) + length / 2).checked_div(length)?;
            let size = i32::try_from(rounded).unwrap_or(i32::MAX);
            Some(Q15::saturate(if component < 0 { -size } else { size }))
        };
        match (scaled(x, a), scaled(y, b), scaled(z, c)) {
            (Some(x), Some(y), Some(z)) => Ok(Self { x, y, z }),
            _ => Err(Error::Normal),
        }
    }

    /// The components x, y and z.
    #[must_use]
    pub const fn components(self) -> [Q15; 3] {
        [self.x, self.y, self.z]
    }
}
