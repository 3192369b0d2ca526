//! Lights and materials as Rust source: modules `light` and `material` of constants, like those of
//! `eigenshade::presets`, and `sources` and `gloss` for highlights.

use super::entry::{Channel, Entry, Format, Kind};
use super::highlights::SourcesAndGloss;
use super::{float, lines};
use eigenshade_model::highlight_constants::modules;
use std::fmt::Write;

/// The text of the module. `command` appears in its first line.
#[must_use]
pub fn module(entries: &[Entry], highlights: Option<&SourcesAndGloss>, command: &str) -> String {
    let mut text = format!("// {command}\n");
    for kind in [Kind::Light, Kind::Material] {
        let of_kind: Vec<&Entry> = entries.iter().filter(|entry| entry.kind == kind).collect();
        let Some(format) = of_kind.first().map(|entry| entry.format) else { continue };
        let (name, record) = (kind.name(), record(kind));
        let _ = write!(
            text,
            "\n/// {}.\npub mod {name} {{\n{}",
            kind.meaning(),
            match format {
                Format::F32 => format!(
                    "    use eigenshade::specialized::checked;\n    \
                     use eigenshade::{{{record}, Rgb}};\n"
                ),
                Format::Q15 => format!(
                    "    use eigenshade::q15::{record};\n    \
                     use eigenshade::specialized::checked;\n    \
                     use eigenshade::{{Q15, Rgb}};\n"
                ),
            }
        );
        of_kind.into_iter().for_each(|entry| constant(&mut text, entry));
        text.push_str("}\n");
    }
    if let Some(SourcesAndGloss { sources, glosses }) = highlights {
        let sources = sources.iter().map(|(name, sources)| (name.as_str(), sources.as_slice()));
        let _ = write!(text, "\n{}", modules(&sources.collect::<Vec<_>>(), glosses));
    }
    text
}

fn record(kind: Kind) -> &'static str {
    match kind {
        Kind::Light => "Light",
        Kind::Material => "Material",
    }
}

fn constant(text: &mut String, entry: &Entry) {
    let digit = entry.identifier.starts_with(|letter: char| letter.is_ascii_digit());
    let name = format!("{}{}", if digit { "_" } else { "" }, entry.identifier.to_uppercase());
    let record = record(entry.kind);
    let number = match entry.format {
        Format::F32 => "f32",
        Format::Q15 => "Q15",
    };
    let lint = "#[allow(clippy::approx_constant, reason = \"numbers of a file\")]";
    let _ = write!(
        text,
        "\n    /// {}.\n    {lint}\n    pub const {name}: Rgb<{record}<'static>> = {{\n",
        entry.comment()
    );
    let mut made = Vec::new();
    for (channel, values) in entry.channel_names().iter().zip(&entry.channels) {
        let channel = channel.to_uppercase();
        let numbers: Vec<String> = match values {
            Channel::Floats(numbers) => numbers.iter().copied().map(float).collect(),
            Channel::Integers { mantissas, .. } => {
                mantissas.iter().map(|mantissa| format!("Q15({mantissa})")).collect()
            }
        };
        list(text, &channel, number, &numbers);
        let exponents = match (values, entry.kind) {
            (Channel::Floats(_), _) => String::new(),
            (Channel::Integers { exponents, .. }, Kind::Light) => {
                exponents.iter().map(|exponent| format!("{exponent}, ")).collect()
            }
            (Channel::Integers { exponents, .. }, Kind::Material) => {
                list(text, &format!("{channel}_EXPONENTS"), "i8", exponents);
                format!("&{channel}_EXPONENTS, ")
            }
        };
        let new = if entry.format == Format::F32 { "from_finite" } else { "new" };
        made.push(format!("checked({record}::{new}({exponents}&{channel}))"));
    }
    let value = match made.as_slice() {
        [gray] => format!("Rgb::gray({gray})"),
        _ => format!("Rgb::new(\n            {},\n        )", made.join(",\n            ")),
    };
    let _ = write!(text, "        {value}\n    }};\n");
}

fn list<T: std::fmt::Display>(text: &mut String, name: &str, number: &str, numbers: &[T]) {
    let _ = write!(
        text,
        "        #[rustfmt::skip]\n        static {name}: [{number}; {}] = [\n{}\n        ];\n",
        numbers.len(),
        lines(numbers, 12)
    );
}
