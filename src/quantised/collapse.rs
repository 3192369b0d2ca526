//! One image in integers, its components summed azimuth by azimuth:
//! I(n) = Σ_m Re/Im (n_x + i n_y)^m H_m(n_z).

#[cfg(doc)]
use super::fold::common_exponent;
use super::{Basis, Profile};
use crate::error::{Error, What};
use crate::format::{Fixed, Wide as _};
use crate::projection::zeros;
use core::marker::PhantomData;

/// Room for a collapsed scene.
pub type SceneBuffer<const N: usize> = heapless::Vec<i32, N>;

/// Bits of d that its size leaves out: twice ten and sixteen are 32.
const UNIT: u32 = 16;

/// One image: for each azimuth |m| the polynomials of +m and -m in `buffer`, all times
/// 2^exponent.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Scene<'a, Q, B> {
    pub(crate) lengths: &'a [u8],
    pub(crate) exponent: i32,
    pub(crate) buffer: B,
    format: PhantomData<Q>,
}

impl<'a, Q: Fixed> Basis<'a, Q> {
    /// Sums the components of each azimuth.
    ///
    /// `N` is at least [`scene_len`](Self::scene_len). `mantissas` and `exponent` are
    /// those of the first components; those that are missing count as zero. They may be
    /// any: but the scene's resolution is what 2^16 of them are.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] if there are more coefficients than components,
    /// [`Error::Exponent`] if |exponent| is above 2^16, which that of no light on a
    /// material is, [`Error::Capacity`] if `N` is too small.
    pub fn collapse<const N: usize>(
        &self,
        mantissas: &[i32],
        exponent: i32,
    ) -> Result<Scene<'a, Q, SceneBuffer<N>>, Error> {
        let buffer = zeros::<i32, N>(What::Scene, self.scene_len())?;
        self.collapse_into(mantissas, exponent, buffer)
    }

    /// [`collapse`](Self::collapse) into a buffer of one's own, of length
    /// [`scene_len`](Self::scene_len).
    ///
    /// # Errors
    ///
    /// [`Error::Length`] if there are more coefficients than components, or the buffer
    /// has another length; [`Error::Exponent`] as there.
    pub fn collapse_into<B: AsMut<[i32]>>(
        &self,
        mantissas: &[i32],
        exponent: i32,
        mut buffer: B,
    ) -> Result<Scene<'a, Q, B>, Error> {
        let sums = buffer.as_mut();
        Error::check(What::Scene, self.scene_len(), sums.len())?;
        if mantissas.len() > self.components() {
            let (expected, found) = (self.components(), mantissas.len());
            return Err(Error::Length { what: What::Coefficients, expected, found });
        }
        if exponent.unsigned_abs() > 1 << 16 {
            return Err(Error::Exponent);
        }
        sums.fill(0);
        let weight = |index: u16| mantissas.get(usize::from(index)).copied().unwrap_or(0);
        // The weights' sum is bounded, so that of weighed terms is.
        let common = self.common_exponent(mantissas);
        let (mut terms, mut rest, mut azimuth) = (self.parts.terms, &mut *sums, 0);
        for profile in self.parts.profiles {
            while azimuth < usize::from(profile.azimuth) {
                let passed = self.parts.length(azimuth) * if azimuth == 0 { 1 } else { 2 };
                rest = rest.get_mut(passed..).unwrap_or_default();
                azimuth += 1;
            }
            let length = self.parts.length(azimuth);
            let (of_profile, after) = terms.split_at_checked(length).unwrap_or((terms, &[]));
            terms = after;
            let by = i32::from(profile.exponent) - common;
            add(weight(profile.plus).shifted(by), of_profile, rest);
            // Φ_-m = √2 sin(-mβ) = -√2 Im (n_x + i n_y)^m / sin^m.
            let of_minus = -weight(profile.minus).shifted(by);
            add(of_minus, of_profile, rest.get_mut(length..).unwrap_or_default());
        }
        let to = self.finish(mantissas, exponent, common, sums);
        Ok(Scene { lengths: self.parts.lengths, exponent: to, buffer, format: PhantomData })
    }

    /// The scene of polynomials and an exponent that were collapsed before, from wherever
    /// they were kept. Others give meaningless irradiances.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless there are [`scene_len`](Self::scene_len) of them.
    pub fn scene<B: AsRef<[i32]>>(
        &self,
        exponent: i32,
        buffer: B,
    ) -> Result<Scene<'a, Q, B>, Error> {
        Error::check(What::Scene, self.scene_len(), buffer.as_ref().len())?;
        Ok(Scene { lengths: self.parts.lengths, exponent, buffer, format: PhantomData })
    }

    /// Scales the sums of weighed terms; gives their exponent.
    pub(crate) fn finish(
        &self,
        mantissas: &[i32],
        exponent: i32,
        common: i32,
        sums: &mut [i32],
    ) -> i32 {
        let to = exponent + self.size(mantissas) - Q::TERM_BITS.cast_signed();
        self.round(exponent + common + Q::WEIGHT_SHIFT.cast_signed() - to, sums);
        to
    }

    /// [`common_exponent`] of the weights d, each times its profile's exponent, of the
    /// components of +m and -m together: one count of bits for both.
    #[doc(hidden)]
    #[must_use]
    pub fn common_exponent(&self, mantissas: &[i32]) -> i32 {
        let mut top = i32::MIN;
        let pair = |profile: &Profile| {
            [profile.plus, profile.minus]
                .map(|index| mantissas.get(usize::from(index)).copied().unwrap_or(0))
        };
        for profile in self.parts.profiles {
            let [plus, minus] = pair(profile);
            let either = plus.unsigned_abs() | minus.unsigned_abs();
            if either != 0 {
                let bits = u32::BITS - either.leading_zeros();
                top = top.max(bits.cast_signed() + i32::from(profile.exponent));
            }
        }
        if top == i32::MIN {
            return 0;
        }
        let count = 2 * self.parts.profiles.len() as i32;
        let base = top - (i32::SIZE.cast_signed() - count.bits().cast_signed() - 2);
        let mut sum = 0;
        for profile in self.parts.profiles {
            let by = i32::from(profile.exponent) - base;
            let [plus, minus] = pair(profile);
            sum += plus.shifted(by).abs() + minus.shifted(by).abs();
        }
        sum += sum.shifted(-8);
        let bits = Q::WEIGHT_BITS.cast_signed();
        (base + sum.bits().cast_signed() - bits).max(top - bits)
    }

    /// The least n of: neither a step of a pixel's polynomials nor an irradiance goes
    /// beyond 2^n, in units of these coefficients, less a sixty-fourth for rounding and
    /// normals that are not quite of unit length.
    ///
    /// Either is a sum over components, each at most |d| times what the table states of
    /// its profile.
    fn size(&self, mantissas: &[i32]) -> i32 {
        let size = |index: u16| {
            let found = mantissas.get(usize::from(index));
            found.map_or(0, |d| (d.unsigned_abs() >> UNIT) + u32::from(*d != 0))
        };
        let (mut image, mut largest) = (0_u64, 0_u64);
        let (mut azimuth, mut of_plus, mut of_minus) = (0, 0_u64, 0_u64);
        for profile in self.parts.profiles {
            if profile.azimuth != azimuth {
                (azimuth, of_plus, of_minus) = (profile.azimuth, 0, 0);
            }
            let [plus, minus] = [size(profile.plus), size(profile.minus)];
            let times = |size: u32, of_profile: u16| u64::from(size * u32::from(of_profile));
            of_plus += times(plus, profile.step);
            of_minus += times(minus, profile.step);
            image += times(plus, profile.size) + times(minus, profile.size);
            largest = largest.max(of_plus).max(of_minus);
        }
        largest = largest.max(image);
        // A normal may be a two-thousandth too long, and (n_x + i n_y)^m its mth power: to
        // m = 24 that is in the sixty-fourth.
        let beyond = (self.degree() as u64).saturating_sub(24);
        largest += (largest >> 6) + beyond * (largest >> 10);
        let bits = 64 - largest.leading_zeros();
        bits.cast_signed() - 4 + UNIT.cast_signed()
    }

    /// Scales the terms by 2^`by`.
    ///
    /// A step of Horner's rule rounds down, half a unit on average; so every term that
    /// is added to such a step is rounded up, by as much. The first is added to none,
    /// and the last of m = 0 to one that is not rounded.
    fn round(&self, by: i32, sums: &mut [i32]) {
        let mut rest = sums;
        for (azimuth, &length) in self.parts.lengths.iter().enumerate() {
            for _ in 0..if azimuth == 0 { 1 } else { 2 } {
                let (polynomial, after) =
                    rest.split_at_mut_checked(usize::from(length)).unwrap_or_default();
                rest = after;
                let (last, mut above) = (polynomial.len().saturating_sub(1), 0);
                for (k, term) in polynomial.iter_mut().enumerate() {
                    let nearest = above == 0 || (azimuth == 0 && k == last);
                    above |= *term;
                    *term = match by {
                        0.. => *term << by.min(31),
                        _ if nearest => term.shifted(by),
                        _ => (*term >> (-by).min(31)) + 1,
                    };
                }
            }
        }
    }
}

/// sums += weight terms.
#[inline]
fn add<Q: Fixed>(weight: i32, terms: &[Q], sums: &mut [i32]) {
    if weight == 0 {
        return;
    }
    for (sum, term) in sums.iter_mut().zip(terms) {
        *sum += term.weigh(weight);
    }
}
