//! Lights, materials, normal maps and objects as C headers: a constant record for each, which the functions
//! of `eigenshade.h` take.

use super::entry::{Channel, Entry, Format, Kind, identifier};
use super::highlights::{SourcesAndGloss, numbers_of, numbers_of_gloss};
use super::{comment, float, lines};
use crate::messages::printable;
use eigenshade_model::source::{NamedGloss, Source};
use std::fmt::Write;

/// The text of the header. `guard` is the macro against including it twice.
#[must_use]
pub fn header(
    entries: &[Entry],
    highlights: Option<&SourcesAndGloss>,
    command: &str,
    guard: &str,
) -> String {
    let mut text = String::new();
    entries.iter().for_each(|entry| record(&mut text, entry));
    for (name, sources) in highlights.iter().flat_map(|one| &one.sources) {
        sources_of(&mut text, name, sources);
    }
    highlights.iter().flat_map(|one| &one.glosses).for_each(|gloss| gloss_of(&mut text, gloss));
    guarded(&text, command, guard)
}

/// The text of the header of a normal map of this name, from two bytes for each pixel.
#[must_use]
pub fn normal_map(name: &str, size: [usize; 2], codes: &[u8], command: &str) -> String {
    let mut text = "\n".to_owned();
    array(&mut text, "uint8_t", &format!("{name}_codes"), codes);
    let ([width, height], length) = (size, codes.len());
    let _ = writeln!(
        text,
        "static const eigenshade_normal_map_t {name} = {{\n  \
         {width}, {height}, {length}, {name}_codes}};"
    );
    guarded(&text, command, &format!("EIGENSHADE_{}_H", name.to_uppercase()))
}

/// The text of the header of a packed object of this type and name, from its file.
#[must_use]
pub fn object(kind: &str, name: &str, file: &[u8], command: &str) -> String {
    let mut text = "\n".to_owned();
    array(&mut text, "uint8_t", &format!("{name}_bytes"), file);
    let length = file.len();
    let _ = writeln!(text, "static const {kind} {name} = {{{length}, {name}_bytes}};");
    guarded(&text, command, &format!("EIGENSHADE_{}_H", name.to_uppercase()))
}

fn guarded(constants: &str, command: &str, guard: &str) -> String {
    let command = comment(command);
    format!(
        "/* {command} */\n\n#ifndef {guard}\n#define {guard}\n\n\
         #include \"eigenshade.h\"\n{constants}\n#endif /* {guard} */\n"
    )
}

fn record(text: &mut String, entry: &Entry) {
    let kind = entry.kind.name();
    let suffix = match entry.format {
        Format::F32 => "f32",
        Format::Q15 => "q15",
    };
    let name = format!("{kind}_{}_{suffix}", entry.identifier);
    let _ = writeln!(text, "\n/* {}: {}. */", comment(&entry.comment()), entry.kind.meaning());
    let mut channels = Vec::new();
    for (channel, values) in entry.channel_names().iter().zip(&entry.channels) {
        let list = format!("{name}_{channel}");
        let size = entry.size;
        channels.push(match values {
            Channel::Floats(numbers) => {
                array(text, "float", &list, numbers.iter().map(|&one| float(one) + "f"));
                format!("{{{size}, {}, {list}}}", numbers.len())
            }
            Channel::Integers { mantissas, exponents } => {
                array(text, "int16_t", &list, mantissas);
                let rest = match entry.kind {
                    Kind::Light => exponents.iter().map(ToString::to_string).collect(),
                    Kind::Material => {
                        let of_list = format!("{list}_exponents");
                        array(text, "int8_t", &of_list, exponents);
                        format!("{}, {of_list}", exponents.len())
                    }
                };
                format!("{{{size}, {}, {list}, {rest}}}", mantissas.len())
            }
        });
    }
    let each = (0..3).map(|c| channels[c % channels.len()].as_str()).collect::<Vec<_>>();
    let _ = writeln!(
        text,
        "static const eigenshade_color_{kind}_{suffix}_t {name} = {{\n  {}}};",
        each.join(",\n  ")
    );
}

/// The sources of a light and their number. C has no empty arrays: no sources are a null pointer.
fn sources_of(text: &mut String, light: &str, sources: &[Source]) {
    let (name, count) = (format!("sources_{}", identifier(light)), sources.len());
    let comment = comment(&printable(light));
    let _ = writeln!(
        text,
        "\n/* `{comment}`: {count} small sources. */\nenum {{ {name}_count = {count} }};"
    );
    let record = "static const eigenshade_source_f32_t";
    if sources.is_empty() {
        let _ = writeln!(text, "{record} *const {name}_f32 = 0;");
        return;
    }
    let _ = writeln!(text, "{record} {name}_f32[] = {{");
    for numbers in sources.iter().map(numbers_of) {
        let [direction, energy] = [0, 3].map(|k| vector(&numbers[k..k + 3]));
        let spread = float(numbers[6]);
        let _ = writeln!(text, "  {{{direction}, {energy}, {spread}f}},");
    }
    text.push_str("};\n");
}

fn gloss_of(text: &mut String, NamedGloss { name, gloss, error }: &NamedGloss) {
    let numbers = numbers_of_gloss(gloss);
    let roughness = float(numbers[0]);
    let colors = [1, 4, 7].map(|k| vector(&numbers[k..k + 3])).join(",\n  ");
    let _ = writeln!(
        text,
        "\n/* `{}`: gloss, which leaves {:.0} % of pictures under a small source (rms). */\n\
         static const eigenshade_gloss_f32_t gloss_{}_f32 = {{\n  {roughness}f,\n  {colors}}};",
        comment(&printable(name)),
        100.0 * error,
        identifier(name)
    );
}

fn vector(numbers: &[f32]) -> String {
    let numbers: Vec<String> = numbers.iter().map(|&number| float(number) + "f").collect();
    format!("{{{}}}", numbers.join(", "))
}

fn array<T: std::fmt::Display>(
    text: &mut String,
    number: &str,
    name: &str,
    numbers: impl IntoIterator<Item = T>,
) {
    let list = lines(numbers, 2);
    let _ =
        writeln!(text, "static const {number} {name}[] = {{\n{}}};", list.trim_end_matches(','));
}
