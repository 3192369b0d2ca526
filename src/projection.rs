//! d = UᵀMc, without ever forming c or UᵀM: c = L (x) b has rank one, so the
//! material is folded in first, then the light.

use crate::basis::Basis;
use crate::error::{Error, What};
use crate::light::Light;
use crate::material::Material;
use crate::scalar::Scalar;

/// The coefficients d of one image, component by component.
pub type Coefficients<S, const K: usize> = heapless::Vec<S, K>;

impl<S: Scalar> Basis<'_, S> {
    /// d = UᵀMc of a light on a material: the image's coefficients in the
    /// eigenimages, less those of the mean image if the basis has one.
    ///
    /// `N`, `T` and `K` are at least [`scattering_len`](Self::scattering_len),
    /// [`transfer_len`](Self::transfer_len) and [`components`](Self::components).
    /// A light or material of a lower degree or order than the basis's counts as
    /// zero above.
    ///
    /// Cost: that of [`transfer`](Self::transfer) and [`relight`](Self::relight).
    ///
    /// # Errors
    ///
    /// [`Error::Beyond`] if light or material go beyond the basis,
    /// [`Error::Capacity`] if `N`, `T` or `K` is too small.
    pub fn project<const N: usize, const T: usize, const K: usize>(
        &self,
        light: &Light<'_, S>,
        material: &Material<'_, S>,
    ) -> Result<Coefficients<S, K>, Error> {
        self.relight(&self.transfer::<N, T>(material)?, light)
    }

    /// [`project`](Self::project) with slices: room for
    /// [`scattering_len`](Self::scattering_len) and
    /// [`transfer_len`](Self::transfer_len) numbers, and
    /// [`components`](Self::components) for the answer.
    ///
    /// # Errors
    ///
    /// [`Error::Beyond`] if light or material go beyond the basis,
    /// [`Error::Length`] if a slice has another length.
    pub fn project_into(
        &self,
        light: &Light<'_, S>,
        material: &Material<'_, S>,
        scattering: &mut [S],
        transfer: &mut [S],
        coefficients: &mut [S],
    ) -> Result<(), Error> {
        self.transfer_into(material, scattering, transfer)?;
        self.relight_into(transfer, light, coefficients)
    }
}

/// A buffer of `needed` zeros.
#[inline]
pub(crate) fn zeros<S: Scalar, const N: usize>(
    what: What,
    needed: usize,
) -> Result<heapless::Vec<S, N>, Error> {
    if needed > N {
        return Err(Error::Capacity { what, needed, capacity: N });
    }
    let mut buffer = heapless::Vec::from_array([S::ZERO; N]);
    buffer.truncate(needed);
    Ok(buffer)
}
