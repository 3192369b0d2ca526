//! Charts as SVG, readable on a phone and in print.

use eigenshade_model::error::{Error, Result};
use plotters::coord::ranged1d::{AsRangedCoord, ValueFormatter};
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use std::fmt::Display;
use std::ops::Range;

/// Width and height of a chart in pixels.
const SIZE: (u32, u32) = (720, 500);
/// Height of all text.
const LETTERS: u32 = 19;
/// Colors of lines and dots, distinguishable with red-green color blindness.
pub const BLUE: RGBColor = RGBColor(0, 95, 170);
pub const ORANGE: RGBColor = RGBColor(213, 94, 0);
pub const GREEN: RGBColor = RGBColor(0, 135, 100);
pub const PURPLE: RGBColor = RGBColor(160, 70, 130);
const YELLOW: RGBColor = RGBColor(204, 160, 0);
const SKY: RGBColor = RGBColor(86, 170, 220);
const GRAY: RGBColor = RGBColor(120, 120, 120);
/// Color of background elements.
pub const PALE: RGBColor = RGBColor(196, 199, 204);
pub const INK: RGBColor = RGBColor(40, 42, 46);
/// Color of grid lines and borders.
const GRID: RGBColor = RGBColor(226, 228, 232);
pub const COLORS: [RGBColor; 8] = [BLUE, ORANGE, GREEN, PURPLE, YELLOW, SKY, GRAY, INK];

pub struct Chart {
    /// Titles of the horizontal and of the vertical axis.
    pub titles: [String; 2],
    pub axes: Axes,
    pub legend: SeriesLabelPosition,
    /// The series, in the order of the legend.
    pub series: Vec<Series>,
    /// Texts beside points.
    pub labels: Vec<((f64, f64), String)>,
}

pub enum Axes {
    /// Linear with this many numbers; vertically logarithmic and in percent: 1 is 100 %.
    Percent { columns: Range<f64>, rows: Range<f64>, labels: usize },
    /// Both are logarithmic and reach as far as the points.
    Logarithmic,
}

pub type Points = Vec<(f64, f64)>;

pub struct Series {
    /// The name in the legend; without one it has no entry.
    pub name: String,
    pub style: Style,
    pub color: RGBColor,
    pub width: u32,
    pub points: Points,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    Dots,
    Line,
    Dashed,
}

/// Series in the colors of [`COLORS`].
pub fn colored(all: impl IntoIterator<Item = (impl Into<String>, Style, Points)>) -> Vec<Series> {
    let colored = all.into_iter().zip(COLORS.into_iter().cycle());
    let new = |((name, style, points), color)| Series::new(name, style, color, points);
    colored.map(new).collect()
}

impl Series {
    pub fn new(name: impl Into<String>, style: Style, color: RGBColor, points: Points) -> Self {
        Self { name: name.into(), style, color, width: 3, points }
    }
}

impl Chart {
    pub fn new(titles: [&str; 2], axes: Axes, at: SeriesLabelPosition, all: Vec<Series>) -> Self {
        Self { titles: titles.map(Into::into), axes, legend: at, series: all, labels: vec![] }
    }

    pub fn svg(&self) -> Result<String> {
        let mut svg = String::new();
        let drawn = match &self.axes {
            Axes::Percent { columns, rows, labels } => {
                self.draw(&mut svg, columns.clone(), rows.clone(), *labels, percent)
            }
            Axes::Logarithmic => {
                let points = || self.series.iter().flat_map(|series| &series.points);
                let columns = range(points().map(|point| point.0)).log_scale();
                self.draw(&mut svg, columns, range(points().map(|point| point.1)), 6, number)
            }
        };
        drawn.map_err(fault)?;
        Ok(svg)
    }

    fn draw<X: AsRangedCoord<Value = f64>>(
        &self,
        svg: &mut String,
        columns: X,
        rows: Range<f64>,
        labels: usize,
        percent_or_number: fn(&f64) -> String,
    ) -> DrawResult<()>
    where
        X::CoordDescType: ValueFormatter<f64>,
    {
        let root = SVGBackend::with_string(svg, SIZE).into_drawing_area();
        root.fill(&WHITE)?;
        let mut chart = ChartBuilder::on(&root)
            .margin_top(16)
            .margin_right(28)
            .margin_bottom(6)
            .margin_left(4)
            .x_label_area_size(60)
            .y_label_area_size(92)
            .build_cartesian_2d(columns, rows.clone().log_scale())?;
        chart
            .configure_mesh()
            .x_desc(&self.titles[0])
            .y_desc(&self.titles[1])
            .x_labels(labels)
            .x_label_formatter(&number)
            .y_label_formatter(&percent_or_number)
            .axis_style(INK)
            .bold_line_style(GRID)
            .light_line_style(WHITE)
            .label_style(letters())
            .draw()?;
        for Series { name, style, color, width, points } in &self.series {
            let (style, color) = (*style, *color);
            // Nothing is drawn below or above the axes.
            let points = points.iter().filter(|point| rows.contains(&point.1)).copied();
            let stroke = color.stroke_width(*width);
            let drawn = match style {
                Style::Dots => {
                    chart.draw_series(points.map(|point| Circle::new(point, 5, color.filled())))?
                }
                Style::Line => chart.draw_series(LineSeries::new(points, stroke))?,
                Style::Dashed => chart.draw_series(DashedLineSeries::new(points, 9, 7, stroke))?,
            };
            if !name.is_empty() {
                drawn.label(name).legend(move |(x, y)| {
                    let (ends, stroke) = ([(x, y), (x + 30, y)], color.stroke_width(3));
                    match style {
                        Style::Dots => Circle::new((x + 15, y), 5, color.filled()).into_dyn(),
                        Style::Line => PathElement::new(ends, stroke).into_dyn(),
                        Style::Dashed => DashedPathElement::new(ends, 9, 7, stroke).into_dyn(),
                    }
                });
            }
        }
        chart.draw_series(self.labels.iter().map(|(point, text)| {
            EmptyElement::at(*point) + Text::new(text.clone(), (7, -20), letters())
        }))?;
        chart
            .configure_series_labels()
            .position(self.legend.clone())
            .legend_area_size(40)
            .margin(8)
            .background_style(WHITE)
            .border_style(GRID)
            .label_font(letters())
            .draw()?;
        root.present()
    }
}

/// What drawing into a string returns.
pub type DrawResult<T> = std::result::Result<T, DrawingAreaErrorKind<std::io::Error>>;

/// The text style of the whole chart.
pub fn letters() -> TextStyle<'static> {
    ("sans-serif", LETTERS).into_font().color(&INK)
}

/// The error for a failed chart. It cannot happen, because the chart is written to a string.
pub fn fault(error: impl Display) -> Error {
    Error::new(error.to_string(), "report this: a chart could not be drawn")
}

/// The range of some values, with a margin on either side.
fn range(values: impl Iterator<Item = f64>) -> Range<f64> {
    let of_none = (f64::INFINITY, 0.0f64);
    let (low, high) = values.fold(of_none, |(low, high), one| (low.min(one), high.max(one)));
    if low > high {
        return 1.0..10.0;
    }
    let margin = (high / low).powf(0.06).max(1.3);
    low / margin..high * margin
}

/// Formats powers of ten as percentages with as few characters as possible: 1 is 100 %.
fn percent(value: &f64) -> String {
    let value = 100.0 * value;
    let places = if value >= 0.99 { 0.0 } else { (-value.log10()).ceil().max(0.0) };
    format!("{value:.*} %", places as usize)
}

fn number(value: &f64) -> String {
    if *value == 0.0 || (0.001..1e5).contains(value) {
        format!("{}", (1e6 * value).round() / 1e6)
    } else {
        format!("{value:.0e}")
    }
}
