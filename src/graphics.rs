//! Light from and for other programs: coefficients of three.js, Filament and its tool cmgen.

use crate::buffer::{Buffer, copied};
use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::index::light::{graphics_sign, indices};
use crate::light::{Light, degree};
use crate::nine_terms::{CONSTANT, LINEAR, SQUARE, UPRIGHT};

/// The convention of another program's coefficients.
///
/// All coefficients are in the order of [`eigenshade_table::light`]. Directions are in the
/// program's world: right-handed, y up, with a camera that looks along -z until it is turned. This
/// crate has the same frame. For a camera that is turned, turn the light back with
/// [`Light::turned`].
///
/// | | contains | harmonics | degree |
/// |---|---|---|---|
/// | `ThreeJs` | radiance | orthonormal, Y_1^1 = +√(3/4π) x | any; three.js has 2 |
/// | `Cmgen` | radiance | orthonormal, times (-1)^m | any |
/// | `CmgenIrradiance` | irradiance, not divided by π | as `Cmgen` | 2 |
/// | `Filament` | irradiance over π | 1, y, z, x, xy, yz, 3z² - 1, xz, x² - y² | 2 |
///
/// cmgen attenuates up to three bands by a window of its own (`--sh-window=auto`), which depends on
/// the map and is not undone. `--sh-window=no` keeps the light whole.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Convention {
    /// `SphericalHarmonics3` of three.js, as in a `LightProbe` of intensity 1. Tables after
    /// Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance Environment Maps",
    /// 2001, have the same signs and scale.
    ThreeJs,
    /// Radiance as `cmgen --sh=BANDS` prints it and `IndirectLight::Builder::radiance` takes it:
    /// with the Condon-Shortley phase, but with |m| in sin(|m| φ).
    Cmgen,
    /// Irradiance as `cmgen --sh=3 --sh-irradiance` prints it: `Cmgen` times π, 2π/3 and π/4 for
    /// degrees 0, 1 and 2. Versions without the option `--sh-window` print these numbers divided by
    /// π.
    CmgenIrradiance,
    /// A polynomial in the normal whose value is the irradiance over π, as
    /// `IndirectLight::Builder::irradiance` takes it. `cmgen --deploy` writes the polynomial to
    /// `sh.txt` and to the entry `sh` of a KTX file; `cmgen --sh-shader` prints the polynomial.
    /// `IndirectLight::Builder::intensity` is a factor of the light that is not included.
    Filament,
}

impl Convention {
    /// Converts coefficients of this convention in place to the radiance of a [`Light`]; errors as
    /// [`Light::from_graphics`], except for the capacity.
    pub fn decode(self, coefficients: &mut [f32]) -> Result<(), Error> {
        let degree = self.accept(coefficients.len())?;
        Error::check_finite(Argument::Light, coefficients)?;
        for (coefficient, (l, m)) in coefficients.iter_mut().zip(indices(degree)) {
            *coefficient *= self.share(l, m).recip();
        }
        Ok(())
    }

    /// Converts the radiance of a [`Light`] in place to coefficients of this convention; errors as
    /// [`decode`](Self::decode).
    pub fn encode(self, coefficients: &mut [f32]) -> Result<(), Error> {
        let degree = self.accept(coefficients.len())?;
        Error::check_finite(Argument::Light, coefficients)?;
        for (coefficient, (l, m)) in coefficients.iter_mut().zip(indices(degree)) {
            *coefficient *= self.share(l, m);
        }
        Ok(())
    }

    /// The degree of this number of coefficients.
    fn accept(self, count: usize) -> Result<usize, Error> {
        let degree = degree(count)?;
        match self {
            Self::CmgenIrradiance | Self::Filament if degree > 2 => {
                let argument = Argument::Irradiance;
                Err(Error::Beyond { argument, most: 2, found: degree })
            }
            _ => Ok(degree),
        }
    }

    /// The coefficient of this convention for a coefficient of 1 of this crate.
    fn share(self, degree: usize, order: isize) -> f32 {
        use core::f32::consts::PI;
        let sign = if graphics_sign(order) < 0 { -1.0 } else { 1.0 };
        let phase = if order % 2 == 0 { sign } else { -sign };
        match self {
            Self::ThreeJs => sign,
            Self::Cmgen => phase,
            // The cosine, convolved.
            Self::CmgenIrradiance => {
                phase
                    * match degree {
                        0 => PI,
                        1 => 2.0 / 3.0 * PI,
                        _ => 0.25 * PI,
                    }
            }
            Self::Filament => {
                sign * match (degree, order) {
                    (0, _) => CONSTANT,
                    (1, _) => LINEAR,
                    (_, 0) => UPRIGHT,
                    (_, 2) => 0.5 * SQUARE,
                    _ => SQUARE,
                }
            }
        }
    }
}

impl Light<'_> {
    /// The light of another program's coefficients, one channel. `N` must be at least the number of
    /// coefficients.
    ///
    /// ```
    /// use eigenshade::lights::Convention;
    /// use eigenshade::Light;
    ///
    /// // More light from the right: x is the fourth number, and negative here.
    /// let light = Light::from_graphics::<4>(Convention::ThreeJs, &[3.5, 0.0, 0.0, 1.0])?;
    /// assert_eq!(light[..], [3.5, 0.0, 0.0, -1.0]);
    /// assert_eq!(Light::new(&light)?.to_graphics::<4>(Convention::Cmgen)?[3], -1.0);
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Count`] unless there are (degree + 1)² numbers for some degree;
    /// [`Error::Beyond`] if the convention contains irradiance and the degree is above 2;
    /// [`Error::NotFinite`] with the index of the first number that is infinite or NaN;
    /// [`Error::Capacity`] if `N` is too small.
    pub fn from_graphics<const N: usize>(
        convention: Convention,
        numbers: &[f32],
    ) -> Result<Buffer<f32, N>, Error> {
        let mut light = copied(Argument::Light, numbers.iter().copied())?;
        convention.decode(&mut light)?;
        Ok(light)
    }

    /// This light for another program: the inverse of [`from_graphics`](Self::from_graphics).
    ///
    /// # Errors
    ///
    /// As [`from_graphics`](Self::from_graphics), except for `Count`.
    /// [`truncated`](Self::truncated) brings a light to degree 2.
    pub fn to_graphics<const N: usize>(
        &self,
        convention: Convention,
    ) -> Result<Buffer<f32, N>, Error> {
        let mut numbers = copied(Argument::Light, self.coefficients().iter().copied())?;
        convention.encode(&mut numbers)?;
        Ok(numbers)
    }
}

impl Rgb<Light<'_>> {
    /// [`Light::from_graphics`] of the red, green and blue of each coefficient, as these programs
    /// list them.
    ///
    /// ```
    /// # #[cfg(feature = "baked")] {
    /// use eigenshade::lights::Convention;
    /// use eigenshade::{Light, Material, Normal, Rgb, sphere};
    ///
    /// // `sh.txt` of `cmgen --deploy`: white, and blue from above.
    /// let sh = [[1.0, 1.0, 1.0], [0.0, 0.0, 0.6], [0.0; 3], [0.0; 3]];
    /// let light = Rgb::<Light>::from_graphics::<4>(Convention::Filament, &sh)?;
    /// let scene = sphere::color::scene(light.lights()?, Material::new(&[2.0])?)?;
    /// let up = scene.shade(Normal::new(0.0, 1.0, 0.0)?);
    /// assert!((up.b - 1.6).abs() < 0.01 && (up.r - 1.0).abs() < 0.01);
    /// # }
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As [`Light::from_graphics`]; `NotFinite` counts coefficients.
    pub fn from_graphics<const N: usize>(
        convention: Convention,
        numbers: &[[f32; 3]],
    ) -> Result<Rgb<Buffer<f32, N>>, Error> {
        let mut light = Rgb::new(
            copied(Argument::Light, numbers.iter().map(|[r, ..]| *r))?,
            copied(Argument::Light, numbers.iter().map(|[_, g, _]| *g))?,
            copied(Argument::Light, numbers.iter().map(|[.., b]| *b))?,
        );
        convention.decode(&mut light.r)?;
        convention.decode(&mut light.g)?;
        convention.decode(&mut light.b)?;
        Ok(light)
    }
}
