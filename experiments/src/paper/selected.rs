//! The cost of the paper's truncation to the 1,000 modes of the highest variance.

use super::artefact::{Artefact, digits};
use super::study::{Modes, Study, Trial, place};
use eigenshade_index::mode;
use eigenshade_model::error::Result;
use eigenshade_model::selection::variances;
use eigenshade_table::scene::Criterion;

/// The omitted part and its effect.
pub struct Selected {
    /// Number of modes kept, counting both signs of m; ties are kept or omitted together.
    pub kept: usize,
    /// The share of the modes' summed variance that is omitted.
    pub variance_left: f64,
    /// Number of modes kept for each degree l.
    pub by_degree: Vec<usize>,
    /// The largest |m| that is kept.
    pub largest_order: usize,
    /// The error of an image of these modes alone: median, mean and largest over all images.
    pub image_error: [f64; 3],
    /// Light and material of the image with the largest error.
    pub worst: [String; 2],
    /// Number of components of the image-centered basis, for all modes and for the selected modes.
    pub components: [usize; 2],
    /// The mean error with all components of the selected modes.
    pub floor: f64,
}

impl Selected {
    /// Compares the images of the selected modes with the complete images.
    #[must_use]
    pub fn new(study: &Study, trials: &[Trial]) -> Self {
        let gram = &study.gram;
        let (mut kept, mut largest_order) = (0, 0);
        let mut by_degree = vec![0; gram.degree + 1];
        let (mut all, mut left) = (0.0, 0.0);
        for azimuth in 0..=gram.degree {
            let signs = if azimuth == 0 { 1 } else { 2 };
            let modes = mode::indices(gram.degree, gram.order, azimuth);
            for ((l, o, p, q), value) in modes.zip(variances(gram, azimuth)) {
                all += signs as f64 * value;
                if study.selection[gram.place(azimuth, l, o, p, q)] {
                    kept += signs;
                    by_degree[l] += signs;
                    largest_order = largest_order.max(azimuth);
                } else {
                    left += signs as f64 * value;
                }
            }
        }
        let error = |trial: &Trial| trial.unselected / trial.variance;
        let mut sorted: Vec<(f64, &Trial)> =
            trials.iter().map(|trial| (error(trial), trial)).collect();
        sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
        let at = |place: usize| sorted.get(place).map_or(0.0, |(error, _)| *error);
        let count = trials.len().max(1) as f64;
        let worst = sorted.last().map(|(_, trial)| {
            [&study.lights.entries[trial.light], &study.materials.entries[trial.material]]
                .map(|entry| entry.name.clone())
        });
        let components = Modes::BOTH
            .map(|modes| study.tables[place(Criterion::ImageCentered, modes)].components.len());
        let basis = place(Criterion::ImageCentered, Modes::Selected);
        let last = |trial: &Trial| trial.fits[basis].variances.last().copied().unwrap_or(0.0);
        Self {
            kept,
            variance_left: left / all,
            by_degree,
            largest_order,
            image_error: [
                at(trials.len() / 2),
                trials.iter().map(error).sum::<f64>() / count,
                at(trials.len().saturating_sub(1)),
            ],
            worst: worst.unwrap_or_default(),
            components,
            floor: trials.iter().map(|trial| last(trial) / trial.variance).sum::<f64>() / count,
        }
    }

    /// The CSV file.
    ///
    /// # Errors
    ///
    /// Never in practice.
    pub fn artefacts(&self) -> Result<Vec<Artefact>> {
        let mut rows: Vec<Vec<String>> = [
            ["modes_kept".into(), self.kept.to_string()],
            ["mode_variance_left_out".into(), digits(self.variance_left)],
            ["largest_order_kept".into(), self.largest_order.to_string()],
            ["image_error_median".into(), digits(self.image_error[0])],
            ["image_error_mean".into(), digits(self.image_error[1])],
            ["image_error_largest".into(), digits(self.image_error[2])],
            ["image_error_largest_light".into(), self.worst[0].clone()],
            ["image_error_largest_material".into(), self.worst[1].clone()],
            ["components_of_all_modes".into(), self.components[0].to_string()],
            ["components_of_selected_modes".into(), self.components[1].to_string()],
            ["error_of_all_components".into(), digits(self.floor)],
        ]
        .map(Vec::from)
        .to_vec();

        for (l, count) in self.by_degree.iter().enumerate() {
            rows.push(vec![format!("modes_kept_of_degree_{l}"), count.to_string()]);
        }
        Ok(vec![Artefact::csv("selected_modes.csv", "quantity,value", &rows)?])
    }
}
