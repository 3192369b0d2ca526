//! The transfer of a material in fixed point: T_i,l = Σ_pq factor_i,l,pq S_l,pq with S_l,pq = Σ_o
//! B_op^q Ĉ_lo^q, so that d_i = Σ_l T_i,l L_l^m.

use super::arithmetic::{BITS, Shift as _, over_root_two, settle, settle_row};
use super::{Basis, Material, Q15};
use crate::buffer::{Buffer, zeros};
use crate::checked_slice::{part, part_mut, rows, rows_mut, split_mut, split_row};
use crate::error::{Argument, Error};
use crate::index::{material, pair};
use crate::known_table::{KnownTable, at};

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
fn room(order: usize) -> i32 {
    (((order / 2 + 1) as i32).bits().cast_signed() - 1).max(1)
}

/// Σ a b. The row of factors sums to less than 2^16, so the result fits.
#[inline(always)]
fn product(factors: &[Q15], sums: &[i32]) -> i32 {
    let mut sum = 0;
    for (factor, &scattered) in factors.iter().zip(sums) {
        sum += factor.get() * scattered;
    }
    sum
}

/// The exponent of zeros, below the exponent of any number.
const ZERO_EXPONENT: i32 = -1 << 12;

/// The exponents of a material, order by order.
#[derive(Clone, Copy, Debug)]
pub struct Orders<const O: usize> {
    own: [i8; O],
    /// The largest exponent of each o and of the higher ones of the same parity: Ĉ of (o, q) is
    /// multiplied by their coefficients.
    above: [i8; O],
}

impl<const O: usize> Orders<O> {
    /// The exponents of a material of up to `O` orders. Orders that it does not have are zero.
    #[inline(never)]
    pub fn of(material: &Material<'_>) -> Self {
        let mut own = [i8::MIN; O];
        for (to, &exponent) in own.iter_mut().zip(material.exponents) {
            *to = exponent;
        }
        let (mut above, mut largest, mut of_others) = (own, i8::MIN, i8::MIN);
        for exponent in above.iter_mut().rev() {
            *exponent = largest.max(*exponent);
            (largest, of_others) = (of_others, *exponent);
        }
        Self { own, above }
    }
}

/// Whether a table of this order takes a material.
///
/// # Errors
///
/// [`Error::Beyond`].
#[inline(always)]
pub fn accept_material(order: usize, material: &Material<'_>) -> Result<(), Error> {
    Error::check_beyond(Argument::Material, order, material.order)
}

/// The numbers and exponents of a transfer, to be written.
///
/// # Errors
///
/// None: a buffer holds as many as its capacity.
#[inline(always)]
pub fn transfer_numbers<const T: usize, const E: usize>(
    transfer: &mut TransferBuffer<T, E>,
) -> Result<(&mut [Q15; T], &mut [i16; E]), Error> {
    let TransferBuffer { numbers, exponents } = transfer;
    match (numbers.filled(), exponents.filled()) {
        (Some(numbers), Some(exponents)) => Ok((numbers, exponents)),
        _ => Err(Error::Capacity { argument: Argument::Transfer, needed: T, capacity: T }),
    }
}

/// The coefficients as they are multiplied: divided by √2 unless o and p are equal.
#[inline(never)]
pub fn weighted_coefficients<const B: usize>(mantissas: &[Q15; B]) -> [i32; B] {
    let mut coefficients = [0; B];
    let same = const { &same::<B>() };
    for ((&mantissa, &same), to) in mantissas.iter().zip(same).zip(&mut coefficients) {
        *to = if same { mantissa } else { over_root_two(mantissa) }.get();
    }
    coefficients
}

/// For each coefficient, whether o and p are equal.
const fn same<const B: usize>() -> [bool; B] {
    let (mut same, mut mode) = ([false; B], (0, 0, 0));
    let mut rest = same.as_mut_slice();
    while let [to, others @ ..] = rest {
        *to = mode.0 == mode.1;
        (rest, mode) = (others, material::following(mode));
    }
    same
}

/// The polar integrals of `P` pairs for one degree. For each o, `shifts` holds the shift of its
/// products, minus one, before their own exponents are subtracted.
#[derive(Clone, Copy, Debug)]
pub struct Degree<const P: usize, const O: usize> {
    polar: &'static [Q15; P],
    exponents: &'static [i8; P],
    shifts: [i32; O],
    common: i32,
}

impl<const P: usize, const O: usize> Degree<P, O> {
    /// Prepares the degree `l`.
    #[inline(never)]
    pub fn new<T: KnownTable<Basis<'static>>>(l: usize, orders: &Orders<O>) -> Option<Self> {
        let polar = T::BASIS.parts.polar.as_chunks::<P>().0.get(l)?;
        let exponents = T::BASIS.parts.polar_exponents.as_chunks::<P>().0.get(l)?;
        let room = room(O - 1);
        let mut rest = exponents.as_slice();
        let mut top = i32::MIN;
        for (o, &above) in orders.above.iter().enumerate() {
            let (of_o, after) = rest.split_at_checked(o / 2 + 1)?;
            rest = after;
            let largest = of_o.iter().copied().max().unwrap_or(i8::MIN);
            top = top.max(i32::from(above) + i32::from(largest));
        }
        let common = top + room;
        let shifts = orders.own.map(|of_order| common - i32::from(of_order) - 1);
        Some(Self { polar, exponents, shifts, common })
    }

    /// sum + b Ĉ of the order `L` for the pair (`R`, `S`).
    #[inline(always)]
    pub fn add<const R: usize, const S: usize, const L: usize, const B: usize>(
        &self,
        sum: i32,
        b: &[i32; B],
    ) -> i32 {
        let Self { polar, exponents, shifts, .. } = self;
        let (o, p) = if L > R { (L, R) } else { (R, L) };
        let (from, mode) = (pair::position(L, S), material::position(o, p, S));
        if let (Some(&b), Some(polar), Some(&exponent), Some(&shift)) =
            (b.get(mode), polar.get(from), exponents.get(from), shifts.get(o))
        {
            // The shift is not negative, because an addend has at least one bit of room.
            return sum + (b * polar.get()).round_shr(shift - i32::from(exponent));
        }
        sum
    }

    /// Scales the sums so that they use all bits, and returns their exponent.
    #[inline(never)]
    pub fn normalize(&self, sums: &mut [i32; P]) -> i32 {
        let mut either = 0;
        for &sum in sums.iter() {
            either |= sum.max(-sum);
        }
        let largest = either.bits();
        let by = BITS.cast_signed() - largest.cast_signed();
        if largest == 0 {
            return ZERO_EXPONENT;
        }
        if by < 0 {
            sums.iter_mut().for_each(|sum| *sum = sum.round_shr(-by - 1));
        } else {
            sums.iter_mut().for_each(|sum| *sum = sum.floor_shr(by));
        }
        self.common - by
    }
}

/// Computes the rows of the profiles of azimuth `M`, with `L` degrees each.
#[inline(never)]
pub fn transfer_azimuth<
    B: KnownTable<Basis<'static>>,
    const M: usize,
    const L: usize,
    const P: usize,
    const D: usize,
    const T: usize,
    const E: usize,
>(
    sums: &[[i32; P]; D],
    of_sums: &[i32; D],
    (numbers, exponents): (&mut [Q15; T], &mut [i16; E]),
) {
    let place = const { *at(B::BASIS.parts.azimuths, M) };
    let (first, before) = (usize::from(place.first), place.rows as usize);
    let parts = const { &B::BASIS.parts };
    let rows = part(parts.factors.as_chunks::<P>().0, before..);
    let of_rows = part(parts.factor_exponents, before..);
    let rows = rows.as_chunks::<L>().0.iter().zip(of_rows.as_chunks::<L>().0);
    let numbers = part_mut(numbers, before..).as_chunks_mut::<L>().0;
    let exponents = part_mut(exponents, first..);
    let sums = part(sums, M..);
    let of_sums = part(of_sums, M..);
    for (((rows, of_rows), numbers), exponent) in
        rows.zip(numbers).zip(exponents).take(place.profiles.into())
    {
        let mut row = [0; L];
        for ((place, factors), sums) in row.iter_mut().zip(rows).zip(sums) {
            *place = whole_product(factors, sums);
        }
        *exponent = settle_row(&row, of_rows, of_sums, numbers);
    }
}

/// [`product`] over all pairs.
#[inline(never)]
fn whole_product<const P: usize>(factors: &[Q15; P], sums: &[i32; P]) -> i32 {
    product(factors, sums)
}
