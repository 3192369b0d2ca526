//! The material meets the polar integrals: S_l,pq = Σ_o B_op^q Ĉ_lo^q, where
//! Ĉ = √(o+1) N C and B is b on the diagonal, b/√2 beside it.
//!
//! This is the half of (12) that knows nothing of the normal. The other half,
//! with the eigenimages, stands in the basis's factors, so that
//! T_i,l = Σ_pq factor_i,l,pq S_l,pq is the row of UᵀM with the material folded in.

use crate::basis::Basis;
use crate::error::{Error, What};
use crate::index::layout::LANES;
use crate::index::{material, pair};
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

    /// Writes S: for each group of degrees l, each pair (p, q), a group.
    ///
    /// Of a basis with a selection of modes only those of `azimuth` are summed.
    pub(crate) fn scatter(&self, material: &Material<'_, S>, azimuth: usize, scattering: &mut [S]) {
        scattering.fill(S::ZERO);
        let (scattering, _) = scattering.as_chunks_mut::<LANES>();
        let (polar, _) = self.parts.polar.as_chunks::<LANES>();
        let pairs = pair::count(self.order());
        let modes = material::count(self.order());
        let masks = self.parts.selection.chunks_exact(self.degree() + 1).skip(azimuth * modes);
        let half = S::from_f64(core::f64::consts::FRAC_1_SQRT_2);
        let groups = scattering.chunks_exact_mut(pairs).zip(polar.chunks_exact(pairs));
        for (group, (scattering, polar)) in groups.enumerate() {
            let mut masks = masks.clone();
            let mut coefficients = material.coefficients().iter();
            // The loops of `material::indices`, in rows of pairs.
            for o in 0..=material.order() {
                let lowest = o % 2;
                let row_o = pair::position(o, lowest);
                for p in (lowest..=o).step_by(2) {
                    let row_p = pair::position(p, lowest);
                    for q in 0..=p / 2 {
                        let Some(&b) = coefficients.next() else { continue };
                        let (of_o, of_p) = (row_o + q, row_p + q);
                        let b = if o == p { b } else { b * half };
                        let b = masked(b, masks.next(), group);
                        add(&b, polar, of_o, scattering, of_p);
                        if o != p {
                            add(&b, polar, of_p, scattering, of_o);
                        }
                    }
                }
            }
        }
    }
}

/// b in every lane that the mask of a selection lets through.
#[inline]
fn masked<S: Scalar>(b: S, mask: Option<&[bool]>, group: usize) -> [S; LANES] {
    let mut lanes = [b; LANES];
    if let Some(mask) = mask {
        for (l, lane) in (group * LANES..).zip(&mut lanes) {
            if !mask.get(l).copied().unwrap_or(false) {
                *lane = S::ZERO;
            }
        }
    }
    lanes
}

/// S\[to\] += b Ĉ\[from\].
#[inline]
fn add<S: Scalar>(
    b: &[S; LANES],
    polar: &[[S; LANES]],
    from: usize,
    scattering: &mut [[S; LANES]],
    to: usize,
) {
    if let (Some(polar), Some(sum)) = (polar.get(from), scattering.get_mut(to)) {
        *sum = lanes::multiply_add(*sum, b, polar);
    }
}
