//! Writes the shipped lights and materials as constants with names.

use crate::files::{read_lines, write_output};
use eigenshade_table::{light, material};

/// The degree of the lights and the order of the materials: those of the shipped table.
const DEGREE: usize = 9;
const ORDER: usize = 7;

/// The one gray material that is not from a set in color.
const GRAY: &str = "ptfe-633nm";

/// Writes `preset_lights.rs`, `preset_materials.rs` and both in integers, `preset_sources.rs` and
/// `preset_gloss.rs` to the output folder.
///
/// # Errors
///
/// If a file cannot be read, or a preset lacks coefficients.
pub fn write() -> Result<(), String> {
    let lights = read("tables/inputs/lights.csv", light::count(DEGREE))?;
    constants("Light", &lights, |_| String::new())?;
    let mut materials = read("tables/inputs/merl.csv", material::count(ORDER))?;
    let gray = read("tables/inputs/materials.csv", material::count(ORDER))?;
    materials.extend(gray.into_iter().filter(|one| one.name == GRAY));
    let errors = read_lines(ERRORS)?;
    constants("Material", &materials, |name| error_text(&errors, name))?;
    sources()?;
    glosses()
}

/// Screen errors: name, degree, order, sources, then the mean and the 95th percentile of the
/// pixels, each the median over the maps and what 95 of 100 maps do not exceed; and a map.
const ERRORS: &str = "tables/inputs/merl.errors.csv";

/// The screen error, as a constant's documentation states it.
fn error_text(errors: &[String], name: &str) -> String {
    let rows: Vec<Vec<&str>> = errors.iter().map(|line| line.split(',').collect()).collect();
    let of = |sources: &str| {
        let key = [name, "9", "7", sources];
        let row = rows.iter().find(|row| row.len() == 9 && row[..4] == key)?;
        Some(format!("{} (95 of 100 pixels within {})", row[4], row[6]))
    };
    match (of("0"), of("8")) {
        (Some(none), Some(most)) => format!(
            " Screen error of its pictures, CIEDE2000, median of 18 maps: {none}; with up to 8 \
             sources {most}."
        ),
        _ => String::new(),
    }
}

/// Lines of numbers that share a name: one number a line if gray, otherwise three.
struct Preset {
    name: String,
    channels: Vec<Vec<String>>,
}

/// The first `count` coefficients of each name in a file of `name,index...,value` or `...,r,g,b`.
fn read(path: &str, count: usize) -> Result<Vec<Preset>, String> {
    let lines = read_lines(path)?;
    let (header, lines) = lines.split_first().ok_or_else(|| format!("{path}: empty"))?;
    let width = if header.ends_with(",r,g,b") { 3 } else { 1 };
    let mut presets: Vec<Preset> = Vec::new();
    for line in lines {
        let fields: Vec<&str> = line.split(',').collect();
        let name = fields[0];
        if presets.last().is_none_or(|last| last.name != name) {
            presets.push(Preset { name: name.into(), channels: vec![Vec::new(); width] });
        }
        let Some(Preset { channels, .. }) = presets.last_mut() else { continue };
        for (channel, field) in channels.iter_mut().zip(&fields[fields.len() - width..]) {
            if channel.len() < count {
                let number: f32 = field.parse().map_err(|_| format!("{path}: `{line}`"))?;
                channel.push(format!("{number:?}"));
            }
        }
    }
    match presets.iter().find(|one| one.channels.iter().any(|channel| channel.len() != count)) {
        Some(Preset { name, .. }) => Err(format!("{path}: `{name}` has fewer than {count} lines")),
        None => Ok(presets),
    }
}

/// Writes the constants of one kind, in floats and in integers, and a list of all of them.
fn constants(kind: &str, presets: &[Preset], error: impl Fn(&str) -> String) -> Result<(), String> {
    let lower = kind.to_lowercase();
    let (mut floats, mut integers, mut entries) = (String::new(), String::new(), Vec::new());
    for Preset { name, channels } in presets {
        let constant = constant_name(name);
        let head = format!("/// `{name}`.{}\npub const {constant}: {kind} = {{\n", error(name));
        let numbers = channels.iter().map(|channel| {
            (format!("[f32; {}]", channel.len()), format!("[{}]", channel.join(", ")))
        });
        floats += &head;
        floats += &channels_text(numbers, |c| format!("crate::{kind}::from_finite(&{c})"));
        let numbers = channels.iter().zip(["r", "g", "b"]).map(|(channel, field)| {
            let (count, from) =
                (channel.len(), format!("super::{constant}.{field}.coefficients()"));
            match kind {
                "Light" => (format!("(i32, [Q15; {count}])"), format!("quantized_light({from})")),
                _ => {
                    let buffer = format!("MaterialBuffer<{count}, {}>", ORDER + 1);
                    (buffer, format!("MaterialBuffer::quantized({from})"))
                }
            }
        });
        integers += &head;
        integers += &channels_text(numbers, |c| match kind {
            "Light" => format!("q15::Light::new({c}.0, &{c}.1)"),
            _ => format!("{c}.material()"),
        });
        entries.push(format!("    (\"{name}\", {constant}),\n"));
    }
    floats += &each(&lower, presets.iter().map(|preset| preset.name.as_str()));
    let all = list("All of them, by name", "ALL", &format!("&str, {kind}"), &entries);
    for (text, format) in [(floats, ""), (integers, "_q15")] {
        write_output(&format!("preset_{lower}s{format}.rs"), &(text + &all))?;
    }
    Ok(())
}

/// The body of a constant: its channels' types and numbers as statics, and the color made of them.
/// A gray preset has one channel.
fn channels_text(
    numbers: impl Iterator<Item = (String, String)>,
    new: impl Fn(&str) -> String,
) -> String {
    let (mut statics, mut channels) = (String::new(), Vec::new());
    for ((of_type, numbers), channel) in numbers.zip(["R", "G", "B"]) {
        statics += &format!("    static {channel}: {of_type} = {numbers};\n");
        channels.push(format!("checked({})", new(channel)));
    }
    let function = if channels.len() == 1 { "gray" } else { "new" };
    format!("{statics}    Rgb::{function}({})\n}};\n", channels.join(", "))
}

fn constant_name(name: &str) -> String {
    name.to_uppercase().replace('-', "_")
}

/// A constant that lists others.
fn list(what: &str, constant: &str, entry: &str, entries: &[String]) -> String {
    let (count, entries) = (entries.len(), entries.concat());
    format!("/// {what}.\npub const {constant}: [({entry}); {count}] = [\n{entries}];\n")
}

/// Adds a text to the last group, or to a new one if that has another key.
fn add<K: PartialEq>(groups: &mut Vec<(K, Vec<String>)>, key: K, text: String) {
    match groups.last_mut() {
        Some((last, texts)) if *last == key => texts.push(text),
        _ => groups.push((key, vec![text])),
    }
}

/// A macro that calls another one with the constant and the name of each of them: for other
/// languages, whose names are made of these.
fn each<'a>(kind: &str, names: impl Iterator<Item = &'a str>) -> String {
    let each: String = names
        .map(|name| format!("        {} \"{}\"\n", constant_name(name), name.replace('-', "_")))
        .collect();
    format!(
        "/// Calls a macro with the constant and the name of each of them.\n\
         #[doc(hidden)]\n#[macro_export]\nmacro_rules! each_preset_{kind} {{\n    \
         ($call:ident) => {{ $call! {{\n{each}    }} }};\n}}\n"
    )
}

/// The name and the numbers of each line of a file, which have this count.
fn rows<const N: usize>(path: &str) -> Result<Vec<(String, [f64; N])>, String> {
    let row = |line: &str| {
        let (name, numbers) = line.split_once(',')?;
        let numbers: Vec<f64> =
            numbers.split(',').map(|n| n.parse().ok()).collect::<Option<_>>()?;
        Some((name.to_owned(), numbers.try_into().ok()?))
    };
    let lines = read_lines(path)?;
    let rows = lines.iter().skip(1);
    rows.map(|line| row(line).ok_or_else(|| format!("{path}: `{line}`"))).collect()
}

/// Writes the sources of each light, and the errors with the first ones: constants such as `STUDIO`
/// and `errors::STUDIO`, and a list of all of them.
fn sources() -> Result<(), String> {
    let mut lights = Vec::new();
    for (light, [x, y, z, r, g, b, spread]) in rows("tables/inputs/sources.csv")? {
        // Exactly of length 1, which six digits are not.
        let length = (x * x + y * y + z * z).sqrt();
        let [x, y, z] = [x, y, z].map(|component| (component / length) as f32);
        let [r, g, b, spread] = [r, g, b, spread].map(|number| number as f32);
        let text = format!(
            "    Source::stored([{x:?}, {y:?}, {z:?}], [{r:?}, {g:?}, {b:?}], {spread:?}),\n"
        );
        add(&mut lights, light, text);
    }
    let (mut constants, mut of_errors, mut entries) = (String::new(), String::new(), Vec::new());
    for ((light, sources), (of_light, errors)) in lights.iter().zip(&source_errors()?) {
        let (constant, count) = (constant_name(light), sources.len());
        if light != of_light || errors.len() != count + 1 {
            return Err(format!("`{light}` has {count} sources and {} errors", errors.len()));
        }
        constants += &format!(
            "/// The sources of `{light}`, in the order of their worth.\n\
             pub const {constant}: [Source; {count}] = [\n{}];\n",
            sources.concat()
        );
        of_errors += &format!(
            "    /// Under `{light}`.\n    pub const {constant}: [[f32; 6]; {}] = [\n{}    ];\n",
            errors.len(),
            errors.concat()
        );
        entries.push(format!("    (\"{light}\", &{constant}, &errors::{constant}),\n"));
    }
    constants += &format!(
        "/// The errors of pictures with the first n sources of a light, from n = 0 on: see\n\
         /// [`Gloss::fewest_sources`](crate::Gloss::fewest_sources).\n\
         pub mod errors {{\n{of_errors}}}\n"
    );
    constants += &each("sources", lights.iter().map(|(light, _)| light.as_str()));
    let what = "All of them, by the name of the light, with the errors";
    constants += &list(what, "ALL", "&str, &[Source], &[Errors]", &entries);
    write_output("preset_sources.rs", &constants)
}

/// For each light the errors of metals without sources and with the first ones, at the degree and
/// order of the presets: shares of white for each roughness.
fn source_errors() -> Result<Vec<(String, Vec<String>)>, String> {
    let mut lights = Vec::new();
    let path = "tables/inputs/sources.errors.csv";
    for line in read_lines(path)?.iter().skip(1) {
        let fault = || format!("{path}: `{line}`");
        let fields: Vec<&str> = line.split(',').collect();
        let [light, _, degree, order, base, numbers @ ..] = &fields[..] else {
            return Err(fault());
        };
        if (*degree, *order, *base) != (&*DEGREE.to_string(), &*ORDER.to_string(), "metal") {
            continue;
        }
        let numbers = numbers.iter().map(|text| text.parse().ok()).collect::<Option<Vec<f32>>>();
        let numbers = numbers.ok_or_else(fault)?;
        let errors = numbers.last_chunk::<6>().ok_or_else(fault)?;
        add(&mut lights, (*light).to_owned(), format!("        {errors:?},\n"));
    }
    Ok(lights)
}

/// Writes the gloss of the materials in color as constants.
fn glosses() -> Result<(), String> {
    let (mut constants, mut entries) = (String::new(), Vec::new());
    let rows = rows("tables/inputs/gloss.csv")?;
    for (name, numbers) in &rows {
        let constant = constant_name(name);
        let [roughness, f0_r, f0_g, f0_b, f90_r, f90_g, f90_b, r, g, b, error] = numbers;
        constants += &format!(
            "/// `{name}`. The lobe leaves {:.0} % of pictures under a small source (rms).\n\
             pub const {constant}: Gloss = Gloss::stored({roughness:?}, \
             [{f0_r:?}, {f0_g:?}, {f0_b:?}], [{f90_r:?}, {f90_g:?}, {f90_b:?}], \
             [{r:?}, {g:?}, {b:?}]);\n",
            100.0 * error
        );
        entries.push(format!("    (\"{name}\", {constant}),\n"));
    }
    constants += &each("gloss", rows.iter().map(|(name, _)| name.as_str()));
    constants += &list("All of them, by name", "ALL", "&str, Gloss", &entries);
    write_output("preset_gloss.rs", &constants)
}
