//! Fig. 5 and 6: the error as a function of the number of components, for the whole data set and
//! for each material.
//!
//! The error of an image is defined as in the paper: the variance within the residual over the
//! variance within the image. The residual of K components is the image minus its projection.
//! Standard PCA subtracts the mean image first and does not count it in K, whereas image-centered
//! PCA counts the constant in K.

use super::artefact::{Artefact, digits};
use super::chart::{self, Axes, BLUE, GREEN, Line, ORANGE, PALE, PURPLE};
use super::rank_correlation::rank_correlation;
use super::shape::Shape;
use super::study::{Modes, Study, Trial, place};
use eigenshade_index::material;
use eigenshade_model::error::Result;
use eigenshade_table::scene::Criterion;
use plotters::prelude::SeriesLabelPosition;

/// Errors are given up to this number of components.
pub const SHOWN: usize = 100;
/// The criteria in the order of [`Study::tables`].
pub const CRITERIA: [Criterion; 2] = [Criterion::ImageCentered, Criterion::Standard];
/// The materials that Fig. 6 names, and whether their lines are dashed, so that they differ in
/// print without colors too.
const NAMED: [(&str, plotters::style::RGBColor, bool); 4] = [
    ("07-velvet", PURPLE, true),
    ("41-brick-b", BLUE, true),
    ("05-leather", ORANGE, false),
    ("11-plaster-b", GREEN, false),
];

/// Mean errors, for 0 to [`SHOWN`] components.
pub struct Errors {
    names: Vec<String>,
    lights: Vec<String>,
    /// L_1^0 / L_0^0 of each light: positive if more light comes from the front.
    pub fronts: Vec<f64>,
    /// The share of each material's squared coefficients with o >= 4.
    pub glosses: Vec<f64>,
    /// The share of standard PCA's first component that is constant over the sphere.
    pub first_constant: f64,
    /// Mean over all images, by basis in the order of [`Study::tables`], then by K.
    pub mean: [Vec<f64>; 4],
    /// Mean over all lights, by basis, then by material, then by K.
    pub by_material: [Vec<Vec<f64>>; 4],
    /// Mean over all materials, by basis, then by light, then by K.
    pub by_light: [Vec<Vec<f64>>; 4],
}

impl Errors {
    /// Averages the errors of all images.
    #[must_use]
    pub fn new(study: &Study, trials: &[Trial]) -> Self {
        let name = |entries: &[eigenshade_model::database::Named]| {
            entries.iter().map(|entry| entry.name.clone()).collect::<Vec<_>>()
        };
        let (names, lights) = (name(&study.materials.entries), name(&study.lights.entries));
        let average = |basis: usize, of: &dyn Fn(&Trial) -> bool| -> Vec<f64> {
            let chosen: Vec<&Trial> = trials.iter().filter(|trial| of(trial)).collect();
            let error = |count: usize| {
                let errors =
                    chosen.iter().map(|trial| trial.fits[basis].variances[count] / trial.variance);
                errors.sum::<f64>() / chosen.len() as f64
            };
            (0..=SHOWN).map(error).collect()
        };
        let bases = [0, 1, 2, 3];
        Self {
            mean: bases.map(|basis| average(basis, &|_| true)),
            by_material: bases.map(|basis| {
                let of = |k: usize| average(basis, &move |trial: &Trial| trial.material == k);
                (0..names.len()).map(of).collect()
            }),
            by_light: bases.map(|basis| {
                let of = |k: usize| average(basis, &move |trial: &Trial| trial.light == k);
                (0..lights.len()).map(of).collect()
            }),
            glosses: study.greys.iter().map(|material| gloss(material)).collect(),
            first_constant: Shape::new(&study.tables[place(Criterion::Standard, Modes::All)], 0)
                .map_or(0.0, |shape| shape.constant),
            fronts: study.luminances.iter().map(|light| light[2] / light[0]).collect(),
            names,
            lights,
        }
    }

    /// The mean errors of one material, by K.
    #[must_use]
    pub fn of_material(&self, name: &str, criterion: Criterion, modes: Modes) -> &[f64] {
        let found = self.names.iter().position(|other| other == name);
        let errors = &self.by_material[place(criterion, modes)];
        found.and_then(|k| errors.get(k)).map_or(&[], Vec::as_slice)
    }

    /// The mean errors of each light with its name, for the image-centered basis of all modes.
    pub fn lights(&self) -> impl Iterator<Item = (&str, &[f64])> {
        let names = self.lights.iter().map(String::as_str);
        names.zip(self.by_light[0].iter().map(Vec::as_slice))
    }

    /// The mean errors of each material, for the same basis.
    pub fn materials(&self) -> impl Iterator<Item = (&str, &[f64])> {
        let names = self.names.iter().map(String::as_str);
        names.zip(self.by_material[0].iter().map(Vec::as_slice))
    }

    /// Rank correlation over the lights of [`fronts`](Self::fronts) with the mean error at this
    /// number of components, for the image-centered basis of all modes.
    #[must_use]
    pub fn correlation(&self, count: usize) -> f64 {
        let errors: Vec<f64> = self.lights().map(|(_, errors)| errors[count]).collect();
        rank_correlation(&self.fronts, &errors)
    }

    /// Rank correlation over the materials of [`glosses`](Self::glosses) with the same error.
    #[must_use]
    pub fn gloss_correlation(&self, count: usize) -> f64 {
        let errors: Vec<f64> = self.materials().map(|(_, errors)| errors[count]).collect();
        rank_correlation(&self.glosses, &errors)
    }

    /// The CSV files and the charts.
    pub fn artefacts(&self) -> Result<Vec<Artefact>> {
        let mut rows = Vec::new();
        for count in 0..=SHOWN {
            let errors = self.mean.each_ref().map(|errors| digits(errors[count]));
            rows.push([count.to_string()].into_iter().chain(errors).collect());
        }
        let header = "components,image_centered,standard,image_centered_1000,standard_1000";
        let mut artefacts = vec![
            Artefact::csv("error.csv", header, &rows)?,
            Artefact::chart("error.svg", &self.chart()?),
        ];
        artefacts.push(self.sheet(
            "error_by_material",
            &self.names,
            &self.by_material,
            &CRITERIA,
        )?);
        artefacts.push(self.sheet(
            "error_by_light",
            &self.lights,
            &self.by_light,
            &CRITERIA[..1],
        )?);
        for modes in Modes::BOTH {
            let name = format!("error_by_material{}.svg", modes.suffix());
            artefacts.push(Artefact::chart(name, &self.material_chart(modes)?));
        }
        Ok(artefacts)
    }

    /// A CSV with one row for each basis and K, and one column for each name.
    fn sheet(
        &self,
        name: &str,
        columns: &[String],
        errors: &[Vec<Vec<f64>>; 4],
        criteria: &[Criterion],
    ) -> Result<Artefact> {
        let mut rows = Vec::new();
        for modes in Modes::BOTH {
            for &criterion in criteria {
                for count in 0..=SHOWN {
                    let of_basis = &errors[place(criterion, modes)];
                    let first =
                        [modes.count().to_string(), criterion.name().into(), count.to_string()];
                    let numbers = of_basis.iter().map(|errors| digits(errors[count]));
                    rows.push(first.into_iter().chain(numbers).collect());
                }
            }
        }
        let header = format!("modes,criterion,components,{}", columns.join(","));
        Artefact::csv(format!("{name}.csv"), &header, &rows)
    }

    fn chart(&self) -> Result<String> {
        let line = |basis: usize, name, colour, dashed| Line {
            dashed,
            ..Line::new(name, colour, points(&self.mean[basis]))
        };
        let lines = [
            line(0, "image-centred", BLUE, false),
            line(1, "standard", ORANGE, true),
            line(2, "image-centred, 1000 modes", GREEN, false),
            line(3, "standard, 1000 modes", PURPLE, true),
        ];
        chart::lines(&axes(1e-5..3.0), &lines)
    }

    fn material_chart(&self, modes: Modes) -> Result<String> {
        let mut lines = Vec::new();
        for errors in &self.by_material[place(Criterion::ImageCentered, modes)] {
            lines.push(Line { name: None, width: 1, ..Line::new("", PALE, points(errors)) });
        }
        for (name, colour, dashed) in NAMED {
            let errors = self.of_material(name, Criterion::ImageCentered, modes);
            let line = Line::new(&super::spheres::title(name), colour, points(errors));
            lines.push(Line { dashed, ..line });
        }
        chart::lines(&axes(1e-5..3.0), &lines)
    }
}

/// The share of a BRDF's squared coefficients with o >= 4.
fn gloss(coefficients: &[f64]) -> f64 {
    let square = |values: &[f64]| values.iter().map(|value| value * value).sum::<f64>();
    square(&coefficients[material::count(3)..]) / square(coefficients)
}

fn points(errors: &[f64]) -> Vec<(f64, f64)> {
    (0u32..).map(f64::from).zip(errors.iter().copied()).collect()
}

fn axes(rows: std::ops::Range<f64>) -> Axes {
    Axes {
        horizontal: "components",
        vertical: "mean error: variance left",
        columns: 0.0..SHOWN as f64,
        rows,
        labels: 11,
        format: chart::percent,
        legend: SeriesLabelPosition::UpperRight,
    }
}

/// The least number of components with at most this error, if there is one.
#[must_use]
pub fn needed(errors: &[f64], error: f64) -> Option<usize> {
    errors.iter().position(|found| *found <= error)
}
