//! Look-ups instead of polynomials: each azimuth's H_m(z) sampled at knots.
//!
//! Knots stand evenly on z in \[0, 1\], and one more at either end, where the polynomials
//! continue. A knot holds the samples of all azimuths side by side: H_0, then H_m of +m and of -m for each m up
//! to the last that the scene has. A pixel reads two neighbouring knots, or four, and
//! weighs them alike for every azimuth.

use crate::buffer::zeros;
use crate::error::{Error, What};
use crate::normal::Normal;
use crate::polynomial;
use crate::polynomial::{argument, turned};
use crate::scalar::Scalar;
use crate::scene::Scene;

/// The smallest and largest number of knots: of fewer, the one before z = 0 stood where polynomials have long left
/// their range.
const KNOTS: core::ops::RangeInclusive<usize> = 8..=65_536;

/// One image as samples of its azimuths, in `samples`.
///
/// Errors against the scene that was sampled, rms of the peak: of the median of the shipped lights on the shipped
/// materials, and of the worst.
///
/// | knots | linear | cubic |
/// |---|---|---|
/// | 16 | 6e-4, 5e-3 | 7e-5, 8e-4 |
/// | 32 | 1.4e-4, 1.1e-3 | 6e-6, 7e-5 |
/// | 64 | 3.5e-5, 2.6e-4 | 7e-7, 8e-6 |
/// | 128 | 8e-6, 6.5e-5 | 1.2e-7, 1e-6 |
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Lookup<S, B> {
    /// Samples of a knot: 2 m_max + 1.
    width: usize,
    /// Intervals between knots, less 2^-22 of them: z = 1, and what rounding puts beyond
    /// it, stays within the last without being clamped.
    within: S,
    samples: B,
}

/// Room for samples.
pub type LookupBuffer<S, const N: usize> = heapless::Vec<S, N>;

impl<C> Scene<'_, C> {
    /// Numbers that so many knots take: (2 m_max + 1) (knots + 2).
    #[must_use]
    pub fn lookup_len<S: Scalar>(&self, knots: usize) -> usize
    where
        C: AsRef<[S]>,
    {
        self.width::<S>().saturating_mul(knots.saturating_add(2))
    }

    /// Samples the scene at so many knots; `N` is at least
    /// [`lookup_len`](Self::lookup_len).
    ///
    /// Cost: the scene's polynomials, at each knot.
    ///
    /// # Errors
    ///
    /// [`Error::Knots`] unless they are 8 to 65,536, [`Error::Capacity`] if `N` is too small.
    pub fn lookup<S: Scalar, const N: usize>(
        &self,
        knots: usize,
    ) -> Result<Lookup<S, LookupBuffer<S, N>>, Error>
    where
        C: AsRef<[S]>,
    {
        check_knots(knots)?;
        self.lookup_into(knots, zeros::<S, N>(What::Samples, self.lookup_len(knots))?)
    }

    /// [`lookup`](Self::lookup) into a buffer of one's own, of length
    /// [`lookup_len`](Self::lookup_len).
    ///
    /// # Errors
    ///
    /// [`Error::Knots`] unless they are 8 to 65,536, [`Error::Length`] if the buffer has another
    /// length.
    pub fn lookup_into<S: Scalar, B: AsMut<[S]>>(
        &self,
        knots: usize,
        mut samples: B,
    ) -> Result<Lookup<S, B>, Error>
    where
        C: AsRef<[S]>,
    {
        check_knots(knots)?;
        let to = samples.as_mut();
        Error::check(What::Samples, self.lookup_len(knots), to.len())?;
        let (width, intervals) = (self.width::<S>(), S::from_whole(knots - 1));
        let step = intervals.reciprocal();
        for (knot, samples) in to.chunks_exact_mut(width.max(1)).enumerate() {
            let t = argument((S::from_whole(knot) - S::ONE) * step);
            let values = self.azimuths().enumerate().flat_map(|(azimuth, (plus, minus))| {
                let recurrence = self.recurrence(azimuth);
                let of_minus = (azimuth > 0).then(|| polynomial::value(minus, t, recurrence));
                core::iter::once(polynomial::value(plus, t, recurrence)).chain(of_minus)
            });
            for (sample, value) in samples.iter_mut().zip(values) {
                *sample = value;
            }
        }
        let within = intervals * S::from_f64(1.0 - 1.0 / f64::from(1 << 22));
        Ok(Lookup { width, within, samples })
    }

    /// Samples of a knot: azimuths beyond the last with a polynomial have none.
    fn width<S: Scalar>(&self) -> usize
    where
        C: AsRef<[S]>,
    {
        let there = self.azimuths().enumerate().filter(|(_, (plus, _))| !plus.is_empty());
        there.last().map_or(1, |(azimuth, _)| 2 * azimuth + 1)
    }
}

const fn check_knots(knots: usize) -> Result<(), Error> {
    if knots >= *KNOTS.start() && knots <= *KNOTS.end() {
        Ok(())
    } else {
        Err(Error::Knots { found: knots })
    }
}

impl<S: Scalar, B: AsRef<[S]>> Lookup<S, B> {
    /// The samples, knot by knot from the one before z = 0 on.
    #[must_use]
    pub fn samples(&self) -> &[S] {
        self.samples.as_ref()
    }

    /// The irradiance of one normal, by straight lines between two knots.
    ///
    /// Cost: for each azimuth two times three products; no division.
    #[inline]
    #[must_use]
    pub fn linear(&self, normal: Normal<S>) -> S {
        let (knot, way) = self.interval(normal.z);
        let (from, to) = self.rows(knot.wrapping_add(1));
        let samples = from.iter().zip(to).map(|(&from, &to)| from.add_product(to - from, way));
        around(samples, normal)
    }

    /// The irradiance of one normal, by Catmull-Rom cubics between two knots: their
    /// slopes are those of the chords between their neighbours.
    ///
    /// Cost: for each azimuth two times five products; no division.
    #[inline]
    #[must_use]
    pub fn cubic(&self, normal: Normal<S>) -> S {
        let (knot, way) = self.interval(normal.z);
        let (before, rest) = self.rows(knot);
        let (from, rest) = rest.split_at_checked(self.width).unwrap_or_default();
        let (to, after) = rest.split_at_checked(self.width).unwrap_or_default();
        let [w0, w1, w2, w3] = catmull_rom(way);
        let samples = before.iter().zip(from).zip(to.iter().zip(after));
        let samples = samples.map(|((&before, &from), (&to, &after))| {
            (w0 * before).add_product(w1, from) + (w2 * to).add_product(w3, after)
        });
        around(samples, normal)
    }

    /// The number of the interval of z, and the way from its first knot to its second.
    #[inline]
    fn interval(&self, z: S) -> (usize, S) {
        let place = z * self.within;
        let knot = place.to_whole();
        (knot, place - S::from_whole(knot))
    }

    /// A knot's samples, and all that follow. Nothing for a z that is no normal's.
    #[inline]
    fn rows(&self, knot: usize) -> (&[S], &[S]) {
        let rows = self.samples.as_ref().get(knot.wrapping_mul(self.width)..);
        rows.and_then(|rows| rows.split_at_checked(self.width)).unwrap_or_default()
    }
}

/// The weights of four neighbouring knots at a way from the second to the third.
#[inline]
fn catmull_rom<S: Scalar>(way: S) -> [S; 4] {
    let (square, rest) = (way * way, S::ONE - way);
    let half = S::from_f64(0.5);
    // Half a slope's share of the value: of the second knot's, and of the third's.
    let (of_second, of_third) = (half * way * rest * rest, half * square * rest);
    // w² (3 - 2 w).
    let third = square + S::from_f64(4.0) * of_third;
    [-of_second, S::ONE - third + of_third, third + of_second, -of_third]
}

/// Σ_m of the azimuths' samples times Re and Im of (x + i y)^m.
#[inline]
fn around<S: Scalar>(mut samples: impl Iterator<Item = S>, normal: Normal<S>) -> S {
    let mut sum = samples.next().unwrap_or(S::ZERO);
    let (mut cosine, mut sine) = (normal.x, normal.y);
    while let (Some(plus), Some(minus)) = (samples.next(), samples.next()) {
        sum = sum.add_product(plus, cosine).add_product(minus, sine);
        (cosine, sine) = turned(cosine, sine, normal.x, normal.y);
    }
    sum
}
