//! The estimates of all channels of an image: components, light and material.

use crate::basis::database::comparable_weights;
use crate::basis::moments::{LightMoments, MaterialMoments, equal};
use crate::reading::coefficients::{CUTOFF, Fit, LeastSquares, fit, scalar_product};
use crate::reading::light_estimate::{self, Candidate};
use crate::reading::modes::{self, ModeCoefficients};
use crate::reading::observation::Observation;
use crate::reading::posterior::{Estimate, Posterior, Prior};
use crate::reading::rank_one::RankOne;
use crate::reading::transfer::Transfers;
use eigenshade_model::database::{self, Lights, Materials, Named};
use eigenshade_model::error::Result;
use eigenshade_table::Table;
use std::collections::BTreeMap;

/// Tolerance for comparing the variances of d with the table's eigenvalues, relative to the
/// largest: the two sum the same squares in different ways.
const SAME_STATISTICS: f64 = 1e-9;

/// The data that all readings share, from a table and its databases.
#[derive(Clone, Debug)]
pub struct Reader<'a> {
    table: &'a Table,
    materials: &'a Materials,
    transfers: Transfers,
    prior: Prior,
}

/// The estimates from one channel.
#[derive(Clone, Debug)]
pub struct Channel {
    /// d by scalar product, and its fit.
    pub scalar_product: (Vec<f64>, Fit),
    /// d by weighted least squares, and its fit.
    pub least_squares: (Vec<f64>, Fit),
    /// The posterior of d, and the fit of its mean.
    pub posterior: (Estimate, Fit),
    /// The noise that was assumed.
    pub noise: f64,
    /// The modes of the least-squares d with the least norm.
    pub least_norm: ModeCoefficients,
    /// The posterior mean of the modes.
    pub modes: ModeCoefficients,
    /// The posterior modes factored into a light times a material, in the scale of a material of
    /// the database.
    pub product: RankOne,
}

/// The estimates from an image.
#[derive(Clone, Debug)]
pub struct Reading {
    /// The estimates for each channel.
    pub channels: Vec<Channel>,
    /// The number of directions that the pixels determine, out of as many as there are components.
    pub rank: usize,
    /// The factor by which pixel errors may grow in d.
    pub condition: f64,
    /// The materials of the database, most likely first.
    pub candidates: Vec<Candidate>,
}

impl<'a> Reader<'a> {
    /// Uses the first `components` of the table, and these databases. Fails if a database is empty,
    /// a light cannot be normalized, or a number is not finite.
    pub fn new(
        table: &'a Table,
        components: usize,
        lights: &Lights,
        materials: &'a Materials,
    ) -> Result<Self> {
        let transfers = Transfers::new(table, components);
        let scene = &table.scene;
        let of_lights = weights(&lights.entries, &scene.light.weights)?;
        let moments = LightMoments::weighted(lights, scene.light.normalize, &of_lights)?;
        let weights = weights(&materials.entries, &scene.material.weights)?;
        let weights = comparable_weights(scene, (lights, &of_lights), (materials, weights))?;
        let of_materials = MaterialMoments::weighted(materials, weights);
        let prior = Prior::new(table, &transfers, &moments, of_materials)?;
        Ok(Self { table, materials, transfers, prior })
    }

    /// Whether the databases are those from which the table was made: the eigenvalues of V_d are
    /// the table's.
    #[must_use]
    pub fn is_of_the_database(&self) -> bool {
        let eigenvalues = self.table.spectrum.iter().map(|(_, value)| *value);
        let moments = self.prior.second_moment();
        let largest =
            self.table.spectrum.iter().filter_map(|(_, value)| *value).fold(0.0, f64::max);
        (0..moments.nrows()).zip(eigenvalues).all(|(k, value)| {
            value.is_none_or(|value| (moments[(k, k)] - value).abs() <= SAME_STATISTICS * largest)
        })
    }

    /// Whether all images of the databases are black, so that nothing can be estimated.
    #[must_use]
    pub fn is_black(&self) -> bool {
        self.prior.is_black()
    }

    /// Reads an image of one gray channel or three colors. `noise` is the standard deviation of a
    /// pixel of weight 1, if it is known. Fails if the singular values do not converge.
    pub fn read(&self, observation: &Observation, noise: Option<f64>) -> Result<Reading> {
        let squares = LeastSquares::new(observation, CUTOFF)?;
        let posterior = Posterior::new(observation, &self.prior)?;
        let channels = (0..observation.channels.ncols())
            .map(|channel| self.channel(observation, &squares, &posterior, channel, noise))
            .collect::<Result<Vec<_>>>()?;
        let noises: Vec<f64> = channels.iter().map(|channel| channel.noise).collect();
        let (prior, transfers) = (&self.prior, &self.transfers);
        let candidates =
            light_estimate::rank(observation, prior, transfers, self.materials, &noises)?;
        let (rank, condition) = (squares.rank(), squares.condition());
        Ok(Reading { channels, rank, condition, candidates })
    }

    fn channel(
        &self,
        observation: &Observation,
        squares: &LeastSquares,
        posterior: &Posterior<'_>,
        channel: usize,
        stated: Option<f64>,
    ) -> Result<Channel> {
        let rank = squares.rank();
        let fitted = |d: Vec<f64>| {
            let fit = fit(observation, channel, &d, rank);
            (d, fit)
        };
        let least_squares = fitted(squares.solve(observation.centered(channel).as_ref()));
        let noise = posterior.noise(channel, stated, least_squares.1.noise);
        let estimate = posterior.estimate(channel, noise);
        let of_mean = fit(observation, channel, &estimate.d, rank);
        let modes = modes::posterior_mean(&self.transfers, &self.prior, &estimate);
        let mut product = RankOne::of(&modes)?;
        product.scaled_to(&self.prior.materials.vectors);
        Ok(Channel {
            scalar_product: fitted(scalar_product(observation, channel)),
            least_norm: modes::least_norm(self.table, &least_squares.0),
            least_squares,
            posterior: (estimate, of_mean),
            noise,
            modes,
            product,
        })
    }
}

/// The weights of the table's scene, or equal weights for a different database.
fn weights(entries: &[Named], by_name: &BTreeMap<String, f64>) -> Result<Vec<f64>> {
    let is_there = |name: &String| entries.iter().any(|entry| entry.name == *name);
    if by_name.keys().all(is_there) {
        database::weights(entries, by_name)
    } else {
        Ok(equal(entries.len()))
    }
}
