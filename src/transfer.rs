//! A material folded into a basis: T_i,l = Σ_pq factor_i,l,pq S_l,pq, so that
//! d_i = Σ_l T_i,l L_l^m.
//!
//! +m and -m share the sum; theirs differ by (-1)^m.

use crate::basis::{Basis, ProfilePlace};
use crate::error::{Error, What};
use crate::index::{layout, pair};
use crate::lanes;
use crate::material::Material;
use crate::projection::zeros;
use crate::scalar::Scalar;

const LANES: usize = layout::LANES;

/// One material folded into a basis: see [`Basis::transfer`].
#[derive(Clone, Debug, PartialEq)]
pub struct Transfer<S, const N: usize>(pub(crate) heapless::Vec<S, N>);

impl<S: Scalar> Basis<'_, S> {
    /// Folds a material into the basis.
    ///
    /// `N` is at least [`scattering_len`](Self::scattering_len), `T` at least
    /// [`transfer_len`](Self::transfer_len).
    ///
    /// Cost: for each profile, each degree from its |m| on, one multiplication for
    /// each pair (p, q).
    ///
    /// # Errors
    ///
    /// [`Error::Beyond`] if the material goes beyond the basis,
    /// [`Error::Capacity`] if `N` or `T` is too small.
    pub fn transfer<const N: usize, const T: usize>(
        &self,
        material: &Material<'_, S>,
    ) -> Result<Transfer<S, T>, Error> {
        let mut scattering = zeros::<S, N>(What::Scattering, self.scattering_len())?;
        let mut transfer = zeros::<S, T>(What::Transfer, self.transfer_len())?;
        self.transfer_into(material, &mut scattering, &mut transfer)?;
        Ok(Transfer(transfer))
    }

    /// [`transfer`](Self::transfer) with slices.
    ///
    /// # Errors
    ///
    /// [`Error::Beyond`] if the material goes beyond the basis,
    /// [`Error::Length`] if a slice is not as long as
    /// [`scattering_len`](Self::scattering_len) and
    /// [`transfer_len`](Self::transfer_len) say.
    pub fn transfer_into(
        &self,
        material: &Material<'_, S>,
        scattering: &mut [S],
        transfer: &mut [S],
    ) -> Result<(), Error> {
        self.accept_material(material)?;
        Error::check(What::Scattering, self.scattering_len(), scattering.len())?;
        Error::check(What::Transfer, self.transfer_len(), transfer.len())?;
        // Lanes with |m| > l stay zero.
        transfer.fill(S::ZERO);
        let pairs = pair::count(self.order());
        let (mut factors, _) = self.parts.factors.as_chunks::<LANES>();
        let groups = layout::groups(self.degree());
        let mut scattered = None;
        for place in self.parts.profiles {
            let azimuth = place.azimuth();
            // One scattering serves every azimuth, unless a selection of modes
            // makes them differ.
            if scattered.is_none()
                || (scattered != Some(azimuth) && !self.parts.selection.is_empty())
            {
                self.scatter(material, azimuth, scattering);
                scattered = Some(azimuth);
            }
            let (scattering, _) = scattering.as_chunks::<LANES>();
            let first = layout::first_group(azimuth);
            let rest = scattering.get(first * pairs..).unwrap_or_default();
            for (group, scattering) in (first..groups).zip(rest.chunks_exact(pairs)) {
                let (of_group, after) = factors.split_at_checked(pairs).unwrap_or((factors, &[]));
                factors = after;
                let sums = lanes::product(of_group, scattering);
                self.spread(place, group, &sums, transfer);
            }
        }
        Ok(())
    }

    /// Writes T_l of one group of degrees into the rows of +m and -m.
    #[inline]
    fn spread(&self, place: &ProfilePlace, group: usize, sums: &[S; LANES], transfer: &mut [S]) {
        let azimuth = place.azimuth();
        let odd = azimuth % 2 == 1;
        for (l, &sum) in (group * LANES..=self.degree()).zip(sums) {
            let Some(row) = l.checked_sub(azimuth) else { continue };
            for (of, value) in
                [(place.plus_row, sum), (place.minus_row, if odd { -sum } else { sum })]
            {
                if let Some(to) = transfer.get_mut(of.start as usize + row * of.step as usize) {
                    *to = value;
                }
            }
        }
    }
}
