//! The normals that an object shows, and the share of its picture that each one takes.

use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::normals::visible;

/// The normals of an object.
#[derive(Clone, Debug, PartialEq)]
pub enum Geometry {
    /// Normals of a sphere: density cos(α)/π over the visible hemisphere.
    Sphere,
    /// A list of normals.
    Listed(WeightedNormals),
}

/// Unit normals with z >= 0, each with its share of the picture.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WeightedNormals {
    normals: Vec<[f64; 3]>,
    weights: Vec<f64>,
}

impl WeightedNormals {
    /// Normals with weights of any scale; those of weight zero are left out.
    ///
    /// Normals are scaled to unit length. A normal that points slightly away from the camera is
    /// moved to the rim, as by [`visible`].
    ///
    /// # Errors
    ///
    /// If a normal has no direction or points away, a weight is negative or not finite, or no
    /// normal has a weight above zero. Messages number the pairs from 0.
    pub fn new(pairs: impl IntoIterator<Item = ([f64; 3], f64)>) -> Result<Self> {
        let pairs = pairs.into_iter();
        let least = pairs.size_hint().0;
        let mut listed =
            Self { normals: Vec::with_capacity(least), weights: Vec::with_capacity(least) };
        for (number, (normal, weight)) in pairs.enumerate() {
            if !(weight >= 0.0 && weight.is_finite()) {
                let what = format!("normal {number} has weight {weight}");
                return Err(Error::new(what, "give it a finite weight of zero or more"));
            }
            if weight == 0.0 {
                continue;
            }
            let normal = visible(normal)
                .map_err(|(what, remedy)| Error::new(format!("normal {number}: {what}"), remedy))?;
            listed.normals.push(normal);
            listed.weights.push(weight);
        }
        // Scale by the largest weight first, so that the sum neither overflows nor vanishes.
        let largest = listed.weights.iter().copied().fold(0.0, f64::max);
        let sum: f64 = listed.weights.iter().map(|weight| weight / largest).sum();
        if listed.weights.is_empty() {
            return Err(Error::new(
                "no normal is visible",
                "give at least one that faces the camera, with a weight above zero",
            ));
        }
        listed.weights.iter_mut().for_each(|weight| *weight = *weight / largest / sum);
        Ok(listed)
    }

    /// The normals.
    #[must_use]
    pub fn normals(&self) -> &[[f64; 3]] {
        &self.normals
    }

    /// The weights, which sum to 1.
    #[must_use]
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }
}
