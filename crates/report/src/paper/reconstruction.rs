//! Fig. 7: reconstructions of velvet and leather, and leather's brightest point under every light.

use super::plate::{Plate, UNCLIPPED, gray};
use super::{Modes, Study, Trial, csv, place, row, title};
use crate::figures::OutputFile;
use crate::numbers::exposure;
use eigenshade_model::error::Result;
use eigenshade_model::evaluation::Evaluator;
use eigenshade_model::reference::DirectSum;
use eigenshade_model::sphere_rings::{Ring, rings};
use eigenshade_table::Table;
use eigenshade_table::scene::Criterion;

/// Material and light of each image.
const SHOWN: [(&str, &str); 2] = [("07-velvet", "forest"), ("05-leather", "studio")];
const COUNTS: [usize; 6] = [3, 5, 10, 20, 30, 50];
/// Width of each sphere in pixels.
const SIZE: usize = 148;
/// The colors of the residual end at this share of the image's largest value.
const RESIDUAL: f64 = 0.1;
/// The material whose highlight the paper describes.
const GLOSSY: &str = "05-leather";
/// The highlight counts as present if the error of its brightest point is at most this.
const LIMIT: f64 = 0.1;
/// The largest number of components that is tried.
const LISTED: usize = 100;
/// The widest spacing of the normals in radians, where a highlight is sought.
const SPACING: f64 = 0.02;

pub fn files(study: &Study) -> Result<Vec<OutputFile>> {
    let [plate, sheet] = plate(study)?;
    Ok(vec![plate, sheet, highlights(study)?])
}

/// The plate and its CSV.
fn plate(study: &Study) -> Result<[OutputFile; 2]> {
    let mut rows = Vec::new();
    let which = place(Criterion::ImageCentered, Modes::All);
    let evaluator = Evaluator::new(&study.tables[which]).with_components(LISTED);
    let mut plate = Plate::new(SIZE, (COUNTS.len() + 1, 2 * SHOWN.len()), [2, 0, 1]);
    let normals = plate.view.normals.clone();
    let eigenimages = evaluator.eigenimages(&normals);
    for (pair, (material, light)) in SHOWN.into_iter().enumerate() {
        let trial = study.trial(light, material)?;
        let image = direct_sum(study, trial, &normals);
        let peak = image.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        let scale = exposure(image.clone(), UNCLIPPED);
        plate.light((0, 2 * pair), scale, gray(&image));
        plate.below((0, 2 * pair), &[&title(material)]);
        let fit = &trial.fits[which];
        let brightest = brightest(&evaluator, &fit.coefficients, &image, &normals);
        let errors = fit.variances.iter().map(|left| left / trial.variance);
        for (count, (error, share)) in errors.zip(brightest).enumerate() {
            rows.push(row(&[&light, &material, &count], [error, share]));
        }
        for (column, count) in (1..).zip(COUNTS) {
            let ours = eigenimages.reconstruct(&fit.coefficients[..count]);
            plate.light((column, 2 * pair), scale, gray(&ours));
            let residual = image.iter().zip(&ours).map(|(a, b)| (a - b) / (RESIDUAL * peak));
            plate.signed((column, 2 * pair + 1), residual);
            let left = 100.0 * fit.variances[count] / trial.variance;
            plate.below((column, 2 * pair + 1), &[&format!("{left:.1} %")]);
        }
    }
    plate.above(0, "reference");
    for (column, count) in (1..).zip(COUNTS) {
        plate.above(column, &format!("K = {count}"));
    }
    let picture =
        OutputFile::picture("reconstruction.png", plate.scale(&format!("{RESIDUAL} of the peak")));
    let header = "light,material,components,error,brightest";
    Ok([picture, csv("reconstruction.csv", header, &rows)?])
}

/// The number of components of all modes from which leather's brightest point is right, under every
/// light. A light that needs more components than were tried has an empty field.
fn highlights(study: &Study) -> Result<OutputFile> {
    let which = place(Criterion::ImageCentered, Modes::All);
    let evaluator = Evaluator::new(&study.tables[which]).with_components(LISTED);
    let normals: Vec<[f64; 3]> = rings(SPACING).iter().flat_map(Ring::normals).collect();
    let mut rows = Vec::new();
    for light in &study.lights.entries {
        let trial = study.trial(&light.name, GLOSSY)?;
        let image = direct_sum(study, trial, &normals);
        let shares = brightest(&evaluator, &trial.fits[which].coefficients, &image, &normals);
        let count = right_from(&shares).map_or(String::new(), |count| count.to_string());
        rows.push(vec![light.name.clone(), count]);
    }
    csv("highlight.csv", "light,components", &rows)
}

/// The first number of components from which the brightest point is right and stays right; `None`
/// if that takes more components than there are. `shares` are the reconstructed values at that
/// point relative to the reference, by number of components.
pub fn right_from(shares: &[f64]) -> Option<usize> {
    let wrong = |share: &f64| (share - 1.0).abs() > LIMIT;
    let first = shares.iter().rposition(wrong).map_or(0, |last| last + 1);
    (first < shares.len()).then_some(first)
}

fn direct_sum(study: &Study, trial: &Trial, normals: &[[f64; 3]]) -> Vec<f64> {
    let reference = DirectSum::new(study.lights.degree, study.materials.order);
    let (light, gray) = (&study.luminances[trial.light], &study.grays[trial.material]);
    let modes = normals.iter().map(|&normal| reference.at(normal));
    modes.map(|modes| modes.irradiance(light, &modes.scatter(gray))).collect()
}

/// With 0, 1, .. components, the value at the image's brightest normal, of the reference there.
fn brightest(
    evaluator: &Evaluator<&Table>,
    coefficients: &[f64],
    image: &[f64],
    normals: &[[f64; 3]],
) -> Vec<f64> {
    let most = image.iter().zip(normals).max_by(|a, b| a.0.total_cmp(b.0));
    let (&reference, &normal) = most.unwrap_or((&1.0, &[0.0, 0.0, 1.0]));
    let there = evaluator.eigenimages(&[normal]);
    (0..=LISTED).map(|count| there.reconstruct(&coefficients[..count])[0] / reference).collect()
}

#[cfg(test)]
mod tests {
    use super::right_from;

    #[test]
    fn a_point_is_right_from_the_last_wrong_one_on() {
        assert_eq!(right_from(&[0.0, 0.95, 0.8, 1.09, 0.91]), Some(3));
        assert_eq!((right_from(&[1.0, 1.0]), right_from(&[1.0, 0.5])), (Some(0), None));
    }
}
