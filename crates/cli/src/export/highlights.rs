//! What sharp highlights need of lights and materials.

use eigenshade_model::source::{Gloss, NamedGloss, Source};

/// Small sources of lights, and the gloss of materials.
#[derive(Debug, Default)]
pub struct SourcesAndGloss {
    /// Names of lights, and their sources.
    pub sources: Vec<(String, Vec<Source>)>,
    /// The gloss of the materials.
    pub glosses: Vec<NamedGloss>,
}

impl SourcesAndGloss {
    /// The sources of a light as seven numbers each: see [`numbers_of`].
    #[must_use]
    pub fn sources_of(&self, light: &str) -> Vec<f32> {
        let of_light = self.sources.iter().filter(|(name, _)| name == light);
        of_light.flat_map(|(_, sources)| sources).flat_map(numbers_of).collect()
    }

    /// The ten numbers of the gloss of a material: roughness, then reflectance, reflectance at
    /// grazing incidence and albedo by channel.
    #[must_use]
    pub fn gloss_of(&self, material: &str) -> Vec<f32> {
        let of_material = self.glosses.iter().filter(|one| one.name == material);
        of_material.flat_map(|one| numbers_of_gloss(&one.gloss)).collect()
    }
}

/// Direction, energy and spread.
#[must_use]
pub fn numbers_of(source: &Source) -> [f32; 7] {
    let Source { direction: [x, y, z], energy: [r, g, b], spread } = *source;
    [x, y, z, r, g, b, spread].map(|number| number as f32)
}

/// As [`SourcesAndGloss::gloss_of`].
#[must_use]
pub fn numbers_of_gloss(gloss: &Gloss) -> [f32; 10] {
    let Gloss { roughness, reflectance, grazing, albedo } = *gloss;
    let ([a, b, c], [d, e, f], [g, h, i]) = (reflectance, grazing, albedo);
    [roughness, a, b, c, d, e, f, g, h, i].map(|number| number as f32)
}
