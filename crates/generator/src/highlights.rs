//! The small sources of a scene's lights and the gloss of its materials, as Rust constants.

use eigenshade_model::source::{Gloss, NamedGloss, Source, SourceSets};
use std::fmt::Write;

/// What highlights of a scene need.
#[derive(Clone, Debug, PartialEq)]
pub struct Highlights {
    /// The most sources of a light.
    pub most: usize,
    /// The sources of the lights that have some.
    pub sources: Vec<SourceSets>,
    /// The gloss of the materials of which it is known.
    pub glosses: Vec<NamedGloss>,
    /// Lights without sources, such as those that no map is known of.
    pub dark: Vec<String>,
    /// Materials without gloss.
    pub without_gloss: Vec<String>,
}

impl Highlights {
    /// The modules `sources` and `gloss`: data alone, to which the runtime's types are made at run
    /// time.
    #[must_use]
    pub fn text(&self) -> String {
        let expect =
            "    #![allow(clippy::approx_constant, clippy::type_complexity, reason = \"data\")]\n";
        let mut text = format!(
            "/// Small sources, at most {} of a light.\npub mod sources {{\n{expect}\
             \n    /// Direction, energy, major axis and minor spread, as `eigenshade::Source::new` takes \
             them.\n    pub type Record = ([f32; 3], [f32; 3], [f32; 3], f32);\n\
             \n    /// By the name of the light.\n    pub const ALL: &[(&str, &[Record])] = &[\n",
            self.most
        );
        for sets in &self.sources {
            let _ = writeln!(text, "        ({:?}, &[", sets.name);
            for &Source { direction, energy, major, minor } in sets.of_most(self.most) {
                let [direction, energy, major] = [direction, energy, major].map(rounded);
                let minor = minor as f32;
                let _ = writeln!(
                    text,
                    "            ({direction:?}, {energy:?}, {major:?}, {minor:?}),"
                );
            }
            text += "        ]),\n";
        }
        let _ = write!(
            text,
            "    ];\n}}\n/// The gloss of materials.\npub mod gloss {{\n{expect}\
             \n    /// Roughness, f0 and albedo, as `eigenshade::Gloss::new` takes them, and f90, as \
             `with_grazing` does.\n    pub type Record = (f32, [f32; 3], [f32; 3], [f32; 3]);\n\
             \n    /// By the name of the material.\n    pub const ALL: &[(&str, Record)] = &[\n"
        );
        for NamedGloss { name, gloss, .. } in &self.glosses {
            let Gloss { roughness, reflectance, grazing, albedo } = *gloss;
            let [f0, albedo, f90] = [reflectance, albedo, grazing].map(rounded);
            let roughness = roughness as f32;
            let _ =
                writeln!(text, "        ({name:?}, ({roughness:?}, {f0:?}, {albedo:?}, {f90:?})),");
        }
        text + "    ];\n}\n"
    }

    /// A line for each kind of thing that is missing: sources, or gloss.
    #[must_use]
    pub fn warnings(&self) -> Vec<String> {
        let lines = [
            ("no sources of the lights", &self.dark, "they are not in `highlights.sources`"),
            (
                "no gloss of the materials",
                &self.without_gloss,
                "they are not in `highlights.gloss`",
            ),
        ];
        let missing = lines.into_iter().filter(|(_, names, _)| !names.is_empty());
        missing.map(|(what, names, why)| format!("{what} {}: {why}", names.join(", "))).collect()
    }
}

fn rounded(vector: [f64; 3]) -> [f32; 3] {
    vector.map(|number| number as f32)
}
