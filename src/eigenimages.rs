//! The eigenimages themselves, component by component: slower than a [`Scene`](crate::Scene), which
//! is their sum, but each has its value.

use crate::basis::Basis;
use crate::error::Error;
use crate::float;
use crate::index::record::ProfilePlace;
use crate::normal::Normal;
use crate::scene::weights;
use crate::shade::{argument, value};

impl<'a> Basis<'a> {
    /// The irradiance of one normal as Σ d_i U_i, component by component, without collapsing. A
    /// reference for [`Scene::shade`](crate::Scene::shade).
    ///
    /// # Errors
    ///
    /// [`Error::Length`] if there are more coefficients than components.
    pub fn reconstruct(&self, coefficients: &[f32], normal: Normal) -> Result<f32, Error> {
        Error::check_components(self.components(), coefficients.len())?;
        let mut sum = 0.0;
        for (place, value, [cosine, sine]) in self.eigenimages_at(normal) {
            let [plus, minus] = weights(place.components(), coefficients);
            sum += value * (plus * cosine + minus * sine);
        }
        Ok(sum)
    }

    /// For each profile the value of its polynomial at a normal, and what it is multiplied by in
    /// the eigenimages of +m and, with the opposite sign, of -m. There is no root and no division.
    #[inline]
    pub(crate) fn eigenimages_at(
        &self,
        normal: Normal,
    ) -> impl Iterator<Item = (&'a ProfilePlace, f32, [f32; 2])> {
        let t = argument(normal.z);
        let (mut cosine, mut sine, mut azimuth) = (1.0, 0.0, 0);
        self.profiles().map(move |(place, terms)| {
            while azimuth < place.azimuth() {
                (cosine, sine) = turned(cosine, sine, normal.x, normal.y);
                azimuth += 1;
            }
            (place, value(terms, t), [cosine, sine])
        })
    }
}

/// (cosine + i sine)(x + i y).
#[inline]
fn turned(cosine: f32, sine: f32, x: f32, y: f32) -> (f32, f32) {
    (float::add_product(cosine * x, -sine, y), float::add_product(cosine * y, sine, x))
}
