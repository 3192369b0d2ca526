//! Scores a reading against the true light and material.

use crate::numbers::median;
use eigenshade_cli::reading::Reading;
use eigenshade_generator::reading::observation::EigenimageValues;
use eigenshade_generator::reading::rank_one::RankOne;
use eigenshade_generator::reading::transfer::Transfers;
use eigenshade_index::light;
use eigenshade_model::database::{Lights, Materials};
use eigenshade_table::Table;
use eigenshade_testing::fixtures::{Image, direct_images};
use eigenshade_testing::largest;

/// Iterations for a product in least-norm modes, of which many do not converge within 10,000.
const LEAST_NORM_TURNS: usize = 200;

/// Images of known lights on known materials, in luminance.
pub struct TestSet {
    /// The normal of each pixel.
    pub normals: Vec<[f64; 3]>,
    pub images: Vec<TestImage>,
}

/// An image by the direct sum, scaled to a peak of 1.
pub struct TestImage {
    light: Vec<f64>,
    material: Vec<f64>,
    name: String,
    pub pixels: Vec<f64>,
    /// The factor by which it was scaled.
    scale: f64,
}

impl TestSet {
    /// Combines every light with every material.
    pub fn new(lights: &Lights, materials: &Materials, normals: Vec<[f64; 3]>) -> Self {
        let images = direct_images(lights, materials, &normals);
        let names = materials.entries.iter().flat_map(|one| vec![&one.name; lights.entries.len()]);
        let image = |((light, material, pixels), name): (Image, &String)| {
            let scale = largest(pixels.iter().copied()).recip();
            let pixels = pixels.iter().map(|value| scale * value).collect();
            TestImage { light, material, name: name.clone(), pixels, scale }
        };
        Self { images: images.into_iter().zip(names).map(image).collect(), normals }
    }
}

/// The errors of all readings of one kind of degradation.
#[derive(Default)]
pub struct Score {
    /// |d - reference| / |reference| by scalar product, least squares and posterior mean.
    coefficients: [Vec<f64>; 3],
    /// Rms of the image's error over the pixels that were not seen (or over all pixels if all were
    /// seen), relative to its peak, by the same three methods.
    images: [Vec<f64>; 3],
    /// Rank of the true material among the candidates, from 1.
    places: Vec<usize>,
    /// Errors of the light, up to degree 2 and up to the table's degree, with the likeliest
    /// material and with the true one; then up to degree 2 from the product in the posterior modes,
    /// and up to degree 2 from the product in the least-norm modes of least squares.
    lights: [Vec<f64>; 6],
}

/// The median of many errors and the worst one.
fn cell(errors: &[f64]) -> String {
    match errors.iter().copied().max_by(f64::total_cmp) {
        Some(worst) => format!("{:.1e}, {worst:.1e}", median(errors)),
        None => "-".into(),
    }
}

impl Score {
    /// Errors of d for each estimate, then of its image where it was not seen.
    pub fn of_estimates(&self) -> Vec<String> {
        self.coefficients.iter().chain(&self.images).map(|errors| cell(errors)).collect()
    }

    /// Ranks of the true material, then errors of the light.
    pub fn of_scene(&self) -> Vec<String> {
        let first = self.places.iter().filter(|place| **place == 1).count();
        let places = match self.places.iter().max() {
            Some(last) => [format!("{first} of {}", self.places.len()), last.to_string()],
            None => ["-", "-"].map(String::from),
        };
        places.into_iter().chain(self.lights.iter().map(|errors| cell(errors))).collect()
    }
}

/// The scores of readings whose channels are the images. `degraded` has the pixels' weights.
pub fn scores(
    readings: &[Reading],
    table: &Table,
    set: &TestSet,
    degraded: &[(Vec<f64>, Vec<f64>)],
    materials: &Materials,
) -> Score {
    let components = table.count();
    let transfers = Transfers::new(table, components);
    let values = EigenimageValues::new(table, components);
    let mut rows = vec![vec![0.0; components + 1]; set.normals.len()];
    rows.iter_mut().zip(&set.normals).for_each(|(row, normal)| values.at(*normal, row));
    let channels =
        readings.iter().flat_map(|reading| (0..reading.channels.len()).map(move |c| (reading, c)));
    let images = set.images.iter().zip(degraded);
    let mut score = Score::default();
    for ((reading, channel), (image, (_, weights))) in channels.zip(images) {
        let light = &image.light;
        let reference: Vec<f64> = transfers
            .of(&image.material)
            .row_iter()
            .map(|row| image.scale * row.iter().zip(light).map(|(t, l)| t * l).sum::<f64>())
            .collect();
        let all = weights.iter().all(|weight| *weight > 0.0);
        let unseen: Vec<usize> =
            (0..weights.len()).filter(|pixel| all || weights[*pixel] == 0.0).collect();
        let found = &reading.channels[channel];
        let estimates = [&found.scalar_product.0, &found.least_squares.0, &found.posterior.0.d];
        for (which, d) in estimates.into_iter().enumerate() {
            score.coefficients[which].push(distance(d, &reference) / length(&reference));
            let off = |&pixel: &usize| {
                let made: f64 = rows[pixel].iter().zip(d).map(|(u, d)| u * d).sum();
                (made - image.pixels[pixel]).powi(2)
            };
            let square: f64 = unseen.iter().map(off).sum();
            score.images[which].push((square / unseen.len() as f64).sqrt());
        }
        let mut ranked: Vec<_> = reading.candidates.iter().collect();
        ranked
            .sort_by(|a, b| b.channels[channel].evidence.total_cmp(&a.channels[channel].evidence));
        let low = light::count(2).min(light.len());
        let mut add = |which: usize, estimate: &[f64], count: usize| {
            score.lights[which].push(misdirection(&estimate[..count], &light[..count]));
        };
        let best = &ranked[0].channels[channel].light;
        add(0, best, low);
        add(1, best, light.len());
        let place = ranked.iter().position(|one| materials.entries[one.index].name == image.name);
        if let Some(place) = place {
            let known = &ranked[place].channels[channel].light;
            score.places.push(place + 1);
            add(2, known, low);
            add(3, known, light.len());
        }
        add(4, &found.product.light, low);
        if let Ok(product) = RankOne::within(&found.least_norm, LEAST_NORM_TURNS) {
            add(5, &product.light, low);
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

/// |s found - reference| / |reference| at the best s: unknown albedo leaves the exposure open.
fn misdirection(found: &[f64], reference: &[f64]) -> f64 {
    let product: f64 = found.iter().zip(reference).map(|(a, b)| a * b).sum();
    let square = found.iter().map(|a| a * a).sum::<f64>();
    let factor = if square > 0.0 { product / square } else { 0.0 };
    let scaled: Vec<f64> = found.iter().map(|a| factor * a).collect();
    distance(&scaled, reference) / length(reference)
}
