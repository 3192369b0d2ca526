//! A span as a table holds it: its profiles and their two signs of m.

use crate::eigenimages;
use crate::span::{Function, Span};
use eigenshade_table::{Component, GramFactor, Profile};

impl Span {
    /// Its functions as components, without eigenvalues.
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

    /// Its profiles; polynomials are off by at most `tolerance` of what the strongest
    /// profile is in an image.
    ///
    /// Of an image of modes c the coordinate in a profile is at most s |c|, s its singular
    /// value: a weak profile may be off by as much more as it is weaker.
    pub(crate) fn table_profiles(&self, gram: &GramFactor, tolerance: f64) -> Vec<Profile> {
        let largest = self.largest();
        let mut profiles = Vec::new();
        for of in &self.azimuths {
            for (profile, singular) in of.singular_values.iter().enumerate() {
                let coordinates = of.profiles.get(.., profile..profile + 1).to_owned();
                let tolerance = (tolerance * largest / singular).min(1.0);
                let image = eigenimages::image(gram, &of.block, &coordinates, tolerance);
                // The span's own U: V / s, where `modes` is s V.
                let modes = of.modes.row(profile).iter();
                let modes = modes.map(|mode| mode / singular.powi(2)).collect();
                profiles.push(Profile { modes, ..image });
            }
        }
        profiles
    }
}
