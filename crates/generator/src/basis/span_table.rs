//! Converts a span to the entries of a table: its profiles and their two signs of m.

use crate::basis::eigenimages;
use crate::basis::span::{Function, Span};
use eigenshade_index::effect::Effects;
use eigenshade_table::{Component, GramFactor, Profile};
use faer::Mat;

impl Span {
    /// The functions of the span as components, without eigenvalues.
    pub(crate) fn components(&self) -> Vec<Component> {
        let mut first = Vec::new();
        let mut start = 0;
        for of in &self.azimuths {
            first.push(start);
            start += of.profiles.ncols();
        }
        self.functions()
            .map(|Function { order, profile }| Component {
                order,
                profile: first[order.unsigned_abs() as usize] + profile,
                eigenvalue: None,
            })
            .collect()
    }

    /// The profiles of the span for the given images, as columns of coordinates, and a mean image,
    /// which may be empty.
    ///
    /// The polynomial error of a profile is at most `tolerance` divided by the largest coordinate
    /// of any image in that profile, so its contribution to an image stays within `tolerance`.
    pub(crate) fn table_profiles(
        &self,
        of_table: (&GramFactor, Effects),
        tolerance: f64,
        images: &Mat<f64>,
        mean: &[f64],
    ) -> Vec<Profile> {
        let largest = |function: usize| -> f64 {
            let of_images = (0..images.ncols()).map(|image| images[(function, image)]);
            let of_mean = mean.get(function).copied();
            of_images.chain(of_mean).fold(0.0, |most, value| most.max(value.abs()))
        };
        let mut profiles = Vec::new();
        let mut functions = 0..;
        for (azimuth, of) in self.azimuths.iter().enumerate() {
            for (profile, singular) in of.singular_values.iter().enumerate() {
                let signs = if azimuth == 0 { 1 } else { 2 };
                let weight = functions.by_ref().take(signs).map(largest).fold(0.0, f64::max);
                let coordinates = of.profiles.get(.., profile..profile + 1).to_owned();
                let tolerance = (tolerance / weight).min(1.0);
                let image = eigenimages::image(of_table, &of.block, &coordinates, tolerance);
                // The span's own U is V / s; `modes` is s V.
                let modes = of.modes.row(profile).iter();
                let modes = modes.map(|mode| mode / singular.powi(2)).collect();
                profiles.push(Profile { modes, ..image });
            }
        }
        profiles
    }
}
