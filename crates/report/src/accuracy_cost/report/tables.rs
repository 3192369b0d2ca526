//! The tables of the page.

use super::{MISSING, cost, difference, instructions, percent};
use crate::accuracy_cost::errors::{self, Spread};
use crate::accuracy_cost::machines::{LIMITS, Lighting, MACHINES, Machine, cheapest, picture};
use crate::accuracy_cost::total::subjects::ALL;
use crate::accuracy_cost::total::{COMPONENTS, MATCAP, PREFILTERED, components_name};
use crate::accuracy_cost::{Measured, settings};
use crate::pages::table;
use crate::sheet::{Counts, M4F, Record};
use eigenshade_cli::messages::grouped;

/// The boards of the short table.
const SHORT: [&str; 2] = ["m4f", "m0"];

/// The cheapest settings of two boards by total screen error, for a new light with every picture.
pub fn choice(rows: &[Record]) -> String {
    let boards = || MACHINES.iter().filter(|machine| SHORT.contains(&machine.key)).rev();
    let columns = boards()
        .map(|one| format!(" | {} | half of the pictures | a pixel, {}:", one.title, one.unit()));
    let columns = format!("95 of 100 pictures below{}", columns.collect::<String>());
    let row = |below: f64| {
        let mut fields = vec![below.to_string()];
        for machine in boards() {
            let chosen = cheapest(rows, machine, Lighting::Moving, below);
            let pixel = chosen.and_then(|row| machine.number(row, "pixel"));
            fields.push(chosen.map_or(MISSING.into(), described));
            fields.push(chosen.map_or(MISSING.into(), |row| screen(row, "total_", "median")));
            fields.push(pixel.map_or(MISSING.into(), instructions));
        }
        fields
    };
    table(&columns, LIMITS.map(row))
}

/// A screen error: the mean and the 95th percentile of the pixels, of the median picture or of the
/// one that 95 of 100 do not exceed.
fn screen(row: &Record, prefix: &str, of: &str) -> String {
    let number =
        |measure| row.number(&format!("{prefix}{measure}_{of}")).map_or(MISSING.into(), difference);
    format!("{} / {}", number("mean"), number("p95"))
}

/// A setting in words: degree, order, components, terms, sources and format.
fn described(row: &Record) -> String {
    let columns = ["degree", "order", "components", "way", "terms", "sources", "format"];
    let [degree, order, components, way, terms, sources, format] = columns.map(|one| row.text(one));
    let read = match (way, components) {
        ("nine-terms", _) => "nine terms".into(),
        (_, "") => format!("{terms} terms"),
        _ => format!("{components} components, {terms} terms"),
    };
    let sources = match sources {
        "0" => String::new(),
        "1" => " + 1 source".into(),
        _ => format!(" + {sources} sources"),
    };
    format!("{degree}/{order}, {read}{sources}, {format}")
}

pub fn of_machine(rows: &[Record], machine: &Machine) -> String {
    let mut columns = format!(
        "light | below | setting | terms: | median picture: | 95 of 100: | of white: | \
         method: | a pixel, {}: | a new light: | 96 x 96 pixels: | table, bytes: | \
         RAM, bytes:",
        machine.unit()
    );
    if machine.board.is_some() {
        columns += " | program, flash: | program, RAM:";
    }
    let whole = |value: f64| grouped(value.round() as usize);
    let price = if machine.board.is_some() { instructions } else { cost };
    let row = |lighting, below: f64| {
        let light = if lighting == Lighting::Still { "still" } else { "moving" };
        let mut fields = vec![light.to_owned(), below.to_string()];
        if let Some(row) = cheapest(rows, machine, lighting, below) {
            fields.push(format!("`{}`", row.text("setting")));
            fields.push(row.number("terms").map_or(MISSING.into(), whole));
            for of in ["median", "most"] {
                fields.push(screen(row, "total_", of));
            }
            let mut add = |value: Option<f64>, format: fn(f64) -> String| {
                fields.push(value.map_or(MISSING.into(), format));
            };
            add(row.number("total_white_most"), percent);
            add(row.number("unseen_rms_most"), percent);
            add(machine.number(row, "pixel"), price);
            add(machine.number(row, "light"), price);
            add(picture(row, machine, lighting), price);
            add(row.number("table_bytes"), whole);
            add(row.number("state_bytes"), whole);
            if machine.board.is_some() {
                add(machine.number(row, "flash"), whole);
                add(machine.number(row, "ram"), whole);
            }
        }
        fields.resize(columns.split(" | ").count(), MISSING.into());
        fields
    };
    let lines = [Lighting::Still, Lighting::Moving].map(|one| LIMITS.map(|below| row(one, below)));
    table(&columns, lines.concat())
}

pub fn model(rows: &[Record]) -> String {
    let surfaces = rows.len() / settings::sizes().count();
    let names = errors::of_size(rows, (1, 0)).map(|row| format!(" | {}:", row.text("surface")));
    let columns =
        format!("degree, order | median: | worst:{}", names.take(surfaces).collect::<String>());
    let row = |(degree, order)| {
        let Spread { median, worst, .. } = errors::spread(rows, (degree, order));
        let mut fields = vec![format!("{degree}, {order}"), percent(median), percent(worst)];
        let of_surface =
            errors::of_size(rows, (degree, order)).filter_map(|row| row.number("median"));
        fields.extend(of_surface.map(percent));
        fields
    };
    table(&columns, settings::sizes().map(row))
}

pub fn mathematics(rows: &[Record]) -> String {
    let reference = "9/7 K50 polynomial f32";
    let row = |row: &Record| {
        let name = row.text("setting");
        let name = if name == reference { "none" } else { name.rsplit(' ').next().unwrap_or("") };
        let [median, worst] = ["rms_median", "rms_worst"]
            .map(|column| row.number(column).map_or(MISSING.into(), percent));
        let pixel = row.number("host_pixel").map_or(MISSING.into(), cost);
        vec![format!("`{name}`"), median, worst, pixel]
    };
    let is_shown =
        |row: &&Record| row.text("parameter") == "mathematics" || row.text("setting") == reference;
    let columns = "root | median: | worst: | a pixel, nine-term pixels:";
    table(columns, rows.iter().filter(is_shown).map(row))
}

/// What each effect costs, and what a basis without it leaves out of the pictures.
pub fn effects(rows: &[Record]) -> String {
    let row = |row: &Record| {
        let [error, bytes, pixel, light] =
            ["rms_median", "table_bytes", "host_pixel", "host_light"].map(|one| row.number(one));
        let shown =
            |value: Option<f64>, format: fn(f64) -> String| value.map_or(MISSING.into(), format);
        vec![
            row.text("effects").replace(' ', ", "),
            row.text("terms").into(),
            shown(bytes, |bytes| grouped(bytes as usize)),
            shown(pixel, cost),
            shown(light, cost),
            shown(error, percent),
        ]
    };
    let is_shown = |row: &&Record| {
        row.text("parameter") == "effects" || row.text("setting") == "9/7 all polynomial f32"
    };
    let columns = "effects | terms: | table, bytes: | a pixel, nine-term pixels: | a new light: | \
                   method, median:";
    table(columns, rows.iter().filter(is_shown).map(row))
}

/// The ways to a picture whose total errors the page shows for all kinds of materials.
const SHOWN: [&str; 23] = [
    "2/0 all nine-terms f32",
    "2/2 all polynomial f32",
    "4/3 all polynomial f32",
    "6/5 all polynomial f32",
    "9/7 all polynomial f32 no-window",
    "9/7 all polynomial f32",
    "9/7 all polynomial f32 sources1",
    "9/7 all polynomial f32 sources2",
    "9/7 all polynomial f32 sources4 no-window",
    "9/7 all polynomial f32 sources4",
    "9/7 all polynomial f32 sources8 no-window",
    "9/7 all polynomial f32 sources8",
    "12/12 K400 polynomial f32 no-window",
    "12/12 K400 polynomial f32",
    "12/12 K400 polynomial f32 sources4 no-window",
    "12/12 K400 polynomial f32 sources4",
    "12/12 K400 polynomial f32 sources8 no-window",
    "12/12 K400 polynomial f32 sources8",
    "16/16 K400 polynomial f64",
    "sphere.bin f32",
    "sphere.bin q15",
    "color.bin f32",
    "pbr.bin f32",
];

/// The row of total errors of a way to a picture, for a kind of materials.
pub fn of_kind<'a>(rows: &'a [Record], setting: &str, kind: &str) -> Option<&'a Record> {
    rows.iter().find(|row| (row.text("setting"), row.text("kind")) == (setting, kind))
}

pub fn total(measured: &Measured) -> String {
    let columns = "setting | glTF: | 95 of 100: | matte: | 95 of 100: | measured: | 95 of 100: | \
                   all: | 95 of 100: | below white: | 95 of 100: | of white: | 95 of 100:";
    let row = |setting: &str| {
        let mut fields = fields(measured, setting, &["gltf", "matte", "measured", ALL]);
        let row = of_kind(&measured.total, setting, ALL);
        for of in ["median", "most"] {
            fields.push(row.map_or(MISSING.into(), |row| screen(row, "below_", of)));
        }
        for of in ["median", "most"] {
            let number = row.and_then(|row| row.number(&format!("white_{of}")));
            fields.push(number.map_or(MISSING.into(), percent));
        }
        fields
    };
    table(columns, SHOWN.map(row))
}

/// The runtime's table with other numbers of components, over all materials.
pub fn components(measured: &Measured) -> String {
    let columns = "components: | f32, bytes: | Q15, bytes: | no sources: | 95 of 100: | close: | \
                   up to 8 sources: | 95 of 100: | close:";
    let row = |count: usize| {
        let [none, eight] =
            [0, 8].map(|sources| of_kind(&measured.total, &components_name(count, sources), ALL));
        let bytes = |column| {
            let bytes = none.and_then(|row| row.number(column));
            bytes.map_or(MISSING.into(), |bytes| grouped(bytes as usize))
        };
        let mut fields = vec![count.to_string(), bytes("f32_bytes"), bytes("q15_bytes")];
        for row in [none, eight] {
            for of in ["median", "most"] {
                fields.push(row.map_or(MISSING.into(), |row| screen(row, "", of)));
            }
            let close = row.and_then(|row| row.number("close"));
            fields.push(close.map_or(MISSING.into(), percent));
        }
        fields
    };
    table(columns, COMPONENTS.map(row))
}

/// The setting, then the screen errors of the median picture and of 95 of 100, for kinds of
/// materials.
fn fields(measured: &Measured, setting: &str, kinds: &[&str]) -> Vec<String> {
    let mut fields = vec![format!("`{setting}`")];
    for kind in kinds {
        let row = of_kind(&measured.total, setting, kind);
        for of in ["median", "most"] {
            fields.push(row.map_or(MISSING.into(), |row| screen(row, "", of)));
        }
    }
    fields
}

/// The instructions of a pixel of a rival on a Cortex-M4F. A baked map that is looked up by points
/// is the same look-up as a matcap: its points are the matcap's normals.
pub fn rival_pixel(rival: &str) -> Option<f64> {
    let operation = if rival == MATCAP { "baked_point" } else { "prefiltered" };
    Counts::recorded().get(M4F, operation, "instructions").map(|count| count as f64)
}

/// The settings that the page compares with their rivals.
const COMPARED: [&str; 11] = [
    "2/0 all nine-terms f32",
    MATCAP,
    PREFILTERED,
    "9/7 K9 trim1e-1 polynomial f32",
    "9/7 K25 trim3e-2 polynomial f32",
    "9/7 K130 trim2e-4 polynomial f32",
    "9/7 K130 trim2e-4 polynomial f32 sources4",
    "9/7 all bilinear32 f32",
    "9/7 all bilinear32 f32 sources4",
    "12/12 K400 bilinear32 f32",
    "12/12 K400 bilinear32 f32 sources8",
];

/// The ways to draw glTF materials, with their costs.
pub fn rivals(measured: &Measured) -> String {
    let columns = "way | median picture: | 95 of 100: | a pixel, instructions:";
    let row = |setting: &str| {
        let mut fields = fields(measured, setting, &["gltf"]);
        let is_it = |row: &&Record| row.text("setting") == setting;
        let pixel = match setting {
            MATCAP | PREFILTERED => rival_pixel(setting),
            _ => measured.settings.iter().find(is_it).and_then(|row| row.number("m4f_pixel")),
        };
        fields.push(pixel.map_or(MISSING.into(), instructions));
        fields
    };
    table(columns, COMPARED.map(row))
}
