//! The transfer of a material: T_i,l = Σ_pq factor_i,l,pq S_l,pq, so that d_i = Σ_l T_i,l L_l^m.
//!
//! +m and -m share the sum; their numbers differ by (-1)^m. Before that, the material is scattered
//! into the polar integrals: S_l,pq = Σ_o B_op^q Ĉ_lo^q, where Ĉ = √(o+1) N C, and B is b on the
//! diagonal and b/√2 off it. S is the half of (12) that does not depend on the normal. The factors
//! of the basis hold the other half, together with the eigenimages, so that T is UᵀM for this
//! material.

use crate::basis::Basis;
use crate::buffer::{Buffer, zeros};
use crate::checked_slice::{part, part_mut, rows, split, split_mut, split_row};
use crate::error::{Argument, Error};
use crate::float;
use crate::groups;
use crate::index::{layout, layout::LANES, material, pair, record::ProfilePlace};
use crate::material::Material;

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

impl<'a> Basis<'a> {
    pub(crate) fn accept_material(&self, material: &Material<'_>) -> Result<(), Error> {
        Error::check_beyond(Argument::Material, self.order(), material.order())?;
        if self.projects() { Ok(()) } else { Err(Error::TransfersOnly) }
    }

    /// Divides the workspace of a projection or of a transfer.
    #[inline]
    pub(crate) fn divide<'w>(&self, workspace: &'w mut [f32]) -> Workspace<'w> {
        let rows = (self.degree() + 1) * self.row();
        let (scattering, rest) = split_mut(workspace, rows);
        let sums = self.sums_len();
        let (sums, lights) = split_mut(rest, sums);
        Workspace { scattering, sums, lights: lights.as_chunks_mut().0 }
    }

    /// The rows of S from l = `azimuth` on.
    #[inline]
    pub(crate) fn scattered_from<'w>(&self, azimuth: usize, scattering: &'w [f32]) -> &'w [f32] {
        part(scattering, azimuth * self.row()..)
    }

    /// The profiles of each azimuth in twos, with their factors.
    #[inline]
    pub(crate) fn rows(&self) -> impl Iterator<Item = (&'a [ProfilePlace], &'a [f32])> + use<'a> {
        let (degree, row) = (self.degree(), self.row());
        let (mut places, mut factors) = (self.parts.profiles, self.parts.factors);
        // Written by hand because the compiler cannot prove that `chunk_by` never panics.
        core::iter::from_fn(move || {
            let azimuth = places.first()?.azimuth();
            let same = places.iter().take(2).take_while(|place| place.azimuth() == azimuth);
            let (two, others) = places.split_at_checked(same.count())?;
            let length = layout::rows(degree, azimuth, two.len()) * row;
            let (rows, rest) = split_row(factors, length);
            (places, factors) = (others, rest);
            Some((two, rows))
        })
    }

    /// Writes S: for each l a zero-padded row over the pairs (p, q). `sums` holds S along l
    /// meanwhile.
    pub(crate) fn scatter(
        &self,
        material: &Material<'_>,
        sums: &mut [f32],
        scattering: &mut [f32],
    ) {
        let groups = layout::groups(self.degree());
        match groups {
            1 => self.scatter_rows::<1>(material, sums),
            2 => self.scatter_rows::<2>(material, sums),
            3 => self.scatter_rows::<3>(material, sums),
            _ => self.scatter_rows::<{ layout::groups(layout::MAX_DEGREE) }>(material, sums),
        }
        let (sums, _) = sums.as_chunks::<LANES>();
        transpose(sums, groups, scattering.as_chunks_mut::<LANES>().0, self.row() / LANES);
    }

    /// Computes S along l, in rows of `G` groups.
    fn scatter_rows<const G: usize>(&self, material: &Material<'_>, sums: &mut [f32]) {
        let (polar, _) = self.parts.polar.as_chunks::<LANES>().0.as_chunks::<G>();
        let (sums, _) = sums.as_chunks_mut::<LANES>().0.as_chunks_mut::<G>();
        // The rows that fill the last group of pairs.
        for row in sums.iter_mut().skip(pair::count(self.order())) {
            *row = [[0.0; LANES]; G];
        }
        for q in 0..=self.order() {
            scatter_pairs(q, (self.order() - q) / 2 + 1, material.coefficients(), polar, sums);
        }
    }
}

/// The sums S_l,pq of one q, for its pairs p = q, q + 2, ...: products of a symmetric matrix B and
/// rows of Ĉ, which run along l. Coefficients beyond the material's order are zero.
#[inline(always)]
pub(crate) fn scatter_pairs<const G: usize>(
    q: usize,
    pairs: usize,
    material: &[f32],
    polar: &[[[f32; LANES]; G]],
    sums: &mut [[[f32; LANES]; G]],
) {
    let half = core::f32::consts::FRAC_1_SQRT_2;
    for p in 0..pairs {
        let mut sum = [[0.0; LANES]; G];
        for o in 0..pairs {
            let mode = material::position(q + 2 * p.max(o), q + 2 * p.min(o), q);
            let row = polar.get(pair::position(q + 2 * o, q));
            let (Some(&b), Some(row)) = (material.get(mode), row) else { continue };
            let b = if o == p { b } else { half * b };
            for (sum, row) in sum.iter_mut().zip(row) {
                *sum = groups::multiply_add(*sum, &[b; LANES], row);
            }
        }
        if let Some(to) = sums.get_mut(pair::position(q + 2 * p, q)) {
            *to = sum;
        }
    }
}

/// Transposes S from rows of `groups` groups over l, one for each pair, to rows of `width` groups
/// over the pairs, one for each l.
#[inline(always)]
pub(crate) fn transpose(
    sums: &[[f32; LANES]],
    groups: usize,
    scattering: &mut [[f32; LANES]],
    width: usize,
) {
    // Blocks of four pairs by four degrees.
    for (column, pairs) in rows(sums, LANES * groups).enumerate() {
        let (first, rest) = split(pairs, groups);
        let (second, rest) = split(rest, groups);
        let (third, fourth) = split(rest, groups);
        let rows = first.iter().zip(second).zip(third.iter().zip(fourth));
        let mut places = part_mut(scattering, column..).iter_mut().step_by(width.max(1));
        for ((first, second), (third, fourth)) in rows {
            let degrees = first.iter().zip(second).zip(third.iter().zip(fourth));
            for (((&first, &second), (&third, &fourth)), place) in degrees.zip(&mut places) {
                *place = [first, second, third, fourth];
            }
        }
    }
}

/// Whether a table of this order takes a material.
///
/// # Errors
///
/// [`Error::Beyond`].
#[inline(always)]
pub fn accept_material(order: usize, material: &Material<'_>) -> Result<(), Error> {
    Error::check_beyond(Argument::Material, order, material.order())
}

pub(crate) struct Workspace<'w> {
    /// S, with a row for each l.
    pub(crate) scattering: &'w mut [f32],
    /// Room for S along l.
    pub(crate) sums: &'w mut [f32],
    /// The light of one azimuth.
    pub(crate) lights: &'w mut [[f32; 2]],
}
