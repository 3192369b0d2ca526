//! Small sources and gloss as Rust constants.

use crate::source::{Gloss, NamedGloss, Source};
use std::fmt::Write;

const EXPECT: &str =
    "    #![allow(clippy::approx_constant, clippy::type_complexity, reason = \"data\")]\n";

/// The modules `sources`, with the sources of each light by its name, and `gloss`, as far as there
/// are some. The modules hold data alone, of which the runtime's types are made at run time.
#[must_use]
pub fn modules(sources: &[(&str, &[Source])], glosses: &[NamedGloss]) -> String {
    let mut text = String::new();
    if !sources.is_empty() {
        of_sources(&mut text, sources);
    }
    if !glosses.is_empty() {
        of_glosses(&mut text, glosses);
    }
    text
}

fn of_sources(text: &mut String, sources: &[(&str, &[Source])]) {
    let _ = write!(
        text,
        "/// Small sources of lights.\npub mod sources {{\n{EXPECT}\
         \n    /// Direction, energy and spread: the arguments of `eigenshade::Source::new`.\n    \
         pub type Record = ([f32; 3], [f32; 3], f32);\n\
         \n    /// By the name of the light.\n    pub const ALL: &[(&str, &[Record])] = &[\n"
    );
    for (name, of_light) in sources {
        let _ = writeln!(text, "        ({name:?}, &[");
        for &Source { direction, energy, spread } in *of_light {
            let [direction, energy] = [direction, energy].map(rounded);
            let spread = spread as f32;
            let _ = writeln!(text, "            ({direction:?}, {energy:?}, {spread:?}),");
        }
        text.push_str("        ]),\n");
    }
    text.push_str("    ];\n}\n");
}

fn of_glosses(text: &mut String, glosses: &[NamedGloss]) {
    let _ = write!(
        text,
        "/// The gloss of materials.\npub mod gloss {{\n{EXPECT}\
         \n    /// Roughness, reflectance and albedo: the arguments of `eigenshade::Gloss::new`; then \
         that of\n    /// `with_grazing`.\n    \
         pub type Record = (f32, [f32; 3], [f32; 3], [f32; 3]);\n\
         \n    /// By the name of the material.\n    pub const ALL: &[(&str, Record)] = &[\n"
    );
    for NamedGloss { name, gloss, .. } in glosses {
        let Gloss { roughness, reflectance, grazing, albedo } = *gloss;
        let [reflectance, albedo, grazing] = [reflectance, albedo, grazing].map(rounded);
        let roughness = roughness as f32;
        let _ = writeln!(
            text,
            "        ({name:?}, ({roughness:?}, {reflectance:?}, {albedo:?}, {grazing:?})),"
        );
    }
    text.push_str("    ];\n}\n");
}

fn rounded(vector: [f64; 3]) -> [f32; 3] {
    vector.map(|number| number as f32)
}
