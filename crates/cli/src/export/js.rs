//! Lights and materials as a JavaScript module: typed arrays for the web package.

use super::entry::{Channel, Entry, Kind};
use super::highlights::SourcesAndGloss;
use super::{float, lines};
use std::fmt::Write;

/// The text of the module: objects `lights` and `materials` by name, with the channels r, g and b,
/// and the `sources` and `gloss` of highlights.
#[must_use]
pub fn module(entries: &[Entry], highlights: Option<&SourcesAndGloss>, command: &str) -> String {
    let mut text = format!("// {command}\n");
    for kind in [Kind::Light, Kind::Material] {
        let of_kind: Vec<&Entry> = entries.iter().filter(|entry| entry.kind == kind).collect();
        if of_kind.is_empty() {
            continue;
        }
        let _ = writeln!(text, "\n/** {}. */\nexport const {}s = {{", kind.meaning(), kind.name());
        of_kind.into_iter().for_each(|entry| object(&mut text, entry, highlights));
        text.push_str("};\n");
    }
    text
}

fn object(text: &mut String, entry: &Entry, highlights: Option<&SourcesAndGloss>) {
    let name = serde_json::Value::from(entry.name.as_str());
    let _ = writeln!(text, "  // {}\n  {name}: {{", entry.comment());
    for (place, channel) in ["r", "g", "b"].into_iter().enumerate() {
        if let Some(Channel::Floats(numbers)) = entry.channels.get(place % entry.channels.len()) {
            let list = lines(numbers.iter().copied().map(float), 6);
            let _ = writeln!(text, "    {channel}: new Float32Array([\n{list}\n    ]),");
        }
    }
    if let Some(highlights) = highlights {
        let of_sources = "Small sources: direction, energy and spread of each.";
        let of_gloss = "Roughness, then reflectance, the same at grazing incidence, and albedo.";
        let (name, meaning, numbers) = match entry.kind {
            Kind::Light => ("sources", of_sources, highlights.sources_of(&entry.name)),
            Kind::Material => ("gloss", of_gloss, highlights.gloss_of(&entry.name)),
        };
        let list = lines(numbers.into_iter().map(float), 6);
        let _ = writeln!(text, "    // {meaning}\n    {name}: new Float32Array([\n{list}\n    ]),");
    }
    text.push_str("  },\n");
}
