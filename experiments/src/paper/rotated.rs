//! The error if each light is rotated in every way, as the statistics of the basis assume: the
//! remaining variance over the variance within the images, both averaged over all rotations of all
//! lights.
//!
//! Over all rotations, L_l^m of different (l, m) are uncorrelated and share the power of their
//! degree equally, (38). The average is therefore that of images of single harmonics.

use super::artefact::{Artefact, digits};
use super::error::SHOWN;
use super::study::{DEGREE, Modes, Study, place};
use eigenshade_generator::basis::node_image::MaterialImages;
use eigenshade_generator::basis::representation::fit;
use eigenshade_index::light;
use eigenshade_model::error::Result;
use eigenshade_shading::parallel;
use eigenshade_table::scene::Criterion;
use indicatif::ProgressBar;

/// Errors with the image-centered components of all modes, for 0 to [`SHOWN`] components.
pub struct Rotated {
    names: Vec<String>,
    /// Error of all materials together.
    pub all: Vec<f64>,
    /// Error by material and then by K.
    pub by_material: Vec<Vec<f64>>,
}

impl Rotated {
    /// Fits every harmonic on every material.
    #[must_use]
    pub fn new(study: &Study, progress: &ProgressBar) -> Self {
        let table = &study.tables[place(Criterion::ImageCentered, Modes::All)];
        let images = MaterialImages::new(&study.gram, &[], &study.greys);
        let power = |l: usize| -> f64 {
            let of_degree = |light: &Vec<f64>| -> f64 {
                let coefficients = &light[l * l..(l + 1) * (l + 1)];
                coefficients.iter().map(|value| value * value).sum()
            };
            let sum: f64 = study.luminances.iter().map(of_degree).sum();
            sum / (study.luminances.len() * (2 * l + 1)) as f64
        };
        let variances = parallel::map(study.greys.len(), progress, |material| {
            let mut sums = vec![0.0; SHOWN + 1];
            for (l, m) in light::indices(DEGREE) {
                let mut harmonic = vec![0.0; light::count(DEGREE)];
                harmonic[light::position(l, m)] = 1.0;
                let left = fit(table, &images.image(&harmonic, material)).variances;
                sums.iter_mut().zip(left).for_each(|(sum, left)| *sum += power(l) * left);
            }
            sums
        });
        let over_first = |sums: &[f64]| sums.iter().map(|sum| sum / sums[0]).collect::<Vec<f64>>();
        let total = |count: usize| variances.iter().map(|sums| sums[count]).sum();
        Self {
            names: study.materials.entries.iter().map(|entry| entry.name.clone()).collect(),
            all: over_first(&(0..=SHOWN).map(total).collect::<Vec<f64>>()),
            by_material: variances.iter().map(|sums| over_first(sums)).collect(),
        }
    }

    /// The errors of one material, by K.
    #[must_use]
    pub fn of_material(&self, name: &str) -> &[f64] {
        let found = self.names.iter().position(|other| other == name);
        found.and_then(|k| self.by_material.get(k)).map_or(&[], Vec::as_slice)
    }

    /// The CSV file.
    ///
    /// # Errors
    ///
    /// Never in practice.
    pub fn artefacts(&self) -> Result<Vec<Artefact>> {
        let row = |count: usize| {
            let numbers = [&self.all].into_iter().chain(&self.by_material);
            let numbers = numbers.map(|errors| digits(errors[count]));
            [count.to_string()].into_iter().chain(numbers).collect()
        };
        let rows: Vec<Vec<String>> = (0..=SHOWN).map(row).collect();
        let header = format!("components,all,{}", self.names.join(","));
        Ok(vec![Artefact::csv("error_rotated.csv", &header, &rows)?])
    }
}
