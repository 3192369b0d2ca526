//! Section 4.4: spheres rendered by the direct sum to a stated accuracy, with the weakest terms
//! left out.

use super::artefact::{Artefact, digits};
use super::plate::Plate;
use super::spheres::title;
use super::study::{Study, Trial};
use eigenshade_cli::picture::sphere_view::SphereView;
use eigenshade_cli::picture::tone::exposure;
use eigenshade_generator::basis::partial_sum::{PartialSum, Term};
use eigenshade_model::error::Result;
use eigenshade_model::truth::Truth;
use eigenshade_shading::parallel;
use indicatif::ProgressBar;

/// Material and light of each sphere: one matte with a bright rim, one glossy, one between the two.
pub const SHOWN: [(&str, &str); 3] =
    [("07-velvet", "forest"), ("05-leather", "studio"), ("55-orange-peel", "blender-sunset")];
/// The stated accuracies: root mean square of the omitted part, relative to the image's mean.
pub const ACCURACIES: [f64; 4] = [0.1, 0.03, 0.01, 0.003];
/// Width of each sphere in pixels.
const SIZE: usize = 176;
/// The share of an image's values that its exposure leaves unclipped.
const UNCLIPPED: f64 = 0.98;
/// The colors of the residual end at this share of the stated accuracy: half, as stated on the
/// plate and the page.
const RESIDUAL: f64 = 0.5;

/// One sphere, rendered to one accuracy. The bound and the errors are relative to the image's mean.
pub struct Rendering {
    /// Material and light.
    pub names: [&'static str; 2],
    /// The stated accuracy.
    pub accuracy: f64,
    /// The number of terms summed: the fewest whose bound is within the accuracy.
    pub terms: usize,
    /// The bound on the omitted part.
    pub bound: f64,
    /// The root mean square of the omitted part, over the nodes of the quadrature.
    pub error: f64,
    /// The same over the pixels of the picture, each weighted by its share of the disc.
    pub pixel_error: f64,
    /// The largest error of any pixel.
    pub largest: f64,
    /// The pixel values of the picture.
    pub image: Vec<f64>,
}

/// All renderings.
pub struct Renderings {
    /// The renderings by pair and then by accuracy.
    pub all: Vec<Rendering>,
    /// The complete pictures, by pair.
    pub truths: Vec<Vec<f64>>,
    /// The means of the complete pictures over the sphere, by pair.
    pub means: Vec<f64>,
    /// The normals of the pictures' pixels.
    pub normals: Vec<[f64; 3]>,
}

impl Renderings {
    /// Renders the spheres.
    ///
    /// # Errors
    ///
    /// Never in practice: the shipped data contain all images.
    pub fn new(study: &Study, trials: &[Trial], progress: &ProgressBar) -> Result<Self> {
        let view = SphereView::new(SIZE);
        let sums = PartialSum::new(&study.gram, &[]);
        let (mut all, mut truths, mut means) = (Vec::new(), Vec::new(), Vec::new());
        for (material, light) in SHOWN {
            let trial = study.trial(trials, light, material)?;
            let (luminance, grey) = (&study.luminances[trial.light], &study.greys[trial.material]);
            let terms = sums.strongest(luminance, grey);
            let steps = sums.steps(luminance, grey);
            // The steps go from all terms down to none, and their bounds rise.
            let within = |accuracy: f64| {
                let reached =
                    steps.iter().take_while(|step| step.bound <= accuracy * trial.mean).last();
                reached.or(steps.first())
            };
            let steps: Vec<_> = ACCURACIES.into_iter().filter_map(within).collect();
            let counts: Vec<usize> = steps.iter().map(|step| step.terms).collect();
            let truth = Truth::new(study.lights.degree, study.materials.order);
            let pixels = parallel::map(view.normals.len(), progress, |k| {
                let modes = truth.at(view.normals[k]);
                let whole = modes.irradiance(luminance, &modes.scatter(grey));
                let value = |(l, m, o, p, q)| modes.value(l, m, o, p, q);
                (whole, partial(&terms, &counts, value))
            });
            let whole: Vec<f64> = pixels.iter().map(|(whole, _)| *whole).collect();
            for (place, (step, accuracy)) in steps.into_iter().zip(ACCURACIES).enumerate() {
                let image: Vec<f64> = pixels.iter().map(|(_, sums)| sums[place]).collect();
                let left = image.iter().zip(&whole).map(|(sum, whole)| (sum - whole).abs());
                let largest = left.clone().fold(0.0, f64::max) / trial.mean;
                let weights = view.pixels.iter().map(|pixel| pixel.coverage);
                let square: f64 = left.zip(weights.clone()).map(|(left, w)| w * left * left).sum();
                all.push(Rendering {
                    names: [material, light],
                    accuracy,
                    terms: step.terms,
                    bound: step.bound / trial.mean,
                    error: step.error / trial.mean,
                    pixel_error: (square / weights.sum::<f64>()).sqrt() / trial.mean,
                    largest,
                    image,
                });
            }
            truths.push(whole);
            means.push(trial.mean);
        }
        Ok(Self { all, truths, means, normals: view.normals })
    }

    /// The plate and the CSV file.
    ///
    /// # Errors
    ///
    /// Never in practice.
    pub fn artefacts(&self) -> Result<Vec<Artefact>> {
        let mut rows = Vec::new();
        for one in &self.all {
            let [material, light] = one.names.map(str::to_owned);
            let numbers = [one.accuracy, one.bound, one.error, one.pixel_error, one.largest];
            let mut fields = vec![light, material, one.terms.to_string()];
            fields.extend(numbers.map(digits));
            rows.push(fields);
        }
        let header = "light,material,terms,accuracy,bound,error,pixel_error,largest_pixel_error";
        Ok(vec![
            Artefact::csv("bound_spheres.csv", header, &rows)?,
            Artefact::picture("bound_spheres.png", self.plate()),
        ])
    }

    /// Each pair takes two rows: the complete image and the image at each accuracy, with the
    /// omitted part below.
    fn plate(&self) -> eigenshade_cli::picture::canvas::Canvas {
        let mut plate = Plate::new(SIZE, (ACCURACIES.len() + 1, 2 * SHOWN.len()), (2, 0, 2));
        for (pair, truth) in self.truths.iter().enumerate() {
            let scale = exposure(truth.clone(), UNCLIPPED);
            let shown =
                |image: &[f64]| image.iter().map(|value| [scale * value; 3]).collect::<Vec<_>>();
            plate.light(0, 2 * pair, &shown(truth));
            let (material, _) = SHOWN[pair];
            plate.below(0, 2 * pair, 0, &title(material));
            let ours = self.all.iter().skip(ACCURACIES.len() * pair).take(ACCURACIES.len());
            for (column, one) in (1..).zip(ours) {
                plate.light(column, 2 * pair, &shown(&one.image));
                plate.below(column, 2 * pair, 0, &format!("{} terms", one.terms));
                let end = RESIDUAL * one.accuracy * self.means[pair];
                let left = truth.iter().zip(&one.image).map(|(a, b)| (a - b) / end);
                plate.signed(column, 2 * pair + 1, &left.collect::<Vec<_>>());
                let words = |value: f64| format!("{:.3} %", 100.0 * value);
                plate.below(column, 2 * pair + 1, 0, &format!("<= {}", words(one.bound)));
                plate.below(column, 2 * pair + 1, 1, &words(one.error));
            }
        }
        plate.above(0, "truth");
        for (column, accuracy) in (1..).zip(ACCURACIES) {
            plate.above(column, &format!("{} %", 100.0 * accuracy));
        }
        plate.scale("stated/2")
    }
}

/// The sums of the first terms, for each number in `counts`, which falls or rises.
fn partial(
    terms: &[Term],
    counts: &[usize],
    value: impl Fn((usize, isize, usize, usize, usize)) -> f64,
) -> Vec<f64> {
    let mut sums = vec![0.0; counts.len()];
    let most = counts.iter().copied().max().unwrap_or(0);
    for (place, term) in terms.iter().enumerate().take(most) {
        let light = term.coefficient * value(term.mode);
        for (sum, _) in sums.iter_mut().zip(counts).filter(|(_, count)| place < **count) {
            *sum += light;
        }
    }
    sums
}
