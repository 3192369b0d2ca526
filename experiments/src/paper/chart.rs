//! Charts of lines, as SVG: for a phone and for print.

use eigenshade_model::error::{Error, Result};
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use std::fmt::Display;
use std::ops::Range;

/// Pixels of a chart, across and down.
pub const SIZE: (u32, u32) = (720, 500);
/// Height of all letters.
pub const LETTERS: u32 = 19;
/// Lines and their names. Told apart by people who do not tell red from green.
pub const BLUE: RGBColor = RGBColor(0, 95, 170);
/// See [`BLUE`].
pub const ORANGE: RGBColor = RGBColor(213, 94, 0);
/// See [`BLUE`].
pub const GREEN: RGBColor = RGBColor(0, 135, 100);
/// See [`BLUE`].
pub const PURPLE: RGBColor = RGBColor(160, 70, 130);
/// What stands behind.
pub const PALE: RGBColor = RGBColor(196, 199, 204);
/// Letters.
pub const INK: RGBColor = RGBColor(40, 42, 46);

/// One line.
pub struct Line {
    /// What it is called in the legend; none for one that is not named.
    pub name: Option<String>,
    /// Its colour.
    pub colour: RGBColor,
    /// Whether it is dashed.
    pub dashed: bool,
    /// Its width.
    pub width: u32,
    /// What it joins.
    pub points: Vec<(f64, f64)>,
    /// Whether each point is marked.
    pub marked: bool,
}

impl Line {
    /// A line with a name.
    pub fn new(name: &str, colour: RGBColor, points: Vec<(f64, f64)>) -> Self {
        let name = Some(name.to_owned());
        Self { name, colour, dashed: false, width: 3, points, marked: false }
    }
}

/// Two axes: the horizontal one linear, the vertical one logarithmic.
pub struct Axes {
    /// Below.
    pub horizontal: &'static str,
    /// At the left.
    pub vertical: &'static str,
    /// Range of the horizontal axis.
    pub columns: Range<f64>,
    /// Range of the vertical axis.
    pub rows: Range<f64>,
    /// Numbers at the horizontal axis.
    pub labels: usize,
    /// What the numbers at the vertical axis look like.
    pub format: fn(&f64) -> String,
    /// Where the legend stands.
    pub legend: SeriesLabelPosition,
}

/// The chart.
pub fn lines(axes: &Axes, lines: &[Line]) -> Result<String> {
    let mut svg = String::new();
    {
        let root = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
        root.fill(&WHITE).map_err(fault)?;
        let mut chart = ChartBuilder::on(&root)
            .margin_top(16)
            .margin_right(28)
            .margin_bottom(6)
            .margin_left(4)
            .x_label_area_size(60)
            .y_label_area_size(92)
            .build_cartesian_2d(axes.columns.clone(), axes.rows.clone().log_scale())
            .map_err(fault)?;
        chart
            .configure_mesh()
            .x_desc(axes.horizontal)
            .y_desc(axes.vertical)
            .x_labels(axes.labels)
            .x_label_formatter(&|value| format!("{value:.0}"))
            .y_label_formatter(&axes.format)
            .axis_style(INK)
            .bold_line_style(RGBColor(226, 228, 232))
            .light_line_style(WHITE)
            .label_style(letters())
            .axis_desc_style(letters())
            .draw()
            .map_err(fault)?;
        for line in lines {
            let style = line.colour.stroke_width(line.width);
            // Outside the axes nothing is drawn.
            let points: Vec<(f64, f64)> = line
                .points
                .iter()
                .filter(|(x, y)| axes.rows.contains(y) && *x <= axes.columns.end)
                .copied()
                .collect();
            let drawn = if line.dashed {
                chart.draw_series(DashedLineSeries::new(points.clone(), 9, 7, style))
            } else {
                chart.draw_series(LineSeries::new(points.clone(), style))
            };
            let drawn = drawn.map_err(fault)?;
            if let Some(name) = &line.name {
                let (dashed, colour) = (line.dashed, line.colour);
                drawn.label(name).legend(move |(x, y)| {
                    let (ends, style) = ([(x, y), (x + 30, y)], colour.stroke_width(3));
                    if dashed {
                        DashedPathElement::new(ends, 9, 7, style).into_dyn()
                    } else {
                        PathElement::new(ends, style).into_dyn()
                    }
                });
            }
            if line.marked {
                let mark = |&point: &(f64, f64)| Circle::new(point, 5, line.colour.filled());
                chart.draw_series(points.iter().map(mark)).map_err(fault)?;
            }
        }
        if lines.iter().any(|line| line.name.is_some()) {
            chart
                .configure_series_labels()
                .position(axes.legend.clone())
                .legend_area_size(40)
                .margin(8)
                .background_style(WHITE)
                .border_style(RGBColor(226, 228, 232))
                .label_font(letters())
                .draw()
                .map_err(fault)?;
        }
        root.present().map_err(fault)?;
    }
    Ok(svg)
}

/// The letters of everything.
pub fn letters() -> TextStyle<'static> {
    ("sans-serif", LETTERS).into_font().color(&INK)
}

/// 1 for 100 %, and so on; powers of ten.
pub fn percent(value: &f64) -> String {
    let value = 100.0 * value;
    if value >= 0.99 { format!("{value:.0} %") } else { format!("{} %", short(value)) }
}

/// A power of ten as few letters as may be.
fn short(value: f64) -> String {
    let places = (-value.log10()).ceil().max(0.0) as usize;
    format!("{value:.places$}")
}

/// What cannot happen: the chart goes to a text.
pub fn fault(error: impl Display) -> Error {
    Error::new(error.to_string(), "report this: a chart could not be drawn")
}
