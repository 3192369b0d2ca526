//! The charts: a front for each machine, the cost of degrees and orders, and the growth curves.

use super::chart::{Line, Lines, Scatter, growth, scatter};
use super::choice::{FRAME, LIMITS, Lighting, cheapest, frame};
use super::front::front;
use super::growth::Growth;
use super::knobs::{DEGREE, ORDER};
use super::machine::Machine;
use super::model::Row;
use super::points::Point;
use super::setting::{Cut, Format, Scaling, Setting, Way};
use super::words::{exponent, per_cent};
use super::{COMMAND, model};
use eigenshade_model::error::Result;

/// A chart's file name and its text.
pub type Figure = (String, String);

/// All charts.
///
/// # Errors
///
/// Never in practice.
pub fn all(points: &[Point], models: &[Row], growths: &[Growth]) -> Result<Vec<Figure>> {
    let mut figures = Vec::new();
    for machine in Machine::ALL {
        figures.push((format!("{}.svg", machine.key()), of_machine(points, machine)?));
    }
    figures.push(("degrees.svg".into(), degrees(points, models)?));
    for (quantity, unit) in kinds(growths) {
        figures.push((growth_file(quantity, unit), growing(growths, quantity, unit)?));
    }
    let signed = |(name, svg): Figure| (name, format!("<!-- {COMMAND} -->\n{svg}"));
    Ok(figures.into_iter().map(signed).collect())
}

/// A short name that distinguishes a setting from the others of a chart.
#[must_use]
pub fn short(setting: &Setting, terms: usize) -> String {
    let count = match setting.recipe.components {
        Some(count) => format!("K {count}"),
        None => "all K".into(),
    };
    let format = match setting.format {
        Format::F32 => String::new(),
        other => format!(" {other}"),
    };
    let shortened = setting.recipe.cut != Cut::Whole || setting.recipe.azimuths.is_some();
    match setting.way {
        Way::NineTerms => "nine terms".into(),
        Way::Polynomial if !shortened => format!("{count}{format}"),
        Way::Polynomial | Way::Within(_) => format!("{count}, {terms} terms{format}"),
        Way::Eigen => format!("{count} one by one{format}"),
        Way::Linear(knots) => format!("{count}, {knots} knots{format}"),
        Way::Cubic(knots) => format!("{count}, {knots} knots cubic{format}"),
        Way::Bilinear(size) => format!("{count}, map {size}²{format}"),
        Way::Nearest(size) => format!("{count}, map {size}² nearest{format}"),
    }
}

/// Whether a setting has the shipped degree and order; only such settings have comparable errors.
fn comparable(point: &Point) -> bool {
    let recipe = point.setting.recipe;
    (recipe.degree, recipe.order) == (DEGREE, ORDER) && point.setting.scaling == Scaling::None
}

fn of_machine(points: &[Point], machine: Machine) -> Result<String> {
    let error = |point: &Point| point.method.unseen.rms.most;
    let priced: Vec<(usize, (f64, f64))> = points
        .iter()
        .enumerate()
        .filter(|(_, point)| comparable(point))
        .filter_map(|(k, point)| {
            let cost = frame(point, machine, Lighting::Still)? / FRAME as f64;
            Some((k, (cost, error(point))))
        })
        .collect();
    let places: Vec<(f64, f64)> = priced.iter().map(|(_, place)| *place).collect();
    let front = front(&places);
    // The settings that the page's table chooses have labels.
    let taken: Vec<usize> = LIMITS
        .iter()
        .filter_map(|&limit| cheapest(points, machine, Lighting::Still, limit))
        .collect();
    let few = front.len() <= 6;
    let label = |k: usize| {
        let point = &points[k];
        let named = few || taken.contains(&k);
        if named { short(&point.setting, point.method.terms) } else { String::new() }
    };
    let nine = points.iter().find(|point| point.setting.way == Way::NineTerms);
    let nine = nine.and_then(|point| frame(point, machine, Lighting::Still));
    let model = points.iter().find(|point| comparable(point)).and_then(|point| point.model);
    scatter(&Scatter {
        horizontal: format!("{}: a pixel, in {}", machine.title(), machine.unit()),
        vertical: "rms error of the peak, 95 of 100 unseen",
        front: front.iter().map(|&k| (places[k], label(priced[k].0))).collect(),
        points: places,
        upright: nine.map(|cost| {
            let each = cost / FRAME as f64;
            (
                each,
                if machine.counts() { format!("nine terms: {each}") } else { "nine terms".into() },
            )
        }),
        level: model.map(|one| {
            (one.median, format!("degree {DEGREE}, order {ORDER}: {}", per_cent(one.median)))
        }),
    })
}

/// The cost of a pixel of a degree and an order, and the error of its model, by the cheapest
/// setting whose method error is at most a third of that.
#[must_use]
pub fn of_degree(
    points: &[Point],
    models: &[Row],
    (degree, order): (usize, usize),
) -> Option<(f64, f64)> {
    let model = model::spread(models, degree, order)?;
    let able = points.iter().filter(|point| {
        let recipe = point.setting.recipe;
        (recipe.degree, recipe.order) == (degree, order)
            && point.setting.scaling == Scaling::None
            && point.method.seen.rms.median <= model.median / 3.0
    });
    let costs = able.filter_map(|point| frame(point, Machine::Host, Lighting::Still));
    let least = costs.min_by(f64::total_cmp)?;
    Some((least / FRAME as f64, model.median))
}

/// The model's error against the cost of a pixel.
fn degrees(points: &[Point], models: &[Row]) -> Result<String> {
    let sizes = model::sizes();
    let priced = sizes.iter().filter_map(|&(degree, order)| {
        let place = of_degree(points, models, (degree, order))?;
        Some((place, format!("{degree}, {order}")))
    });
    let (places, labels): (Vec<_>, Vec<String>) = priced.unzip();
    let front = front(&places);
    scatter(&Scatter {
        horizontal: format!("a pixel, in {}", Machine::Host.unit()),
        vertical: "error of the model, median",
        front: front.iter().map(|&k| (places[k], labels[k].clone())).collect(),
        points: places,
        upright: None,
        level: None,
    })
}

/// The quantities that grow and the units in which they are measured, one chart for each.
#[must_use]
pub fn kinds(growths: &[Growth]) -> Vec<(&'static str, &'static str)> {
    let mut kinds: Vec<_> = growths.iter().map(|one| (one.quantity, one.unit)).collect();
    kinds.dedup();
    kinds
}

/// The file name of the chart.
#[must_use]
pub fn growth_file(quantity: &str, unit: &str) -> String {
    let measure = if unit == "ns" { "times" } else { unit };
    format!("growth-{quantity}-{measure}.svg")
}

/// The chart of one quantity in one unit.
///
/// # Errors
///
/// Never in practice.
pub fn growing(growths: &[Growth], quantity: &str, unit: &str) -> Result<String> {
    let mut lines = Vec::new();
    for growth in growths.iter().filter(|one| (one.quantity, one.unit) == (quantity, unit)) {
        let (Some(first), Some((a, b))) =
            (growth.points.first(), super::exponent::fit(&growth.points))
        else {
            continue;
        };
        let points: Vec<(f64, f64)> =
            growth.points.iter().map(|&(x, y)| (x, y / first.1)).collect();
        let ends = [points[points.len() / 2], points[points.len() - 1]];
        let fitted = ends.map(|(x, _)| (x, a * x.powf(b) / first.1));
        let theory = growth.theory.map(|theory| format!(" ({})", exponent(theory)));
        let name = format!("{}: {b:.2}{}", growth.measure, theory.unwrap_or_default());
        lines.push(Line { name, points, fitted });
    }
    let horizontal = format!("{quantity}; exponents fitted (theory)");
    let vertical = match unit {
        "ns" => "time, of the first",
        "bytes" => "bytes, of the first",
        _ => "multiplications, of the first",
    };
    growth(&Lines { horizontal, vertical, lines })
}
