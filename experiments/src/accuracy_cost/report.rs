//! The charts, and the tables of the page.

use super::errors::MAPS;
use super::errors::Spread;
use super::machines::{LIMITS, Lighting, PIXELS, cheapest, is_choice, pareto, picture};
use super::machines::{MACHINES, Machine};
use super::sheet::{FIGURES, csv};
use super::times::{Curve, curves, power_law};
use super::total::{ALL, MATCAP, PREFILTERED};
use super::{Measured, settings};
use crate::chart::{Axes, Chart, Points, Style, colored};
use crate::figures::OutputFile;
use crate::numbers::{self, limit};
use crate::pages::{Part, table, with_parts};
use crate::sheet::{Counts, M4F, Record};
use eigenshade_cli::messages::grouped;
use eigenshade_model::error::{Error, Result};
use plotters::prelude::SeriesLabelPosition;
use std::fs;
use std::path::Path;

/// The file name of the page.
pub const PAGE: &str = "accuracy-cost.md";
/// The page into which tables are inserted where a folder has none.
const TEMPLATE: &str = include_str!("../../../docs/accuracy-cost/accuracy-cost.md");
/// A number that was not measured.
const MISSING: &str = "-";

/// The files of a folder: CSV, charts, and the page with its tables replaced.
pub fn files(measured: &Measured, folder: &Path) -> Result<Vec<OutputFile>> {
    let path = folder.join(PAGE);
    let page = if path.exists() {
        fs::read_to_string(&path).map_err(|error| Error::io(&path, &error))?
    } else {
        TEMPLATE.to_owned()
    };
    let page = with_parts(&page, &tables(measured))
        .map_err(|fault| Error::new(fault, "restore these markers").in_file(&path))?;
    let sheets = measured.sheets().into_iter().map(|(form, rows)| csv(form, rows));
    let mut files = sheets.collect::<Result<Vec<OutputFile>>>()?;
    files.extend(charts(measured)?);
    files.push(OutputFile::text(PAGE, page));
    Ok(files)
}

/// The tables of the page, by the names of their markers.
fn tables(measured: &Measured) -> Vec<Part> {
    let mut parts: Vec<Part> = MACHINES
        .iter()
        .map(|machine| (machine.key, of_machine(&measured.settings, machine)))
        .collect();
    parts.push(("choice", choice(&measured.settings)));
    parts.push(("total", total(measured)));
    parts.push(("rivals", rivals(measured)));
    parts.push(("model", model(&measured.model)));
    parts.push(("mathematics", mathematics(&measured.settings)));
    parts.push(("growth", growth(&measured.growth)));
    parts
}

/// An error in percent with two digits, or as a power of ten below 0.01 %.
fn percent(error: f64) -> String {
    match error {
        _ if !error.is_finite() => MISSING.into(),
        ..1e-4 => format!("{error:.1e}"),
        _ => numbers::percent(error, 2),
    }
}

/// A cost with three digits, or four if it is large.
fn cost(value: f64) -> String {
    match value {
        1000.0.. => {
            let unit = 10f64.powi(value.log10() as i32 - 3);
            grouped((unit * (value / unit).round()) as usize)
        }
        100.0.. => format!("{value:.0}"),
        10.0.. => format!("{value:.1}"),
        _ => format!("{value:.2}"),
    }
}

/// Counted instructions: all digits of small counts.
fn instructions(value: f64) -> String {
    if value < 1000.0 { grouped(value as usize) } else { cost(value) }
}

/// A difference of colors.
fn difference(value: f64) -> String {
    format!("{value:.1}")
}

/// The boards of the short table.
const SHORT: [&str; 2] = ["m4f", "m0"];

/// The cheapest settings of two boards by total error, for still light.
fn choice(rows: &[Record]) -> String {
    let boards = || MACHINES.iter().filter(|machine| SHORT.contains(&machine.key)).rev();
    let columns =
        boards().map(|machine| format!(" | {} | a pixel, {}:", machine.title, machine.unit()));
    let columns = format!("total error below{}", columns.collect::<String>());
    let row = |below| {
        let mut fields = vec![limit(below)];
        for machine in boards() {
            let chosen = cheapest(rows, machine, Lighting::Still, below);
            let pixel = chosen.and_then(|row| machine.number(row, "pixel"));
            fields.push(chosen.map_or(MISSING.into(), |row| format!("`{}`", row.text("setting"))));
            fields.push(pixel.map_or(MISSING.into(), instructions));
        }
        fields
    };
    table(&columns, LIMITS.map(row))
}

/// The ways to a picture whose total errors the page shows for all kinds of materials.
const SHOWN: [&str; 11] = [
    "2/0 all nine-terms f32",
    "2/2 all polynomial f32",
    "4/3 all polynomial f32",
    "6/5 all polynomial f32",
    "9/7 all polynomial f32",
    "12/12 K400 polynomial f32",
    "16/16 K400 polynomial f32",
    "sphere.bin f32",
    "sphere.bin q15",
    "color.bin f32",
    "pbr.bin f32",
];

/// The row of total errors of a way to a picture, for a kind of materials.
fn of_kind<'a>(rows: &'a [Record], setting: &str, kind: &str) -> Option<&'a Record> {
    rows.iter().find(|row| (row.text("setting"), row.text("kind")) == (setting, kind))
}

fn total(measured: &Measured) -> String {
    let columns = "setting | glTF, median: | 95 of 100: | matte: | 95 of 100: | measured: | \
                   95 of 100: | all: | 95 of 100: | worst pixel: | 95 of 100: | color: | \
                   95 of 100:";
    let row = |setting: &str| {
        let mut fields = vec![format!("`{setting}`")];
        let mut add = |kind, error: &str, format: fn(f64) -> String| {
            for column in ["median", "most"] {
                let row = of_kind(&measured.total, setting, kind);
                let number = row.and_then(|row| row.number(&format!("{error}_{column}")));
                fields.push(number.map_or(MISSING.into(), format));
            }
        };
        ["gltf", "matte", "measured", ALL].into_iter().for_each(|kind| add(kind, "rms", percent));
        add(ALL, "pixel", percent);
        add(ALL, "difference", difference);
        fields
    };
    table(columns, SHOWN.map(row))
}

/// The instructions of a pixel of a matcap on a Cortex-M4F. A baked map that is looked up by points
/// is the same look-up: its points are the matcap's normals.
fn matcap_pixel() -> Option<f64> {
    Counts::recorded().get(M4F, "baked_point", "instructions").map(|count| count as f64)
}

/// The settings that the page compares with their rivals.
const COMPARED: [&str; 7] = [
    "2/0 all nine-terms f32",
    MATCAP,
    PREFILTERED,
    "9/7 K9 trim1e-1 polynomial f32",
    "9/7 K25 trim3e-2 polynomial f32",
    "9/7 K130 trim2e-4 polynomial f32",
    "9/7 all bilinear32 f32",
];

fn rivals(measured: &Measured) -> String {
    let columns = "way | rms, median: | 95 of 100: | worst pixel: | 95 of 100: | color: | \
                   95 of 100: | a pixel, instructions:";
    let row = |setting: &str| {
        let mut fields = vec![format!("`{setting}`")];
        for (error, format) in
            [("rms", percent as fn(f64) -> String), ("pixel", percent), ("difference", difference)]
        {
            for column in ["median", "most"] {
                let row = of_kind(&measured.total, setting, "gltf");
                let number = row.and_then(|row| row.number(&format!("{error}_{column}")));
                fields.push(number.map_or(MISSING.into(), format));
            }
        }
        let is_it = |row: &&Record| row.text("setting") == setting;
        let pixel = match setting {
            MATCAP => matcap_pixel(),
            _ => measured.settings.iter().find(is_it).and_then(|row| row.number("m4f_pixel")),
        };
        let gpu = if setting == PREFILTERED { "GPU only" } else { MISSING };
        fields.push(pixel.map_or(gpu.into(), instructions));
        fields
    };
    table(columns, COMPARED.map(row))
}

/// Total errors of glTF materials against the instructions of a pixel on a Cortex-M4F.
fn total_chart(measured: &Measured) -> Chart {
    let error = |setting: &str| {
        of_kind(&measured.total, setting, "gltf").and_then(|row| row.number("rms_most"))
    };
    let point = |row: &Record| Some((row.number("m4f_pixel")?, error(row.text("setting"))?));
    let of_ways = |ways: &[&str]| -> Points {
        let is_it = |row: &&Record| {
            is_choice(row) && ways.iter().any(|way| row.text("way").starts_with(way))
        };
        measured.settings.iter().filter(is_it).filter_map(point).collect()
    };
    let (polynomials, baked) = (of_ways(&["polynomial"]), of_ways(&["bilinear"]));
    let front = pareto(&polynomials);
    let matcap: Points = matcap_pixel().zip(error(MATCAP)).into_iter().collect();
    let nine = of_ways(&["nine-terms"]);
    let labels = front.iter().chain(&matcap).chain(&nine).map(labelled).collect();
    let costs = || polynomials.iter().chain(&baked).map(|point| point.0);
    let ends = [costs().fold(f64::INFINITY, f64::min), costs().fold(0.0, f64::max)];
    let prefiltered = error(PREFILTERED).map(|error| ends.map(|cost| (cost, error)).to_vec());
    let series = vec![
        ("eigenshade, polynomials".into(), Style::Dots, polynomials),
        ("eigenshade, baked map".into(), Style::Dots, baked),
        ("nine-term formula".into(), Style::Dots, nine),
        ("32 x 32 matcap".into(), Style::Dots, matcap),
        ("prefiltered maps (GPU)".into(), Style::Dashed, prefiltered.unwrap_or_default()),
        ("best polynomials".into(), Style::Line, staircase(&front)),
    ];
    let titles =
        ["Cortex-M4F: a pixel, in instructions".into(), "total rms error, 95 of 100 glTF".into()];
    Chart { labels, ..chart(titles, SeriesLabelPosition::LowerRight, series) }
}

/// A point with its error.
fn labelled(&(cost, error): &(f64, f64)) -> ((f64, f64), String) {
    ((cost, error), percent(error))
}

/// A front is a staircase: a higher cost need not bring any gain.
fn staircase(front: &[(f64, f64)]) -> Points {
    let steps = front.windows(2).flat_map(|pair| [(pair[1].0, pair[0].1), pair[1]]);
    front.first().copied().into_iter().chain(steps).collect()
}

fn of_machine(rows: &[Record], machine: &Machine) -> String {
    let mut columns = format!(
        "light | total error below | setting | terms: | median: | 95 of 100: | worst pixel: | \
         color: | method: | a pixel, {}: | a new light: | 96 x 96 pixels: | table, bytes: | \
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
        let mut fields = vec![light.to_owned(), limit(below)];
        if let Some(row) = cheapest(rows, machine, lighting, below) {
            fields.push(format!("`{}`", row.text("setting")));
            let mut add = |value: Option<f64>, format: fn(f64) -> String| {
                fields.push(value.map_or(MISSING.into(), format));
            };
            add(row.number("terms"), whole);
            for kind in ["rms_median", "rms_most", "pixel_most"] {
                add(row.number(&format!("total_{kind}")), percent);
            }
            add(row.number("total_difference_most"), difference);
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
    let lines = [Lighting::Still, Lighting::Moving]
        .into_iter()
        .flat_map(|lighting| LIMITS.map(|below| row(lighting, below)));
    table(&columns, lines)
}

/// The errors of the model in these rows.
fn spread<'a>(rows: impl Iterator<Item = &'a Record>) -> Spread {
    let errors = rows.flat_map(|row| MAPS.iter().filter_map(|map| row.number(map)));
    Spread::of(&errors.collect::<Vec<f64>>())
}

/// The rows of a degree and an order.
fn of_size(rows: &[Record], (degree, order): (usize, usize)) -> impl Iterator<Item = &Record> {
    let size = [degree, order].map(|one| one.to_string());
    rows.iter().filter(move |row| ["degree", "order"].map(|column| row.text(column)) == size)
}

fn model(rows: &[Record]) -> String {
    let surfaces = rows.len() / settings::sizes().count();
    let names = of_size(rows, (1, 0)).map(|row| format!(" | {}:", row.text("surface")));
    let columns =
        format!("degree, order | median: | worst:{}", names.take(surfaces).collect::<String>());
    let row = |(degree, order)| {
        let Spread { median, worst, .. } = spread(of_size(rows, (degree, order)));
        let mut fields = vec![format!("{degree}, {order}"), percent(median), percent(worst)];
        let of_surface = of_size(rows, (degree, order)).filter_map(|row| row.number("median"));
        fields.extend(of_surface.map(percent));
        fields
    };
    table(&columns, settings::sizes().map(row))
}

fn mathematics(rows: &[Record]) -> String {
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

fn growth(rows: &[Record]) -> String {
    let row = |curve: Curve| {
        let size = |place: Option<&(f64, f64)>| place.map_or(0, |point| point.0.round() as usize);
        let [first, last] = [curve.points.first(), curve.points.last()].map(size).map(grouped);
        let exponent = |value: Option<f64>| match value {
            Some(value) if value.fract() == 0.0 => value.to_string(),
            Some(value) => format!("{value:.2}"),
            None => MISSING.into(),
        };
        let [fitted, theory] =
            [curve.exponent().map(|fitted| fitted + 1e-9), curve.theory].map(exponent);
        let Curve { measure, unit, quantity, .. } = curve;
        vec![format!("{measure}, {unit}"), quantity, format!("{first} to {last}"), fitted, theory]
    };
    let columns = "what | against | sizes | fitted: | theory:";
    table(columns, curves(rows).into_iter().map(row))
}

/// The charts.
fn charts(measured: &Measured) -> Result<Vec<OutputFile>> {
    let mut charts: Vec<(String, Chart)> = MACHINES
        .iter()
        .map(|machine| (machine.key.to_owned(), chart_of_machine(&measured.settings, machine)))
        .collect();
    charts.push(("total".into(), total_chart(measured)));
    charts.push(("degrees".into(), degrees(measured)));
    let curves = curves(&measured.growth);
    for of_kind in curves.chunk_by(|a, b| (&a.quantity, &a.unit) == (&b.quantity, &b.unit)) {
        // Where all are proportional, a chart shows nothing that the table does not.
        if of_kind.len() > 1 {
            let unit = if of_kind[0].unit == "ns" { "times" } else { &of_kind[0].unit };
            let name = format!("growth-{}-{unit}", of_kind[0].quantity);
            charts.push((name, growth_chart(of_kind)));
        }
    }
    let drawn =
        |(name, chart): (String, Chart)| Ok(FIGURES.chart(&format!("{name}.svg"), &chart.svg()?));
    charts.into_iter().map(drawn).collect()
}

/// A chart with logarithmic axes.
fn chart(
    titles: [String; 2],
    legend: SeriesLabelPosition,
    series: Vec<(String, Style, Points)>,
) -> Chart {
    Chart { titles, axes: Axes::Logarithmic, legend, series: colored(series), labels: vec![] }
}

/// The series of a chart of errors against costs, by parts of the method's name.
const WAYS: [(&str, &[&str]); 6] = [
    ("polynomials", &["polynomial"]),
    ("within a tolerance", &["within"]),
    ("look-ups", &["linear", "cubic"]),
    ("baked maps", &["bilinear", "nearest"]),
    ("component by component", &["eigen"]),
    ("nine-term formula", &["nine-terms"]),
];

fn chart_of_machine(rows: &[Record], machine: &Machine) -> Chart {
    let point = |row: &Record| {
        let error = row.number("total_rms_most").filter(|error| *error > 0.0)?;
        Some((machine.number(row, "pixel")?, error))
    };
    let choices = || rows.iter().filter(|row| is_choice(row));
    let all: Vec<(f64, f64)> = choices().filter_map(point).collect();
    let mut series = Vec::new();
    for (name, ways) in WAYS {
        let of = |row: &&Record| ways.iter().any(|way| row.text("way").starts_with(way));
        let points: Points = choices().filter(of).filter_map(point).collect();
        if !points.is_empty() {
            series.push((name.into(), Style::Dots, points));
        }
    }
    let front = pareto(&all);
    let labels = front.first().into_iter().chain(front.last()).map(labelled).collect();
    series.push(("Pareto front".into(), Style::Line, staircase(&front)));
    let horizontal = format!("{}: a pixel, in {}", machine.title, machine.unit());
    let titles = [horizontal, "total rms error of the peak, 95 of 100".into()];
    Chart { labels, ..chart(titles, SeriesLabelPosition::UpperRight, series) }
}

/// The model's error against the cost of a pixel, by the cheapest setting whose error of the method
/// is at most a third of the model's.
fn degrees(measured: &Measured) -> Chart {
    let cheapest_of = |size| {
        let error = spread(of_size(&measured.model, size)).median;
        let able = of_size(&measured.settings, size).filter(|row| {
            row.text("parameter") != "mathematics"
                && row.number("rms_median").is_some_and(|method| method <= error / 3.0)
        });
        let costs = able.filter_map(|row| picture(row, &MACHINES[0], Lighting::Still));
        costs.min_by(f64::total_cmp).map(|cost| (cost / PIXELS, error))
    };
    let sizes = settings::sizes().filter_map(|size| cheapest_of(size).map(|point| (size, point)));
    let labels: Vec<_> =
        sizes.map(|((degree, order), point)| (point, format!("{degree}, {order}"))).collect();
    let points = labels.iter().map(|(point, _)| *point).collect();
    let series = vec![("degree, order".into(), Style::Dots, points)];
    let horizontal = format!("a pixel, in {}", MACHINES[0].unit());
    let titles = [horizontal, "error of the model, median".into()];
    Chart { labels, ..chart(titles, SeriesLabelPosition::LowerLeft, series) }
}

/// Curves relative to their first points, each with its fitted power law.
fn growth_chart(curves: &[Curve]) -> Chart {
    let mut series = Vec::new();
    for curve in curves {
        let Some((&(_, first), (a, b))) = curve.points.first().zip(power_law(&curve.points)) else {
            continue;
        };
        let points = curve.points.iter().map(|&(x, y)| (x, y / first)).collect();
        series.push((curve.measure.clone(), Style::Line, points));
        let fitted = &curve.points[curve.points.len() / 2..];
        let points = fitted.iter().map(|&(x, _)| (x, a * x.powf(b) / first)).collect();
        series.push((format!("exponent {b:.2}"), Style::Dashed, points));
    }
    let titles = [curves[0].quantity.clone(), format!("{}, of the first", curves[0].unit)];
    chart(titles, SeriesLabelPosition::UpperLeft, series)
}
