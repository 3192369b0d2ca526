//! The irradiance of a normal, in fixed point.

use super::Normal;
use super::collapse::Scene;
use super::kernels::value;
use crate::format::{Fixed, Wide as _};

impl<Q: Fixed, B: AsRef<[i32]>> Scene<'_, Q, B> {
    /// Shades one normal. The irradiance is the result times 2 to the scene's
    /// [`exponent`](Self::exponent).
    #[inline]
    #[must_use]
    pub fn shade(&self, normal: Normal<Q>) -> i32 {
        let t = Q::argument(normal.z);
        let (first, mut lengths, mut rest) = self.constant();
        // The last step of m = 0 needs no rounding.
        let (last, first) = first.split_last().unwrap_or((&0, &[]));
        let mut sum = Q::product(value::<Q>(first, t), t).wrapping_plus(Q::of_value(*last));
        let (mut cosine, mut sine) = (normal.x.halved(), normal.y.halved());
        while let [length, others @ ..] = lengths {
            let length = usize::from(*length);
            let (plus, after) = rest.split_at_checked(length).unwrap_or((rest, &[]));
            let (minus, after) = after.split_at_checked(length).unwrap_or((after, &[]));
            (lengths, rest) = (others, after);
            sum = sum.wrapping_plus(Q::product(value::<Q>(plus, t), cosine));
            sum = sum.wrapping_plus(Q::product(value::<Q>(minus, t), sine));
            (cosine, sine) = (
                Q::dot(cosine, normal.x, -sine, normal.y),
                Q::dot(cosine, normal.y, sine, normal.x),
            );
        }
        Q::sum(sum)
    }

    /// The polynomial of m = 0, and the lengths and polynomials of the other azimuths.
    #[inline]
    fn constant(&self) -> (&[i32], &[u8], &[i32]) {
        let (length, lengths) = self.lengths.split_first().unwrap_or((&0, &[]));
        let terms = self.buffer.as_ref();
        let (first, rest) = terms.split_at_checked(usize::from(*length)).unwrap_or((terms, &[]));
        (first, lengths, rest)
    }
}

impl<Q, B: AsRef<[i32]>> Scene<'_, Q, B> {
    /// The polynomials of each azimuth: those of +m, and those of -m (empty for m = 0).
    #[must_use]
    pub fn terms(&self) -> &[i32] {
        self.buffer.as_ref()
    }
}

impl<Q, B> Scene<'_, Q, B> {
    /// The exponent of every irradiance.
    #[must_use]
    pub const fn exponent(&self) -> i32 {
        self.exponent
    }
}
