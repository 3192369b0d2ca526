//! A scene no better than asked for, or several of one shape: components, azimuths and terms
//! are left out as long as a tolerance holds.
//!
//! Components are orthonormal, so leaving some out costs Σ d_i², the mean square over the
//! normals; what terms cost is in [`terms`]. What components lack lies within the terms that
//! stay, what terms lack outside them: the squares add.

mod accounts;
mod basis;
mod density;
mod energy;
mod peak;
mod report;
mod set;
mod terms;

use crate::basis::Basis;
use crate::error::Error;
use crate::scalar::Scalar;
use crate::scene::Scene;

pub use report::{Economy, Tolerance};
pub use set::Shape;

impl<'a, S: Scalar> Basis<'a, S> {
    /// A cheaper scene within a tolerance of that of all `coefficients`:
    /// [`collapse_into`](Self::collapse_into), then fewer components, azimuths and terms. A set
    /// of one image, as [`collapse_set_within`](Self::collapse_set_within) takes several.
    ///
    /// The scene's polynomials lie at the beginning of `buffer`, of length
    /// [`scene_len`](Self::scene_len); their lengths in `lengths`, which has room for
    /// [`azimuths`](Self::azimuths). Polynomials of more than 32 terms or of azimuths above 63
    /// stay as they are, unless their azimuth has a recurrence. A tolerance below
    /// [`Economy::floor`] asks for more than the table has.
    ///
    /// Set-up cost, with the shipped table: two projections on a Cortex-M4F, less than one in
    /// software floats, and three on x86-64, seven with AVX2. Stack: some 700 numbers.
    ///
    /// # Errors
    ///
    /// As [`collapse_into`](Self::collapse_into); [`Error::Length`] if `lengths` is too short;
    /// [`Error::Tolerance`] unless the tolerance is above zero.
    pub fn collapse_within<'l, B: AsMut<[S]> + AsRef<[S]>>(
        &self,
        coefficients: &[S],
        tolerance: Tolerance<S>,
        lengths: &'l mut [u16],
        mut buffer: B,
    ) -> Result<(Scene<'l, B>, Economy<S>), Error>
    where
        'a: 'l,
    {
        let (one, mut economies) = ([coefficients], [Economy::default()]);
        let room = buffer.as_mut();
        let shape = self.collapse_set_within(&one, 1, tolerance, lengths, room, &mut economies)?;
        let [economy] = economies;
        Ok((Scene::of(shape.lengths, shape.recurrences, buffer), economy))
    }
}
