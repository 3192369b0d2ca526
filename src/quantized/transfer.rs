//! The transfer of a material in fixed point: T_i,l = Σ_pq factor_i,l,pq S_l,pq with S_l,pq = Σ_o
//! B_op^q Ĉ_lo^q, so that d_i = Σ_l T_i,l L_l^m.

use super::settle::{settle, settle_large};
use super::{Basis, Material};
use crate::buffer::{Buffer, zeros};
use crate::error::{Argument, Error};
use crate::format::{FixedPoint, Wide};
use crate::index::pair;
use crate::invariant::{part, part_mut, split_mut};
use crate::lanes::rows;
use crate::places::Shape;

/// The transfer of a material: for each profile a row over l from |m| on, times 2 to the exponent
/// of the profile.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Transfer<'a, Q> {
    pub(crate) numbers: &'a [Q],
    pub(crate) exponents: &'a [i16],
    /// Whether the absolute values of every row are known to sum to less than 2^(BITS + 1).
    pub(crate) bounded: bool,
}

impl<'a, Q> Transfer<'a, Q> {
    /// A transfer of these numbers. [`Basis::relight`](super::Basis::relight) checks on every call
    /// that there are as many as it needs and that no sum can leave its accumulator.
    /// [`Basis::checked_transfer`](super::Basis::checked_transfer) checks this only once.
    #[must_use]
    pub const fn new(numbers: &'a [Q], exponents: &'a [i16]) -> Self {
        Self { numbers, exponents, bounded: false }
    }
}

/// Storage for a [`Transfer`] of `T` numbers and `P` profiles.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TransferBuffer<Q, const T: usize, const P: usize> {
    pub(crate) numbers: Buffer<Q, T>,
    pub(crate) exponents: Buffer<i16, P>,
}

impl<Q, const T: usize, const P: usize> TransferBuffer<Q, T, P> {
    /// The stored transfer.
    #[must_use]
    pub fn view(&self) -> Transfer<'_, Q> {
        Transfer { numbers: &self.numbers, exponents: &self.exponents, bounded: true }
    }
}

impl<Q: FixedPoint> Basis<'_, Q> {
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
        material: &Material<'_, Q>,
    ) -> Result<TransferBuffer<Q, T, P>, Error> {
        let mut workspace = zeros::<Q::Wide, N>(Argument::Workspace, self.workspace_len())?;
        let mut transfer = TransferBuffer {
            numbers: zeros::<Q, T>(Argument::Transfer, self.transfer_len())?,
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
    /// [`Error::Beyond`] if the order of the material exceeds that of the basis,
    /// [`Error::TransfersOnly`] if the basis only holds transfers, [`Error::Length`] unless
    /// `workspace` has [`workspace_len`](Self::workspace_len) numbers, `numbers` has
    /// [`transfer_len`](Self::transfer_len) and `exponents` has [`profiles`](Self::profiles).
    pub fn transfer_into(
        &self,
        material: &Material<'_, Q>,
        workspace: &mut [Q::Wide],
        numbers: &mut [Q],
        exponents: &mut [i16],
    ) -> Result<(), Error> {
        let (basis, found) = (self.order(), material.order);
        if found > basis {
            return Err(Error::Beyond { argument: Argument::Material, basis, found });
        }
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
                (*sum, *of_sum) =
                    (product(factors, sums), of_sums + Q::Wide::of(of_factors.into()));
            }
            let row = row.iter().take(degrees - azimuth);
            let found = row.map(|&[sum, exponent]| (sum, exponent.saturated()));
            *exponent = settle(found, of_profile);
        }
        Ok(())
    }
}

/// Σ a b. The row of factors sums to less than 2^(BITS + 1), so the result fits.
#[inline(always)]
fn product<Q: FixedPoint>(factors: &[Q], sums: &[Q::Wide]) -> Q::Wide {
    let mut sum = Q::Wide::default();
    for (factor, &scattered) in factors.iter().zip(sums) {
        sum += factor.widen() * scattered;
    }
    sum
}

/// The mantissas and exponents of a material, of exactly these lengths.
#[inline(always)]
#[must_use]
pub fn inputs<'a, Q, const B: usize, const O: usize>(
    material: &Material<'a, Q>,
) -> Option<(&'a [Q; B], &'a [i8; O])> {
    Some((material.mantissas.try_into().ok()?, material.exponents.try_into().ok()?))
}

/// The numbers and exponents of a transfer, to be filled.
#[inline(always)]
pub fn numbers<Q: FixedPoint, const T: usize, const E: usize>(
    transfer: &mut TransferBuffer<Q, T, E>,
) -> Option<(&mut [Q; T], &mut [i16; E])> {
    let TransferBuffer { numbers, exponents } = transfer;
    Some((numbers.filled()?, exponents.filled()?))
}

/// Computes the rows of the profiles of azimuth `M`, with `L` degrees each.
#[inline(never)]
pub fn azimuth<
    B: Shape<Basis<'static, Q>>,
    Q: FixedPoint,
    const M: usize,
    const L: usize,
    const P: usize,
    const D: usize,
    const T: usize,
    const E: usize,
>(
    sums: &[[Q::Wide; P]; D],
    of_sums: &[i32; D],
    (numbers, exponents): (&mut [Q; T], &mut [i16; E]),
) {
    let place = const { &B::BASIS.azimuth_at(M) };
    let parts = const { &B::BASIS.parts };
    let rows = part(parts.factors.as_chunks::<P>().0, place.rows..);
    let of_rows = part(parts.factor_exponents, place.rows..);
    let rows = rows.as_chunks::<L>().0.iter().zip(of_rows.as_chunks::<L>().0);
    let numbers = part_mut(numbers, place.rows..).as_chunks_mut::<L>().0;
    let exponents = part_mut(exponents, place.first..);
    let sums = part(sums, M..);
    let of_sums = part(of_sums, M..);
    for (((rows, of_rows), numbers), exponent) in
        rows.zip(numbers).zip(exponents).take(place.profiles)
    {
        let mut row = [Q::Wide::default(); L];
        for ((place, factors), sums) in row.iter_mut().zip(rows).zip(sums) {
            *place = product_of_pairs(factors, sums);
        }
        *exponent = settle_degrees(&row, of_rows, of_sums, numbers);
    }
}

/// [`product`] over all pairs.
#[inline(never)]
fn product_of_pairs<Q: FixedPoint, const P: usize>(
    factors: &[Q; P],
    sums: &[Q::Wide; P],
) -> Q::Wide {
    product(factors, sums)
}

/// [`settle_large`] over `L` degrees.
#[inline(never)]
fn settle_degrees<Q: FixedPoint, const L: usize>(
    row: &[Q::Wide; L],
    of_factors: &[i8; L],
    of_sums: &[i32],
    numbers: &mut [Q; L],
) -> i16 {
    let mut exponents = [0; L];
    for ((exponent, &of_factors), of_sums) in exponents.iter_mut().zip(of_factors).zip(of_sums) {
        *exponent = i32::from(of_factors) + of_sums;
    }
    settle_large(row.iter().copied().zip(exponents.iter().copied()), numbers)
}
