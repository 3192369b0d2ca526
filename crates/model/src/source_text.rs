//! Small sources and gloss as Rust constants.

use crate::source::{Gloss, NamedGloss, Source, SourceSets};
use std::fmt::Write;

/// The modules `sources`, with at most this many of each light, and `gloss`. One without entries is
/// empty. They are data alone, of which the runtime's types are made at run time.
#[must_use]
pub fn modules(most: usize, sources: &[SourceSets], glosses: &[NamedGloss]) -> String {
    let expect =
        "    #![allow(clippy::approx_constant, clippy::type_complexity, reason = \"data\")]\n";
    let mut text = format!(
        "/// Small sources, at most {most} of a light.\npub mod sources {{\n{expect}\
         \n    /// Direction, energy, major axis and minor spread, as `eigenshade::Source::new` takes \
         them.\n    pub type Record = ([f32; 3], [f32; 3], [f32; 3], f32);\n\
         \n    /// By the name of the light.\n    pub const ALL: &[(&str, &[Record])] = &[\n"
    );
    for sets in sources {
        let _ = writeln!(text, "        ({:?}, &[", sets.name);
        for &Source { direction, energy, major, minor } in sets.of_most(most) {
            let [direction, energy, major] = [direction, energy, major].map(rounded);
            let minor = minor as f32;
            let _ =
                writeln!(text, "            ({direction:?}, {energy:?}, {major:?}, {minor:?}),");
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
    for NamedGloss { name, gloss, .. } in glosses {
        let Gloss { roughness, reflectance, grazing, albedo } = *gloss;
        let [f0, albedo, f90] = [reflectance, albedo, grazing].map(rounded);
        let roughness = roughness as f32;
        let _ = writeln!(text, "        ({name:?}, ({roughness:?}, {f0:?}, {albedo:?}, {f90:?})),");
    }
    text + "    ];\n}\n"
}

fn rounded(vector: [f64; 3]) -> [f32; 3] {
    vector.map(|number| number as f32)
}
