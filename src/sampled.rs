//! Look-ups instead of polynomials: the H_m(z) of each azimuth, sampled at knots.
//!
//! The knots are evenly spaced over z in \[0, 1\], with one more at either end, where the
//! polynomials continue. A knot holds the samples of all azimuths side by side: H_0, then H_m of +m
//! and of -m for each m up to the last one in the scene. A pixel reads two or four neighboring
//! knots, and weights them the same for every azimuth.

use crate::buffer::{Buffer, zeros};
use crate::error::{Argument, Error};
use crate::normal::Normal;
use crate::polynomial;
use crate::polynomial::{argument, turned};
use crate::scalar::Scalar;
use crate::scene::Scene;

/// The smallest and largest number of knots. With fewer, the knot before z = 0 would lie where
/// polynomials are far out of their range.
const KNOTS: core::ops::RangeInclusive<usize> = 8..=65_536;

/// One image as samples of its azimuths, in `samples`.
///
/// The table gives rms errors against the sampled scene, as fractions of the peak. The first number
/// is the median over the shipped lights on the gray materials, the second the worst case.
///
/// | knots | linear | cubic |
/// |---|---|---|
/// | 16 | 6.5e-4, 4e-3 | 9.5e-5, 6e-4 |
/// | 32 | 1.4e-4, 9e-4 | 8e-6, 5.5e-5 |
/// | 64 | 3.5e-5, 2.2e-4 | 8e-7, 6e-6 |
/// | 128 | 8.5e-6, 5.5e-5 | 1.2e-7, 7e-7 |
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SampledScene<S, B> {
    /// Samples per knot: 2 m_max + 1.
    width: usize,
    /// The number of intervals between knots, reduced by 2^-22 of itself so that z = 1, and values
    /// that rounding puts beyond it, stay within the last interval without clamping.
    within: S,
    samples: B,
}

/// A buffer for samples.
pub type SampledBuffer<S, const N: usize> = Buffer<S, N>;

impl<C> Scene<'_, C> {
    /// Length of the samples for a number of knots: (2 m_max + 1) (knots + 2).
    #[must_use]
    pub fn sampled_len<S: Scalar>(&self, knots: usize) -> usize
    where
        C: AsRef<[S]>,
    {
        self.width::<S>().saturating_mul(knots.saturating_add(2))
    }

    /// Samples the scene at `knots` knots. `N` must be at least [`sampled_len`](Self::sampled_len).
    ///
    /// ```
    /// # #[cfg(feature = "baked")] {
    /// use eigenshade::{Light, Material, Normal, sphere};
    ///
    /// let light = Light::new(&[3.5, 0.0, 1.0, 0.0])?;
    /// let scene = sphere::collapse(&sphere::project(&light, &Material::new(&[2.0])?)?)?;
    /// const SAMPLES: usize = 13 * (32 + 2); // this table reaches m = 6
    /// let sampled = scene.sampled::<f32, SAMPLES>(32)?;
    /// let normal = Normal::new(0.0, 0.6, 0.8)?;
    /// assert!((sampled.cubic(normal) - scene.shade(normal)).abs() < 1e-4);
    /// # }
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// Cost: evaluating the scene's polynomials at each knot.
    ///
    /// # Errors
    ///
    /// [`Error::Knots`] unless there are 8 to 65,536 knots, [`Error::Capacity`] if `N` is too
    /// small.
    pub fn sampled<S: Scalar, const N: usize>(
        &self,
        knots: usize,
    ) -> Result<SampledScene<S, SampledBuffer<S, N>>, Error>
    where
        C: AsRef<[S]>,
    {
        check_knots(knots)?;
        self.sampled_into(knots, zeros::<S, N>(Argument::Samples, self.sampled_len(knots))?)
    }

    /// [`sampled`](Self::sampled) into a buffer of your own, of length
    /// [`sampled_len`](Self::sampled_len).
    ///
    /// # Errors
    ///
    /// [`Error::Knots`] unless there are 8 to 65,536 knots, [`Error::Length`] if the buffer has
    /// another length.
    pub fn sampled_into<S: Scalar, B: AsMut<[S]>>(
        &self,
        knots: usize,
        mut samples: B,
    ) -> Result<SampledScene<S, B>, Error>
    where
        C: AsRef<[S]>,
    {
        check_knots(knots)?;
        let to = samples.as_mut();
        Error::check(Argument::Samples, self.sampled_len(knots), to.len())?;
        let (width, intervals) = (self.width::<S>(), S::from_whole(knots - 1));
        let step = intervals.reciprocal();
        for (knot, samples) in to.chunks_exact_mut(width.max(1)).enumerate() {
            let t = argument((S::from_whole(knot) - S::ONE) * step);
            let values = self.azimuths().enumerate().flat_map(|(azimuth, (plus, minus))| {
                let recurrence = self.recurrences().of(azimuth);
                let of_minus = (azimuth > 0).then(|| polynomial::value(minus, t, recurrence));
                core::iter::once(polynomial::value(plus, t, recurrence)).chain(of_minus)
            });
            for (sample, value) in samples.iter_mut().zip(values) {
                *sample = value;
            }
        }
        let within = intervals * S::from_f64(1.0 - 1.0 / f64::from(1 << 22));
        Ok(SampledScene { width, within, samples })
    }

    /// Samples per knot. Azimuths beyond the last one with a polynomial have no samples.
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

impl<S: Scalar, B: AsRef<[S]>> SampledScene<S, B> {
    /// The samples, knot by knot, starting with the knot before z = 0.
    #[must_use]
    pub fn samples(&self) -> &[S] {
        self.samples.as_ref()
    }

    /// The irradiance of one normal, interpolated linearly between two knots.
    ///
    /// Cost: two times three products for each azimuth; no division.
    #[inline]
    #[must_use]
    pub fn linear(&self, normal: Normal<S>) -> S {
        let (knot, way) = self.interval(normal.z);
        let (from, to) = self.rows(knot.wrapping_add(1));
        let samples = from.iter().zip(to).map(|(&from, &to)| from.add_product(to - from, way));
        around(samples, normal)
    }

    /// The irradiance of one normal, interpolated by Catmull-Rom cubics between two knots. The
    /// slope at a knot is that of the chord between its neighbors.
    ///
    /// Cost: two times five products for each azimuth; no division.
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

    /// The index of the interval that contains z, and the fraction of the way from its first knot
    /// to its second.
    #[inline]
    fn interval(&self, z: S) -> (usize, S) {
        let place = z * self.within;
        let knot = place.to_whole();
        (knot, place - S::from_whole(knot))
    }

    /// The samples of a knot, and all samples after them. Both are empty for a z outside the range
    /// of normals.
    #[inline]
    fn rows(&self, knot: usize) -> (&[S], &[S]) {
        let rows = self.samples.as_ref().get(knot.wrapping_mul(self.width)..);
        rows.and_then(|rows| rows.split_at_checked(self.width)).unwrap_or_default()
    }
}

/// The weights of four neighboring knots, for a point at a fraction `way` from the second knot to
/// the third.
#[inline]
fn catmull_rom<S: Scalar>(way: S) -> [S; 4] {
    let (square, rest) = (way * way, S::ONE - way);
    let half = S::from_f64(0.5);
    // Half the weight of each slope in the value: at the second knot and at the third.
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
