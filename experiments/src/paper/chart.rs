//! Line charts as SVG, readable on a phone and in print.

use eigenshade_model::error::{Error, Result};
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use std::fmt::Display;
use std::ops::Range;

/// Width and height of a chart in pixels.
pub const SIZE: (u32, u32) = (720, 500);
/// Height of all text.
pub const LETTERS: u32 = 19;
/// Color of lines and their names, distinguishable with red-green color blindness.
pub const BLUE: RGBColor = RGBColor(0, 95, 170);
/// See [`BLUE`].
pub const ORANGE: RGBColor = RGBColor(213, 94, 0);
/// See [`BLUE`].
pub const GREEN: RGBColor = RGBColor(0, 135, 100);
/// See [`BLUE`].
pub const PURPLE: RGBColor = RGBColor(160, 70, 130);
/// Color of background elements.
pub const PALE: RGBColor = RGBColor(196, 199, 204);
/// Color of the text.
pub const INK: RGBColor = RGBColor(40, 42, 46);

/// One line.
pub struct Line {
    /// The name in the legend; `None` if it has no entry.
    pub name: Option<String>,
    /// Its color.
    pub colour: RGBColor,
    /// Whether it is dashed.
    pub dashed: bool,
    /// Its width.
    pub width: u32,
    /// The points that it joins.
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
    /// Title of the horizontal axis.
    pub horizontal: &'static str,
    /// Title of the vertical axis.
    pub vertical: &'static str,
    /// Range of the horizontal axis.
    pub columns: Range<f64>,
    /// Range of the vertical axis.
    pub rows: Range<f64>,
    /// How many numbers the horizontal axis has.
    pub labels: usize,
    /// The format of the numbers at the vertical axis.
    pub format: fn(&f64) -> String,
    /// The position of the legend.
    pub legend: SeriesLabelPosition,
}

/// Draws the chart.
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
            // Nothing is drawn outside the axes.
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

/// The text style of the whole chart.
pub fn letters() -> TextStyle<'static> {
    ("sans-serif", LETTERS).into_font().color(&INK)
}

/// Formats powers of ten as percentages: 1 is 100 %.
pub fn percent(value: &f64) -> String {
    let value = 100.0 * value;
    if value >= 0.99 { format!("{value:.0} %") } else { format!("{} %", short(value)) }
}

/// Formats a power of ten with as few characters as possible.
fn short(value: f64) -> String {
    let places = (-value.log10()).ceil().max(0.0) as usize;
    format!("{value:.places$}")
}

/// The error for a failed chart. It cannot happen, because the chart is written to a string.
pub fn fault(error: impl Display) -> Error {
    Error::new(error.to_string(), "report this: a chart could not be drawn")
}
