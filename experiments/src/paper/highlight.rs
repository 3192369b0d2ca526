//! The brightest point of leather, reconstructed under every light.

use super::artefact::Artefact;
use super::study::{Modes, Study, Trial, place};
use eigenshade::{Basis, Normal};
use eigenshade_model::error::Result;
use eigenshade_model::truth::Truth;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::fault;
use eigenshade_shading::sphere_rings::{Ring, rings};
use eigenshade_table::scene::Criterion;

/// The material whose highlight the paper describes.
pub const MATERIAL: &str = "05-leather";
/// The highlight counts as present if the error of its brightest point is at most this.
pub const LIMIT: f64 = 0.1;
/// The largest number of components that is tried.
pub const LISTED: usize = 100;
/// The widest spacing of the normals in radians.
const SPACING: f64 = 0.02;

/// The first number of components from which the brightest point is right and stays right; `None`
/// if that takes more components than there are. `shares` are the reconstructed values at that
/// point relative to the reference, by number of components.
#[must_use]
pub fn right_from(shares: &[f64]) -> Option<usize> {
    let wrong = |share: &f64| (share - 1.0).abs() > LIMIT;
    let first = shares.iter().rposition(wrong).map_or(0, |last| last + 1);
    (first < shares.len()).then_some(first)
}

/// The direct sum at these normals.
#[must_use]
pub fn image(study: &Study, trial: &Trial, truth: &Truth, normals: &[[f64; 3]]) -> Vec<f64> {
    let (light, grey) = (&study.luminances[trial.light], &study.greys[trial.material]);
    let of = |&normal: &[f64; 3]| {
        let modes = truth.at(normal);
        modes.irradiance(light, &modes.scatter(grey))
    };
    normals.iter().map(of).collect()
}

/// The reconstructions with the first 0, 1, .. components at the brightest normal of the image,
/// relative to the reference there.
///
/// # Errors
///
/// Never in practice: the normals are unit vectors.
pub fn brightest(
    basis: &Basis<'_, f64>,
    coefficients: &[f64],
    image: &[f64],
    normals: &[[f64; 3]],
) -> Result<Vec<f64>> {
    let most = image.iter().zip(normals).max_by(|a, b| a.0.total_cmp(b.0));
    let (&truth, &[x, y, z]) = most.unwrap_or((&1.0, &[0.0, 0.0, 1.0]));
    let normal = Normal::new(x, y, z).map_err(fault)?;
    let there = |count: usize| basis.reconstruct(&coefficients[..count], normal);
    (0..=LISTED).map(|count| Ok(there(count).map_err(fault)? / truth)).collect()
}

/// The highlight of leather with the components of all modes.
pub struct Highlights {
    /// Each light, with the first number of components from which the brightest point is right.
    pub lights: Vec<(String, Option<usize>)>,
}

impl Highlights {
    /// Measures the highlight under every light.
    ///
    /// # Errors
    ///
    /// Never in practice: the shipped data contain every image.
    pub fn new(study: &Study, trials: &[Trial]) -> Result<Self> {
        let which = place(Criterion::ImageCentered, Modes::All);
        let owned = OwnedBasis::<f64>::new(&study.tables[which]);
        let basis = owned.basis().map_err(fault)?;
        let truth = Truth::new(study.lights.degree, study.materials.order);
        let normals: Vec<[f64; 3]> = rings(SPACING).iter().flat_map(Ring::normals).collect();
        let under = |name: &str| {
            let trial = study.trial(trials, name, MATERIAL)?;
            let image = image(study, trial, &truth, &normals);
            let coefficients = &trial.fits[which].coefficients;
            let shares = brightest(&basis, coefficients, &image, &normals)?;
            Ok((name.to_owned(), right_from(&shares)))
        };
        let lights = study.lights.entries.iter().map(|light| under(&light.name));
        Ok(Self { lights: lights.collect::<Result<_>>()? })
    }

    /// The least, the middle (the upper of two) and the largest number of components; `None` means
    /// more than were tried.
    #[must_use]
    pub fn spread(&self) -> [Option<usize>; 3] {
        let mut counts: Vec<Option<usize>> = self.lights.iter().map(|(_, count)| *count).collect();
        counts.sort_by_key(|count| count.unwrap_or(usize::MAX));
        let at = |place: usize| counts.get(place).copied().flatten();
        [at(0), at(counts.len() / 2), at(counts.len().saturating_sub(1))]
    }

    /// The CSV file. A light that needs more components than were tried has an empty field.
    ///
    /// # Errors
    ///
    /// Never in practice.
    pub fn artefact(&self) -> Result<Artefact> {
        let row = |(light, count): &(String, Option<usize>)| {
            let count = count.map_or(String::new(), |count| count.to_string());
            vec![light.clone(), count]
        };
        let rows: Vec<Vec<String>> = self.lights.iter().map(row).collect();
        Artefact::csv("highlight.csv", "light,components", &rows)
    }
}
