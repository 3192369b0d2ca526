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
mod set;
mod terms;

use crate::basis::Basis;
use crate::error::Error;
use crate::scalar::Scalar;
use crate::scene::Scene;

pub use set::Shape;

/// What an image may be off that of all components, root mean square over a sphere's normals;
/// what the components lack comes besides, see [`Economy::floor`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Tolerance<S> {
    /// A share of the image's peak, above 0; of a colour's channel, of the largest peak of all
    /// channels.
    OfPeak(S),
    /// So many decibels below the peak; 20 are a tenth.
    Decibels(u8),
    /// An irradiance, above 0.
    Irradiance(S),
}

/// What was chosen, and what it costs at most.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Economy<S> {
    /// Number of leading components that suffice: a scene made from these alone also stays within
    /// the bound. The scene itself uses all components, which costs a pixel nothing.
    pub components: usize,
    /// Azimuths |m| from 0 on that are left.
    pub azimuths: usize,
    /// Terms of all polynomials: a pixel costs a multiplication for each but a polynomial's
    /// first, and 4m - 2 for azimuths up to m.
    pub terms: usize,
    /// At most so far is the image off that of all components, root mean square over a
    /// sphere's normals; rounding apart. Its square is the sum of the next two's.
    pub bound: S,
    /// So far at most if the components beyond [`components`](Self::components) are left out.
    pub left_out_by_components: S,
    /// So far for the azimuths and terms that are left out.
    pub left_out_by_terms: S,
    /// An estimate of what the table's components themselves lack of the image, root mean
    /// square over a sphere's normals: the root of the sum of the squares of the last fifth of
    /// the coefficients. A tolerance below it is met only against the image of all components.
    ///
    /// Of unseen materials under the shipped lights, with the shipped table, it is the error in
    /// the median, within a factor of 2 for nine images of ten, and within 4 for all.
    pub floor: S,
    /// The largest of 41 pixels of the image, at most its peak; of all channels, where the
    /// image is one of a colour.
    pub peak: S,
}

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
