//! Fig. 2: the variance of each irradiance mode, over degrees of the light and modes of
//! the surface.

use super::artefact::{Artefact, digits};
use super::chart::{self, Axes, BLUE, GREEN, INK, Line, ORANGE, fault, letters};
use super::study::{DEGREE, ORDER, Study};
use eigenshade_generator::basis::gram;
use eigenshade_index::{material, mode};
use eigenshade_model::error::Result;
use eigenshade_model::selection::variances;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// The surfaces of the paper: the largest order, the degree up to which the paper uses the light,
/// and the name.
pub const SURFACES: [(usize, usize, &str); 3] =
    [(0, 2, "Lambertian"), (4, 5, "o <= 4"), (7, 7, "o <= 7")];

/// Variances below this share of the largest are rounding; most of them are exactly zero.
const ROUNDING: f64 = 1e-20;
/// The degree up to which variance beyond [`DEGREE`] is computed.
pub const FURTHER: usize = 24;
/// Decades that the color scale spans: down to a millionth.
const DECADES: f64 = 6.0;

/// The variances, and their shares for the paper's three surfaces.
pub struct Variance {
    /// Variance summed over m, by mode of the surface in the order of [`material`], then by l.
    pub by_mode: Vec<Vec<f64>>,
    /// For each of [`SURFACES`], the share of the variance up to degree [`FURTHER`] that lies
    /// beyond [`DEGREE`].
    pub further: [f64; 3],
    /// For each, the number of m that are among the selected modes.
    selected: Vec<Vec<usize>>,
}

impl Variance {
    /// Sums the variances over m.
    #[must_use]
    pub fn new(study: &Study) -> Self {
        let empty = vec![vec![0.0; DEGREE + 1]; material::count(ORDER)];
        let empty_counts = vec![vec![0; DEGREE + 1]; material::count(ORDER)];
        let further = further();
        let mut variance = Self { by_mode: empty, further, selected: empty_counts };
        for azimuth in 0..=DEGREE {
            let signs = if azimuth == 0 { 1 } else { 2 };
            let modes = mode::indices(DEGREE, ORDER, azimuth);
            for ((l, o, p, q), value) in modes.zip(variances(&study.gram, azimuth)) {
                let place = material::position(o, p, q);
                variance.by_mode[place][l] += signs as f64 * value;
                if study.selection[study.gram.place(azimuth, l, o, p, q)] {
                    variance.selected[place][l] += signs;
                }
            }
        }
        let largest = variance.largest();
        for value in variance.by_mode.iter_mut().flatten() {
            if *value < ROUNDING * largest {
                *value = 0.0;
            }
        }
        variance
    }

    fn largest(&self) -> f64 {
        self.by_mode.iter().flatten().copied().fold(0.0, f64::max)
    }

    /// For each l, the share of the variance of all modes up to `order` that lies beyond degree l.
    #[must_use]
    pub fn beyond(&self, order: usize) -> Vec<f64> {
        let of_degree = |l: usize| {
            let modes = self.by_mode.iter().take(material::count(order));
            modes.map(|by_degree| by_degree[l]).sum::<f64>()
        };
        let all: f64 = (0..=DEGREE).map(of_degree).sum();
        (0..=DEGREE).map(|l| (l + 1..=DEGREE).map(of_degree).sum::<f64>() / all).collect()
    }

    /// The share of the variance of the modes of one o that lies beyond degree l.
    #[must_use]
    pub fn of_order_beyond(&self, o: usize, l: usize) -> f64 {
        let first = o.checked_sub(1).map_or(0, material::count);
        let modes = || self.by_mode.iter().take(material::count(o)).skip(first);
        let all: f64 = modes().flatten().sum();
        modes().flat_map(|by_degree| by_degree.iter().skip(l + 1)).sum::<f64>() / all
    }

    /// The CSV file and the charts.
    pub fn artefacts(&self) -> Result<Vec<Artefact>> {
        let mut rows = Vec::new();
        for (place, (o, p, q)) in material::indices(ORDER).enumerate() {
            for l in q..=DEGREE {
                let counts = [l, o, p, q].map(|index| index.to_string());
                let value = digits(self.by_mode[place][l]);
                let kept = self.selected[place][l].to_string();
                let orders = (2 * l + 1).to_string();
                rows.push(counts.into_iter().chain([value, orders, kept]).collect());
            }
        }
        let mut shares = Vec::new();
        for (order, _, name) in SURFACES {
            for (l, beyond) in self.beyond(order).into_iter().enumerate().take(DEGREE) {
                let modes = mode::total(l, order).to_string();
                shares.push(vec![name.into(), l.to_string(), modes, digits(beyond)]);
            }
        }
        Ok(vec![
            Artefact::csv("variance.csv", "l,o,p,q,variance,modes,selected", &rows)?,
            Artefact::chart("variance.svg", &self.map()?),
            Artefact::csv("variance_beyond.csv", "surface,degree,modes,beyond", &shares)?,
            Artefact::chart("variance_beyond.svg", &self.shares()?),
        ])
    }

    fn shares(&self) -> Result<String> {
        let mut lines = Vec::new();
        for ((order, degree, name), colour) in SURFACES.into_iter().zip([BLUE, ORANGE, GREEN]) {
            let points: Vec<(f64, f64)> =
                (0u32..).map(f64::from).zip(self.beyond(order)).take(DEGREE).collect();
            let modes = mode::total(degree, order);
            let dots = points.get(degree..=degree).map(<[_]>::to_vec).unwrap_or_default();
            let name = format!("{name}; dot: l = {degree}, {modes} modes");
            lines.push(Line::new(&name.replace("<=", "≤"), colour, points));
            lines.push(Line { name: None, marked: true, ..Line::new("", colour, dots) });
        }
        let axes = Axes {
            horizontal: "light up to degree l",
            vertical: "share of the variance beyond",
            columns: 0.0..8.0,
            // Slightly lower, so that the last power of ten gets its label.
            rows: 0.99e-4..1.0,
            labels: 9,
            format: chart::percent,
            legend: SeriesLabelPosition::LowerLeft,
        };
        chart::lines(&axes, &lines)
    }

    /// The map of all modes, with the three surfaces outlined.
    fn map(&self) -> Result<String> {
        let (left, top, cell) = (76, 74, (20, 30));
        let columns = i32::try_from(self.by_mode.len()).unwrap_or(0);
        let (right, bottom) = (left + columns * cell.0, top + 10 * cell.1);
        let size = (980, 500);
        let x = |place: usize| left + cell.0 * place as i32;
        let y = |l: usize| bottom - cell.1 * l as i32;
        let mut svg = String::new();
        {
            let root = SVGBackend::with_string(&mut svg, size).into_drawing_area();
            root.fill(&WHITE).map_err(fault)?;
            let centred = |h, v| letters().pos(Pos::new(h, v));
            let write = |text: String, at: (i32, i32), style: TextStyle<'_>| {
                root.draw(&Text::new(text, at, style)).map_err(fault)
            };
            let largest = self.largest();
            for (place, by_degree) in self.by_mode.iter().enumerate() {
                for (l, value) in by_degree.iter().enumerate() {
                    let depth = 1.0 + (value / largest).log10() / DECADES;
                    let corners = [(x(place), y(l + 1)), (x(place + 1) - 1, y(l) - 1)];
                    root.draw(&Rectangle::new(corners, colour(depth).filled())).map_err(fault)?;
                }
            }
            for (order, degree, name) in SURFACES {
                let edge = x(material::count(order));
                let path = [(left, y(degree + 1)), (edge, y(degree + 1)), (edge, bottom)];
                let path = path.map(|(x, y)| (x - 1, y - 1));
                root.draw(&PathElement::new(path, WHITE.stroke_width(7))).map_err(fault)?;
                root.draw(&PathElement::new(path, INK.stroke_width(3))).map_err(fault)?;
                let text = format!("{}: {}", name.replace("<=", "≤"), mode::total(degree, order));
                // The Lambertian's name begins at the left edge; the other names end at their own
                // edges.
                let (at, anchor) =
                    if order == 0 { (left, HPos::Left) } else { (edge, HPos::Right) };
                write(text, (at, top - 22), centred(anchor, VPos::Bottom))?;
                root.draw(&PathElement::new(
                    [(edge - 1, top - 20), (edge - 1, y(degree + 1))],
                    INK.stroke_width(1),
                ))
                .map_err(fault)?;
            }
            for l in 0..=DEGREE {
                let at = (left - 10, y(l) - cell.1 / 2);
                write(l.to_string(), at, centred(HPos::Right, VPos::Center))?;
            }
            for o in 0..=ORDER {
                let first = if o == 0 { 0 } else { material::count(o - 1) };
                let middle = (x(first) + x(material::count(o))) / 2;
                write(o.to_string(), (middle, bottom + 8), centred(HPos::Center, VPos::Top))?;
                if o > 0 {
                    let tick = [(x(first) - 1, bottom), (x(first) - 1, bottom + 22)];
                    root.draw(&PathElement::new(tick, INK.stroke_width(1))).map_err(fault)?;
                }
            }
            let below = ((left + right) / 2, bottom + 34);
            let text = "modes of the surface (o, p, q), by o";
            write(text.into(), below, centred(HPos::Center, VPos::Top))?;
            let upright = centred(HPos::Center, VPos::Center).transform(FontTransform::Rotate270);
            write("degree l of the light".into(), (24, (top + bottom) / 2), upright)?;
            // The logarithmic color scale.
            let scale = (left + 280, bottom + 76);
            for step in 0..60 {
                let from = scale.0 + 6 * step;
                let corners = [(from, scale.1), (from + 6, scale.1 + 16)];
                let shade = colour(f64::from(step) / 59.0);
                root.draw(&Rectangle::new(corners, shade.filled())).map_err(fault)?;
            }
            let beside = (scale.0 - 10, scale.1 + 8);
            let what = "variance, of the largest".to_owned();
            write(what, beside, centred(HPos::Right, VPos::Center))?;
            for (third, text) in ["≤ 1e-6", "1e-4", "1e-2", "1"].into_iter().enumerate() {
                let at = (scale.0 + 120 * third as i32, scale.1 + 20);
                write(text.into(), at, centred(HPos::Center, VPos::Top))?;
            }
            root.present().map_err(fault)?;
        }
        Ok(svg)
    }
}

fn further() -> [f64; 3] {
    let gram = gram::of_sphere(FURTHER, ORDER);
    let mut sums = [[0.0; 2]; 3];
    for azimuth in 0..=FURTHER {
        let signs = if azimuth == 0 { 1.0 } else { 2.0 };
        let modes = mode::indices(FURTHER, ORDER, azimuth);
        for ((l, o, _, _), value) in modes.zip(variances(&gram, azimuth)) {
            for ((order, _, _), [all, beyond]) in SURFACES.iter().zip(&mut sums) {
                let value = if o <= *order { signs * value } else { 0.0 };
                *all += value;
                *beyond += if l > DEGREE { value } else { 0.0 };
            }
        }
    }
    sums.map(|[all, beyond]| beyond / all)
}

/// Pale for 0, dark for 1, so that the order is also visible in print without colors.
fn colour(depth: f64) -> RGBColor {
    const STOPS: [[f64; 3]; 4] =
        [[240.0, 242.0, 245.0], [144.0, 196.0, 222.0], [38.0, 110.0, 170.0], [14.0, 26.0, 72.0]];
    let place = 3.0 * depth.clamp(0.0, 1.0);
    let stop = (place as usize).min(2);
    let share = place - stop as f64;
    let [r, g, b] =
        [0, 1, 2].map(|c| STOPS[stop][c] + share * (STOPS[stop + 1][c] - STOPS[stop][c]));
    RGBColor(r as u8, g as u8, b as u8)
}
