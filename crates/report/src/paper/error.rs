//! Fig. 5 and 6: the error as a function of the number of components, for the whole data set and
//! for each material; and what the truncation to 1,000 modes costs.
//!
//! The error of an image is defined as in the paper: the variance within the residual over the
//! variance within the image. The residual of K components is the image minus its projection.
//! Standard PCA subtracts the mean image first and does not count it in K, whereas image-centered
//! PCA counts the constant in K.

use super::node_image::{MaterialImages, fit};
use super::{DEGREE, Modes, Sheets, Study, Trial, csv, digits, place, row, title};
use crate::chart::{
    Axes, BLUE, Chart, GREEN, ORANGE, PALE, PURPLE, Points, Series, Style, colored,
};
use crate::figures::{self, OutputFile};
use crate::sheet::Sheet;
use eigenshade_model::database::Named;
use eigenshade_model::error::Result;
use eigenshade_model::parallel;
use eigenshade_model::selection::variances;
use eigenshade_table::scene::Criterion;
use eigenshade_table::{light, mode};
use plotters::prelude::SeriesLabelPosition;
use plotters::style::RGBColor;

/// Errors are given up to this number of components.
pub const SHOWN: usize = 100;
/// The image-centered basis of all modes in [`Study::tables`].
const CENTERED: usize = 0;
/// The materials that Fig. 6 names, and their lines, which differ in print without colors too.
const NAMED: [(&str, RGBColor, Style); 4] = [
    ("07-velvet", PURPLE, Style::Dashed),
    ("41-brick-b", BLUE, Style::Dashed),
    ("05-leather", ORANGE, Style::Line),
    ("11-plaster-b", GREEN, Style::Line),
];

pub fn files(study: &Study) -> Result<Vec<OutputFile>> {
    let (materials, lights) = (&study.materials.entries, &study.lights.entries);
    let mean = [0, 1, 2, 3].map(|basis| average(study, basis, |_| true));
    let by = |of: fn(&Trial) -> usize, count: usize| -> Vec<Vec<f64>> {
        (0..count).map(|k| average(study, CENTERED, |trial| of(trial) == k)).collect()
    };
    let by_material = by(|trial| trial.material, materials.len());
    let by_light = by(|trial| trial.light, lights.len());
    let rotated = rotated(study, &study.luminances);
    let names = |entries: &[Named]| {
        entries.iter().map(|entry| entry.name.as_str()).collect::<Vec<_>>().join(",")
    };
    let header = "components,image_centered,standard,image_centered_1000,standard_1000";
    let [of_materials, of_lights] =
        [materials, lights].map(|entries| format!("components,{}", names(entries)));
    let of_rotated = format!("components,all,{}", names(materials));
    Ok(vec![
        csv("error.csv", header, by_count(&mean))?,
        csv("error_by_material.csv", &of_materials, by_count(&by_material))?,
        csv("error_by_light.csv", &of_lights, by_count(&by_light))?,
        csv("error_rotated.csv", &of_rotated, by_count(&rotated))?,
        selected(study)?,
    ])
}

/// The charts of the CSV files.
pub fn charts(sheets: &Sheets) -> Result<Vec<OutputFile>> {
    Ok(vec![
        figures::chart("error.svg", &mean_chart(&sheets["error"])?),
        figures::chart("error_by_material.svg", &material_chart(&sheets["error_by_material"])?),
    ])
}

/// The mean error of the chosen images with one basis, for 0 to [`SHOWN`] components.
fn average(study: &Study, basis: usize, is_chosen: impl Fn(&Trial) -> bool) -> Vec<f64> {
    let chosen: Vec<&Trial> = study.trials.iter().filter(|trial| is_chosen(trial)).collect();
    let error = |trial: &&Trial, count: usize| trial.fits[basis].variances[count] / trial.variance;
    let sum = |count: usize| chosen.iter().map(|trial| error(trial, count)).sum::<f64>();
    (0..=SHOWN).map(|count| sum(count) / chosen.len() as f64).collect()
}

/// The errors if each light is rotated in every way, as the statistics of the basis assume: the
/// remaining variance over the variance within the images, both averaged over all rotations of all
/// lights. They are for the image-centered components of all modes: first for all materials
/// together, then for each, for 0 to [`SHOWN`] components.
///
/// Over all rotations, L_l^m of different (l, m) are uncorrelated and share the power of their
/// degree equally, (38). The average is therefore that of images of single harmonics.
pub fn rotated(study: &Study, luminances: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let table = &study.tables[place(Criterion::ImageCentered, Modes::All)];
    let images = MaterialImages::new(&study.gram, &[], &study.grays);
    let power = |l: usize| -> f64 {
        let of_degree = |light: &Vec<f64>| -> f64 {
            light[l * l..(l + 1) * (l + 1)].iter().map(|value| value * value).sum()
        };
        let sum: f64 = luminances.iter().map(of_degree).sum();
        sum / (luminances.len() * (2 * l + 1)) as f64
    };
    let variances = parallel::map(study.grays.len(), &(), |material| {
        let mut sums = vec![0.0; SHOWN + 1];
        for (l, m) in light::indices(DEGREE) {
            let mut harmonic = vec![0.0; light::count(DEGREE)];
            harmonic[light::position(l, m)] = 1.0;
            let left = fit(table, &images.image(&harmonic, material)).variances;
            sums.iter_mut().zip(left).for_each(|(sum, left)| *sum += power(l) * left);
        }
        sums
    });
    let total = |count: usize| variances.iter().map(|sums| sums[count]).sum();
    let all: Vec<f64> = (0..=SHOWN).map(total).collect();
    let over_first = |sums: &Vec<f64>| sums.iter().map(|sum| sum / sums[0]).collect();
    [&all].into_iter().chain(&variances).map(over_first).collect()
}

/// One row for each number of components, one column for each of `errors`.
fn by_count(errors: &[Vec<f64>]) -> Vec<Vec<String>> {
    (0..=SHOWN).map(|count| row(&[&count], errors.iter().map(|errors| errors[count]))).collect()
}

fn mean_chart(sheet: &Sheet) -> Result<String> {
    let names = [
        ("image-centered", Style::Line),
        ("standard", Style::Dashed),
        ("image-centered, 1000 modes", Style::Line),
        ("standard, 1000 modes", Style::Dashed),
    ];
    let lines = names.into_iter().zip(&sheet.columns[1..]);
    chart(colored(lines.map(|((name, style), of)| (name, style, points(&sheet.numbers(of))))))
}

fn material_chart(sheet: &Sheet) -> Result<String> {
    let line = |name: &String| {
        let line = Series::new("", Style::Line, PALE, points(&sheet.numbers(name)));
        Series { width: 1, ..line }
    };
    let mut lines: Vec<_> = sheet.columns[1..].iter().map(line).collect();
    for (name, color, style) in NAMED {
        lines.push(Series::new(title(name), style, color, points(&sheet.numbers(name))));
    }
    chart(lines)
}

fn points(errors: &[f64]) -> Points {
    (0u32..).map(f64::from).zip(errors.iter().copied()).collect()
}

fn chart(series: Vec<Series>) -> Result<String> {
    let titles = ["components", "mean error: variance left"];
    let axes = Axes::Percent { columns: 0.0..SHOWN as f64, rows: 1e-5..3.0, labels: 11 };
    Chart::new(titles, axes, SeriesLabelPosition::UpperRight, series).svg()
}

/// The cost of the paper's truncation to the 1,000 modes of the highest variance: how many modes
/// are kept, counting both signs of m, and their share of the variance; the error of an image of
/// these modes alone; what all their components leave.
fn selected(study: &Study) -> Result<OutputFile> {
    let (gram, trials) = (&study.gram, &study.trials);
    let mut largest_order = 0;
    let mut by_degree = vec![0; gram.degree + 1];
    let (mut all, mut left) = (0.0, 0.0);
    for azimuth in 0..=gram.degree {
        let signs = if azimuth == 0 { 1 } else { 2 };
        let modes = mode::indices(gram.degree, gram.order, azimuth);
        for ((l, o, p, q), value) in modes.zip(variances(gram, azimuth)) {
            all += signs as f64 * value;
            if study.selection[gram.place(azimuth, l, o, p, q)] {
                by_degree[l] += signs;
                largest_order = largest_order.max(azimuth);
            } else {
                left += signs as f64 * value;
            }
        }
    }
    let error = |trial: &Trial| trial.unselected / trial.variance;
    let mean =
        |of: &dyn Fn(&Trial) -> f64| trials.iter().map(of).sum::<f64>() / trials.len() as f64;
    let mut sorted: Vec<&Trial> = trials.iter().collect();
    sorted.sort_by(|a, b| error(a).total_cmp(&error(b)));
    let (median, worst) = (sorted[trials.len() / 2], sorted[trials.len() - 1]);
    let bases = Modes::BOTH.map(|modes| place(Criterion::ImageCentered, modes));
    let components = bases.map(|basis| study.tables[basis].components.len());
    let floor = |trial: &Trial| trial.fits[bases[1]].variances[components[1]] / trial.variance;
    let rows = [
        ("modes_kept", by_degree.iter().sum::<usize>().to_string()),
        ("mode_variance_left_out", digits(left / all)),
        ("largest_order_kept", largest_order.to_string()),
        ("image_error_median", digits(error(median))),
        ("image_error_mean", digits(mean(&error))),
        ("image_error_largest", digits(error(worst))),
        ("image_error_largest_light", study.lights.entries[worst.light].name.clone()),
        ("image_error_largest_material", study.materials.entries[worst.material].name.clone()),
        ("components_of_all_modes", components[0].to_string()),
        ("components_of_selected_modes", components[1].to_string()),
        ("error_of_all_components", digits(mean(&floor))),
    ];
    let rows = rows.map(|(quantity, value)| [quantity.into(), value]);
    let of_degree =
        |(l, count): (usize, &usize)| [format!("modes_kept_of_degree_{l}"), count.to_string()];
    let rows = rows.into_iter().chain(by_degree.iter().enumerate().map(of_degree));
    csv("selected_modes.csv", "quantity,value", rows)
}
