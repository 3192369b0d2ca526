//! Scores a reading against the true light and material.

use crate::median::median;
use crate::reading::damage::Damage;
use eigenshade_cli::reading::image_reading::Reading;
use eigenshade_generator::reading::eigenimage_values::EigenimageValues;
use eigenshade_generator::reading::rank_one::RankOne;
use eigenshade_generator::reading::transfer::Transfers;
use eigenshade_index::light;
use eigenshade_model::database::{Materials, Named};
use eigenshade_model::truth::Truth;
use eigenshade_table::Table;
use std::fmt;

/// Iterations for a product in least-norm modes: these are far from any product, and many do not
/// converge within 10,000.
const LEAST_NORM_TURNS: usize = 200;

/// Images of known lights on known materials.
pub struct Truths {
    /// Light and material of each image.
    pairs: Vec<(Vec<f64>, Named)>,
    /// The normal of each pixel.
    pub normals: Vec<[f64; 3]>,
    /// The direct sums, scaled to a peak of 1.
    pub images: Vec<Vec<f64>>,
    /// The factor by which each was scaled.
    scales: Vec<f64>,
}

/// Errors of many images, shown as their median and the worst one.
#[derive(Default)]
pub struct Errors(Vec<f64>);

impl fmt::Display for Errors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0.iter().copied().max_by(f64::total_cmp) {
            Some(worst) => write!(f, "{:.1e}, {worst:.1e}", median(&self.0)),
            None => write!(f, "-"),
        }
    }
}

/// The errors of all readings of one kind of damage.
#[derive(Default)]
pub struct Score {
    /// |d - truth| / |truth| by scalar product, least squares and posterior mean.
    pub coefficients: [Errors; 3],
    /// Rms of the image's error over the pixels that were not seen (or over all pixels if all were
    /// seen), relative to its peak, by the same three methods.
    pub images: [Errors; 3],
    /// Rank of the true material among the candidates, from 0.
    pub places: Vec<usize>,
    /// Errors of the light, up to degree 2 and up to the table's degree, with the likeliest
    /// material and with the true one; then up to degree 2 from the product in the posterior modes,
    /// and up to degree 2 from the product in the least-norm modes of least squares.
    pub lights: [Errors; 6],
}

impl Truths {
    /// Combines every light with every material, in luminance.
    pub fn new(
        [lights, materials]: [Vec<Named>; 2],
        [degree, order]: [usize; 2],
        normals: Vec<[f64; 3]>,
    ) -> Self {
        let truth = Truth::new(degree, order);
        let modes: Vec<_> = normals.iter().map(|normal| truth.at(*normal)).collect();
        let mut truths =
            Self { pairs: Vec::new(), normals: Vec::new(), images: Vec::new(), scales: Vec::new() };
        for material in &materials {
            let coefficients = material.luminance();
            let scattered: Vec<_> =
                modes.iter().map(|modes| modes.scatter(&coefficients)).collect();
            for light in &lights {
                let light = light.luminance();
                let image: Vec<f64> = modes
                    .iter()
                    .zip(&scattered)
                    .map(|(modes, scattered)| modes.irradiance(&light, scattered))
                    .collect();
                let scale = image.iter().fold(0.0f64, |peak, value| peak.max(value.abs())).recip();
                truths.images.push(image.iter().map(|value| scale * value).collect());
                truths.scales.push(scale);
                truths.pairs.push((light, material.clone()));
            }
        }
        drop(modes);
        Self { normals, ..truths }
    }
}

/// The scores of these readings, whose channels are the images.
pub fn scores(
    readings: &[Reading],
    table: &Table,
    truths: &Truths,
    damage: Damage,
    materials: &Materials,
) -> Score {
    let components = table.components.len();
    let transfers = Transfers::new(table, components);
    let values = EigenimageValues::new(table, components);
    let mut rows = vec![vec![0.0; components + 1]; truths.normals.len()];
    rows.iter_mut().zip(&truths.normals).for_each(|(row, normal)| values.at(*normal, row));
    let channels =
        readings.iter().flat_map(|reading| (0..reading.channels.len()).map(move |c| (reading, c)));
    let mut score = Score::default();
    for ((reading, channel), k) in channels.zip(0..) {
        let (light, material) = &truths.pairs[k];
        let image = &truths.images[k];
        let transfer = transfers.of(&material.luminance());
        let truth: Vec<f64> = transfer
            .row_iter()
            .map(|row| truths.scales[k] * row.iter().zip(light).map(|(t, l)| t * l).sum::<f64>())
            .collect();
        let weights = damage.apply(image, &truths.normals, k as u64).1;
        let all = weights.iter().all(|weight| *weight > 0.0);
        let unseen: Vec<usize> =
            (0..weights.len()).filter(|pixel| all || weights[*pixel] == 0.0).collect();
        let found = &reading.channels[channel];
        let estimates = [&found.scalar_product.0, &found.least_squares.0, &found.posterior.0.d];
        for (which, d) in estimates.into_iter().enumerate() {
            score.coefficients[which].0.push(distance(d, &truth) / length(&truth));
            let square: f64 = unseen
                .iter()
                .map(|&pixel| {
                    let made: f64 = rows[pixel].iter().zip(d).map(|(u, d)| u * d).sum();
                    (made - image[pixel]).powi(2)
                })
                .sum();
            score.images[which].0.push((square / unseen.len() as f64).sqrt());
        }
        let mut ranked: Vec<_> = reading.candidates.iter().collect();
        ranked
            .sort_by(|a, b| b.channels[channel].evidence.total_cmp(&a.channels[channel].evidence));
        let is_true = |place: &usize| materials.entries[ranked[*place].index].name == material.name;
        let place = (0..ranked.len()).find(is_true);
        let low = light::count(2).min(light.len());
        let error =
            |estimate: &[f64], count: usize| misdirection(&estimate[..count], &light[..count]);
        let best = &ranked[0].channels[channel].light;
        let known = place.map(|place| &ranked[place].channels[channel].light);
        score.lights[0].0.push(error(best, low));
        score.lights[1].0.push(error(best, light.len()));
        if let (Some(place), Some(known)) = (place, known) {
            score.places.push(place);
            score.lights[2].0.push(error(known, low));
            score.lights[3].0.push(error(known, light.len()));
        }
        score.lights[4].0.push(error(&found.product.light, low));
        if let Ok(product) = RankOne::within(&found.least_norm, LEAST_NORM_TURNS) {
            score.lights[5].0.push(error(&product.light, low));
        }
    }
    score
}

fn length(values: &[f64]) -> f64 {
    values.iter().map(|value| value * value).sum::<f64>().sqrt()
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

/// |s found - truth| / |truth| at the best factor s, because an image of unknown albedo does not
/// determine the exposure.
fn misdirection(found: &[f64], truth: &[f64]) -> f64 {
    let product: f64 = found.iter().zip(truth).map(|(a, b)| a * b).sum();
    let square = found.iter().map(|a| a * a).sum::<f64>();
    let factor = if square > 0.0 { product / square } else { 0.0 };
    let scaled: Vec<f64> = found.iter().map(|a| factor * a).collect();
    distance(&scaled, truth) / length(truth)
}
