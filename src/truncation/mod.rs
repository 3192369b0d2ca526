//! Scenes that are only as accurate as required, one by one or several of the same shape:
//! components, azimuths and terms are left out as long as a tolerance holds.
//!
//! Components are orthonormal, so omitting some costs Σ d_i², the mean square over the normals. The
//! error of the components lies within the span of the remaining terms and the error of the terms
//! outside it, so their squares add.

mod accounts;
mod density;
mod orthogonal;
mod report;
mod set;
mod terms;

use crate::basis::Basis;
use crate::error::Error;
use crate::scene::Scene;

pub use report::{Tolerance, Truncation};
pub use set::Shape;

impl<'a> Basis<'a> {
    /// Computes a cheaper scene, within a tolerance of the scene of all `coefficients`:
    /// [`collapse_into`](Self::collapse_into) with fewer components, azimuths and terms.
    /// [`collapse_set_within`](Self::collapse_set_within) takes several images.
    ///
    /// The polynomials of the scene are written to the beginning of `buffer`, of length
    /// [`scene_len`](Self::scene_len), and their lengths to `lengths`, which needs room for
    /// [`azimuths`](Self::azimuths). A tolerance below [`Truncation::floor`] is finer than the
    /// accuracy of the table.
    ///
    /// Set-up cost, with the shipped table: two projections on a Cortex-M4F, less than one in
    /// software floats, three on x86-64, and seven with AVX2. Stack: some 700 numbers.
    ///
    /// # Errors
    ///
    /// The same as [`collapse_into`](Self::collapse_into); [`Error::Length`] if `lengths` is too
    /// short; [`Error::Tolerance`] unless the tolerance is above zero.
    pub fn collapse_within<'l, B: AsMut<[f32]> + AsRef<[f32]>>(
        &self,
        coefficients: &[f32],
        tolerance: Tolerance,
        lengths: &'l mut [u16],
        mut buffer: B,
    ) -> Result<(Scene<'l, B>, Truncation), Error>
    where
        'a: 'l,
    {
        let (one, mut reports) = ([coefficients], [Truncation::default()]);
        let room = buffer.as_mut();
        let shape = self.collapse_set_within(&one, 1, tolerance, lengths, room, &mut reports)?;
        let [report] = reports;
        Ok((Scene::of(shape.lengths, buffer), report))
    }
}
