//! Combines the material with the polar integrals: S_l,pq = Σ_o B_op^q Ĉ_lo^q, where Ĉ = √(o+1) N
//! C, and B is b on the diagonal and b/√2 off it.
//!
//! This is the half of (12) that does not depend on the normal. The factors of the basis hold the
//! other half, together with the eigenimages, so that T_i,l = Σ_pq factor_i,l,pq S_l,pq is the row
//! of UᵀM for this material.

use crate::basis::Basis;
use crate::error::{Argument, Error};
use crate::float;
use crate::index::effect::{Effect, Effects};
use crate::index::{layout, layout::LANES, material};
use crate::invariant::{part_mut, split};
use crate::lanes;
use crate::material::Material;

impl Basis<'_> {
    pub(crate) fn accept_material(&self, material: &Material<'_>) -> Result<(), Error> {
        Error::check_beyond(Argument::Material, self.order(), material.order())?;
        if self.projects() { Ok(()) } else { Err(Error::TransfersOnly) }
    }

    /// Writes S: for each l a zero-padded row over the pairs (p, q). `sums` holds S along l
    /// meanwhile. Only modes of `effects` are summed; if the basis has a selection of modes, only
    /// those of `azimuth`. Inlined so that the compiler can see when all effects are meant.
    #[inline(always)]
    pub(crate) fn scatter(
        &self,
        material: &Material<'_>,
        effects: Effects,
        azimuth: usize,
        sums: &mut [f32],
        scattering: &mut [f32],
    ) {
        sums.fill(0.0);
        // Rows of the usual degrees have kernels with their length built in.
        match layout::groups(self.degree()) {
            _ if !self.parts.selection.is_empty() || !effects.is_all() => {
                self.scatter_some(material, effects, azimuth, sums);
            }
            1 => self.scatter_rows::<1>(material, sums),
            2 => self.scatter_rows::<2>(material, sums),
            3 => self.scatter_rows::<3>(material, sums),
            4 => self.scatter_rows::<4>(material, sums),
            groups => self.scatter_long(groups, material, sums),
        }
        self.transpose(sums, scattering);
    }

    /// Computes S along l, in rows of `G` groups.
    fn scatter_rows<const G: usize>(&self, material: &Material<'_>, sums: &mut [f32]) {
        let (polar, _) = self.parts.polar.as_chunks::<LANES>().0.as_chunks::<G>();
        let (sums, _) = sums.as_chunks_mut::<LANES>().0.as_chunks_mut::<G>();
        self.couple(material, core::iter::repeat(()), |b, from, to, _, ()| {
            if let (Some(polar), Some(sums)) = (polar.get(from), sums.get_mut(to)) {
                for (sum, polar) in sums.iter_mut().zip(polar) {
                    *sum = lanes::multiply_add(*sum, &[b; LANES], polar);
                }
            }
        });
    }

    /// Computes S along l, in rows of any number of groups.
    fn scatter_long(&self, groups: usize, material: &Material<'_>, sums: &mut [f32]) {
        let (polar, _) = self.parts.polar.as_chunks::<LANES>();
        let (sums, _) = sums.as_chunks_mut::<LANES>();
        self.couple(material, core::iter::repeat(()), |b, from, to, _, ()| {
            if let (Some(polar), Some(sums)) =
                (polar.get(from * groups..), sums.get_mut(to * groups..))
            {
                for (sum, polar) in sums.iter_mut().zip(polar).take(groups) {
                    *sum = lanes::multiply_add(*sum, &[b; LANES], polar);
                }
            }
        });
    }

    /// Computes S along l, in rows of any length, for some effects. If the basis has a selection of
    /// modes, only for the modes of one azimuth.
    fn scatter_some(
        &self,
        material: &Material<'_>,
        effects: Effects,
        azimuth: usize,
        sums: &mut [f32],
    ) {
        let degrees = self.degree() + 1;
        let length = LANES * layout::groups(self.degree());
        let selection = self.parts.selection;
        let of_azimuth = selection.get(azimuth * material::count(self.order()) * degrees..);
        let orders = material::indices(material.order()).map(|(o, _, _)| o);
        self.couple(material, orders, |b, from, to, mode, o| {
            let polar = self.parts.polar.get(from * length..).unwrap_or_default();
            let sums = sums.get_mut(to * length..).unwrap_or_default();
            let kept = of_azimuth.and_then(|selection| selection.get(mode * degrees..));
            // Without a selection, every mode is kept.
            let kept = kept.unwrap_or_default().iter().chain(core::iter::repeat(&true));
            let rows = sums.iter_mut().zip(polar).zip(kept).take(degrees);
            for (l, ((sum, &polar), &kept)) in rows.enumerate() {
                let kept = kept && effects.keeps(l, o);
                *sum = if kept { float::add_product(*sum, b, polar) } else { *sum };
            }
        });
    }

    /// Calls `add(b, from, to, mode, more)` for every term b Ĉ\[from\] of S\[to\]. `more` is the
    /// additional item of the coefficient; b is divided by √2 off the diagonal. A coefficient that
    /// is not factored has positions beyond all rows: nothing is added.
    #[inline(always)]
    fn couple<M: Copy>(
        &self,
        material: &Material<'_>,
        more: impl Iterator<Item = M>,
        mut add: impl FnMut(f32, usize, usize, usize, M),
    ) {
        let half = core::f32::consts::FRAC_1_SQRT_2;
        let couplings = material.coefficients().iter().zip(self.parts.couplings);
        for (mode, ((&b, coupling), more)) in couplings.zip(more).enumerate() {
            let (o, p) = (usize::from(coupling.o), usize::from(coupling.p));
            if o == p {
                add(b, o, p, mode, more);
            } else {
                add(half * b, o, p, mode, more);
                add(half * b, p, o, mode, more);
            }
        }
    }

    /// For each profile of m = 0, the contribution to T_i,0 of the coefficients that are not
    /// factored. Empty if there are none, or without the ambient effect.
    pub(crate) fn unfactored(
        &self,
        material: &Material<'_>,
        effects: Effects,
    ) -> impl Iterator<Item = f32> {
        let wanted = effects.has(Effect::Ambient);
        let numbers = if wanted { self.parts.ambient } else { &[] };
        let (order, of_basis) = (material.order(), self.effects());
        let rows = numbers.chunks_exact(self.unfactored_count().max(1));
        rows.map(move |row| {
            let all = material::indices(order).zip(material.coefficients());
            let unfactored = all.filter(move |&((o, _, q), _)| of_basis.is_unfactored(o, q));
            row.iter().zip(unfactored).fold(0.0, |sum, (&a, (_, &b))| float::add_product(sum, a, b))
        })
    }

    /// Transposes S from rows over l, one for each pair, to rows over the pairs, one for each l.
    fn transpose(&self, sums: &[f32], scattering: &mut [f32]) {
        let width = self.row() / LANES;
        let groups = layout::groups(self.degree()).max(1);
        let (sums, _) = sums.as_chunks::<LANES>();
        let (scattering, _) = scattering.as_chunks_mut::<LANES>();
        // Blocks of four pairs by four degrees.
        for (column, pairs) in sums.chunks_exact((LANES * groups).max(1)).enumerate() {
            let (first, rest) = split(pairs, groups);
            let (second, rest) = split(rest, groups);
            let (third, fourth) = split(rest, groups);
            let rows = first.iter().zip(second).zip(third.iter().zip(fourth));
            let places = part_mut(scattering, column..);
            let mut places = places.iter_mut().step_by(width.max(1));
            for ((first, second), (third, fourth)) in rows {
                let degrees = first.iter().zip(second).zip(third.iter().zip(fourth));
                for (((&first, &second), (&third, &fourth)), place) in degrees.zip(&mut places) {
                    *place = [first, second, third, fourth];
                }
            }
        }
    }
}
