//! SVG charts with two logarithmic axes, large letters and no overlapping labels.

use crate::paper::chart::{BLUE, GREEN, INK, LETTERS, ORANGE, PALE, SIZE, fault, letters};
use eigenshade_model::error::Result;
use plotters::coord::Shift;
use plotters::coord::combinators::LogCoord;
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::ops::Range;

/// Average width of a letter, relative to the height of the letters.
const LETTER_WIDTH: f64 = 0.42;
/// Colors of a chart's lines, in order.
const COLORS: [RGBColor; 3] = [BLUE, ORANGE, GREEN];

/// Points, their Pareto front, and reference lines.
pub struct Scatter {
    /// Title of the horizontal axis.
    pub horizontal: String,
    /// Title of the vertical axis.
    pub vertical: &'static str,
    /// All points.
    pub points: Vec<(f64, f64)>,
    /// The points of the front by rising cost, with their labels.
    pub front: Vec<((f64, f64), String)>,
    /// The cost of a reference, with its label.
    pub upright: Option<(f64, String)>,
    /// The error of a reference, with its label.
    pub level: Option<(f64, String)>,
}

/// Lines with legends.
pub struct Lines {
    /// Title of the horizontal axis.
    pub horizontal: String,
    /// Title of the vertical axis.
    pub vertical: &'static str,
    /// The lines.
    pub lines: Vec<Line>,
}

/// One line.
pub struct Line {
    /// Its legend.
    pub name: String,
    /// The points that it joins.
    pub points: Vec<(f64, f64)>,
    /// The ends of the fitted straight line.
    pub fitted: [(f64, f64); 2],
}

type Drawing<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Chart<'a> = ChartContext<'a, SVGBackend<'a>, Cartesian2d<LogCoord<f64>, LogCoord<f64>>>;

/// The range of some values, with a margin on either side.
fn range(values: impl Iterator<Item = f64>, margin: f64) -> Range<f64> {
    let (mut low, mut high) = (f64::INFINITY, 0.0f64);
    for value in values.filter(|value| *value > 0.0 && value.is_finite()) {
        (low, high) = (low.min(value), high.max(value));
    }
    if low > high {
        (low, high) = (1.0, 10.0);
    }
    let more = (high / low).powf(margin).max(1.3);
    low / more..high * more
}

/// Formats a number for an axis.
fn plain(value: &f64) -> String {
    if (0.001..1e6).contains(value) {
        let text = format!("{value:.3}");
        let text = text.trim_end_matches('0').trim_end_matches('.');
        if *value >= 1000.0 {
            eigenshade_cli::messages::grouped(value.round() as usize)
        } else {
            text.into()
        }
    } else {
        format!("{value:.0e}")
    }
}

/// Formats an error for an axis.
fn share(value: &f64) -> String {
    if *value < 0.99e-4 { format!("{value:.0e}") } else { format!("{} %", plain(&(100.0 * value))) }
}

fn framed<'a>(
    root: &Drawing<'a>,
    [columns, rows]: [Range<f64>; 2],
    [horizontal, vertical]: [&str; 2],
    format: fn(&f64) -> String,
) -> Result<Chart<'a>> {
    root.fill(&WHITE).map_err(fault)?;
    let mut chart = ChartBuilder::on(root)
        .margin_top(16)
        .margin_right(28)
        .margin_bottom(6)
        .margin_left(4)
        .x_label_area_size(60)
        .y_label_area_size(96)
        .build_cartesian_2d(columns.log_scale(), rows.log_scale())
        .map_err(fault)?;
    chart
        .configure_mesh()
        .x_desc(horizontal)
        .y_desc(vertical)
        .x_labels(6)
        .y_labels(8)
        .x_label_formatter(&plain)
        .y_label_formatter(&format)
        .axis_style(INK)
        .bold_line_style(RGBColor(226, 228, 232))
        .light_line_style(WHITE)
        .label_style(letters())
        .axis_desc_style(letters())
        .draw()
        .map_err(fault)?;
    Ok(chart)
}

/// A box of pixels: left, top, right, bottom.
type Frame = [i32; 4];

fn meet([a, b, c, d]: Frame, [e, f, g, h]: Frame) -> bool {
    a < g && e < c && b < h && f < d
}

/// The labels placed so far.
struct Labels {
    taken: Vec<Frame>,
    within: Frame,
}

impl Labels {
    /// Writes a label beside a pixel if there is free space for it. Returns whether it was written.
    fn write(&mut self, root: &Drawing<'_>, (x, y): (i32, i32), text: &str) -> Result<bool> {
        let width = (LETTER_WIDTH * f64::from(LETTERS) * text.chars().count() as f64) as i32;
        let height = LETTERS.cast_signed();
        let places = [
            (x + 9, y - height - 4),
            (x + 9, y + 4),
            (x - width - 9, y + 4),
            (x - width - 9, y - height - 4),
            (x + 12, y - height / 2),
        ];
        for (left, top) in places {
            let frame = [left, top, left + width, top + height];
            let [a, b, c, d] = self.within;
            let inside = left >= a && top >= b && left + width <= c && top + height <= d;
            if inside && !self.taken.iter().any(|other| meet(*other, frame)) {
                self.taken.push(frame);
                let style = letters().pos(Pos::new(HPos::Left, VPos::Top));
                root.draw(&Text::new(text.to_owned(), (left, top), style)).map_err(fault)?;
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Reserves the area of this straight line, so that no label covers it.
    fn keep_off(&mut self, (a, b): (i32, i32), (c, d): (i32, i32)) {
        self.taken.push([a.min(c) - 2, b.min(d) - 2, a.max(c) + 2, b.max(d) + 2]);
    }
}

/// The chart of a front.
///
/// # Errors
///
/// Never in practice.
pub fn scatter(scatter: &Scatter) -> Result<String> {
    let mut svg = String::new();
    {
        let root = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
        let upright = scatter.upright.iter().map(|(cost, _)| *cost);
        let level = scatter.level.iter().map(|(error, _)| *error);
        let costs = scatter.points.iter().map(|point| point.0).chain(upright);
        let errors = scatter.points.iter().map(|point| point.1).chain(level);
        let (columns, rows) = (range(costs, 0.08), range(errors, 0.06));
        let axes = [&*scatter.horizontal, scatter.vertical];
        let mut chart = framed(&root, [columns.clone(), rows.clone()], axes, share)?;
        let pixel = |point: (f64, f64)| chart.backend_coord(&point);
        let corners = [pixel((columns.start, rows.end)), pixel((columns.end, rows.start))];
        let within = [corners[0].0, corners[0].1, corners[1].0, corners[1].1];
        let mut labels = Labels { taken: Vec::new(), within };
        let places: Vec<(i32, i32)> =
            scatter.front.iter().map(|(point, _)| pixel(*point)).collect();
        let upright = scatter.upright.as_ref().map(|(cost, _)| pixel((*cost, rows.start)));
        let level = scatter.level.as_ref().map(|(error, _)| pixel((columns.start, *error)));
        labels.taken.extend(places.iter().map(|&(x, y)| [x - 7, y - 7, x + 7, y + 7]));
        let dots = scatter.points.iter().map(|&point| Circle::new(point, 4, PALE.filled()));
        chart.draw_series(dots).map_err(fault)?;
        if let Some((cost, _)) = &scatter.upright {
            let ends = [(*cost, rows.start), (*cost, rows.end)];
            let dashes = DashedPathElement::new(ends, 7, 6, ORANGE.stroke_width(2));
            chart.draw_series([dashes]).map_err(fault)?;
        }
        if let Some((error, _)) = &scatter.level {
            let ends = [(columns.start, *error), (columns.end, *error)];
            let dashes = DashedPathElement::new(ends, 7, 6, GREEN.stroke_width(2));
            chart.draw_series([dashes]).map_err(fault)?;
        }
        // A front is a staircase: a higher cost need not bring any gain.
        let mut stairs = Vec::new();
        for (k, (point, _)) in scatter.front.iter().enumerate() {
            if k > 0 {
                stairs.push((point.0, scatter.front[k - 1].0.1));
            }
            stairs.push(*point);
        }
        for pair in stairs.windows(2) {
            labels.keep_off(chart.backend_coord(&pair[0]), chart.backend_coord(&pair[1]));
        }
        chart.draw_series(LineSeries::new(stairs, BLUE.stroke_width(3))).map_err(fault)?;
        let dots = scatter.front.iter().map(|(point, _)| Circle::new(*point, 6, BLUE.filled()));
        chart.draw_series(dots).map_err(fault)?;
        if let Some(((_, text), (x, y))) = scatter.upright.as_ref().zip(upright) {
            labels.keep_off((x, y), (x, within[1]));
            labels.write(&root, (x, y - 6), text)?;
        }
        if let Some(((_, text), (x, y))) = scatter.level.as_ref().zip(level) {
            labels.keep_off((x, y), (within[2], y));
            // At its beginning or at its end.
            let _ =
                labels.write(&root, (x, y), text)? || labels.write(&root, (within[2], y), text)?;
        }
        let front = places.iter().zip(&scatter.front);
        for (place, (_, text)) in front.filter(|(_, (_, text))| !text.is_empty()) {
            labels.write(&root, *place, text)?;
        }
        root.present().map_err(fault)?;
    }
    Ok(svg)
}

/// The chart of the growth curves.
///
/// # Errors
///
/// Never in practice.
pub fn growth(lines: &Lines) -> Result<String> {
    let mut svg = String::new();
    {
        let root = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
        let all = || lines.lines.iter().flat_map(|line| line.points.iter().copied());
        let columns = range(all().map(|point| point.0), 0.06);
        let mut rows = range(all().map(|point| point.1), 0.06);
        // Makes room for the legend.
        rows.end *= (rows.end / rows.start).powf(0.12 * lines.lines.len() as f64);
        let axes = [&*lines.horizontal, lines.vertical];
        let mut chart = framed(&root, [columns, rows], axes, plain)?;
        for (Line { name, points, fitted }, color) in lines.lines.iter().zip(COLORS) {
            let style = color.stroke_width(3);
            chart
                .draw_series(LineSeries::new(points.clone(), style))
                .map_err(fault)?
                .label(name)
                .legend(move |(x, y)| PathElement::new([(x, y), (x + 30, y)], style));
            let dots = points.iter().map(|&point| Circle::new(point, 5, color.filled()));
            chart.draw_series(dots).map_err(fault)?;
            let dashes = DashedPathElement::new(*fitted, 7, 6, INK.stroke_width(1));
            chart.draw_series([dashes]).map_err(fault)?;
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperLeft)
            .legend_area_size(40)
            .margin(8)
            .background_style(WHITE)
            .border_style(RGBColor(226, 228, 232))
            .label_font(letters())
            .draw()
            .map_err(fault)?;
        root.present().map_err(fault)?;
    }
    Ok(svg)
}

#[cfg(test)]
mod tests {
    use super::{meet, plain, range, share};

    #[test]
    fn numbers_beside_axes_are_short() {
        let texts = [0.01, 1.0, 25.0, 1000.0, 5e6].map(|value| plain(&value));
        assert_eq!(texts, ["0.01", "1", "25", "1,000", "5e6"]);
        assert_eq!([0.01, 1e-3, 1e-5].map(|value| share(&value)), ["1 %", "0.1 %", "1e-5"]);
    }

    #[test]
    fn ranges_enclose() {
        let found = range([2.0, 200.0, 0.0].into_iter(), 0.1);
        assert!(found.start < 2.0 && found.end > 200.0 && found.start > 0.0);
        assert!(meet([0, 0, 2, 2], [1, 1, 3, 3]) && !meet([0, 0, 2, 2], [2, 0, 3, 2]));
    }
}
