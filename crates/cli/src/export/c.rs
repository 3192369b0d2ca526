//! Lights and materials as a C header: a constant record for each, which the functions of
//! `eigenshade_color.h` take.

use super::entry::{Channel, Entry, Format, Kind};
use super::source::{comment, float, lines};
use std::fmt::Write;

/// The text of the header. `guard` is the macro against including it twice.
#[must_use]
pub fn header(entries: &[Entry], format: Format, command: &str, guard: &str) -> String {
    let command = comment(command);
    let mut text = format!(
        "/* {command} */\n\n#ifndef {guard}\n#define {guard}\n\n#include \"eigenshade_color.h\"\n"
    );
    entries.iter().for_each(|entry| record(&mut text, entry, format));
    let _ = writeln!(text, "\n#endif /* {guard} */");
    text
}

fn record(text: &mut String, entry: &Entry, format: Format) {
    let kind = entry.kind.name();
    let suffix = match format {
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
