//! Normals in integers.

use crate::error::Error;
use crate::format::{Fixed, Q15, Q31};

/// One visible unit normal, its components fractions of 2^BITS: x to the right, y up,
/// z >= 0 toward the camera.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Normal<Q> {
    pub(crate) x: Q,
    pub(crate) y: Q,
    pub(crate) z: Q,
}

macro_rules! checked {
    ($format:ident, $wide:ident, $bits:literal) => {
        impl Normal<$format> {
            /// The normal of these components. It has to be a unit vector within one part
            /// in 2,000; it is not scaled.
            ///
            /// # Errors
            ///
            /// [`Error::Normal`] if its length is another, [`Error::Hidden`] if z < 0.
            pub const fn new(x: $format, y: $format, z: $format) -> Result<Self, Error> {
                const ONE: $wide = 1 << (2 * $bits);
                let (a, b, c) = (x.0.unsigned_abs(), y.0.unsigned_abs(), z.0.unsigned_abs());
                let (a, b, c) = (a as $wide, b as $wide, c as $wide);
                let square = a * a + b * b + c * c;
                if square < ONE - ONE / 1_000 || square > ONE + ONE / 1_000 {
                    Err(Error::Normal)
                } else if z.0 < 0 {
                    Err(Error::Hidden)
                } else {
                    Ok(Self { x, y, z })
                }
            }
        }
    };
}
checked!(Q15, u32, 15);
checked!(Q31, u64, 31);

impl<Q: Fixed> Normal<Q> {
    /// x, y and z.
    #[must_use]
    pub const fn components(self) -> [Q; 3] {
        [self.x, self.y, self.z]
    }
}
