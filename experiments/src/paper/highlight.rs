//! The brightest point of leather, reconstructed, under every light.

use super::artefact::Artefact;
use super::study::{Modes, Study, Trial, place};
use eigenshade::{Basis, Normal};
use eigenshade_model::error::Result;
use eigenshade_model::truth::Truth;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::fault;
use eigenshade_shading::sphere_rings::{Ring, rings};
use eigenshade_table::scene::Criterion;

/// The material whose highlight the paper speaks of.
pub const MATERIAL: &str = "05-leather";
/// The highlight is there if its brightest point is off by at most this.
pub const LIMIT: f64 = 0.1;
/// Numbers of components that are tried.
pub const LISTED: usize = 100;
/// The normals are no farther apart, radians.
const SPACING: f64 = 0.02;

/// The first number of components from which the brightest point is right, and stays; none if
/// that takes more than there are. `shares` are the reconstruction there, of the truth, by
/// number of components.
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

/// The reconstruction by the first 0, 1, .. components at the image's brightest normal, of the
/// truth there.
///
/// # Errors
///
/// None in truth: the normals are unit vectors.
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

/// Leather's highlight by the components of all modes.
pub struct Highlights {
    /// Light, and the first number of components from which the brightest point is right.
    pub lights: Vec<(String, Option<usize>)>,
}

impl Highlights {
    /// Under every light.
    ///
    /// # Errors
    ///
    /// None in truth: the shipped data have every image.
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

    /// The least, the middle (the upper of two) and the largest number of components; none is
    /// more than were tried.
    #[must_use]
    pub fn spread(&self) -> [Option<usize>; 3] {
        let mut counts: Vec<Option<usize>> = self.lights.iter().map(|(_, count)| *count).collect();
        counts.sort_by_key(|count| count.unwrap_or(usize::MAX));
        let at = |place: usize| counts.get(place).copied().flatten();
        [at(0), at(counts.len() / 2), at(counts.len().saturating_sub(1))]
    }

    /// CSV; a light that takes more than were tried has an empty field.
    ///
    /// # Errors
    ///
    /// None in truth.
    pub fn artefact(&self) -> Result<Artefact> {
        let row = |(light, count): &(String, Option<usize>)| {
            let count = count.map_or(String::new(), |count| count.to_string());
            vec![light.clone(), count]
        };
        let rows: Vec<Vec<String>> = self.lights.iter().map(row).collect();
        Artefact::csv("highlight.csv", "light,components", &rows)
    }
}
