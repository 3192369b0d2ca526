//! The gloss of a material: a microfacet lobe over a matte base.

use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::index::highlights::{DIELECTRIC, ROUGHNESS, SMOOTHEST};

/// The roughness from which on harmonics of degree 9 show highlights as well as sources do.
const MATTE: f32 = 0.6;

/// The parameters of a GGX lobe over a matte base, with which [`Highlights`](crate::Highlights)
/// shade small sources of light.
///
/// With α = roughness² and the half-way direction h of light and view, the BRDF is
/// f = (1 - F) albedo / π + F D V, where
///
/// * F = f0 + (f90 - f0)(1 - cos θ_d)^5, with f90 = 1 unless given;
/// * D = α² / π(sin² θ_h + α² cos² θ_h)²;
/// * V = 1/2 / (cos θ_i √(α² + (1 - α²) cos² θ_r) + the same with i and r exchanged).
///
/// `eigenshade material ggx` and `Material::metallic_roughness` have the same BRDF; a gloss takes
/// any roughness, because it needs no coefficients.
///
/// ```
/// use eigenshade::{Gloss, Rgb};
///
/// let plastic = Gloss::metallic_roughness([0.6, 0.1, 0.1], 0.0, 0.3)?;
/// assert_eq!(plastic.reflectance(), Rgb::gray(0.04));
/// assert_eq!(plastic.albedo(), Rgb::new(0.6, 0.1, 0.1));
/// # Ok::<(), eigenshade::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Gloss {
    alpha: f32,
    reflectance: Rgb<f32>,
    grazing: Rgb<f32>,
    albedo: Rgb<f32>,
}

impl Gloss {
    /// The reflectance of dielectrics at normal incidence.
    pub const DIELECTRIC: f32 = DIELECTRIC as f32;
    /// The roughness from which on a material [needs no sources](Self::needs_sources).
    pub const MATTE: f32 = MATTE;

    /// A gloss that [`new`](Self::new) accepts, of a roughness from 0.065 to 1.
    #[cfg(feature = "presets")]
    pub(crate) const fn stored(
        roughness: f32,
        [f0_r, f0_g, f0_b]: [f32; 3],
        [f90_r, f90_g, f90_b]: [f32; 3],
        [r, g, b]: [f32; 3],
    ) -> Self {
        Self {
            alpha: roughness * roughness,
            reflectance: Rgb::new(f0_r, f0_g, f0_b),
            grazing: Rgb::new(f90_r, f90_g, f90_b),
            albedo: Rgb::new(r, g, b),
        }
    }
}

impl Gloss {
    /// From the roughness, the reflectance at normal incidence (f0) and the albedo of the matte
    /// base, all from 0 to 1.
    ///
    /// A roughness below 0.065 counts as 0.065: most sources are far wider than its lobe, of
    /// α = 0.0042.
    ///
    /// # Errors
    ///
    /// [`Error::Outside`] if a number is not from 0 to 1.
    pub fn new(roughness: f32, reflectance: [f32; 3], albedo: [f32; 3]) -> Result<Self, Error> {
        let range = [0.0, 1.0];
        Error::check_range(Argument::Roughness, [roughness], range)?;
        Error::check_range(Argument::Reflectance, reflectance, range)?;
        Error::check_range(Argument::Color, albedo, range)?;
        let least = SMOOTHEST as f32;
        let roughness = if roughness > least { roughness } else { least };
        let [reflectance, albedo] = [reflectance.into(), albedo.into()];
        let grazing = Rgb::gray(1.0);
        Ok(Self { alpha: roughness * roughness, reflectance, grazing, albedo })
    }

    /// With this reflectance at grazing incidence, f90, from 0 to 1; it is 1 by default. Lobes
    /// fitted to measured materials need less.
    ///
    /// # Errors
    ///
    /// [`Error::Outside`] if a number is not from 0 to 1.
    pub fn with_grazing(self, grazing: [f32; 3]) -> Result<Self, Error> {
        Error::check_range(Argument::Reflectance, grazing, [0.0, 1.0])?;
        Ok(Self { grazing: grazing.into(), ..self })
    }

    /// From the linear base color, metallic and roughness of glTF, all from 0 to 1: f0 is 0.04 +
    /// (base color - 0.04) metallic, the albedo base color (1 - metallic).
    ///
    /// # Errors
    ///
    /// [`Error::Outside`] if a number is not from 0 to 1.
    pub fn metallic_roughness(
        base_color: [f32; 3],
        metallic: f32,
        roughness: f32,
    ) -> Result<Self, Error> {
        let range = [0.0, 1.0];
        Error::check_range(Argument::Color, base_color, range)?;
        Error::check_range(Argument::Metallic, [metallic], range)?;
        let dielectric = DIELECTRIC as f32;
        // Rounding may exceed 1.
        let rest = 1.0 - metallic;
        let reflectance = base_color.map(|base| dielectric * rest + base * metallic);
        Self::new(roughness, reflectance.map(at_most_one), base_color.map(|base| base * rest))
    }

    /// α, the square of the roughness.
    #[must_use]
    pub const fn alpha(&self) -> f32 {
        self.alpha
    }

    /// Whether sources make pictures of this material nearer: its roughness is below
    /// [`MATTE`](Gloss::MATTE). Harmonics of degree 9 show wider lobes without sources.
    ///
    /// ```
    /// use eigenshade::Gloss;
    ///
    /// let gloss = |roughness| Gloss::new(roughness, [0.9_f32; 3], [0.0; 3]);
    /// assert!(gloss(0.3)?.needs_sources());
    /// assert!(!gloss(0.6)?.needs_sources());
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    #[must_use]
    pub fn needs_sources(&self) -> bool {
        let matte = MATTE;
        self.alpha < matte * matte
    }

    /// The fewest sources of a light with which pictures of this material are within `tolerance`, a
    /// share of white; 0 if it [needs none](Self::needs_sources), and `None` if all exceed it.
    ///
    /// `errors` has a row for no sources, for the first one, for the first two and so on, such as
    /// [`presets::sources::errors::STUDIO`](crate::presets::sources::errors::STUDIO). A row has the
    /// errors of GGX metals of the roughness of [`ROUGHNESS`](crate::index::highlights::ROUGHNESS),
    /// 0.1 to 0.6: the root mean square over a sphere's picture under its metered exposure, clipped
    /// at white, as a share of white, against direct integration of the whole light; the larger one
    /// of the light as captured and turned. The error is linear in α between the metals; a
    /// roughness below 0.1 has the error of 0.1, which is too small. A dielectric over a matte base
    /// has smaller errors. For a lobe that was fitted to another material, add the rms residual of
    /// the fit.
    ///
    /// ```
    /// # #[cfg(feature = "presets")] {
    /// use eigenshade::Gloss;
    /// use eigenshade::presets::{gloss::GOLD_METALLIC_PAINT, sources::errors::STUDIO};
    ///
    /// assert_eq!(GOLD_METALLIC_PAINT.fewest_sources(&STUDIO, 0.02), Some(2));
    /// let matte = Gloss::new(0.6, [0.04; 3], [0.8, 0.2, 0.2])?;
    /// assert_eq!(matte.fewest_sources(&STUDIO, 0.02), Some(0));
    /// # }
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    #[must_use]
    pub fn fewest_sources(&self, errors: &[[f32; 6]], tolerance: f32) -> Option<usize> {
        let fits = |row: &[f32; 6]| !self.needs_sources() || self.interpolated(row) <= tolerance;
        errors.iter().position(fits)
    }

    /// The error of this material, interpolated between the metals' errors.
    fn interpolated(&self, errors: &[f32; 6]) -> f32 {
        let [first, ..] = *errors;
        let (mut knot, mut error) = (0.0, first);
        let knots = ROUGHNESS.map(|roughness| (roughness * roughness) as f32);
        for (&next, next_knot) in errors.iter().zip(knots) {
            if self.alpha <= next_knot {
                return error + (next - error) * (self.alpha - knot) * (next_knot - knot).recip();
            }
            (knot, error) = (next_knot, next);
        }
        error
    }

    /// The reflectance at normal incidence, f0.
    #[must_use]
    pub const fn reflectance(&self) -> Rgb<f32> {
        self.reflectance
    }

    /// The reflectance at grazing incidence, f90.
    #[must_use]
    pub const fn grazing(&self) -> Rgb<f32> {
        self.grazing
    }

    /// The albedo of the matte base.
    #[must_use]
    pub const fn albedo(&self) -> Rgb<f32> {
        self.albedo
    }
}

fn at_most_one(number: f32) -> f32 {
    if number < 1.0 { number } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_are_linear_between_metals() {
        let errors = [0.05, 0.04, 0.02, 0.01, 0.005, 0.001];
        let error = |alpha: f32| {
            let gloss = Gloss::new(alpha.sqrt(), [0.9; 3], [0.0; 3]);
            gloss.map_or(f32::NAN, |gloss| gloss.interpolated(&errors))
        };
        for (alpha, expected) in [
            (0.0, 0.05),
            (0.01, 0.05),
            (0.025, 0.045),
            (0.04, 0.04),
            (0.0625, 0.031),
            (0.36, 0.001),
            (1.0, 0.001),
        ] {
            assert!((error(alpha) - expected).abs() < 1e-7, "{alpha}: {}", error(alpha));
        }
    }
}
