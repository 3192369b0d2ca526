//! The peak of an image, and what tolerances are of it.

use super::Tolerance;
use crate::error::Error;
use crate::normal::Normal;
use crate::scalar::Scalar;
use crate::scene::Scene;

/// Where the peak is looked for: toward the camera, and slants of these cosines and sines,
/// each at eight azimuths.
const SLANTS: [(f64, f64); 5] = [
    (0.92, 0.391_918_358_845_308_5),
    (0.75, 0.661_437_827_766_147_6),
    (0.5, 0.866_025_403_784_438_6),
    (0.25, 0.968_245_836_551_854_2),
    (0.0, 1.0),
];

impl<S: Scalar> Tolerance<S> {
    /// As an irradiance.
    pub(super) fn irradiance(self, peak: S) -> Result<S, Error> {
        let (share, of) = match self {
            Self::OfPeak(share) => (share, peak),
            Self::Decibels(decibels) => {
                // 10^(-1/20) so many times.
                let one = S::from_f64(0.891_250_938_133_745_5);
                ((0..decibels).fold(S::ONE, |share, _| share * one), peak)
            }
            Self::Irradiance(irradiance) => (irradiance, S::ONE),
        };
        // Of what is not finite there is no share, and no comparison with it holds: nothing is
        // left out.
        let of = if of.is_finite() { of } else { of * S::ZERO };
        if share > S::ZERO && share.is_finite() { Ok(share * of) } else { Err(Error::Tolerance) }
    }
}

/// The largest |I| at some normals.
pub(super) fn peak<S: Scalar, B: AsRef<[S]>>(scene: &Scene<'_, B>) -> S {
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
