//! Small sources of lights and the gloss of materials, as source in a programming language.

use super::entry::identifier;
use super::source::{comment, float};
use eigenshade_model::source::{Gloss, NamedGloss, Source, SourceSets};
use eigenshade_model::source_text::modules;
use std::fmt::Write;

/// What sharp highlights need.
#[derive(Debug, Default)]
pub struct Highlights {
    /// The most sources of a light.
    pub most: usize,
    /// The sources of the lights.
    pub sources: Vec<SourceSets>,
    /// The gloss of the materials.
    pub glosses: Vec<NamedGloss>,
}

impl Highlights {
    /// The sources of a light, ten numbers each: direction, energy, major axis and minor spread.
    #[must_use]
    pub fn sources_of(&self, light: &str) -> Vec<f32> {
        let sets = self.sources.iter().filter(|sets| sets.name == light);
        sets.flat_map(|sets| sets.of_most(self.most)).flat_map(of_source).collect()
    }

    /// The ten numbers of the gloss of a material: roughness, then reflectance, reflectance at
    /// grazing incidence and albedo by channel.
    #[must_use]
    pub fn gloss_of(&self, material: &str) -> Vec<f32> {
        let gloss = self.glosses.iter().filter(|one| one.name == material);
        gloss.flat_map(|one| of_gloss(&one.gloss)).collect()
    }
}

/// Rust: modules `sources` and `gloss`.
#[must_use]
pub fn rust(highlights: &Highlights) -> String {
    format!("\n{}", modules(highlights.most, &highlights.sources, &highlights.glosses))
}

fn of_source(source: &Source) -> [f32; 10] {
    let Source { direction: [x, y, z], energy: [r, g, b], major: [u, v, w], minor } = *source;
    [x, y, z, r, g, b, u, v, w, minor].map(|number| number as f32)
}

fn of_gloss(gloss: &Gloss) -> [f32; 10] {
    let Gloss { roughness, reflectance, grazing, albedo } = *gloss;
    let ([a, b, c], [d, e, f], [g, h, i]) = (reflectance, grazing, albedo);
    [roughness, a, b, c, d, e, f, g, h, i].map(|number| number as f32)
}

/// C: arrays of `eigenshade_source_f32_t`, and `eigenshade_gloss_f32_t`.
#[must_use]
pub fn c(highlights: &Highlights) -> String {
    let mut text = String::new();
    let vector = |numbers: &[f32]| {
        let numbers: Vec<String> = numbers.iter().map(|&number| float(number) + "f").collect();
        format!("{{{}}}", numbers.join(", "))
    };
    // A light whose sources do not pay has none, and C has no empty arrays.
    let some = |sets: &&SourceSets| !sets.of_most(highlights.most).is_empty();
    for sets in highlights.sources.iter().filter(some) {
        let (name, most) = (comment(&sets.name), highlights.most);
        let _ = writeln!(
            text,
            "\n/* `{name}`: at most {most} small sources. */\n\
             static const eigenshade_source_f32_t sources_{}_f32[] = {{",
            identifier(&sets.name)
        );
        for source in sets.of_most(most) {
            let numbers = of_source(source);
            let [direction, energy, major] = [0, 3, 6].map(|k| vector(&numbers[k..k + 3]));
            let minor = float(numbers[9]);
            let _ = writeln!(text, "  {{{direction}, {energy},\n   {major}, {minor}f}},");
        }
        text += "};\n";
    }
    for NamedGloss { name, gloss, .. } in &highlights.glosses {
        let numbers = of_gloss(gloss);
        let roughness = float(numbers[0]);
        let colors = [1, 4, 7].map(|k| vector(&numbers[k..k + 3])).join(",\n  ");
        let _ = writeln!(
            text,
            "\n/* `{}`: gloss. */\n\
             static const eigenshade_gloss_f32_t gloss_{}_f32 = {{\n  {roughness}f,\n  {colors}}};",
            comment(name),
            identifier(name)
        );
    }
    text
}
