//! The transfer of a material in fixed point: T_i,l = Σ_pq factor_i,l,pq S_l,pq with S_l,pq = Σ_o
//! B_op^q Ĉ_lo^q, so that d_i = Σ_l T_i,l L_l^m.

use super::arithmetic::{BITS, Shift as _, over_root_two};
use super::{Basis, Material, Q15};
use crate::buffer::{Buffer, zeros};
use crate::checked_slice::{part, split_mut, split_row};
use crate::checked_slice::{rows, rows_mut};
use crate::error::{Argument, Error};
use crate::index::{material, pair};

/// The transfer of a material: for each profile a row over l from |m| on, times 2 to its exponent.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Transfer<'a> {
    pub(crate) numbers: &'a [Q15],
    pub(crate) exponents: &'a [i16],
    /// Whether the absolute values of every row are known to sum to less than 2^16.
    pub(crate) bounded: bool,
}

impl<'a> Transfer<'a> {
    /// A transfer of these numbers. [`Basis::relight`](super::Basis::relight) checks on every call
    /// that there are as many as it needs and that no sum can overflow its accumulator.
    /// [`Basis::checked_transfer`](super::Basis::checked_transfer) checks this only once.
    #[must_use]
    pub const fn new(numbers: &'a [Q15], exponents: &'a [i16]) -> Self {
        Self { numbers, exponents, bounded: false }
    }
}

/// Storage for a [`Transfer`] of `T` numbers and `P` profiles.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TransferBuffer<const T: usize, const P: usize> {
    pub(crate) numbers: Buffer<Q15, T>,
    pub(crate) exponents: Buffer<i16, P>,
}

impl<const T: usize, const P: usize> TransferBuffer<T, P> {
    /// The stored transfer.
    #[must_use]
    pub fn view(&self) -> Transfer<'_> {
        Transfer { numbers: &self.numbers, exponents: &self.exponents, bounded: true }
    }
}

impl Basis<'_> {
    /// Computes the transfer of a material.
    ///
    /// `N` must be at least [`workspace_len`](Self::workspace_len), `T` at least
    /// [`transfer_len`](Self::transfer_len), and `P` at least [`profiles`](Self::profiles).
    ///
    /// # Errors
    ///
    /// The same as [`transfer_into`](Self::transfer_into), and [`Error::Capacity`] if `N`, `T` or
    /// `P` is too small.
    pub fn transfer<const N: usize, const T: usize, const P: usize>(
        &self,
        material: &Material<'_>,
    ) -> Result<TransferBuffer<T, P>, Error> {
        let mut workspace = zeros::<i32, N>(Argument::Workspace, self.workspace_len())?;
        let mut transfer = TransferBuffer {
            numbers: zeros::<Q15, T>(Argument::Transfer, self.transfer_len())?,
            exponents: zeros::<i16, P>(Argument::Transfer, self.profiles())?,
        };
        let TransferBuffer { numbers, exponents } = &mut transfer;
        self.transfer_into(material, &mut workspace, numbers, exponents)?;
        Ok(transfer)
    }

    /// [`transfer`](Self::transfer) with slices.
    ///
    /// # Errors
    ///
    /// [`Error::Beyond`] if the material goes beyond the basis's order, [`Error::TransfersOnly`] if
    /// the basis only holds transfers, [`Error::Length`] unless `workspace` has
    /// [`workspace_len`](Self::workspace_len) numbers, `numbers` has
    /// [`transfer_len`](Self::transfer_len) and `exponents` has [`profiles`](Self::profiles).
    pub fn transfer_into(
        &self,
        material: &Material<'_>,
        workspace: &mut [i32],
        numbers: &mut [Q15],
        exponents: &mut [i16],
    ) -> Result<(), Error> {
        Error::check_beyond(Argument::Material, self.order(), material.order)?;
        if self.parts.polar.is_empty() {
            return Err(Error::TransfersOnly);
        }
        Error::check(Argument::Workspace, self.workspace_len(), workspace.len())?;
        Error::check(Argument::Transfer, self.transfer_len(), numbers.len())?;
        Error::check(Argument::Transfer, self.profiles(), exponents.len())?;
        let pairs = pair::count(self.order());
        let degrees = self.degree() + 1;
        let (sums, rest) = split_mut(workspace, degrees * pairs);
        let (of_sums, row) = split_mut(rest, degrees);
        self.scatter(material, sums, of_sums);
        let (row, _) = row.as_chunks_mut::<2>();
        let mut factors = rows(self.parts.factors, pairs);
        let mut of_factors = self.parts.factor_exponents.iter();
        let mut numbers = numbers;
        for (profile, exponent) in self.parts.profiles.iter().zip(exponents) {
            let azimuth = usize::from(profile.azimuth);
            let (of_profile, after) = split_mut(numbers, degrees - azimuth);
            numbers = after;
            let of_degrees =
                rows(part(sums, azimuth * pairs..), pairs).zip(of_sums.iter().skip(azimuth));
            for ([sum, of_sum], (sums, &of_sums)) in row.iter_mut().zip(of_degrees) {
                let (Some(factors), Some(&of_factors)) = (factors.next(), of_factors.next()) else {
                    break;
                };
                (*sum, *of_sum) = (product(factors, sums), of_sums + i32::from(of_factors));
            }
            let row = row.iter().take(degrees - azimuth);
            let found = row.map(|&[sum, exponent]| (sum, exponent));
            *exponent = settle(found, of_profile);
        }
        Ok(())
    }

    /// Writes S: for each l a row over the pairs (p, q), of numbers to 2^15, and its exponent.
    fn scatter(&self, material: &Material<'_>, sums: &mut [i32], exponents: &mut [i32]) {
        let pairs = pair::count(self.order());
        let room = room(self.order());
        let polar = rows(self.parts.polar, pairs).zip(rows(self.parts.polar_exponents, pairs));
        for ((polar, of_polar), (sums, exponent)) in polar.zip(rows_mut(sums, pairs).zip(exponents))
        {
            // Ĉ of (o, q) is multiplied by coefficients of o and of all higher orders of the same
            // parity.
            let (mut above, mut of_others, mut top, mut rest) = (None, None, i32::MIN, of_polar);
            for o in (0..=self.order()).rev() {
                let (below, of_o) = split_row(rest, pair::position(o, 0));
                rest = below;
                above = above.max(material.exponents.get(o));
                if let (Some(&above), Some(&of_polar)) = (above, of_o.iter().max()) {
                    top = top.max(i32::from(above) + i32::from(of_polar));
                }
                (above, of_others) = (of_others, above);
            }
            let common = top + room;
            sums.fill(0);
            let coefficients = material::indices(material.order).zip(material.mantissas);
            for ((o, p, q), &b) in coefficients {
                let of_order = material.exponents.get(o).copied().unwrap_or_default();
                let (of_o, of_p) = (pair::position(o, q), pair::position(p, q));
                let b = if o == p { b } else { over_root_two(b) };
                let mut add = |from: usize, to: usize| {
                    let (Some(&polar), Some(&of_polar), Some(sum)) =
                        (polar.get(from), of_polar.get(from), sums.get_mut(to))
                    else {
                        return;
                    };
                    let by = i32::from(of_order) + i32::from(of_polar) - common;
                    *sum += (b.get() * polar.get()).shifted(by);
                };
                add(of_o, of_p);
                if o != p {
                    add(of_p, of_o);
                }
            }
            let largest = sums.iter().map(|sum| sum.bits()).max().unwrap_or_default();
            let by = BITS.cast_signed() - largest.cast_signed();
            for sum in sums.iter_mut() {
                *sum = sum.shifted(by);
            }
            *exponent = if largest == 0 { ZERO_EXPONENT } else { common - by };
        }
    }
}

/// The number of bits by which the addends of S are shifted right so that their sum fits. There is
/// one addend for each o of a parity. The shift is at least one bit, because the kernel of a
/// table shifts by at least one.
#[inline(always)]
pub(crate) fn room(order: usize) -> i32 {
    (((order / 2 + 1) as i32).bits().cast_signed() - 1).max(1)
}

/// Rounds numbers with exponents of their own to mantissas, and returns the common exponent.
#[inline(always)]
pub(crate) fn settle(row: impl Iterator<Item = (i32, i32)> + Clone, numbers: &mut [Q15]) -> i16 {
    let common = common_exponent(row.clone(), BITS);
    for (to, (number, exponent)) in numbers.iter_mut().zip(row) {
        *to = Q15::saturate(number.shifted(exponent - common));
    }
    common as i16
}

/// Σ a b. The row of factors sums to less than 2^16, so the result fits.
#[inline(always)]
pub(crate) fn product(factors: &[Q15], sums: &[i32]) -> i32 {
    let mut sum = 0;
    for (factor, &scattered) in factors.iter().zip(sums) {
        sum += factor.get() * scattered;
    }
    sum
}

/// The exponent of zeros, below the exponent of any number.
pub(crate) const ZERO_EXPONENT: i32 = -1 << 12;

/// When a row is aligned to its largest exponent, its largest number must have this many bits more
/// than are kept.
pub(crate) const GUARD_BITS: u32 = 5;

/// A common exponent for at most 511 numbers, each with an exponent of its own. With it, the
/// mantissas are below 2^`bits`, and the sum of their sizes after rounding is below 2^(`bits` + 1).
/// It is the least such exponent, except for the 256th that rounding may add.
fn common_exponent(numbers: impl Iterator<Item = (i32, i32)> + Clone, bits: u32) -> i32 {
    let (mut largest, mut top, mut count) = (i32::MIN, None, 0);
    numbers.clone().for_each(|(number, exponent)| {
        count += 1;
        largest = largest.max(exponent);
        if number != 0 {
            top = top.max(Some(number.bits().cast_signed() + exponent));
        }
    });
    let Some(top) = top else { return 0 };
    let guard = guard(count);
    let at = |reference: i32| {
        let (mut most, mut sum) = (0, 0);
        numbers.clone().for_each(|(number, exponent)| {
            let aligned = number.max(-number).floor_shr(exponent - reference);
            most = most.max(aligned);
            sum += aligned.floor_shr(-guard.cast_signed());
        });
        row_bits(most, sum, count, guard)
    };
    // If no number with the largest exponent is large, align all of them so that they fill their
    // bits.
    let found = at(largest);
    let (reference, found) = if found >= bits + GUARD_BITS {
        (largest, found)
    } else {
        let reference = top - 31;
        (reference, at(reference))
    };
    reference + found.cast_signed() - bits.cast_signed()
}

/// By how many bits sizes are shifted right so that `count` of them, plus a 256th, fit in a sum.
#[inline(always)]
pub(crate) fn guard(count: i32) -> u32 {
    (count + (count >> 8)).bits()
}

/// The least n such that the sizes are below 2^n, and their sum, including the error of rounding,
/// is below 2^(n + 1). `either` is the largest size, or the bitwise OR of all sizes; `sum` is the
/// sum of `count` sizes, each shifted right by [`guard`].
#[inline(always)]
pub(crate) fn row_bits(either: i32, sum: i32, count: i32, guard: u32) -> u32 {
    // Each size was rounded down.
    let sum = sum + sum.floor_shr(-8) + count;
    let half = guard - 1;
    sum.max(either.floor_shr(-half.cast_signed())).bits() + half
}
