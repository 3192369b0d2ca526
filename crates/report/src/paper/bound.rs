//! Section 4.4: the direct sum to a stated accuracy, without the terms of the least variance, and
//! the error bound that follows from their variances: over all images, and for rendered spheres.

use super::partial_sum::{PartialSum, Step};
use super::plate::{Plate, UNCLIPPED, gray};
use super::spheres::SHOWN;
use super::{Modes, Study, Trial, csv, row, title};
use crate::chart::{Axes, Chart, Points, Style, colored};
use crate::figures::{self, OutputFile};
use crate::numbers::exposure;
use crate::sheet::Sheet;
use eigenshade_model::error::Result;
use eigenshade_model::parallel;
use eigenshade_model::reference::DirectSum;
use plotters::prelude::SeriesLabelPosition;

/// The stated accuracies: root mean square of the omitted part, relative to the image's mean.
const ACCURACIES: [f64; 6] = [0.3, 0.1, 1e-2, 1e-3, 1e-4, 1e-6];
/// Light and material of the image whose errors are drawn.
const DRAWN: (&str, &str) = ("studio", "05-leather");
/// The stated accuracies of the rendered spheres.
const RENDERED: [f64; 4] = [0.1, 0.03, 0.01, 0.003];
/// Width of each sphere in pixels.
const SIZE: usize = 176;
/// The colors of the residual end at half of the stated accuracy, as the plate and the page say.
const RESIDUAL: f64 = 0.5;

/// The result of one image for one accuracy.
#[derive(Clone, Copy)]
struct Reached {
    /// The fewest terms whose bound is within the accuracy.
    step: Step,
    /// The number of terms that would suffice if the errors were known.
    sufficient: usize,
    mean: f64,
}

pub fn files(study: &Study) -> Result<Vec<OutputFile>> {
    let mut rows = Vec::new();
    for modes in Modes::BOTH {
        let kept = if modes == Modes::All { &[][..] } else { &study.selection };
        let sums = PartialSum::new(&study.gram, kept);
        let found = parallel::map(study.trials.len(), &(), |k| {
            let trial = &study.trials[k];
            let steps = steps(study, &sums, trial);
            ACCURACIES.map(|accuracy| reach(&steps, trial.mean, accuracy))
        });
        for (place, accuracy) in ACCURACIES.into_iter().enumerate() {
            let reached: Vec<Reached> =
                found.iter().filter_map(|of_image| of_image[place]).collect();
            rows.push(row(&[&modes.count()], [accuracy].into_iter().chain(summary(&reached))));
        }
    }
    let header = "modes,accuracy,images,least_terms,median_terms,most_terms,\
                  sufficient_terms,largest_error,median_error_over_bound,\
                  largest_error_over_bound,median_bound_over_triangle,\
                  exceeding_uncorrelated,largest_error_over_uncorrelated";
    let mut files = rendered_files(study)?;
    files.push(csv("bound.csv", header, &rows)?);
    files.push(course(study)?);
    Ok(files)
}

fn steps(study: &Study, sums: &PartialSum<'_>, trial: &Trial) -> Vec<Step> {
    sums.steps(&study.luminances[trial.light], &study.grays[trial.material])
}

fn reach(steps: &[Step], mean: f64, accuracy: f64) -> Option<Reached> {
    let allowed = accuracy * mean;
    let step = *steps.iter().take_while(|step| step.bound <= allowed).last()?;
    // All longer sums are within the accuracy too.
    let sufficient = steps.iter().take_while(|step| step.error <= allowed).last()?.terms;
    Some(Reached { step, sufficient, mean })
}

/// The columns of the CSV after the accuracy, over the images that reach it.
fn summary(reached: &[Reached]) -> [f64; 11] {
    let (middle, last) = (reached.len() / 2, reached.len().saturating_sub(1));
    let sorted = |of: &dyn Fn(&Reached) -> f64| {
        let mut values: Vec<f64> = reached.iter().map(of).collect();
        values.sort_by(f64::total_cmp);
        values.resize(reached.len().max(1), 0.0);
        values
    };
    let terms = sorted(&|one| one.step.terms as f64);
    let ratio = sorted(&|one| one.step.error / one.step.bound.max(f64::MIN_POSITIVE));
    let excess = sorted(&|one| one.step.error / one.step.uncorrelated.max(f64::MIN_POSITIVE));
    // Where each m misses one term, the two are equal up to rounding.
    let over = excess.iter().filter(|ratio| **ratio > 1.0 + 1e-9).count();
    [
        reached.len() as f64,
        terms[0],
        terms[middle],
        terms[last],
        sorted(&|one| one.sufficient as f64)[middle],
        sorted(&|one| one.step.error / one.mean)[last],
        ratio[middle],
        ratio[last],
        sorted(&|one| one.step.bound / one.step.triangle)[middle],
        over as f64 / reached.len().max(1) as f64,
        excess[last],
    ]
}

/// The course of one image's partial sums.
fn course(study: &Study) -> Result<OutputFile> {
    let trial = study.trial(DRAWN.0, DRAWN.1)?;
    let steps = steps(study, &PartialSum::new(&study.gram, &[]), trial);
    // One point in eight is still denser than one per pixel.
    let rows = steps.iter().step_by(8).map(|step| {
        row(&[&step.terms], [step.bound, step.uncorrelated, step.error].map(|one| one / trial.mean))
    });
    csv("bound_course.csv", "terms,bound,uncorrelated,error", rows)
}

pub fn chart(sheet: &Sheet) -> Result<OutputFile> {
    let terms = sheet.numbers("terms");
    let course = |column| terms.iter().copied().zip(sheet.numbers(column)).collect::<Points>();
    let series = [
        ("bound", Style::Line, course("bound")),
        ("root of the summed variances", Style::Dashed, course("uncorrelated")),
        ("error", Style::Line, course("error")),
    ];
    let titles = ["terms summed, the strongest first", "rms left out, of the mean"];
    // Slightly lower, so that the last power of ten gets its label.
    let axes = Axes::Percent { columns: 0.0..3704.0, rows: 0.99e-6..10.0, labels: 8 };
    let chart = Chart::new(titles, axes, SeriesLabelPosition::LowerLeft, colored(series));
    Ok(figures::chart("bound.svg", &chart.svg()?))
}

pub struct Rendered {
    /// The mean of the complete image.
    pub mean: f64,
    /// The complete image at each normal.
    pub whole: Vec<f64>,
    /// The partial sums, by accuracy: the fewest terms whose bound is within it, and their image.
    pub sums: Vec<(Step, Vec<f64>)>,
}

/// Renders a light on a material at these normals.
pub fn render(study: &Study, light: &str, on: &str, normals: &[[f64; 3]]) -> Result<Rendered> {
    let trial = study.trial(light, on)?;
    let (luminance, grays) = (&study.luminances[trial.light], &study.grays[trial.material]);
    let sums = PartialSum::new(&study.gram, &[]);
    let terms = sums.strongest(luminance, grays);
    let steps = sums.steps(luminance, grays);
    // The steps go from all terms down to none, and their bounds rise.
    let within = |accuracy: f64| {
        let reached = steps.iter().take_while(|step| step.bound <= accuracy * trial.mean).last();
        *reached.unwrap_or(&steps[0])
    };
    let chosen = RENDERED.map(within);
    let reference = DirectSum::new(study.lights.degree, study.materials.order);
    let pixels = parallel::map(normals.len(), &(), |k| {
        let modes = reference.at(normals[k]);
        let mut sums = [0.0; RENDERED.len()];
        for (place, term) in terms.iter().enumerate().take(chosen[RENDERED.len() - 1].terms) {
            let (l, m, o, p, q) = term.mode;
            let light = term.coefficient * modes.value(l, m, o, p, q);
            for (sum, _) in sums.iter_mut().zip(chosen).filter(|(_, step)| place < step.terms) {
                *sum += light;
            }
        }
        (modes.irradiance(luminance, &modes.scatter(grays)), sums)
    });
    let image = |place: usize| pixels.iter().map(|(_, sums)| sums[place]).collect();
    Ok(Rendered {
        mean: trial.mean,
        whole: pixels.iter().map(|(whole, _)| *whole).collect(),
        sums: chosen.into_iter().enumerate().map(|(place, step)| (step, image(place))).collect(),
    })
}

/// The plate and the CSV file. Each pair takes two rows of the plate: the complete image and the
/// image at each accuracy, with the omitted part below.
fn rendered_files(study: &Study) -> Result<Vec<OutputFile>> {
    let mut rows = Vec::new();
    let mut plate = Plate::new(SIZE, (RENDERED.len() + 1, 2 * SHOWN.len()), [2, 0, 2]);
    for (pair, (material, light)) in SHOWN.into_iter().enumerate() {
        let normals = &plate.view.normals;
        let Rendered { mean, whole, sums } = render(study, light, material, normals)?;
        let scale = exposure(whole.clone(), UNCLIPPED);
        plate.light((0, 2 * pair), scale, gray(&whole));
        plate.below((0, 2 * pair), &[&title(material)]);
        for (k, ((step, image), accuracy)) in sums.iter().zip(RENDERED).enumerate() {
            let left = whole.iter().zip(image).map(|(whole, sum)| whole - sum);
            let largest = left.clone().fold(0.0, |most: f64, left| most.max(left.abs()));
            let weights = plate.view.pixels.iter().map(|pixel| pixel.coverage);
            let squares = left.clone().zip(weights.clone()).map(|(left, w)| w * left * left);
            let pixel_error = (squares.sum::<f64>() / weights.sum::<f64>()).sqrt() / mean;
            let (bound, error) = (step.bound / mean, step.error / mean);
            let numbers = [accuracy, bound, error, pixel_error, largest / mean];
            rows.push(row(&[&light, &material, &step.terms], numbers));
            plate.light((k + 1, 2 * pair), scale, gray(image));
            plate.below((k + 1, 2 * pair), &[&format!("{} terms", step.terms)]);
            let end = RESIDUAL * accuracy * mean;
            plate.signed((k + 1, 2 * pair + 1), left.map(|left| left / end));
            let format = |value: f64| format!("{:.3} %", 100.0 * value);
            let lines = [&*format!("<= {}", format(bound)), &*format(error)];
            plate.below((k + 1, 2 * pair + 1), &lines);
        }
    }
    plate.above(0, "reference");
    for (column, accuracy) in (1..).zip(RENDERED) {
        plate.above(column, &format!("{} %", 100.0 * accuracy));
    }
    let header = "light,material,terms,accuracy,bound,error,pixel_error,largest_pixel_error";
    Ok(vec![
        csv("bound_spheres.csv", header, &rows)?,
        OutputFile::picture("bound_spheres.png", plate.scale("stated/2")),
    ])
}
