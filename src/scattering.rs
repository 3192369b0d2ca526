//! Combines the material with the polar integrals: S_l,pq = Σ_o B_op^q Ĉ_lo^q, where Ĉ = √(o+1) N
//! C, and B is b on the diagonal and b/√2 off it.
//!
//! S is the half of (12) that does not depend on the normal. The factors of the basis hold the
//! other half, together with the eigenimages, so that T_i,l = Σ_pq factor_i,l,pq S_l,pq is the row
//! of UᵀM for this material.

use crate::basis::Basis;
use crate::checked_slice::{part_mut, rows, split};
use crate::error::{Argument, Error};
use crate::groups;
use crate::index::{layout, layout::LANES, material, pair};
use crate::material::Material;

impl Basis<'_> {
    pub(crate) fn accept_material(&self, material: &Material<'_>) -> Result<(), Error> {
        Error::check_beyond(Argument::Material, self.order(), material.order())?;
        if self.projects() { Ok(()) } else { Err(Error::TransfersOnly) }
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
