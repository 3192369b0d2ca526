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
/// Color of grid lines and borders.
const GRID: RGBColor = RGBColor(226, 228, 232);

/// One line.
pub struct Line {
    /// The name in the legend; without one it has no entry.
    pub name: String,
    pub color: RGBColor,
    pub is_dashed: bool,
    pub width: u32,
    /// The points that it joins.
    pub points: Vec<(f64, f64)>,
    /// The point that has a dot.
    pub marked: Option<usize>,
}

impl Line {
    /// A solid line.
    pub fn new(name: impl Into<String>, color: RGBColor, points: Vec<(f64, f64)>) -> Self {
        Self { name: name.into(), color, is_dashed: false, width: 3, points, marked: None }
    }
}

/// Two axes: the horizontal one linear, the vertical one logarithmic and in percent.
pub struct Axes {
    /// Titles of the horizontal and the vertical axis.
    pub titles: [&'static str; 2],
    /// Range of the horizontal axis.
    pub columns: Range<f64>,
    /// Range of the vertical axis; 1 is 100 %.
    pub rows: Range<f64>,
    /// How many numbers the horizontal axis has.
    pub labels: usize,
    pub legend: SeriesLabelPosition,
}

/// Draws the chart.
pub fn lines(axes: &Axes, lines: &[Line]) -> Result<String> {
    let mut svg = String::new();
    draw(&mut svg, axes, lines).map_err(fault)?;
    Ok(svg)
}

fn draw(svg: &mut String, axes: &Axes, lines: &[Line]) -> DrawResult<()> {
    let root = SVGBackend::with_string(svg, SIZE).into_drawing_area();
    root.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&root)
        .margin_top(16)
        .margin_right(28)
        .margin_bottom(6)
        .margin_left(4)
        .x_label_area_size(60)
        .y_label_area_size(92)
        .build_cartesian_2d(axes.columns.clone(), axes.rows.clone().log_scale())?;
    chart
        .configure_mesh()
        .x_desc(axes.titles[0])
        .y_desc(axes.titles[1])
        .x_labels(axes.labels)
        .x_label_formatter(&|value| format!("{value:.0}"))
        .y_label_formatter(&percent)
        .axis_style(INK)
        .bold_line_style(GRID)
        .light_line_style(WHITE)
        .label_style(letters())
        .axis_desc_style(letters())
        .draw()?;
    for line in lines {
        let (color, style) = (line.color, line.color.stroke_width(line.width));
        // Nothing is drawn outside the axes.
        let is_inside =
            |point: &&(f64, f64)| axes.rows.contains(&point.1) && point.0 <= axes.columns.end;
        let points = line.points.iter().filter(is_inside).copied();
        let path = move |ends: Vec<(i32, i32)>| match line.is_dashed {
            true => DashedPathElement::new(ends, 9, 7, color.stroke_width(3)).into_dyn(),
            false => PathElement::new(ends, color.stroke_width(3)).into_dyn(),
        };
        let drawn = match line.is_dashed {
            true => chart.draw_series(DashedLineSeries::new(points, 9, 7, style))?,
            false => chart.draw_series(LineSeries::new(points, style))?,
        };
        if !line.name.is_empty() {
            drawn.label(&line.name).legend(move |(x, y)| path(vec![(x, y), (x + 30, y)]));
        }
        let marked = line.marked.and_then(|place| line.points.get(place));
        chart.draw_series(marked.map(|&point| Circle::new(point, 5, color.filled())))?;
    }
    chart
        .configure_series_labels()
        .position(axes.legend.clone())
        .legend_area_size(40)
        .margin(8)
        .background_style(WHITE)
        .border_style(GRID)
        .label_font(letters())
        .draw()?;
    root.present()
}

/// What drawing into a string returns.
pub type DrawResult<T> = std::result::Result<T, DrawingAreaErrorKind<std::io::Error>>;

/// The text style of the whole chart.
pub fn letters() -> TextStyle<'static> {
    ("sans-serif", LETTERS).into_font().color(&INK)
}

/// Formats powers of ten as percentages with as few characters as possible: 1 is 100 %.
fn percent(value: &f64) -> String {
    let value = 100.0 * value;
    let places = if value >= 0.99 { 0.0 } else { (-value.log10()).ceil().max(0.0) };
    format!("{value:.*} %", places as usize)
}

/// The error for a failed chart. It cannot happen, because the chart is written to a string.
pub fn fault(error: impl Display) -> Error {
    Error::new(error.to_string(), "report this: a chart could not be drawn")
}
