//! Fig. 2: the variance of the irradiance modes, over degrees of the light and surface modes.

use super::{DEGREE, ORDER, Study, csv, row};
use crate::chart::{Axes, COLORS, Chart, DrawResult, INK, Points, Series, Style, fault, letters};
use crate::figures::{self, OutputFile};
use crate::sheet::Sheet;
use eigenshade_model::error::Result;
use eigenshade_model::selection::variances;
use eigenshade_table::{material, mode};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// The surfaces of the paper: the largest order, the degree of the light, and the name.
pub const SURFACES: [(usize, usize, &str); 3] =
    [(0, 2, "Lambertian"), (4, 5, "o <= 4"), (7, 7, "o <= 7")];
/// Variances below this share of the largest are rounding; most of them are exactly zero.
const ROUNDING: f64 = 1e-20;
/// Decades that the color scale spans: down to a millionth.
const DECADES: f64 = 6.0;

/// The variances by mode of the surface in the order of [`material`], then by l.
pub struct Variance {
    /// Variance summed over m.
    pub by_mode: Vec<[f64; DEGREE + 1]>,
    /// The number of m that are among the selected modes.
    selected: Vec<[usize; DEGREE + 1]>,
}

impl Variance {
    pub fn new(study: &Study) -> Self {
        let count = material::count(ORDER);
        let mut by_mode = vec![[0.0; DEGREE + 1]; count];
        let mut selected = vec![[0; DEGREE + 1]; count];
        for azimuth in 0..=DEGREE {
            let signs = if azimuth == 0 { 1 } else { 2 };
            let modes = mode::indices(DEGREE, ORDER, azimuth);
            for ((l, o, p, q), value) in modes.zip(variances(&study.gram, azimuth)) {
                let place = material::position(o, p, q);
                by_mode[place][l] += signs as f64 * value;
                if study.selection[study.gram.place(azimuth, l, o, p, q)] {
                    selected[place][l] += signs;
                }
            }
        }
        let largest = largest(&by_mode);
        let rounding = by_mode.iter_mut().flatten().filter(|value| **value < ROUNDING * largest);
        rounding.for_each(|value| *value = 0.0);
        Self { by_mode, selected }
    }

    /// For each l, the share of the variance of all modes up to `order` that lies beyond degree l.
    pub fn beyond(&self, order: usize) -> Vec<f64> {
        let of_degree = |l: usize| -> f64 {
            self.by_mode.iter().take(material::count(order)).map(|by_degree| by_degree[l]).sum()
        };
        let all: f64 = (0..=DEGREE).map(of_degree).sum();
        (0..=DEGREE).map(|l| (l + 1..=DEGREE).map(of_degree).sum::<f64>() / all).collect()
    }

    pub fn files(&self) -> Result<Vec<OutputFile>> {
        let mut rows = Vec::new();
        for (place, (o, p, q)) in material::indices(ORDER).enumerate() {
            for l in q..=DEGREE {
                let [value, selected] = [self.by_mode[place][l], self.selected[place][l] as f64];
                rows.push(row(&[&l, &o, &p, &q], [value, (2 * l + 1) as f64, selected]));
            }
        }
        let mut shares = Vec::new();
        for (order, _, name) in SURFACES {
            for (l, beyond) in self.beyond(order).into_iter().enumerate().take(DEGREE) {
                shares.push(row(&[&name, &l, &mode::total(l, order)], [beyond]));
            }
        }
        Ok(vec![
            csv("variance.csv", "l,o,p,q,variance,modes,selected", &rows)?,
            csv("variance_beyond.csv", "surface,degree,modes,beyond", &shares)?,
        ])
    }

    /// The variances of `variance.csv`, without the selected modes.
    pub fn of(sheet: &Sheet) -> Self {
        let mut by_mode = vec![[0.0; DEGREE + 1]; material::count(ORDER)];
        let [l, o, p, q] = ["l", "o", "p", "q"].map(|name| sheet.numbers(name));
        for (k, value) in sheet.numbers("variance").into_iter().enumerate() {
            let [l, o, p, q] = [&l, &o, &p, &q].map(|index| index[k] as usize);
            by_mode[material::position(o, p, q)][l] = value;
        }
        Self { by_mode, selected: Vec::new() }
    }

    pub fn charts(&self) -> Result<Vec<OutputFile>> {
        let mut map = String::new();
        self.map(&mut map).map_err(fault)?;
        let shares = self.shares()?;
        Ok(vec![
            figures::chart("variance.svg", &map),
            figures::chart("variance_beyond.svg", &shares),
        ])
    }

    fn shares(&self) -> Result<String> {
        let mut series = Vec::new();
        for ((order, degree, name), color) in SURFACES.into_iter().zip(COLORS) {
            let points: Points =
                (0u32..).map(f64::from).zip(self.beyond(order)).take(DEGREE).collect();
            let dot = vec![points[degree]];
            let name = name.replace("<=", "≤");
            let name = format!("{name}; dot: l = {degree}, {} modes", mode::total(degree, order));
            series.push(Series::new(name, Style::Line, color, points));
            series.push(Series::new("", Style::Dots, color, dot));
        }
        let titles = ["light up to degree l", "share of the variance beyond"];
        // Slightly lower, so that the last power of ten gets its label.
        let axes = Axes::Percent { columns: 0.0..8.0, rows: 0.99e-4..1.0, labels: 9 };
        Chart::new(titles, axes, SeriesLabelPosition::LowerLeft, series).svg()
    }

    /// The map of all modes, with the three surfaces outlined and a logarithmic color scale.
    fn map(&self, svg: &mut String) -> DrawResult<()> {
        let root = SVGBackend::with_string(svg, (980, 500)).into_drawing_area();
        root.fill(&WHITE)?;
        let (upper, lower) = root.split_vertically(436);
        // Coordinates are half modes and half degrees, so that the middles are whole.
        let right = |order: usize| 2 * material::count(order) as i32;
        let middle = |o: usize| (o.checked_sub(1).map_or(0, right) + right(o)) / 2;
        let middles: Vec<i32> = (0..=ORDER).map(middle).collect();
        let degrees = (0..=DEGREE).map(|l| 2 * l as i32 + 1).collect();
        let mut chart = ChartBuilder::on(&upper)
            .margin_top(6)
            .margin_right(28)
            .margin_left(4)
            .x_label_area_size(60)
            .y_label_area_size(76)
            .build_cartesian_2d(
                (0..right(ORDER)).with_key_points(middles.clone()),
                (0..22).with_key_points(degrees),
            )?;
        chart
            .configure_mesh()
            .disable_mesh()
            .x_desc("modes of the surface (o, p, q), by o")
            .y_desc("degree l of the light")
            .x_label_formatter(&|x: &i32| middles.partition_point(|middle| middle < x).to_string())
            .y_label_formatter(&|y: &i32| (y / 2).to_string())
            .axis_style(WHITE)
            .label_style(letters())
            .axis_desc_style(letters())
            .draw()?;
        let largest = largest(&self.by_mode);
        for (column, by_degree) in (0..).zip(&self.by_mode) {
            chart.draw_series((0..).zip(by_degree).map(|(l, value)| {
                let depth = 1.0 + (value / largest).log10() / DECADES;
                let corners = [(2 * column, 2 * l + 2), (2 * column + 2, 2 * l)];
                Rectangle::new(corners, color(depth).filled())
            }))?;
        }
        let gaps = (0..=ORDER).map(|o| vec![(right(o), 0), (right(o), 20)]);
        chart.draw_series(gaps.map(|line| PathElement::new(line, WHITE.stroke_width(1))))?;
        for (order, degree, name) in SURFACES {
            let (right, top) = (right(order), 2 * degree as i32 + 2);
            let outline = vec![(0, top), (right, top), (right, 0)];
            for style in [WHITE.stroke_width(7), INK.stroke_width(3)] {
                chart.draw_series([PathElement::new(outline.clone(), style)])?;
            }
            let stem = vec![(right, top), (right, 21)];
            chart.draw_series([PathElement::new(stem, INK.stroke_width(1))])?;
            // The Lambertian's name begins at the left edge; the others end at their own edges.
            let (at, side) = if order == 0 { (0, HPos::Left) } else { (right, HPos::Right) };
            let text = format!("{}: {}", name.replace("<=", "≤"), mode::total(degree, order));
            let style = letters().pos(Pos::new(side, VPos::Bottom));
            chart.draw_series([Text::new(text, (at, 21), style)])?;
        }
        let label = |text: &'static str, at, side| {
            lower.draw(&Text::new(text, at, letters().pos(Pos::new(side, VPos::Center))))
        };
        label("variance, of the largest", (346, 16), HPos::Right)?;
        for step in 0..60 {
            let shade = color(f64::from(step) / 59.0);
            let corners = [(356 + 6 * step, 8), (362 + 6 * step, 24)];
            lower.draw(&Rectangle::new(corners, shade.filled()))?;
        }
        for (x, text) in [(356, "≤ 1e-6"), (476, "1e-4"), (596, "1e-2"), (716, "1")] {
            label(text, (x, 40), HPos::Center)?;
        }
        root.present()
    }
}

fn largest(by_mode: &[[f64; DEGREE + 1]]) -> f64 {
    by_mode.iter().flatten().copied().fold(0.0, f64::max)
}

/// Pale for 0, dark for 1, so that the order is also visible in print without colors.
fn color(depth: f64) -> RGBColor {
    const STOPS: [[f64; 3]; 4] =
        [[240.0, 242.0, 245.0], [144.0, 196.0, 222.0], [38.0, 110.0, 170.0], [14.0, 26.0, 72.0]];
    let place = 3.0 * depth.clamp(0.0, 1.0);
    let stop = (place as usize).min(2);
    let share = place - stop as f64;
    let [r, g, b] =
        [0, 1, 2].map(|c| STOPS[stop][c] + share * (STOPS[stop + 1][c] - STOPS[stop][c]));
    RGBColor(r as u8, g as u8, b as u8)
}
