//! The coefficients d of an image in fixed point, and a new light on a transferred material:
//! d_i = Σ_l T_i,l L_l^m.

use super::{Basis, Light, Transfer};
use crate::buffer::{Buffer, zeros};
use crate::error::{Argument, Error};
use crate::format::{FixedPoint, Wide};
use crate::index::light;

/// The coefficients d of one image, component by component. The mantissas are at most 2^30 in size
/// and are multiplied by 2^exponent.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Coefficients<const K: usize> {
    pub(crate) mantissas: Buffer<i32, K>,
    pub(crate) exponent: i32,
}

impl<const K: usize> Coefficients<K> {
    /// The mantissas, component by component.
    #[must_use]
    pub fn mantissas(&self) -> &[i32] {
        &self.mantissas
    }

    /// The common exponent.
    #[must_use]
    pub const fn exponent(&self) -> i32 {
        self.exponent
    }
}

/// Number of bits of a mantissa of d.
const BITS: i32 = 30;

impl<Q: FixedPoint> Basis<'_, Q> {
    /// Computes d for a new light on a material whose transfer is known.
    ///
    /// `K` must be at least [`components`](Self::components).
    ///
    /// # Errors
    ///
    /// The same as [`relight_into`](Self::relight_into), and [`Error::Capacity`] if `K` is too
    /// small.
    pub fn relight<const K: usize>(
        &self,
        transfer: &Transfer<'_, Q>,
        light: &Light<'_, Q>,
    ) -> Result<Coefficients<K>, Error> {
        let mut mantissas = zeros::<i32, K>(Argument::Coefficients, self.components())?;
        let exponent = self.relight_into(transfer, light, &mut mantissas)?;
        Ok(Coefficients { mantissas, exponent })
    }

    /// [`relight`](Self::relight) into a slice of [`components`](Self::components) mantissas.
    /// Returns their exponent.
    ///
    /// # Errors
    ///
    /// [`Error::Beyond`] if the degree of the light exceeds that of the basis, [`Error::Length`] if
    /// the transfer or the slice does not fit the basis, [`Error::Bound`] if a row of a transfer
    /// made by [`Transfer::new`] sums to 2^(BITS + 1) or more.
    pub fn relight_into(
        &self,
        transfer: &Transfer<'_, Q>,
        light: &Light<'_, Q>,
        mantissas: &mut [i32],
    ) -> Result<i32, Error> {
        let (basis, found) = (self.degree(), light.degree);
        if found > basis {
            return Err(Error::Beyond { argument: Argument::Light, basis, found });
        }
        Error::check(Argument::Transfer, self.transfer_len(), transfer.numbers.len())?;
        Error::check(Argument::Transfer, self.profiles(), transfer.exponents.len())?;
        Error::check(Argument::Coefficients, self.components(), mantissas.len())?;
        if !transfer.bounded && !self.has_bounded(transfer.numbers) {
            return Err(Error::Bound);
        }
        let mut numbers = transfer.numbers;
        let mut top = None;
        let mut note = |place: Option<&mut i32>, sum: Q::Wide, exponent: i16| {
            let Some(place) = place else { return };
            // Keep the upper 31 bits.
            *place = sum.shifted(31 - Q::Wide::SIZE.cast_signed()).saturated();
            if *place != 0 {
                top = top.max(Some(place.bits().cast_signed() + i32::from(exponent)));
            }
        };
        for (profile, &exponent) in self.parts.profiles.iter().zip(transfer.exponents) {
            let azimuth = usize::from(profile.azimuth);
            let (row, after) =
                numbers.split_at_checked(basis + 1 - azimuth).unwrap_or((numbers, &[]));
            numbers = after;
            let [plus, minus] = sums(row, light.mantissas, azimuth);
            note(mantissas.get_mut(usize::from(profile.plus)), plus, exponent);
            note(mantissas.get_mut(usize::from(profile.minus)), minus, exponent);
        }
        let common = top.map_or(0, |top| top - BITS);
        for (profile, &exponent) in self.parts.profiles.iter().zip(transfer.exponents) {
            for component in [profile.plus, profile.minus] {
                if let Some(place) = mantissas.get_mut(usize::from(component)) {
                    *place = place.shifted(i32::from(exponent) - common);
                }
            }
        }
        Ok(common + light.exponent + Q::Wide::SIZE.cast_signed() - 31)
    }
}

impl<Q: FixedPoint> Basis<'_, Q> {
    /// Whether the absolute values of each row sum to less than 2^(BITS + 1).
    fn has_bounded(&self, mut numbers: &[Q]) -> bool {
        self.parts.profiles.iter().all(|profile| {
            let length = self.degree() + 1 - usize::from(profile.azimuth);
            let (row, after) = numbers.split_at_checked(length).unwrap_or((numbers, &[]));
            numbers = after;
            let mut sum = Q::Wide::default();
            for number in row {
                let number = number.widen();
                sum += if number < Q::Wide::default() { -number } else { number };
            }
            sum.bits() <= Q::BITS + 1
        })
    }
}

/// Σ_l T_l L_l^±m, with the sum of -m times (-1)^m. Each row of a transfer of this basis sums to
/// less than 2^(BITS + 1), so both fit. The sums may wrap for a transfer of another basis, whose
/// rows have other lengths.
#[inline]
fn sums<Q: FixedPoint>(row: &[Q], light: &[Q], azimuth: usize) -> [Q::Wide; 2] {
    let mut sums = [Q::Wide::default(); 2];
    let order = azimuth.cast_signed();
    for (l, number) in (azimuth..).zip(row) {
        let (Some(plus), Some(minus)) =
            (light.get(light::position(l, order)), light.get(light::position(l, -order)))
        else {
            break;
        };
        let [of_plus, of_minus] = &mut sums;
        *of_plus = of_plus.wrapping_plus(number.widen() * plus.widen());
        *of_minus = of_minus.wrapping_plus(number.widen() * minus.widen());
    }
    let [plus, minus] = sums;
    let odd = azimuth % 2 == 1;
    [plus, if odd { minus.wrapping_minus() } else { minus }]
}
