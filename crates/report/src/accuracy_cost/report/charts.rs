//! The charts.

use super::difference;
use super::tables::{of_kind, rival_pixel};
use crate::accuracy_cost::machines::{
    Lighting, MACHINES, Machine, PIXELS, is_choice, pareto, picture,
};
use crate::accuracy_cost::total::{MATCAP, PREFILTERED};
use crate::accuracy_cost::{Measured, errors, settings};
use crate::chart::{Axes, Chart, Points, Style, colored};
use crate::figures::{self, OutputFile};
use crate::sheet::Record;
use eigenshade_model::error::Result;
use plotters::prelude::SeriesLabelPosition;
use std::ops::RangeInclusive;

pub fn all(measured: &Measured) -> Result<Vec<OutputFile>> {
    let of_machine =
        |one: &Machine| (one.key.to_owned(), chart_of_machine(&measured.settings, one));
    let mut charts: Vec<(String, Chart)> = MACHINES.iter().map(of_machine).collect();
    charts.push(("total".into(), total_chart(measured)));
    charts.push(("degrees".into(), degrees(measured)));
    let drawn = charts.into_iter();
    drawn.map(|(name, chart)| Ok(figures::chart(format!("{name}.svg"), &chart.svg()?))).collect()
}

fn chart(
    titles: [String; 2],
    legend: SeriesLabelPosition,
    series: Vec<(String, Style, Points)>,
) -> Chart {
    Chart { titles, axes: Axes::Logarithmic, legend, series: colored(series), labels: vec![] }
}

/// The series of a chart of errors against costs, by the start of the method's name.
const WAYS: [(&str, &str); 5] = [
    ("polynomials", "polynomial"),
    ("within a tolerance", "within"),
    ("baked maps", "bilinear"),
    ("component by component", "eigen"),
    ("nine-term formula", "nine-terms"),
];

fn chart_of_machine(rows: &[Record], machine: &Machine) -> Chart {
    let point = |row: &Record| {
        let error = row.number("total_mean_most").filter(|error| *error > 0.0)?;
        Some((machine.number(row, "pixel")?, error))
    };
    let choices = || rows.iter().filter(|row| is_choice(row));
    let all: Vec<(f64, f64)> = choices().filter_map(point).collect();
    let mut series = Vec::new();
    for (name, way) in WAYS {
        let of_way = choices().filter(|row| row.text("way").starts_with(way));
        series.push((name.into(), Style::Dots, of_way.filter_map(point).collect::<Points>()));
    }
    series.retain(|(_, _, points)| !points.is_empty());
    let front = pareto(&all);
    let ends = front.first().into_iter().chain(front.last());
    let labels = ends.map(|&point| (point, difference(point.1))).collect();
    series.push(("Pareto front".into(), Style::Line, staircase(&front)));
    let horizontal = format!("{}: a pixel, in {}", machine.title, machine.unit());
    let titles = [horizontal, "CIEDE2000, mean of a picture, 95 of 100".into()];
    Chart { labels, ..chart(titles, SeriesLabelPosition::UpperRight, series) }
}

/// The model's error against the cheapest pixel whose method has at most a third of that error.
fn degrees(measured: &Measured) -> Chart {
    let cheapest_of = |size| {
        let error = errors::spread(&measured.model, size).median;
        let able = errors::of_size(&measured.settings, size).filter(|row| {
            let method = row.number("rms_median");
            is_choice(row) && method.is_some_and(|method| method <= error / 3.0)
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

/// The series of eigenshade in the chart of total errors, by their numbers of sources.
const LAMPS: [(&str, RangeInclusive<usize>); 4] = [
    ("eigenshade, no sources", 0..=0),
    ("1 or 2 sources", 1..=2),
    ("4 sources", 4..=4),
    ("8 or 16 sources", 8..=16),
];
/// The ways to a pixel that the chart of total errors joins: polynomials, and maps.
const POLYNOMIALS: &[&str] = &["polynomial", "within"];
const MAPS: &[&str] = &["bilinear"];

/// Total errors of glTF materials against the instructions of a pixel on a Cortex-M4F.
fn total_chart(measured: &Measured) -> Chart {
    let error = |setting: &str| {
        of_kind(&measured.total, setting, "gltf").and_then(|row| row.number("mean_most"))
    };
    let point = |row: &Record| Some((row.number("m4f_pixel")?, error(row.text("setting"))?));
    let choices = || measured.settings.iter().filter(|row| is_choice(row));
    let rival = |name| rival_pixel(name).zip(error(name)).into_iter().collect::<Points>();
    let is_nine = |row: &&Record| row.text("way") == "nine-terms" && row.text("sources") == "0";
    let nine: Points = choices().filter(is_nine).filter_map(point).collect();
    let [matcap, prefiltered] = [MATCAP, PREFILTERED].map(rival);
    let all: Vec<((f64, f64), &Record)> =
        choices().filter_map(|row| Some((point(row)?, row))).collect();
    // The best of each number of sources, by polynomials and by maps.
    let best = |counts: &RangeInclusive<usize>, ways: &[&str]| {
        let has = |row: &Record| {
            ways.iter().any(|way| row.text("way").starts_with(way))
                && row.text("sources").parse().is_ok_and(|count| counts.contains(&count))
        };
        let of = all.iter().filter(|(_, row)| has(row)).map(|(point, _)| *point);
        pareto(&of.collect::<Vec<_>>())
    };
    let mut series: Vec<(String, Style, Points)> = Vec::new();
    for (name, counts) in LAMPS {
        let points = [POLYNOMIALS, MAPS].map(|ways| best(&counts, ways)).concat();
        series.push((name.into(), Style::Dots, points));
    }
    let any = 0..=usize::MAX;
    let [polynomials, maps] = [POLYNOMIALS, MAPS].map(|ways| best(&any, ways));
    let named = |point: &(f64, f64)| {
        let (_, row) = all.iter().find(|(other, _)| other == point)?;
        let [degree, order, sources] = ["degree", "order", "sources"].map(|one| row.text(one));
        let sources = if sources == "0" { String::new() } else { format!(" + {sources}") };
        Some((*point, format!("{degree}/{order}{sources}: {}", difference(point.1))))
    };
    let rivals = [("nine terms", &nine), ("split sum", &prefiltered), ("32 x 32 matcap", &matcap)];
    let rivals = rivals.into_iter().filter_map(|(name, points)| {
        points.first().map(|point| (*point, format!("{name}: {}", difference(point.1))))
    });
    let labels = maps.iter().chain(polynomials.first()).filter_map(named).chain(rivals).collect();
    series.extend([
        ("polynomials".into(), Style::Dashed, staircase(&polynomials)),
        ("maps of 32 x 32 texels".into(), Style::Line, staircase(&maps)),
        (String::new(), Style::Dots, [nine, prefiltered, matcap].concat()),
    ]);
    series.retain(|(_, _, points)| !points.is_empty());
    let titles = [
        "Cortex-M4F: a pixel, in instructions".into(),
        "CIEDE2000, mean, 95 of 100 glTF pictures".into(),
    ];
    Chart { labels, ..chart(titles, SeriesLabelPosition::UpperRight, series) }
}

/// A front is a staircase: a higher cost need not bring any gain.
fn staircase(front: &[(f64, f64)]) -> Points {
    let steps = front.windows(2).flat_map(|pair| [(pair[1].0, pair[0].1), pair[1]]);
    front.first().copied().into_iter().chain(steps).collect()
}
