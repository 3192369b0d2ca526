//! Small bright sources, which are taken out of the harmonics of a light.

use crate::analytic::add_harmonics;
use crate::buffer::{Buffer, copied, zeros};
use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::index::light::count;
use crate::light::Light;
use crate::mathematics;
use crate::rotation::{Rotation, dot};

/// How far a direction's length may be from 1.
const LENGTH: f32 = 1e-3;

/// The largest standard deviation in radians, and what it may exceed by rounding.
const WIDEST: f32 = 0.5 * (1.0 + 1e-5);

/// A small bright source of light: a round blob on the sphere of directions.
///
/// The harmonics of a light represent a lamp, a window or the sun as a patch some 180 degrees /
/// degree wide, so its reflection on a glossy material is just as wide. Taken out of the light
/// ([`Rgb::residual`]) and shaded by [`Highlights`](crate::Highlights), a lamp has a sharp
/// reflection.
///
/// The blob is the heat kernel of variance spread²: its harmonics of degree l are a point's, times
/// exp(-l (l + 1) spread² / 2). The blob's integral over the sphere is 1, times the energy.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Source {
    direction: [f32; 3],
    energy: Rgb<f32>,
    spread: f32,
}

impl Source {
    /// A source in the unit vector `direction`, which points from the object to the light in the
    /// camera's frame.
    ///
    /// * `energy`: the integral of its radiance over solid angle, in each channel, at least 0.
    /// * `spread`: the standard deviation in radians along every direction. A disc of angular
    ///   radius r has r / 2; 0 is a point.
    ///
    /// The direction is scaled to length 1.
    ///
    /// ```
    /// use eigenshade::Source;
    ///
    /// // A disc of radiance 40 and 0.1 rad in radius, to the upper left: its solid angle is
    /// // 0.0314 sr.
    /// let lamp = Source::new([-0.6, 0.0, 0.8], [40.0 * 0.0314; 3], 0.05)?;
    /// assert_eq!(lamp.energy().g, 40.0 * 0.0314);
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Source`] if the length of the direction differs from 1 by more than 1e-3, a number
    /// is not finite, an energy is below 0, or not 0 <= spread <= 0.5.
    pub fn new(
        direction: [f32; 3],
        energy: impl Into<Rgb<f32>>,
        spread: f32,
    ) -> Result<Self, Error> {
        let energy = energy.into();
        let square = dot(direction, direction);
        let off = square - 1.0;
        let most = 2.0 * LENGTH;
        let is_unit = off <= most && -off <= most;
        let is_bright = [energy.r, energy.g, energy.b]
            .into_iter()
            .all(|energy| energy >= 0.0 && energy.is_finite());
        if !(is_unit && is_bright && (0.0..=WIDEST).contains(&spread)) {
            return Err(Error::Source);
        }
        let scale = mathematics::inverse_root(square);
        Ok(Self { direction: direction.map(|component| component * scale), energy, spread })
    }

    /// A source that [`new`](Self::new) accepts, without changes.
    #[cfg(feature = "presets")]
    pub(crate) const fn stored(direction: [f32; 3], [r, g, b]: [f32; 3], spread: f32) -> Self {
        Self { direction, energy: Rgb::new(r, g, b), spread }
    }

    /// The direction, of length 1.
    #[must_use]
    pub const fn direction(&self) -> [f32; 3] {
        self.direction
    }

    /// The integral of radiance over solid angle.
    #[must_use]
    pub const fn energy(&self) -> Rgb<f32> {
        self.energy
    }

    /// The standard deviation along every direction, in radians.
    #[must_use]
    pub const fn spread(&self) -> f32 {
        self.spread
    }

    /// This source after a rotation, which must also turn the light that it was taken out of. A
    /// turned source may set behind the object and rise again.
    #[must_use]
    pub fn turned(self, rotation: Rotation) -> Self {
        Self { direction: rotation.turn_direction(self.direction), ..self }
    }

    /// The harmonics up to `degree` of the blob with energy 1. `N` must be at least (degree + 1)².
    ///
    /// # Errors
    ///
    /// [`Error::Capacity`] if `N` is too small.
    pub fn harmonics<const N: usize>(&self, degree: usize) -> Result<Buffer<f32, N>, Error> {
        let mut blob = zeros::<f32, N>(Argument::Light, count(degree))?;
        add_harmonics(&mut blob, self.direction, 1.0)?;
        // exp(-l (l + 1) spread² / 2) is the product of exp(-spread²)^k for k to l.
        let factor = decay(self.spread * self.spread);
        let (mut power, mut damping) = (1.0, 1.0);
        let mut coefficients = blob.iter_mut();
        for l in 0..=degree {
            for coefficient in coefficients.by_ref().take(2 * l + 1) {
                *coefficient *= damping;
            }
            power *= factor;
            damping *= power;
        }
        Ok(blob)
    }
}

/// exp(-x) for x from 0 to 1, by its series: 1 - x (1 - x/2 (1 - x/3 (...))).
fn decay(x: f32) -> f32 {
    (1..=20).rev().fold(1.0, |sum, k| 1.0 - x * (k as f32).recip() * sum)
}

impl Rgb<Light<'_>> {
    /// This light without some sources: L' = L - Σ E_k Y(blob_k). The harmonics lose exactly what
    /// [`Highlights`](crate::Highlights) add for the same sources.
    ///
    /// `N` must be at least (degree + 1)². The residual may be negative in some directions, where
    /// the sources are wider or brighter than what the light has there.
    ///
    /// ```
    /// use eigenshade::{Light, Rgb, Source};
    ///
    /// // Ambient light and a lamp in front.
    /// let light = Rgb::gray(Light::new(&[3.5, 0.0, 0.5, 0.0])?);
    /// let lamp = Source::new([0.0, 0.0, 1.0], [1.0; 3], 0.05)?;
    /// let rest = light.residual::<4>(&[lamp])?;
    /// assert!((rest.r[0] - (3.5 - 0.2821)).abs() < 1e-4);
    /// assert!(rest.r[2].abs() < 0.02);
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// Accurate to 1e-5 of a source's energy. Cost: for each source two roots for each degree and
    /// order l >= m >= 0, so 110 at degree 9. A light that turns needs one residual: turn the
    /// residual and the sources.
    ///
    /// # Errors
    ///
    /// [`Error::Capacity`] if `N` is too small.
    pub fn residual<const N: usize>(
        &self,
        sources: &[Source],
    ) -> Result<Rgb<Buffer<f32, N>>, Error> {
        let mut residual = self.each_ref().try_map(|light| {
            copied::<f32, N>(Argument::Light, light.coefficients().iter().copied())
        })?;
        let degree = self.r.degree().max(self.g.degree()).max(self.b.degree());
        for source in sources {
            let blob = source.harmonics::<N>(degree)?;
            let Rgb { r, g, b } = &mut residual;
            let Rgb { r: of_r, g: of_g, b: of_b } = source.energy;
            for (channel, energy) in [(r, of_r), (g, of_g), (b, of_b)] {
                for (to, &harmonic) in channel.iter_mut().zip(&blob) {
                    *to -= energy * harmonic;
                }
            }
        }
        Ok(residual)
    }
}
