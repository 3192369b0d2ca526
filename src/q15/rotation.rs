//! Rotations of light, made without floats.

use super::arithmetic::{BITS, Shift as _, rotated};
use super::inputs::decoded;
use crate::error::Error;
use crate::index::light::MAX_DEGREE;
use crate::turn::swing_twist::{Multiples, SwingTwist};

/// A rotation of light in integers: light that came from ω comes from Rω afterward.
///
/// A rotation is made without floats and stores cosines and sines to 30 bits, which are the same on
/// every machine. For a sequence of rotations, multiply the quaternions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rotation {
    // A half turn about y, then a twist about z, then a swing that moves z toward an axis: see
    // `turn/swing_twist.rs`. Cosines and sines are fractions of 2^30.
    flips: bool,
    twist: [i32; 2],
    axis: [i32; 2],
    swing: [i32; 2],
}

const ONE: i32 = 1 << 30;

impl Rotation {
    /// The identity.
    pub const NONE: Self = Self { flips: false, twist: [ONE, 0], axis: [ONE, 0], swing: [ONE, 0] };

    /// The rotation of the quaternion x i + y j + z k + w, of integers of any scale, such as
    /// mantissas of one exponent. Each cosine and sine is off by at most 4 units of 2^-30 if the
    /// largest component has 30 bits.
    ///
    /// Cost: five roots and six divisions in 64 bits.
    ///
    /// ```
    /// use eigenshade::q15::{Light, Rotation};
    /// use eigenshade::Q15;
    ///
    /// let camera = [0, 0, 8192, 0].map(Q15);
    /// let light = Light::new(-13, &camera)?;
    /// let quarter = Rotation::from_quaternion([0, 1, 0, 1])?; // about y
    /// let turned = light.turned::<4>(&quarter)?; // now from the right
    /// assert_eq!(turned.light()?.mantissas(), [0, 0, 0, -16_384].map(Q15));
    /// assert_eq!(turned.light()?.exponent(), -14);
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Rotation`] if all components are 0.
    pub fn from_quaternion(quaternion: [i32; 4]) -> Result<Self, Error> {
        let sizes = quaternion.map(i32::unsigned_abs);
        let bits = 32 - sizes.into_iter().fold(0, |all, size| all | size).leading_zeros();
        // At most 30 bits, so that four squares sum to less than 2^62.
        let [x, y, z, w] =
            quaternion.map(|number| i64::from(number).shifted(30 - bits.cast_signed()));
        let flips = x * x + y * y > z * z + w * w;
        let [x, y, z, w] = if flips { [-z, w, x, -y] } else { [x, y, z, w] };
        let (horizontal, vertical) = (x * x + y * y, z * z + w * w);
        let twist = unit(w * w - z * z, 2 * w * z).ok_or(Error::Rotation)?;
        let axis = unit(z * x + y * w, y * z - x * w).unwrap_or([ONE, 0]);
        let sine = 2 * root(horizontal) * root(vertical);
        let swing = unit(vertical - horizontal, sine).ok_or(Error::Rotation)?;
        Ok(Self { flips, twist, axis, swing })
    }

    /// This rotation from floats, in integer arithmetic throughout. Each cosine and sine is off by
    /// at most the rounding of the matrix.
    #[must_use]
    pub fn quantize(rotation: &crate::Rotation) -> Self {
        let matrix = rotation.matrix().map(|row| {
            row.map(|element| {
                let (size, exponent) = decoded(element);
                i64::from(size).shifted(exponent + 30)
            })
        });
        let [[xx, xy, xz], [yx, yy, yz], [_, _, zz]] = matrix;
        let flips = zz < 0;
        let [xx, yx, xz, yz, zz] =
            if flips { [-xx, -yx, -xz, -yz, -zz] } else { [xx, yx, xz, yz, zz] };
        let twist = unit(xx + yy, yx - xy).unwrap_or([ONE, 0]);
        let axis = unit(xz, yz).unwrap_or([ONE, 0]);
        let swing = unit(zz, root(xz * xz + yz * yz)).unwrap_or([ONE, 0]);
        Self { flips, twist, axis, swing }
    }

    /// The multiples of the angles.
    pub(super) fn swing_twist(&self, degree: usize) -> SwingTwist<i32> {
        let [cosine, sine] = self.swing;
        let mut turn = SwingTwist {
            flips: self.flips,
            is_inverse: false,
            swings: sine != 0,
            is_small: cosine > ONE - ONE / 100,
            twist: multiples(self.twist, degree),
            axis: [[0; 2]; MAX_DEGREE],
            swing: [[0; 2]; MAX_DEGREE],
        };
        if turn.swings {
            turn.axis = multiples(self.axis, degree);
            turn.swing = multiples([cosine, -sine], degree);
        }
        turn
    }
}

/// The direction of (x, y) as a cosine and a sine; none if both are 0. Domain: below 2^62.
pub(super) fn unit(x: i64, y: i64) -> Option<[i32; 2]> {
    // The larger one gets 31 bits, so the squares sum to less than 2^63.
    let [a, b] = [x, y].map(i64::unsigned_abs);
    let bits = 64 - (a | b).leading_zeros().cast_signed();
    let [x, y] = [x, y].map(|number| number.shifted(31 - bits).clamp(-0x7fff_ffff, 0x7fff_ffff));
    let length = root(x * x + y * y);
    let scaled = |number: i64| {
        let rounded = ((number.abs() << 30) + length / 2).checked_div(length)?;
        let size = i32::try_from(rounded).unwrap_or(ONE).min(ONE);
        Some(if number < 0 { -size } else { size })
    };
    Some([scaled(x)?, scaled(y)?])
}

/// floor(√square), for square >= 0.
fn root(square: i64) -> i64 {
    square.unsigned_abs().isqrt().cast_signed()
}

/// exp(imα) - 1 up to the degree, as fractions of 2^14.
#[inline(never)]
pub(super) fn multiples(angle: [i32; 2], degree: usize) -> Multiples<i32> {
    const DOWN: u32 = 31 - BITS;
    let rounded = |number: i32| ((number >> (DOWN - 1)) + 1) >> 1;
    let [mut c, mut s] = angle;
    let mut multiples = [[0; 2]; MAX_DEGREE];
    for multiple in multiples.iter_mut().take(degree) {
        *multiple = [rounded(c) - (ONE >> DOWN), rounded(s)];
        [c, s] = rotated([c, s], angle);
    }
    multiples
}
