//! Small bright sources, which are taken out of the harmonics of a light.

use crate::analytic::add_harmonics;
use crate::buffer::{copied, zeros};
use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::index::light::count;
use crate::light::{Light, LightBuffer};
use crate::mathematics;
use crate::rotation::{Rotation, dot};
use core::f32::consts::TAU;

/// How far a direction's length may be from 1.
const LENGTH: f32 = 1e-3;

/// The largest standard deviation in radians, and what it may exceed by rounding.
const WIDEST: f32 = 0.5 * (1.0 + 1e-5);

/// A small bright source of light: an elliptical blob on the sphere of directions.
///
/// The harmonics of a light represent a lamp, a window or the sun as a patch some 180 degrees /
/// degree wide, so its reflection on a glossy material is just as wide. Taken out of the light
/// ([`Rgb::residual`]) and shaded by [`Highlights`](crate::Highlights), it is sharp.
///
/// The blob has the standard deviation |major| along the great circle through its direction s and
/// s + major, and `minor` across. It is the heat kernel of variance minor², whose harmonics of degree
/// l are those of a point times exp(-l (l + 1) minor² / 2), convolved along that circle with a
/// normal distribution of variance t² = |major|² - minor². Its integral over the sphere is 1, times
/// the energy.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Source {
    direction: [f32; 3],
    energy: Rgb<f32>,
    major: [f32; 3],
    minor: f32,
}

impl Source {
    /// A source in the unit vector `direction`, which points from the object to the light in the
    /// camera's frame.
    ///
    /// * `energy`: the integral of its radiance over solid angle, in each channel, at least 0.
    /// * `major`: a vector whose length is the standard deviation in radians along its direction. Its
    ///   part along the direction of the source is removed.
    /// * `minor`: the standard deviation in radians across it.
    ///
    /// The direction is scaled to length 1.
    ///
    /// # Errors
    ///
    /// [`Error::Source`] if the length of the direction differs from 1 by more than 1e-3, a number
    /// is not finite, an energy is below 0, or not 0 <= minor <= |major| <= 0.5.
    pub fn new(
        direction: [f32; 3],
        energy: impl Into<Rgb<f32>>,
        major: [f32; 3],
        minor: f32,
    ) -> Result<Self, Error> {
        let energy = energy.into();
        let square = dot(direction, direction);
        let off = square - 1.0;
        let most = 2.0 * LENGTH;
        let is_unit = off <= most && -off <= most;
        let is_bright = [energy.r, energy.g, energy.b]
            .into_iter()
            .all(|energy| energy >= 0.0 && energy.is_finite());
        if !(is_unit && is_bright) {
            return Err(Error::Source);
        }
        let scale = mathematics::inverse_root(square);
        let direction = direction.map(|component| component * scale);
        let along = dot(major, direction);
        let [[x, y, z], [sx, sy, sz]] = [major, direction];
        let major = [x - along * sx, y - along * sy, z - along * sz];
        let [long, short] = [dot(major, major), minor * minor];
        let fits =
            minor >= 0.0 && short <= long * (1.0 + 2.0 * LENGTH) && long <= (WIDEST * WIDEST);
        match (fits, short <= long) {
            (true, true) => Ok(Self { direction, energy, major, minor }),
            (true, false) => {
                Ok(Self { direction, energy, major, minor: mathematics::square_root(long) })
            }
            (false, _) => Err(Error::Source),
        }
    }

    /// A round source with this standard deviation in radians along every direction. A disc of
    /// angular radius r has r / 2. For a spread of 0, it is a point; errors as [`new`](Self::new).
    ///
    /// ```
    /// use eigenshade::Source;
    ///
    /// // A disc of radiance 40 and 0.1 rad in radius, to the upper left: its solid angle is
    /// // 0.0314 sr.
    /// let lamp = Source::round([-0.6, 0.0, 0.8], [40.0 * 0.0314; 3], 0.05)?;
    /// assert_eq!(lamp.energy().g, 40.0 * 0.0314);
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    pub fn round(
        direction: [f32; 3],
        energy: impl Into<Rgb<f32>>,
        spread: f32,
    ) -> Result<Self, Error> {
        // Perpendicular to the direction and not zero, as not all of x, y and z are small.
        let [x, y, z] = direction;
        let across = if x * x + y * y > z * z { [-y, x, 0.0] } else { [0.0, -z, y] };
        let square = dot(across, across);
        if !(square.is_finite() && square > 0.1) {
            return Err(Error::Source);
        }
        let scale = spread * mathematics::inverse_root(square);
        Self::new(direction, energy, across.map(|component| component * scale), spread)
    }

    /// A source that [`new`](Self::new) accepts, without changes.
    #[cfg(feature = "presets")]
    pub(crate) const fn stored(
        direction: [f32; 3],
        [r, g, b]: [f32; 3],
        major: [f32; 3],
        minor: f32,
    ) -> Self {
        Self { direction, energy: Rgb::new(r, g, b), major, minor }
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

    /// The major axis, perpendicular to the direction: its length is a standard deviation in
    /// radians.
    #[must_use]
    pub const fn major(&self) -> [f32; 3] {
        self.major
    }

    /// The standard deviation across the major axis, in radians.
    #[must_use]
    pub const fn minor(&self) -> f32 {
        self.minor
    }

    /// This source after a rotation, which must also turn the light that it was taken out of. It
    /// may set behind the object and rise again.
    #[must_use]
    pub fn turned(self, rotation: Rotation) -> Self {
        let [direction, major] = [self.direction, self.major].map(|v| rotation.turn_direction(v));
        Self { direction, major, ..self }
    }

    /// The harmonics up to `degree` of the blob with energy 1. `N` must be at least (degree + 1)².
    ///
    /// # Errors
    ///
    /// [`Error::Capacity`] if `N` is too small.
    pub fn harmonics<const N: usize>(&self, degree: usize) -> Result<LightBuffer<N>, Error> {
        let mut blob = zeros::<f32, N>(Argument::Light, count(degree))?;
        self.add_blob(&mut blob, degree)?;
        Ok(blob)
    }

    /// Adds the coefficients of the blob with energy 1 to those of a light.
    ///
    /// The integral along the major axis is a trapezoid sum over nodes s_j = cos(x_j) s + sin(x_j)
    /// major / |major|, x_j = j h t and |j h| <= 5, with weights exp(-(j h)² / 2) over their sum.
    /// With h <= 2π / (5 + t l), its ends and its aliases each leave at most 4e-6 of degree l.
    fn add_blob(&self, coefficients: &mut [f32], degree: usize) -> Result<(), Error> {
        let half = 0.5;
        let long = dot(self.major, self.major);
        let short = self.minor * self.minor;
        let rest = long - short;
        let mut total = 1.0;
        add_harmonics(coefficients, self.direction, 1.0)?;
        // Less is rounding, of a round source.
        if rest > 1e-6 * long {
            let width = mathematics::square_root(rest);
            let five = 5.0;
            let fewest = five * (five + width * (degree as f32)) * (1.0 / TAU);
            let nodes = (fewest as usize) + 1;
            let step = five * (nodes as f32).recip();
            let scale = mathematics::inverse_root(long);
            let [[x, y, z], [ux, uy, uz]] = [self.direction, self.major.map(|u| u * scale)];
            // exp(-(j h)² / 2) has the ratios exp(-h² / 2)^(2 j + 1).
            let (mut weight, mut ratio) = (1.0, decay(half * step * step));
            let square = ratio * ratio;
            for j in 1..=nodes {
                weight *= ratio;
                ratio *= square;
                total += weight + weight;
                let (sine, cosine) = mathematics::sine_and_cosine((j as f32) * step * width);
                for sine in [sine, -sine] {
                    let node =
                        [cosine * x + sine * ux, cosine * y + sine * uy, cosine * z + sine * uz];
                    add_harmonics(coefficients, node, weight)?;
                }
            }
        }
        // exp(-l (l + 1) minor² / 2) is the product of exp(-minor²)^k for k to l.
        let factor = decay(short);
        let (mut power, mut damping) = (1.0, total.recip());
        let mut coefficients = coefficients.iter_mut();
        for l in 0..=degree {
            for coefficient in coefficients.by_ref().take(2 * l + 1) {
                *coefficient *= damping;
            }
            power *= factor;
            damping *= power;
        }
        Ok(())
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
    /// let lamp = Source::round([0.0, 0.0, 1.0], [1.0; 3], 0.05)?;
    /// let rest = light.residual::<4>(&[lamp])?;
    /// assert!((rest.r[0] - (3.5 - 0.2821)).abs() < 1e-4);
    /// assert!(rest.r[2].abs() < 0.02);
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// Accurate to 1e-5 of a source's energy. Cost: for each round source two roots for each degree
    /// and order l >= m >= 0, so 110 at degree 9; for an elongated one of degree 9, 11 to 15 times
    /// as many. A light that turns needs it once: turn the residual and the sources.
    ///
    /// # Errors
    ///
    /// [`Error::Capacity`] if `N` is too small.
    pub fn residual<const N: usize>(
        &self,
        sources: &[Source],
    ) -> Result<Rgb<LightBuffer<N>>, Error> {
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
