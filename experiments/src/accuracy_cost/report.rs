//! The charts, and the tables of the page.

use super::chart::{Chart, Series, Style, svg};
use super::choice::{LIMITS, Lighting, PIXELS, cheapest, is_comparable, pareto, picture};
use super::errors::Spread;
use super::growth::{Curve, curves, power_law};
use super::machines::{MACHINES, Machine};
use super::model::MAPS;
use super::sheet::{COMMAND, Record};
use super::{Measured, settings};
use crate::pages::Part;
use eigenshade_cli::messages::grouped;
use eigenshade_model::error::Result;
use plotters::prelude::SeriesLabelPosition;

/// The file name of the page.
pub const PAGE: &str = "accuracy-cost.md";
/// A number that was not measured.
const MISSING: &str = "-";

/// The tables of the page, by the names of their markers.
pub fn tables(measured: &Measured) -> Vec<Part> {
    let mut parts: Vec<Part> = MACHINES
        .iter()
        .map(|machine| (machine.key, of_machine(&measured.settings, machine)))
        .collect();
    parts.push(("model", model(&measured.model)));
    parts.push(("mathematics", mathematics(&measured.settings)));
    parts.push(("growth", growth(&measured.growth)));
    parts
}

/// A Markdown table. All columns but the first `left` are aligned to the right.
fn table(header: &[&str], left: usize, rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let rules = (0..header.len()).map(|column| if column < left { "---" } else { "---:" });
    let mut text =
        format!("| {} |\n|{}|\n", header.join(" | "), rules.collect::<Vec<_>>().join("|"));
    for row in rows {
        text.push_str(&format!("| {} |\n", row.join(" | ")));
    }
    text
}

/// An error in percent with two digits, or as a power of ten below 0.01 %.
fn percent(error: f64) -> String {
    if !error.is_finite() {
        return MISSING.into();
    }
    if error < 1e-4 {
        return format!("{error:.1e}");
    }
    let value = 100.0 * error;
    let places = usize::try_from(1 - value.log10().floor() as i32).unwrap_or(0).min(6);
    format!("{value:.places$} %")
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

fn of_machine(rows: &[Record], machine: &Machine) -> String {
    let unit = format!("a pixel, {}", machine.unit());
    let mut header = vec!["light", "error below", "setting", "terms", "median", "95 of 100"];
    header.extend(["worst", "worst pixel", "model", &unit, "a new light", "96 x 96 pixels"]);
    header.extend(["table, bytes", "RAM, bytes"]);
    if machine.board.is_some() {
        header.extend(["program, flash", "program, RAM"]);
    }
    let row = |lighting, limit: f64| {
        let light = if lighting == Lighting::Still { "still" } else { "moving" };
        let limit_text = format!("{} %", 100.0 * limit);
        let mut fields = vec![light.to_owned(), limit_text];
        let Some(row) = cheapest(rows, machine, lighting, limit) else {
            fields.resize(header.len(), MISSING.into());
            return fields;
        };
        let text =
            |value: Option<f64>, format: fn(f64) -> String| value.map_or(MISSING.into(), format);
        let whole = |value: f64| grouped(value.round() as usize);
        let price = if machine.board.is_some() {
            |value: f64| if value < 1000.0 { grouped(value as usize) } else { cost(value) }
        } else {
            cost
        };
        fields.push(format!("`{}`", row.text("setting")));
        fields.push(text(row.number("terms"), whole));
        for column in [
            "unseen_rms_median",
            "unseen_rms_most",
            "unseen_rms_worst",
            "unseen_largest_worst",
            "model_median",
        ] {
            fields.push(text(row.number(column), percent));
        }
        fields.push(text(machine.number(row, "pixel"), price));
        fields.push(text(machine.number(row, "light"), price));
        fields.push(text(picture(row, machine, lighting), price));
        fields.push(text(row.number("table_bytes"), whole));
        fields.push(text(row.number("state_bytes"), whole));
        if machine.board.is_some() {
            fields.push(text(machine.number(row, "flash"), whole));
            fields.push(text(machine.number(row, "ram"), whole));
        }
        fields
    };
    let lines = [Lighting::Still, Lighting::Moving]
        .into_iter()
        .flat_map(|lighting| LIMITS.map(|limit| row(lighting, limit)));
    table(&header, 3, lines)
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
    let mut header = vec!["degree, order", "median", "worst"];
    let surfaces = rows.len() / settings::sizes().count();
    header.extend(of_size(rows, (1, 0)).map(|row| row.text("surface")).take(surfaces));
    let row = |(degree, order)| {
        let Spread { median, worst, .. } = spread(of_size(rows, (degree, order)));
        let mut fields = vec![format!("{degree}, {order}"), percent(median), percent(worst)];
        let of_surface = of_size(rows, (degree, order)).filter_map(|row| row.number("median"));
        fields.extend(of_surface.map(percent));
        fields
    };
    table(&header, 1, settings::sizes().map(row))
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
        |row: &&Record| row.text("knob") == "mathematics" || row.text("setting") == reference;
    let header = ["root", "median", "worst", "a pixel, nine-term pixels"];
    table(&header, 1, rows.iter().filter(is_shown).map(row))
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
    let header = ["what", "against", "sizes", "fitted", "theory"];
    table(&header, 3, curves(rows).into_iter().map(row))
}

/// The charts, by file name.
pub fn charts(measured: &Measured) -> Result<Vec<(String, String)>> {
    let mut charts: Vec<(String, Chart)> = MACHINES
        .iter()
        .map(|machine| (machine.key.to_owned(), chart_of_machine(&measured.settings, machine)))
        .collect();
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
    let signed = |(name, chart): (String, Chart)| {
        Ok((format!("{name}.svg"), format!("<!-- {COMMAND} -->\n{}", svg(&chart)?)))
    };
    charts.into_iter().map(signed).collect()
}

/// The series of a chart of errors against costs, by parts of the method's name.
const WAYS: [(&str, &[&str]); 5] = [
    ("polynomials", &["polynomial"]),
    ("within a tolerance", &["within"]),
    ("look-ups", &["linear", "cubic"]),
    ("baked maps", &["bilinear", "nearest"]),
    ("component by component", &["eigen"]),
];

fn chart_of_machine(rows: &[Record], machine: &Machine) -> Chart {
    let point = |row: &Record| {
        let error = row.number("unseen_rms_most").filter(|error| *error > 0.0)?;
        Some((machine.number(row, "pixel")?, error))
    };
    let comparable = || rows.iter().filter(|row| is_comparable(row));
    let all: Vec<(f64, f64)> = comparable().filter_map(point).collect();
    let mut series: Vec<Series> = WAYS
        .iter()
        .map(|(name, ways)| {
            let of = |row: &&Record| ways.iter().any(|way| row.text("way").starts_with(way));
            let points = comparable().filter(of).filter_map(point).collect();
            Series { name: (*name).into(), points, style: Style::Dots }
        })
        .filter(|series| !series.points.is_empty())
        .collect();
    // A front is a staircase: a higher cost need not bring any gain.
    let front = pareto(&all);
    let steps = front.windows(2).flat_map(|pair| [(pair[1].0, pair[0].1), pair[1]]);
    let points = front.first().copied().into_iter().chain(steps).collect();
    series.push(Series { name: "Pareto front".into(), points, style: Style::Line });
    let ends = |of: fn(&(f64, f64)) -> f64| {
        let values = || all.iter().map(of);
        [values().fold(f64::INFINITY, f64::min), values().fold(0.0, f64::max)]
    };
    let nine = rows.iter().find(|row| row.text("way") == "nine-terms");
    if let Some(cost) = nine.and_then(|row| machine.number(row, "pixel")) {
        let points = ends(|point| point.1).map(|error| (cost, error)).to_vec();
        series.push(Series {
            name: "nine-term formula, cost".into(),
            points,
            style: Style::Dashed,
        });
    }
    if let Some(error) = comparable().find_map(|row| row.number("model_median")) {
        let points = ends(|point| point.0).map(|cost| (cost, error)).to_vec();
        series.push(Series {
            name: "degree 9, order 7, error".into(),
            points,
            style: Style::Dashed,
        });
    }
    let horizontal = format!("{}: a pixel, in {}", machine.title, machine.unit());
    let vertical = "rms error of the peak, 95 of 100 unseen".into();
    Chart {
        titles: [horizontal, vertical],
        legend: SeriesLabelPosition::LowerLeft,
        series,
        labels: vec![],
    }
}

/// The model's error against the cost of a pixel, by the cheapest setting whose error of the method
/// is at most a third of the model's.
fn degrees(measured: &Measured) -> Chart {
    let cheapest_of = |size| {
        let error = spread(of_size(&measured.model, size)).median;
        let able = of_size(&measured.settings, size).filter(|row| {
            row.text("knob") != "mathematics"
                && row.number("rms_median").is_some_and(|method| method <= error / 3.0)
        });
        let costs = able.filter_map(|row| picture(row, &MACHINES[0], Lighting::Still));
        costs.min_by(f64::total_cmp).map(|cost| (cost / PIXELS, error))
    };
    let sizes = settings::sizes().filter_map(|size| cheapest_of(size).map(|point| (size, point)));
    let labels: Vec<_> =
        sizes.map(|((degree, order), point)| (point, format!("{degree}, {order}"))).collect();
    let points = labels.iter().map(|(point, _)| *point).collect();
    let name = "degree, order".into();
    let series = vec![Series { name, points, style: Style::Dots }];
    let horizontal = format!("a pixel, in {}", MACHINES[0].unit());
    let titles = [horizontal, "error of the model, median".into()];
    Chart { titles, legend: SeriesLabelPosition::LowerLeft, series, labels }
}

/// Curves relative to their first points, each with its fitted power law.
fn growth_chart(curves: &[Curve]) -> Chart {
    let mut series = Vec::new();
    for curve in curves {
        let Some((&(_, first), (a, b))) = curve.points.first().zip(power_law(&curve.points)) else {
            continue;
        };
        let points = curve.points.iter().map(|&(x, y)| (x, y / first)).collect();
        series.push(Series { name: curve.measure.clone(), points, style: Style::Line });
        let fitted = &curve.points[curve.points.len() / 2..];
        let points = fitted.iter().map(|&(x, _)| (x, a * x.powf(b) / first)).collect();
        series.push(Series { name: format!("exponent {b:.2}"), points, style: Style::Dashed });
    }
    let titles = [curves[0].quantity.clone(), format!("{}, of the first", curves[0].unit)];
    Chart { titles, legend: SeriesLabelPosition::UpperLeft, series, labels: vec![] }
}
