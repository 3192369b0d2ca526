//! The material meets the polar integrals: S_l,pq = Σ_o B_op^q Ĉ_lo^q, where
//! Ĉ = √(o+1) N C and B is b on the diagonal, b/√2 beside it.
//!
//! This is the half of (12) that knows nothing of the normal. The other half,
//! with the eigenimages, stands in the basis's factors, so that
//! T_i,l = Σ_pq factor_i,l,pq S_l,pq is the row of UᵀM with the material folded in.

use crate::basis::{Basis, Coupling};
use crate::error::{Error, What};
use crate::index::layout::LANES;
use crate::index::{layout, material};
use crate::lanes;
use crate::material::Material;
use crate::scalar::Scalar;

impl<S: Scalar> Basis<'_, S> {
    /// Checks a material against this basis.
    pub(crate) fn accept_material(&self, material: &Material<'_, S>) -> Result<(), Error> {
        let (basis, found) = (self.order(), material.order());
        if found > basis {
            return Err(Error::Beyond { what: What::Material, basis, found });
        }
        Ok(())
    }

    /// Writes S: for each l a row over the pairs (p, q), zero-padded. `sums` is
    /// room for it along l.
    ///
    /// Of a basis with a selection of modes only those of `azimuth` are summed.
    pub(crate) fn scatter(
        &self,
        material: &Material<'_, S>,
        azimuth: usize,
        sums: &mut [S],
        scattering: &mut [S],
    ) {
        sums.fill(S::ZERO);
        // Rows of the usual degrees have kernels that know their length.
        match layout::groups(self.degree()) {
            _ if !self.parts.selection.is_empty() => self.scatter_selected(material, azimuth, sums),
            1 => self.scatter_rows::<1>(material, sums),
            2 => self.scatter_rows::<2>(material, sums),
            3 => self.scatter_rows::<3>(material, sums),
            4 => self.scatter_rows::<4>(material, sums),
            _ => self.scatter_long(material, sums),
        }
        self.transpose(sums, scattering);
    }

    /// S along l, in rows of `G` groups.
    fn scatter_rows<const G: usize>(&self, material: &Material<'_, S>, sums: &mut [S]) {
        let (polar, _) = self.parts.polar.as_chunks::<LANES>().0.as_chunks::<G>();
        let (sums, _) = sums.as_chunks_mut::<LANES>().0.as_chunks_mut::<G>();
        self.couple(material, |b, Coupling { from, to, .. }| {
            let (polar, sums) = (polar.get(usize::from(from)), sums.get_mut(usize::from(to)));
            if let (Some(polar), Some(sums)) = (polar, sums) {
                for (sum, polar) in sums.iter_mut().zip(polar) {
                    *sum = lanes::multiply_add(*sum, &[b; LANES], polar);
                }
            }
        });
    }

    /// S along l, in rows of any length.
    fn scatter_long(&self, material: &Material<'_, S>, sums: &mut [S]) {
        let groups = layout::groups(self.degree());
        let (polar, _) = self.parts.polar.as_chunks::<LANES>();
        let (sums, _) = sums.as_chunks_mut::<LANES>();
        self.couple(material, |b, Coupling { from, to, .. }| {
            let polar = polar.get(usize::from(from) * groups..).unwrap_or_default();
            let sums = sums.get_mut(usize::from(to) * groups..).unwrap_or_default();
            for (sum, polar) in sums.iter_mut().zip(polar).take(groups) {
                *sum = lanes::multiply_add(*sum, &[b; LANES], polar);
            }
        });
    }

    /// S along l, of the modes of one azimuth that a selection kept.
    fn scatter_selected(&self, material: &Material<'_, S>, azimuth: usize, sums: &mut [S]) {
        let length = LANES * layout::groups(self.degree());
        self.couple(material, |b, Coupling { from, to, mode }| {
            let polar = self.parts.polar.get(usize::from(from) * length..).unwrap_or_default();
            let sums = sums.get_mut(usize::from(to) * length..).unwrap_or_default();
            let row = azimuth * material::count(self.order()) + usize::from(mode);
            let kept = self.parts.selection.get(row * (self.degree() + 1)..).unwrap_or_default();
            let kept = kept.iter().take(self.degree() + 1);
            for ((sum, &polar), &kept) in sums.iter_mut().zip(polar).zip(kept) {
                *sum += if kept { b * polar } else { S::ZERO };
            }
        });
    }

    /// Calls `add` with b, or b/√2 beside the diagonal, for every term of S.
    #[inline(always)]
    fn couple(&self, material: &Material<'_, S>, mut add: impl FnMut(S, Coupling)) {
        let half = S::from_f64(core::f64::consts::FRAC_1_SQRT_2);
        for &coupling in self.parts.couplings {
            // Couplings stand by o: a lower order ends them.
            let found = material.coefficients().get(usize::from(coupling.mode));
            let Some(&b) = found else { return };
            add(if coupling.from == coupling.to { b } else { half * b }, coupling);
        }
    }

    /// From rows over l, a pair each, to rows over the pairs, an l each.
    fn transpose(&self, sums: &[S], scattering: &mut [S]) {
        let width = layout::row(self.order()) / LANES;
        let groups = layout::groups(self.degree());
        let (sums, _) = sums.as_chunks::<LANES>();
        let (scattering, _) = scattering.as_chunks_mut::<LANES>();
        // Four pairs by four degrees at a time.
        for (column, pairs) in sums.chunks_exact(LANES * groups).enumerate() {
            let (first, rest) = pairs.split_at_checked(groups).unwrap_or_default();
            let (second, rest) = rest.split_at_checked(groups).unwrap_or_default();
            let (third, fourth) = rest.split_at_checked(groups).unwrap_or_default();
            let rows = first.iter().zip(second).zip(third.iter().zip(fourth));
            let places = scattering.get_mut(column..).unwrap_or_default();
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
