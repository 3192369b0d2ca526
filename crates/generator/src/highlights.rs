//! The small sources of a scene's lights and the gloss of its materials, as Rust constants.

use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::highlight_constants::modules;
use eigenshade_model::inputs::gloss_csv::read_glosses;
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::inputs::source_csv::read_sources;
use eigenshade_model::source::{NamedGloss, NamedSources};
use serde::Deserialize;

/// The section `[highlights]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct HighlightFiles {
    pub sources: String,
    pub gloss: String,
    pub most: usize,
}

/// What highlights of a scene need.
#[derive(Clone, Debug, PartialEq)]
pub struct Highlights {
    /// The most sources of a light.
    pub most: usize,
    /// The sources of the lights that have some.
    pub sources: Vec<NamedSources>,
    /// The gloss of the materials of which it is known.
    pub glosses: Vec<NamedGloss>,
    /// Lights without sources, such as those that no map is known of.
    pub dark: Vec<String>,
    /// Materials without gloss.
    pub without_gloss: Vec<String>,
}

impl Highlights {
    /// The sources of the lights and the gloss of the materials, as far as they are known.
    ///
    /// # Errors
    ///
    /// If a file cannot be read, or no light has sources, or no material a gloss.
    pub(crate) fn read(
        files: &HighlightFiles,
        scene: &InputFile,
        lights: &Lights,
        materials: &Materials,
    ) -> Result<Self> {
        let folder = scene.folder();
        let [of_sources, of_gloss] = [&files.sources, &files.gloss].map(|name| folder.join(name));
        let mut sources = read_sources(scene.other(&of_sources))?;
        let mut glosses = read_glosses(scene.other(&of_gloss))?;
        let is_in = |entries: &[Named], name: &str| entries.iter().any(|entry| entry.name == name);
        sources.retain(|light| is_in(&lights.entries, &light.name));
        glosses.retain(|gloss| is_in(&materials.entries, &gloss.name));
        if sources.is_empty() {
            let remedy = "find them with `eigenshade light MAP --sources 8 --out FILE.csv`, or remove \
                          [highlights]";
            return Err(
                Error::new("it has sources of no light of the scene", remedy).in_file(of_sources)
            );
        }
        if glosses.is_empty() {
            let remedy =
                "make it with `eigenshade material .. --out FILE.csv`, or remove [highlights]";
            return Err(Error::new("it has the gloss of no material of the scene", remedy)
                .in_file(of_gloss));
        }
        let others = |entries: &[Named], has: &dyn Fn(&str) -> bool| {
            let names = entries.iter().map(|entry| entry.name.clone());
            names.filter(|name| !has(name)).collect()
        };
        Ok(Self {
            most: files.most,
            dark: others(&lights.entries, &|name| sources.iter().any(|light| light.name == name)),
            without_gloss: others(&materials.entries, &|name| {
                glosses.iter().any(|one| one.name == name)
            }),
            sources,
            glosses,
        })
    }

    /// The modules `sources` and `gloss`: data alone, of which the runtime's types are made at run
    /// time.
    #[must_use]
    pub fn text(&self) -> String {
        let sources = self.sources.iter();
        let sources = sources.map(|light| (light.name.as_str(), light.first(self.most)));
        modules(&sources.collect::<Vec<_>>(), &self.glosses)
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
