//! Section 4.4: the direct sum rendered to a stated accuracy, with the terms of the least variance
//! left out, and the error bound that follows from their variances.

use super::artefact::{Artefact, digits};
use super::chart::{self, Axes, BLUE, GREEN, Line, ORANGE};
use super::study::{Modes, Study, Trial};
use eigenshade_generator::basis::partial_sum::{PartialSum, Step};
use eigenshade_model::error::Result;
use eigenshade_model::selection::variances;
use eigenshade_shading::parallel;
use eigenshade_table::GramFactor;
use indicatif::ProgressBar;
use plotters::prelude::SeriesLabelPosition;

/// The stated accuracies: root mean square of the omitted part, relative to the image's mean.
pub const ACCURACIES: [f64; 6] = [0.3, 0.1, 1e-2, 1e-3, 1e-4, 1e-6];
/// The allowed violation of the bound due to rounding, relative to the image's mean.
pub const ROUNDING: f64 = 1e-13;
/// Light and material of the image whose errors are drawn.
const DRAWN: (&str, &str) = ("studio", "05-leather");

/// The cost of one accuracy, over all images that reach it.
pub struct Row {
    /// The accuracy.
    pub accuracy: f64,
    /// The modes that are summed.
    pub modes: Modes,
    /// The number of images whose bound is within the accuracy.
    pub reached: usize,
    /// Number of terms summed: least, median, most.
    pub terms: [usize; 3],
    /// The median number of terms that would suffice if the errors were known.
    pub sufficient: usize,
    /// The largest error, relative to the mean.
    pub error: f64,
    /// Ratio of error to bound: median and largest.
    pub ratio: [f64; 2],
    /// Median ratio of the bound to the triangle bound.
    pub triangle: f64,
    /// The share of images whose error exceeds the uncorrelated sum.
    pub exceeded: f64,
    /// The largest ratio of the error to the uncorrelated sum.
    pub excess: f64,
}

/// The results for all images.
pub struct Bounds {
    /// By modes, then by accuracy.
    pub rows: Vec<Row>,
    /// Number of partial sums whose error exceeds the bound by more than [`ROUNDING`].
    pub violations: usize,
    /// Number of partial sums that were compared.
    pub compared: usize,
    /// Number of modes that are zero because their polar integrals (11) are zero.
    pub zero_modes: usize,
    /// Every partial sum of the drawn image, with all modes.
    drawn: Vec<Step>,
    /// The same with the selected modes.
    drawn_selected: Vec<Step>,
    /// The mean of the drawn image.
    drawn_mean: f64,
}

/// The result of one image for one accuracy.
#[derive(Clone, Copy)]
struct Reached {
    step: Step,
    sufficient: usize,
    mean: f64,
}

impl Bounds {
    /// Sums every image to every number of terms.
    #[must_use]
    pub fn new(study: &Study, trials: &[Trial], progress: &ProgressBar) -> Self {
        let (mut rows, mut violations, mut compared) = (Vec::new(), 0, 0);
        let mut drawn = Vec::new();
        let drawn_trial = study.trial(trials, DRAWN.0, DRAWN.1).ok();
        for modes in Modes::BOTH {
            let kept = if modes == Modes::All { &[][..] } else { &study.selection };
            let sums = PartialSum::new(&study.gram, kept);
            let steps = |trial: &Trial| {
                sums.steps(&study.luminances[trial.light], &study.greys[trial.material])
            };
            let found = parallel::map(trials.len(), progress, |k| {
                let (trial, steps) = (&trials[k], steps(&trials[k]));
                // Written so that a NaN counts as a violation.
                let holds = |step: &Step| step.error <= step.bound + ROUNDING * trial.mean;
                let over = steps.iter().filter(|step| !holds(step)).count();
                let reached = ACCURACIES.map(|accuracy| reach(&steps, trial.mean, accuracy));
                (over, steps.len(), reached)
            });
            for (over, count, _) in &found {
                violations += over;
                compared += count;
            }
            for (place, accuracy) in ACCURACIES.into_iter().enumerate() {
                let reached = found.iter().filter_map(|(_, _, reached)| reached[place]);
                rows.push(Row::new(accuracy, modes, &reached.collect::<Vec<_>>()));
            }
            drawn.push(drawn_trial.map(&steps).unwrap_or_default());
        }
        let drawn_selected = drawn.pop().unwrap_or_default();
        let drawn = drawn.pop().unwrap_or_default();
        let drawn_mean = drawn_trial.map_or(1.0, |trial| trial.mean);
        Self {
            rows,
            violations,
            compared,
            zero_modes: zero_modes(&study.gram),
            drawn,
            drawn_selected,
            drawn_mean,
        }
    }

    /// The CSV file and the chart.
    pub fn artefacts(&self) -> Result<Vec<Artefact>> {
        let mut rows = Vec::new();
        for row in &self.rows {
            let mut fields = vec![row.modes.count().to_string(), digits(row.accuracy)];
            fields.push(row.reached.to_string());
            fields.extend(row.terms.map(|count| count.to_string()));
            fields.push(row.sufficient.to_string());
            let numbers = [row.error, row.ratio[0], row.ratio[1]];
            let others = [row.triangle, row.exceeded, row.excess];
            fields.extend(numbers.into_iter().chain(others).map(digits));
            rows.push(fields);
        }
        let header = "modes,accuracy,images,least_terms,median_terms,most_terms,\
                      sufficient_terms,largest_error,median_error_over_bound,\
                      largest_error_over_bound,median_bound_over_triangle,\
                      exceeding_uncorrelated,largest_error_over_uncorrelated";
        Ok(vec![
            Artefact::csv("bound.csv", header, &rows)?,
            Artefact::chart("bound.svg", &self.chart()?),
        ])
    }

    fn chart(&self) -> Result<String> {
        let course = |steps: &[Step], value: fn(&Step) -> f64| -> Vec<(f64, f64)> {
            // One point in eight is still denser than one per pixel.
            let points = steps.iter().step_by(8);
            points.map(|step| (step.terms as f64, value(step) / self.drawn_mean)).collect()
        };
        let uncorrelated = course(&self.drawn, |step| step.uncorrelated);
        let lines = [
            Line::new("bound", BLUE, course(&self.drawn, |step| step.bound)),
            Line {
                dashed: true,
                ..Line::new("root of the summed variances", ORANGE, uncorrelated)
            },
            Line::new("error", GREEN, course(&self.drawn, |step| step.error)),
        ];
        let axes = Axes {
            horizontal: "terms summed, the strongest first",
            vertical: "rms left out, of the mean",
            columns: 0.0..3704.0,
            // Slightly lower, so that the last power of ten gets its label.
            rows: 0.99e-6..10.0,
            labels: 8,
            format: chart::percent,
            legend: SeriesLabelPosition::LowerLeft,
        };
        chart::lines(&axes, &lines)
    }

    /// The least error and bound of the drawn image with the selected modes, relative to its mean.
    #[must_use]
    pub fn selected(&self) -> Option<[f64; 2]> {
        let step = self.drawn_selected.first()?;
        Some([step.error, step.bound].map(|value| value / self.drawn_mean))
    }
}

/// The number of modes whose variance is only rounding.
fn zero_modes(gram: &GramFactor) -> usize {
    let of = |azimuth: usize| {
        let signs = if azimuth == 0 { 1 } else { 2 };
        signs * variances(gram, azimuth).iter().filter(|value| **value < 1e-24).count()
    };
    (0..=gram.degree).map(of).sum()
}

/// The fewest terms whose bound is within the accuracy.
fn reach(steps: &[Step], mean: f64, accuracy: f64) -> Option<Reached> {
    let allowed = accuracy * mean;
    let step = *steps.iter().take_while(|step| step.bound <= allowed).last()?;
    // All longer sums are within the accuracy too.
    let sufficient = steps.iter().take_while(|step| step.error <= allowed).last()?.terms;
    Some(Reached { step, sufficient, mean })
}

impl Row {
    fn new(accuracy: f64, modes: Modes, reached: &[Reached]) -> Self {
        let sorted = |of: &dyn Fn(&Reached) -> f64| {
            let mut values: Vec<f64> = reached.iter().map(of).collect();
            values.sort_by(f64::total_cmp);
            values
        };
        let at = |values: &[f64], place: usize| values.get(place).copied().unwrap_or(0.0);
        let (middle, last) = (reached.len() / 2, reached.len().saturating_sub(1));
        let terms = sorted(&|one| one.step.terms as f64);
        let ratio = sorted(&|one| one.step.error / one.step.bound.max(f64::MIN_POSITIVE));
        let excess = sorted(&|one| one.step.error / one.step.uncorrelated.max(f64::MIN_POSITIVE));
        // Where each m misses one term, the two are equal up to rounding.
        let over = excess.iter().filter(|ratio| **ratio > 1.0 + 1e-9).count();
        Self {
            accuracy,
            modes,
            reached: reached.len(),
            terms: [0, middle, last].map(|place| at(&terms, place) as usize),
            sufficient: at(&sorted(&|one| one.sufficient as f64), middle) as usize,
            error: at(&sorted(&|one| one.step.error / one.mean), last),
            ratio: [middle, last].map(|place| at(&ratio, place)),
            triangle: at(&sorted(&|one| one.step.bound / one.step.triangle), middle),
            exceeded: over as f64 / reached.len().max(1) as f64,
            excess: at(&excess, last),
        }
    }
}
