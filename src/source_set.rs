//! Sets of sources of different sizes, and the choice of one for a tolerance.

use crate::gloss::Gloss;
use crate::index::highlights::ROUGHNESS;
use crate::source::Source;

/// A set of sources of a light, with the errors of pictures that use it.
///
/// An error is the root mean square over a sphere's picture under its metered exposure, clipped at
/// white, as a share of white, against direct integration of the whole light. Errors are those of
/// GGX metals, as measured: the larger one of the light as captured and turned. A dielectric over a
/// matte base has smaller ones. For a lobe that was fitted to another material, add what the fit
/// leaves.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SourceSet<'a> {
    sources: &'a [Source],
    errors: [f32; 6],
}

impl<'a> SourceSet<'a> {
    /// The sources, and the errors for metals of the roughness of
    /// [`ROUGHNESS`](eigenshade_table::highlights::ROUGHNESS), 0.1 to 0.6: shares of white, 0 or
    /// more, which is not checked.
    #[must_use]
    pub const fn new(sources: &'a [Source], errors: [f32; 6]) -> Self {
        Self { sources, errors }
    }

    /// The sources.
    #[must_use]
    pub const fn sources(&self) -> &'a [Source] {
        self.sources
    }

    /// The error of pictures of a material, linear in α between the metals. Beyond a roughness of
    /// 0.6 it is that of 0.6, and so too large; below 0.1 it is that of 0.1, and so too small.
    #[must_use]
    pub fn error(&self, gloss: &Gloss) -> f32 {
        let [first, ..] = self.errors;
        let (mut knot, mut error) = (0.0, first);
        let knots = ROUGHNESS.map(|roughness| (roughness * roughness) as f32);
        for (&next, next_knot) in self.errors.iter().zip(knots) {
            if gloss.alpha() <= next_knot {
                let width = (next_knot - knot).recip();
                return error + (next - error) * (gloss.alpha() - knot) * width;
            }
            (knot, error) = (next_knot, next);
        }
        error
    }

    /// The first of some sets whose error is at most `tolerance`, or `None` if all exceed it; the
    /// very first for a material that [needs no sources](Gloss::needs_sources). Order the
    /// sets by their number of sources; the first may have none.
    ///
    /// ```
    /// # #[cfg(feature = "presets")] {
    /// use eigenshade::presets::{gloss::GOLD_METALLIC_PAINT, sources::STUDIO};
    /// use eigenshade::{Gloss, SourceSet};
    ///
    /// let set = SourceSet::within(&STUDIO, &GOLD_METALLIC_PAINT, 0.01);
    /// assert_eq!(set.map(|set| set.sources().len()), Some(4));
    /// let matte = Gloss::new(0.6, [0.04; 3], [0.8, 0.2, 0.2])?;
    /// let set = SourceSet::within(&STUDIO, &matte, 0.01);
    /// assert_eq!(set.map(|set| set.sources().len()), Some(0));
    /// # }
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    #[must_use]
    pub fn within(sets: &[Self], gloss: &Gloss, tolerance: f32) -> Option<Self> {
        let fits = |set: &&Self| !gloss.needs_sources() || set.error(gloss) <= tolerance;
        sets.iter().find(fits).copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_are_linear_between_metals() {
        let set = SourceSet::new(&[], [0.05, 0.04, 0.02, 0.01, 0.005, 0.001]);
        let error = |alpha: f32| {
            let gloss = Gloss::new(alpha.sqrt(), [0.9; 3], [0.0; 3]);
            gloss.map_or(f32::NAN, |gloss| set.error(&gloss))
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
