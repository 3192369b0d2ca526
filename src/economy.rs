//! A scene no better than asked for: components, azimuths and terms are left out as long as
//! a tolerance holds.
//!
//! Components are orthonormal, so leaving some out costs Σ d_i², the mean square over the
//! normals; what terms cost is in [`terms`]. What components lack lies within the terms that
//! stay, what terms lack outside them: the squares add.

mod basis;
mod density;
mod terms;

use crate::basis::Basis;
use crate::error::{Error, What};
use crate::mathematics::{Libm, Mathematics};
use crate::normal::Normal;
use crate::scalar::Scalar;
use crate::scene::Scene;
use terms::{from_orthonormal, spared, to_orthonormal};

/// What an image may be off, root mean square over a sphere's normals.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Tolerance<S> {
    /// A share of the image's peak, above 0.
    OfPeak(S),
    /// So many decibels below the peak; 20 are a tenth.
    Decibels(u8),
    /// An irradiance, above 0.
    Irradiance(S),
}

/// What was chosen, and what it costs at most.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Economy<S> {
    /// The first so many components are in it.
    pub components: usize,
    /// Azimuths |m| from 0 on that are left.
    pub azimuths: usize,
    /// Terms of all polynomials: a pixel costs a multiplication for each but a polynomial's
    /// first, and four for each azimuth but the first.
    pub terms: usize,
    /// At most so far is the image off that of all components, root mean square over a
    /// sphere's normals; rounding apart.
    pub bound: S,
    /// The largest of 41 pixels of the image, at most its peak.
    pub peak: S,
}

/// What of the tolerance is for components, a sixteenth of its square: terms are what a pixel
/// costs.
const COMPONENTS: f64 = 0.25;

/// Where the peak is looked for: toward the camera, and slants of these cosines and sines,
/// each at eight azimuths.
const SLANTS: [(f64, f64); 5] = [
    (0.92, 0.391_918_358_845_308_5),
    (0.75, 0.661_437_827_766_147_6),
    (0.5, 0.866_025_403_784_438_6),
    (0.25, 0.968_245_836_551_854_2),
    (0.0, 1.0),
];

impl<S: Scalar> Basis<'_, S> {
    /// A cheaper scene within a tolerance of that of all `coefficients`:
    /// [`collapse_into`](Self::collapse_into), then fewer components, azimuths and terms.
    ///
    /// The scene's polynomials lie at the beginning of `buffer`, of length
    /// [`scene_len`](Self::scene_len); their lengths in `lengths`, which has room for
    /// [`azimuths`](Self::azimuths). Polynomials of more than 64 terms stay as they are, of
    /// azimuths m above 32 those of more than 128 - 2 m. Set-up cost: two collapses, 41 pixels, four products for each pair of terms of a polynomial
    /// three times over, and for each cut a look at all terms. Stack: some 460 numbers.
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
        buffer: B,
    ) -> Result<(Scene<'l, B>, Economy<S>), Error> {
        let scene = self.collapse_into(coefficients, buffer)?;
        let peak = peak(&scene);
        let tolerance = tolerance.irradiance(peak)?;
        let of_components = S::from_f64(COMPONENTS) * tolerance;
        let mut components = coefficients.len();
        let mut energy = S::ZERO;
        for &d in coefficients.iter().rev() {
            let more = energy.add_product(d, d);
            if more <= of_components * of_components {
                (energy, components) = (more, components - 1);
            } else {
                break;
            }
        }
        let originals = scene.lengths();
        let found = lengths.len();
        let lengths = lengths.get_mut(..originals.len()).ok_or(Error::Length {
            what: What::Lengths,
            expected: originals.len(),
            found,
        })?;
        lengths.copy_from_slice(originals);
        // Components that are left out have no part in terms that are, so the squares add.
        let mut buffer = scene.into_buffer();
        to_orthonormal(originals, buffer.as_mut());
        let squares =
            energy + spared(originals, lengths, buffer.as_ref(), tolerance * tolerance - energy);
        if components < coefficients.len() {
            let some = coefficients.get(..components).unwrap_or_default();
            buffer = self.collapse_into(some, buffer)?.into_buffer();
            to_orthonormal(originals, buffer.as_mut());
        }
        let terms = from_orthonormal(originals, lengths, buffer.as_mut());
        let azimuths = lengths.iter().rposition(|&length| length > 0).map_or(0, |last| last + 1);
        let bound = Libm::square_root(squares);
        let scene = Scene::of(lengths.get(..azimuths).unwrap_or_default(), buffer);
        Ok((scene, Economy { components, azimuths, terms, bound, peak }))
    }
}

impl<S: Scalar> Tolerance<S> {
    /// As an irradiance.
    fn irradiance(self, peak: S) -> Result<S, Error> {
        let (share, of) = match self {
            Self::OfPeak(share) => (share, peak),
            Self::Decibels(decibels) => {
                // 10^(-1/20) so many times.
                let one = S::from_f64(0.891_250_938_133_745_5);
                ((0..decibels).fold(S::ONE, |share, _| share * one), peak)
            }
            Self::Irradiance(irradiance) => (irradiance, S::ONE),
        };
        if share > S::ZERO && share.is_finite() { Ok(share * of) } else { Err(Error::Tolerance) }
    }
}

/// The largest |I| at some normals.
fn peak<S: Scalar, B: AsRef<[S]>>(scene: &Scene<'_, B>) -> S {
    let at = |x: S, y: S, z: S| size(scene.shade(Normal { x, y, z }));
    let mut largest = at(S::ZERO, S::ZERO, S::ONE);
    let diagonal = S::from_f64(core::f64::consts::FRAC_1_SQRT_2);
    for (z, sine) in SLANTS {
        let (z, sine) = (S::from_f64(z), S::from_f64(sine));
        let aslant = sine * diagonal;
        for (x, y) in [(sine, S::ZERO), (S::ZERO, sine), (aslant, aslant), (aslant, -aslant)] {
            for found in [at(x, y, z), at(-x, -y, z)] {
                if found > largest {
                    largest = found;
                }
            }
        }
    }
    largest
}

fn size<S: Scalar>(value: S) -> S {
    if value < S::ZERO { -value } else { value }
}
