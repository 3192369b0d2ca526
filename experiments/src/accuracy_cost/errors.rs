//! The error of the method: a setting against the direct sum of its own degree and order.

use super::images::Shaded;
use super::images::{Image, Images};
use super::numbers::numbers;
use super::settings::Setting;
use crate::numbers::median;
use eigenshade_model::error::Result;
use eigenshade_shading::parallel;
use eigenshade_table::Table;

/// The share of the errors that [`Spread::most`] covers.
const COVERED: f64 = 0.95;

/// Of many errors relative to the peak.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    pub median: f64,
    /// The 95th percentile: the least of these errors that 95 of 100 do not exceed.
    pub most: f64,
    pub worst: f64,
}

impl Spread {
    pub fn of(values: &[f64]) -> Self {
        let mut sorted = values.to_vec();
        sorted.sort_by(f64::total_cmp);
        let rank = (COVERED * sorted.len() as f64).ceil() as usize;
        let most = sorted.get(rank.saturating_sub(1)).copied().unwrap_or(0.0);
        // NaN comes last.
        let worst = sorted.last().copied().unwrap_or(0.0);
        Self { median: median(values), most, worst }
    }
}

/// Errors over a sphere, relative to each image's peak.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errors {
    /// Root mean squares over the normals.
    pub rms: Spread,
    /// Largest errors.
    pub largest: Spread,
}

/// The measured errors of a setting.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// Over the materials from which the basis was made.
    pub seen: Errors,
    /// Over other materials.
    pub unseen: Errors,
    /// The number of terms of a pixel; the median if it depends on the image.
    pub terms: usize,
    /// The index of an image with that number of terms.
    pub typical: usize,
    /// Bytes in RAM: [`Shaded::bytes`].
    pub bytes: usize,
}

/// Compares every image.
pub fn compare(setting: &Setting, table: &Table, images: &Images) -> Result<Found> {
    let numbers = numbers(setting, table, &images.sphere.normals)?;
    let all = parallel::map(images.images.len(), &(), |k| {
        let image = &images.images[k];
        let Shaded { irradiances, terms, bytes } = numbers.image(&image.pair)?;
        Ok((errors(&irradiances, image, &images.sphere.weights), [terms, k, bytes]))
    });
    let all = all.into_iter().collect::<Result<Vec<([f64; 2], [usize; 3])>>>()?;
    let chosen = |seen| all.iter().zip(&images.images).filter(move |(_, one)| one.seen == seen);
    let of = |seen| {
        let [rms, largest] = [0, 1].map(|kind| {
            Spread::of(&chosen(seen).map(|((errors, _), _)| errors[kind]).collect::<Vec<_>>())
        });
        Errors { rms, largest }
    };
    let mut by_terms: Vec<[usize; 3]> = chosen(true).map(|((_, costs), _)| *costs).collect();
    by_terms.sort_unstable();
    let [terms, typical, bytes] = by_terms[by_terms.len() / 2];
    Ok(Found { seen: of(true), unseen: of(false), terms, typical, bytes })
}

/// The rms over the normals and the largest error, relative to the peak.
fn errors(values: &[f64], image: &Image, weights: &[f64]) -> [f64; 2] {
    let (mut square, mut largest) = (0.0, 0.0f64);
    for ((value, reference), weight) in values.iter().zip(&image.reference).zip(weights) {
        let difference = (value - reference).abs();
        square += weight * difference * difference;
        if difference.is_nan() || difference > largest {
            largest = difference;
        }
    }
    [square.sqrt() / image.peak, largest / image.peak]
}

#[cfg(test)]
mod tests {
    use super::Spread;

    #[test]
    fn ninety_five_of_a_hundred_do_not_exceed_the_percentile() {
        let values: Vec<f64> = (1..=100).rev().map(f64::from).collect();
        assert_eq!(Spread::of(&values), Spread { median: 50.5, most: 95.0, worst: 100.0 });
        assert_eq!(Spread::of(&values[..20]).most, 99.0);
        assert_eq!(Spread::of(&values[..1]).most, 100.0);
        assert_eq!(Spread::of(&[]).most, 0.0);
        assert!(Spread::of(&[1.0, f64::NAN]).worst.is_nan());
    }
}
