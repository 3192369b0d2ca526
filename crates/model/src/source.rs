//! Small bright sources of a light, and the gloss of the materials that reflect them.

use crate::inputs::coefficient_text::significant;
use crate::screen::ScreenError;
use eigenshade_table::highlights::{MATTE, ROUGHNESS, SMOOTHEST};

/// A round blob of light on the sphere of directions: see the runtime's `Source`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Source {
    /// The unit vector toward the source.
    pub direction: [f64; 3],
    /// The integral of radiance over solid angle, by channel.
    pub energy: [f64; 3],
    /// The standard deviation along every direction in radians.
    pub spread: f64,
}

impl Source {
    /// This source after a rotation by a row-major matrix.
    #[must_use]
    pub fn turned(&self, matrix: [[f64; 3]; 3]) -> Self {
        let turn = |[x, y, z]: [f64; 3]| matrix.map(|[a, b, c]| a * x + b * y + c * z);
        Self { direction: turn(self.direction), ..*self }
    }

    /// This source with its numbers rounded to significant digits, for smaller files.
    #[must_use]
    pub fn rounded(&self, digits: usize) -> Self {
        let round = |number: f64| significant(number, digits);
        Self {
            direction: self.direction.map(round),
            energy: self.energy.map(round),
            spread: round(self.spread),
        }
    }
}

/// The sources of one light.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NamedSources {
    /// The name of the light.
    pub name: String,
    /// The sources in the order of their worth: the first n are the best n of this list.
    pub sources: Vec<Source>,
}

impl NamedSources {
    /// The first `most` sources, or all if there are fewer.
    #[must_use]
    pub fn first(&self, most: usize) -> &[Source] {
        &self.sources[..most.min(self.sources.len())]
    }
}

/// A GGX lobe over a matte base: see the runtime's `Gloss`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gloss {
    /// The perceptual roughness, 0 to 1.
    pub roughness: f64,
    /// The reflectance at normal incidence by channel, 0 to 1.
    pub reflectance: [f64; 3],
    /// The reflectance at grazing incidence by channel, 0 to 1.
    pub grazing: [f64; 3],
    /// The albedo of the base by channel, 0 to 1.
    pub albedo: [f64; 3],
}

impl Gloss {
    /// α, the square of the roughness, which counts as at least
    /// [`SMOOTHEST`].
    #[must_use]
    pub fn alpha(&self) -> f64 {
        self.roughness.max(SMOOTHEST).powi(2)
    }

    /// Whether sources make pictures of this material nearer: its roughness is below
    /// [`MATTE`].
    #[must_use]
    pub fn needs_sources(&self) -> bool {
        self.alpha() < MATTE * MATTE
    }
}

/// The gloss of one material.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedGloss {
    /// The name of the material.
    pub name: String,
    /// The lobe that is nearest.
    pub gloss: Gloss,
    /// The error of pictures under a small source by this lobe: the root mean square, relative to
    /// the picture.
    pub error: f64,
}

/// The kind of a GGX material: what is below its lobe.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Base {
    /// A metal of reflectance 1, which has nothing below.
    Metal,
    /// A dielectric of reflectance 0.04 over a matte base of albedo 0.5.
    Dielectric,
}

impl Base {
    /// Both kinds.
    pub const ALL: [Self; 2] = [Self::Metal, Self::Dielectric];

    /// The name in files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Metal => "metal",
            Self::Dielectric => "dielectric",
        }
    }

    /// The kind that is nearer to a gloss: a metal, if its lobe reflects more than its base.
    #[must_use]
    pub fn of(gloss: &Gloss) -> Self {
        let sum = |channels: [f64; 3]| channels.iter().sum::<f64>();
        let is_metal = sum(gloss.reflectance) > sum(gloss.albedo);
        if is_metal { Self::Metal } else { Self::Dielectric }
    }
}

/// The errors of pictures of GGX materials under one light with its first sources.
#[derive(Clone, Debug, PartialEq)]
pub struct SourceError {
    /// The name of the light.
    pub light: String,
    /// The number of sources.
    pub sources: usize,
    /// Degree and order.
    pub size: (usize, usize),
    /// The kind of the materials.
    pub base: Base,
    /// For each of [`ROUGHNESS`], against direct
    /// integration, with the window that `eigenshade render` chooses.
    pub errors: [ScreenError; 6],
}

impl SourceError {
    /// The errors of a material, linear in α between the roughnesses. A roughness beyond 0.6 has
    /// the errors of 0.6, a roughness below 0.1 the errors of 0.1.
    #[must_use]
    pub fn of(&self, gloss: &Gloss) -> ScreenError {
        let knots = ROUGHNESS.map(|roughness| roughness * roughness);
        let alpha = gloss.alpha().clamp(knots[0], knots[knots.len() - 1]);
        let next = knots.partition_point(|knot| *knot < alpha).max(1);
        let share = (alpha - knots[next - 1]) / (knots[next] - knots[next - 1]);
        let [before, after] = [self.errors[next - 1], self.errors[next]];
        let between = |of: fn(ScreenError) -> f64| of(before) + share * (of(after) - of(before));
        ScreenError {
            mean: between(|errors| errors.mean),
            p95: between(|errors| errors.p95),
            white: between(|errors| errors.white),
        }
    }
}
