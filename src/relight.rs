//! A new light on a transferred material: d_i = Σ_l T_i,l L_l^m.
//!
//! The lanes run along m, as do the light's coefficients of one degree, so nothing is gathered and
//! nothing is summed across lanes. Lanes with |m| > l read coefficients of other degrees and
//! multiply them by zero.

use crate::basis::Basis;
use crate::buffer::zeros;
use crate::error::{Argument, Error};
use crate::index::{layout, light};
use crate::lanes;
use crate::light::Light;
use crate::parts::Pass;
use crate::projection::Coefficients;
use crate::scalar::Scalar;
use crate::transfer::Transfer;

const LANES: usize = layout::LANES;

impl<S: Scalar> Basis<'_, S> {
    /// Computes d for a new light on a material whose transfer is known, with one multiplication
    /// for each of the [`transfer_len`](Self::transfer_len) numbers.
    ///
    /// # Errors
    ///
    /// [`Error::Beyond`] if the degree of the light exceeds that of the basis, [`Error::Length`] if
    /// the transfer belongs to another basis, [`Error::Capacity`] if `K` is less than
    /// [`components`](Self::components).
    pub fn relight<const T: usize, const K: usize>(
        &self,
        transfer: &Transfer<S, T>,
        light: &Light<'_, S>,
    ) -> Result<Coefficients<S, K>, Error> {
        let mut coefficients = zeros::<S, K>(Argument::Coefficients, self.components())?;
        self.relight_into(transfer.as_slice(), light, &mut coefficients)?;
        Ok(coefficients)
    }

    /// [`relight`](Self::relight) with slices.
    ///
    /// # Errors
    ///
    /// [`Error::Beyond`] if the degree of the light exceeds that of the basis, [`Error::Length`]
    /// unless `transfer` has [`transfer_len`](Self::transfer_len) numbers and `coefficients` has
    /// [`components`](Self::components).
    pub fn relight_into(
        &self,
        transfer: &[S],
        light: &Light<'_, S>,
        coefficients: &mut [S],
    ) -> Result<(), Error> {
        self.accept_light(light)?;
        Error::check(Argument::Transfer, self.transfer_len(), transfer.len())?;
        Error::check(Argument::Coefficients, self.components(), coefficients.len())?;
        let (mut transfer, _) = transfer.as_chunks::<LANES>();
        let (mut slots, _) = self.parts.slots.as_chunks::<LANES>();
        for pass in self.parts.passes {
            let profiles = usize::from(pass.profiles);
            let lowest = layout::lowest_degree(pass.first.into());
            let groups = profiles * (self.degree() + 1).saturating_sub(lowest);
            let (rows, after) = transfer.split_at_checked(groups).unwrap_or((transfer, &[]));
            let (of_pass, others) = slots.split_at_checked(profiles).unwrap_or((slots, &[]));
            (transfer, slots) = (after, others);
            match profiles {
                1 => run::<S, 1>(pass, rows, light, of_pass, coefficients),
                2 => run::<S, 2>(pass, rows, light, of_pass, coefficients),
                3 => run::<S, 3>(pass, rows, light, of_pass, coefficients),
                4 => run::<S, 4>(pass, rows, light, of_pass, coefficients),
                5 => run::<S, 5>(pass, rows, light, of_pass, coefficients),
                6 => run::<S, 6>(pass, rows, light, of_pass, coefficients),
                7 => run::<S, 7>(pass, rows, light, of_pass, coefficients),
                _ => run::<S, { layout::PASS }>(pass, rows, light, of_pass, coefficients),
            }
        }
        self.subtract_mean(coefficients);
        Ok(())
    }
}

/// The components of one pass of `P` profiles.
#[inline]
fn run<S: Scalar, const P: usize>(
    pass: &Pass,
    transfer: &[[S; LANES]],
    light: &Light<'_, S>,
    slots: &[[u16; LANES]],
    coefficients: &mut [S],
) {
    let first = isize::from(pass.first);
    let lowest = layout::lowest_degree(first);
    let (rows, _) = transfer.as_chunks::<P>();
    let rows = rows.get(..(light.degree() + 1).saturating_sub(lowest)).unwrap_or(rows);
    // Degrees whose group of coefficients would start before the first coefficient.
    let before = (lowest..).take_while(|&l| first < 0 && l * l + l < first.unsigned_abs()).count();
    let (early, rows) = rows.split_at_checked(before).unwrap_or((rows, &[]));
    let start = lowest + early.len();
    let (mut sums, done) = inside(rows, light.coefficients(), start, first);
    // Degrees whose group would end after the last coefficient.
    let late = rows.get(done..).unwrap_or_default();
    for (l, row) in (lowest..).zip(early).chain((start + done..).zip(late)) {
        let window = edge(light, l, first);
        for (sum, row) in sums.iter_mut().zip(row) {
            *sum = lanes::multiply_add(*sum, row, &window);
        }
    }
    for (slots, sums) in slots.iter().zip(sums) {
        for (&slot, sum) in slots.iter().zip(sums) {
            if let Some(coefficient) = coefficients.get_mut(usize::from(slot)) {
                *coefficient = sum;
            }
        }
    }
}

/// Sums over the degrees from `degree` on whose groups lie within the coefficients, and the number
/// of these degrees.
///
/// Separate from [`run`] so that the sums stay in registers: if the same function read them lane by
/// lane, the compiler would split them at every step.
#[inline(never)]
fn inside<S: Scalar, const P: usize>(
    rows: &[[[S; LANES]; P]],
    coefficients: &[S],
    degree: usize,
    first: isize,
) -> ([[S; LANES]; P], usize) {
    let mut sums = [[S::ZERO; LANES]; P];
    let (mut start, mut step) = (light::position(degree, first), 2 * degree + 2);
    let mut done = 0;
    for row in rows {
        let window = coefficients.get(start..).and_then(|rest| rest.first_chunk());
        let Some(window) = window else { break };
        for (sum, row) in sums.iter_mut().zip(row) {
            *sum = lanes::multiply_add(*sum, row, window);
        }
        start += step;
        step += 2;
        done += 1;
    }
    (sums, done)
}

/// L_l^m of the orders from `first` on, for a group that reaches beyond the first or last
/// coefficient of the light and so cannot be read whole.
#[cold]
fn edge<S: Scalar>(light: &Light<'_, S>, l: usize, first: isize) -> [S; LANES] {
    let mut window = [S::ZERO; LANES];
    for (order, value) in (first..).zip(&mut window) {
        if order.unsigned_abs() <= l {
            let found = light.coefficients().get(light::position(l, order));
            *value = found.copied().unwrap_or(S::ZERO);
        }
    }
    window
}
