//! SVG charts with two logarithmic axes.

use eigenshade_model::error::{Error, Result};
use plotters::prelude::*;
use std::fmt::Display;
use std::ops::Range;

/// Width and height of a chart in pixels.
const SIZE: (u32, u32) = (720, 500);
/// Colors of the series in order, distinguishable with red-green color blindness.
const COLORS: [RGBColor; 8] = [
    RGBColor(0, 95, 170),
    RGBColor(213, 94, 0),
    RGBColor(0, 135, 100),
    RGBColor(160, 70, 130),
    RGBColor(204, 160, 0),
    RGBColor(86, 170, 220),
    RGBColor(120, 120, 120),
    RGBColor(40, 42, 46),
];

/// Axes and series.
pub struct Chart {
    /// Titles of the horizontal and of the vertical axis.
    pub titles: [String; 2],
    /// The position of the legend.
    pub legend: SeriesLabelPosition,
    /// The series, in the order of the legend.
    pub series: Vec<Series>,
    /// Texts beside points.
    pub labels: Vec<((f64, f64), String)>,
}

/// Points and how they are drawn.
pub struct Series {
    /// The name in the legend.
    pub name: String,
    /// The points.
    pub points: Vec<(f64, f64)>,
    /// How they are drawn.
    pub style: Style,
}

/// How a series is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// As dots.
    Dots,
    /// Joined by a line.
    Line,
    /// Joined by a dashed line.
    Dashed,
}

/// The range of some values, with a margin on either side.
fn range(values: impl Iterator<Item = f64>) -> Range<f64> {
    let (low, high) = values
        .fold((f64::INFINITY, 0.0f64), |(low, high), value| (low.min(value), high.max(value)));
    if low > high {
        return 1.0..10.0;
    }
    let margin = (high / low).powf(0.06).max(1.3);
    low / margin..high * margin
}

/// Draws the chart.
pub fn svg(chart: &Chart) -> Result<String> {
    let mut svg = String::new();
    let points = || chart.series.iter().flat_map(|series| series.points.iter().copied());
    let (columns, rows) =
        (range(points().map(|point| point.0)), range(points().map(|point| point.1)));
    {
        let letters = ("sans-serif", 17).into_font();
        let root = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
        root.fill(&WHITE).map_err(fault)?;
        let mut axes = ChartBuilder::on(&root)
            .margin(16)
            .x_label_area_size(52)
            .y_label_area_size(84)
            .build_cartesian_2d(columns.log_scale(), rows.log_scale())
            .map_err(fault)?;
        axes.configure_mesh()
            .x_desc(&chart.titles[0])
            .y_desc(&chart.titles[1])
            .x_label_formatter(&number)
            .y_label_formatter(&number)
            .light_line_style(WHITE)
            .label_style(letters.clone())
            .draw()
            .map_err(fault)?;
        for (series, color) in chart.series.iter().zip(COLORS.into_iter().cycle()) {
            let points = series.points.iter().copied();
            let line = color.stroke_width(2);
            let drawn = match series.style {
                Style::Dots => {
                    axes.draw_series(points.map(|point| Circle::new(point, 4, color.filled())))
                }
                Style::Line => axes.draw_series(LineSeries::new(points, line)),
                Style::Dashed => axes.draw_series(DashedLineSeries::new(points, 7, 6, line)),
            };
            let drawn = drawn.map_err(fault)?.label(&series.name);
            match series.style {
                Style::Dots => {
                    drawn.legend(move |(x, y)| Circle::new((x + 8, y), 4, color.filled()))
                }
                _ => drawn.legend(move |(x, y)| PathElement::new([(x, y), (x + 16, y)], line)),
            };
        }
        let labels = chart.labels.iter().map(|(point, text)| {
            EmptyElement::at(*point) + Text::new(text.clone(), (7, -18), letters.clone())
        });
        axes.draw_series(labels).map_err(fault)?;
        axes.configure_series_labels()
            .position(chart.legend.clone())
            .background_style(WHITE.mix(0.85))
            .border_style(RGBColor(226, 228, 232))
            .label_font(letters)
            .draw()
            .map_err(fault)?;
        root.present().map_err(fault)?;
    }
    Ok(svg)
}

/// Formats a number at an axis.
fn number(value: &f64) -> String {
    if (0.001..1e5).contains(value) {
        format!("{}", (1e6 * value).round() / 1e6)
    } else {
        format!("{value:.0e}")
    }
}

/// The error for a failed chart. It cannot happen, because the chart is written to a string.
fn fault(error: impl Display) -> Error {
    Error::new(error.to_string(), "report this: a chart could not be drawn")
}
