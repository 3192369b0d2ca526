//! The transfer of a material: T_i,l = Σ_pq factor_i,l,pq S_l,pq, so that d_i = Σ_l T_i,l L_l^m.
//!
//! +m and -m share the sum; their numbers differ by (-1)^m.

use crate::basis::Basis;
use crate::buffer::{Buffer, zeros};
use crate::checked_slice::rows;
use crate::error::{Argument, Error};
use crate::float;
use crate::groups;
use crate::index::{layout, record::ProfilePlace};
use crate::material::Material;
use crate::projection::Workspace;

const LANES: usize = layout::LANES;

/// Padding before the length of a transfer, which makes its numbers start on a cache line. Only on
/// machines that have the memory for it and the registers to benefit.
const BEFORE: usize = if cfg!(target_pointer_width = "64") { 64 - size_of::<usize>() } else { 0 };

/// The transfer of one material: see [`Basis::transfer`].
///
/// A vector stores its length before its numbers. On 64-bit machines it is placed so that no group
/// of numbers straddles two cache lines, which makes relighting a tenth faster.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(C)]
#[cfg_attr(target_pointer_width = "64", repr(align(64)))]
pub struct Transfer<const N: usize> {
    before: [u8; BEFORE],
    numbers: Buffer<f32, N>,
}

impl<const N: usize> Transfer<N> {
    /// The numbers, in the layout of [`eigenshade_table::layout`].
    #[must_use]
    pub fn as_slice(&self) -> &[f32] {
        &self.numbers
    }
}

impl<const N: usize> Transfer<N> {
    /// The transfer of a sum of materials, each times a factor, from their transfers for one basis.
    ///
    /// ```
    /// # #[cfg(feature = "baked")] {
    /// use eigenshade::{Material, Transfer, sphere};
    ///
    /// let matte = sphere::transfer(&Material::new(&[2.0])?)?;
    /// let gloss = sphere::transfer(&Material::new(&[0.5, -0.4])?)?;
    /// let sum = Transfer::sum([&matte, &gloss], [0.5, 1.0])?;
    /// let whole = sphere::transfer(&Material::new(&[1.5, -0.4])?)?;
    /// assert!(sum.as_slice().iter().zip(whole.as_slice()).all(|(a, b)| (a - b).abs() < 1e-6));
    /// # }
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// Cost: one multiplication for each number of each transfer.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] if the transfers have different lengths.
    pub fn sum<const P: usize>(parts: [&Self; P], factors: [f32; P]) -> Result<Self, Error> {
        let expected = parts.first().map_or(0, |part| part.numbers.len());
        let mut numbers = zeros::<f32, N>(Argument::Transfer, expected)?;
        for (part, factor) in parts.into_iter().zip(factors) {
            Error::check(Argument::Transfer, expected, part.numbers.len())?;
            for (sum, &number) in numbers.iter_mut().zip(part.as_slice()) {
                *sum = float::add_product(*sum, factor, number);
            }
        }
        Ok(Self { before: [0; BEFORE], numbers })
    }
}

impl Basis<'_> {
    /// Computes the transfer of a material.
    ///
    /// `N` must be at least [`workspace_len`](Self::workspace_len), `T` at least
    /// [`transfer_len`](Self::transfer_len).
    ///
    /// ```
    /// # #[cfg(feature = "baked")] {
    /// use eigenshade::{Light, Material, sphere};
    ///
    /// let matte = sphere::transfer(&Material::new(&[2.0])?)?; // once for a material
    /// for light in [[3.5, 0.0, 1.0, 0.0], [3.5, -1.0, 0.0, 0.0]] {
    ///     let scene = sphere::collapse(&sphere::relight(&matte, &Light::new(&light)?)?);
    ///     assert!(scene.shade(eigenshade::Normal::new(0.0, 0.6, 0.8)?) > 0.0);
    /// }
    /// # }
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// Cost: for each profile and each degree from its |m| on, one multiplication for each pair (p,
    /// q); before that, for each q and degree, the square of the number of pairs of that q.
    ///
    /// # Errors
    ///
    /// [`Error::Beyond`] if the material goes beyond the basis's order, [`Error::Capacity`] if `N`
    /// or `T` is too small.
    pub fn transfer<const N: usize, const T: usize>(
        &self,
        material: &Material<'_>,
    ) -> Result<Transfer<T>, Error> {
        let mut workspace = zeros::<f32, N>(Argument::Workspace, self.workspace_len())?;
        let numbers = zeros::<f32, T>(Argument::Transfer, self.transfer_len())?;
        let mut transfer = Transfer { before: [0; BEFORE], numbers };
        self.transfer_into(material, &mut workspace, &mut transfer.numbers)?;
        Ok(transfer)
    }

    /// [`transfer`](Self::transfer) with slices.
    ///
    /// # Errors
    ///
    /// [`Error::Beyond`] if the material goes beyond the basis's order, [`Error::Length`] unless
    /// `workspace` has [`workspace_len`](Self::workspace_len) numbers and `transfer` has
    /// [`transfer_len`](Self::transfer_len).
    pub fn transfer_into(
        &self,
        material: &Material<'_>,
        workspace: &mut [f32],
        transfer: &mut [f32],
    ) -> Result<(), Error> {
        self.accept_material(material)?;
        Error::check(Argument::Workspace, self.workspace_len(), workspace.len())?;
        Error::check(Argument::Transfer, self.transfer_len(), transfer.len())?;
        // Lanes with |m| > l stay zero.
        transfer.fill(0.0);
        let width = self.row() / LANES;
        let Workspace { scattering, sums, .. } = self.divide(workspace);
        self.scatter(material, sums, scattering);
        for (places, factors) in self.rows() {
            let azimuth = places.first().map_or(0, |place| place.azimuth());
            let (of_scattering, _) = self.scattered_from(azimuth, scattering).as_chunks::<LANES>();
            let both = rows(factors.as_chunks().0, width).zip(rows(of_scattering, width));
            for (row, (factors, scattering)) in both.enumerate() {
                let sums = groups::sums(product(factors, scattering));
                for (place, sum) in places.iter().zip(sums) {
                    write(place, row, sum, transfer);
                }
            }
        }
        Ok(())
    }
}

/// Not inlined: if the compiler sees the sum across the lanes, it splits the vectors.
#[inline(never)]
fn product(factors: &[groups::Two], scattering: &[[f32; LANES]]) -> groups::Two {
    groups::product(factors, scattering)
}

/// Writes T_l for l = |m| + `row` into the rows of +m and -m.
#[inline]
fn write(place: &ProfilePlace, row: usize, sum: f32, transfer: &mut [f32]) {
    let of_minus = if place.azimuth % 2 == 1 { -sum } else { sum };
    // For m = 0 both write to the same place, and the sign is +.
    for (of, value) in [(place.minus_row, of_minus), (place.plus_row, sum)] {
        if let Some(to) = transfer.get_mut(of.start as usize + row * of.step as usize) {
            *to = value;
        }
    }
}
