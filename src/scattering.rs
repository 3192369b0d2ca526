//! The material meets the polar integrals: S_l,pq = Σ_o B_op^q Ĉ_lo^q, where
//! Ĉ = √(o+1) N C and B is b on the diagonal, b/√2 beside it.
//!
//! This is the half of (12) that knows nothing of the normal. The other half,
//! with the eigenimages, stands in the basis's factors, so that
//! T_i,l = Σ_pq factor_i,l,pq S_l,pq is the row of UᵀM with the material folded in.

use crate::basis::Basis;
use crate::error::{Error, What};
use crate::index::{layout, material, pair};
use crate::material::Material;
use crate::scalar::Scalar;

impl<S: Scalar> Basis<'_, S> {
    /// Checks a material against this basis.
    pub(crate) fn accept_material(&self, material: &Material<'_, S>) -> Result<(), Error> {
        let (basis, found) = (self.order(), material.order());
        if found > basis {
            return Err(Error::Beyond {
                what: What::Material,
                basis,
                found,
            });
        }
        Ok(())
    }

    /// Writes S: for each pair (p, q), `layout::stride` numbers over l.
    ///
    /// Of a basis with a selection of modes only those of `azimuth` are summed.
    pub(crate) fn scatter(&self, material: &Material<'_, S>, azimuth: usize, scattering: &mut [S]) {
        let stride = layout::stride(self.degree());
        scattering.fill(S::ZERO);
        let modes = material::count(self.order());
        let selected = self.parts.selection.chunks_exact(self.degree() + 1);
        let mut selected = selected.skip(azimuth * modes);
        let half = S::from_f64(core::f64::consts::FRAC_1_SQRT_2);
        for ((o, p, q), &b) in material::indices(material.order()).zip(material.coefficients()) {
            let mask = selected.next().unwrap_or(&[]);
            let (of_o, of_p) = (pair::position(o, q) * stride, pair::position(p, q) * stride);
            if o == p {
                self.add(b, of_o, of_o, mask, scattering);
            } else {
                self.add(b * half, of_o, of_p, mask, scattering);
                self.add(b * half, of_p, of_o, mask, scattering);
            }
        }
    }

    /// S\[to..\] += b Ĉ\[from..\], over all l, or over those of the mask.
    #[inline]
    fn add(&self, b: S, from: usize, to: usize, mask: &[bool], scattering: &mut [S]) {
        let width = layout::LANES * layout::groups(self.degree(), 0);
        let (Some(polar), Some(sums)) = (
            self.parts.polar.get(from..from + width),
            scattering.get_mut(to..to + width),
        ) else {
            return;
        };
        if mask.is_empty() {
            let (sums, _) = sums.as_chunks_mut::<{ layout::LANES }>();
            let (polar, _) = polar.as_chunks::<{ layout::LANES }>();
            for (sums, polar) in sums.iter_mut().zip(polar) {
                for (sum, &polar) in sums.iter_mut().zip(polar) {
                    *sum += b * polar;
                }
            }
        } else {
            for ((sum, &polar), &kept) in sums.iter_mut().zip(polar).zip(mask) {
                *sum += if kept { b * polar } else { S::ZERO };
            }
        }
    }
}
