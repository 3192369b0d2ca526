//! The figures of Nillius and Eklundh, "Phenomenological Eigenfunctions for Image Irradiance", ICCV
//! 2003, on the shipped databases. Each file of this module makes one figure, as CSV and as a
//! picture.

pub mod study;

pub mod artefact;

pub(crate) mod chart;

mod plate;

pub mod variance;

pub mod shape;

pub mod eigenimages;

pub mod spheres;

mod rank_correlation;

pub mod error;

pub mod rotated;

pub mod highlight;

pub mod reconstruction;

pub mod bound;

pub mod bound_spheres;

pub mod selected;

pub mod report;

pub mod comparison;

use artefact::Artefact;
use eigenshade_model::error::Result;
use indicatif::ProgressBar;
use study::Study;

/// The folder of the figures, next to the page that shows them.
pub const FOLDER: &str = "paper";
/// The file name of the page.
pub const PAGE: &str = "paper.md";

/// Makes the page and, below [`FOLDER`], its figures.
///
/// # Errors
///
/// If the folder for temporary files, through which the shipped data are read, fails.
pub fn make(progress: &ProgressBar) -> Result<Vec<Artefact>> {
    let study = Study::new(progress)?;
    let trials = study.trials(progress);
    let variance = variance::Variance::new(&study);
    let eigenimages = eigenimages::Eigenimages::new(&study)?;
    let spheres = spheres::Spheres::new(&study, &trials, progress)?;
    let errors = error::Errors::new(&study, &trials);
    let rotated = rotated::Rotated::new(&study, progress);
    let bounds = bound::Bounds::new(&study, &trials, progress);
    let renderings = bound_spheres::Renderings::new(&study, &trials, progress)?;
    let reconstructions = reconstruction::Reconstructions::new(&study, &trials)?;
    let highlights = highlight::Highlights::new(&study, &trials)?;
    let selected = selected::Selected::new(&study, &trials);
    let page = report::Report {
        study: &study,
        variance: &variance,
        eigenimages: &eigenimages,
        spheres: &spheres,
        errors: &errors,
        rotated: &rotated,
        bounds: &bounds,
        renderings: &renderings,
        reconstructions: &reconstructions,
        highlights: &highlights,
        selected: &selected,
    };
    let mut artefacts = vec![Artefact::text(PAGE, page.page())];
    for figure in [
        variance.artefacts()?,
        eigenimages.artefacts(),
        spheres.artefacts()?,
        errors.artefacts()?,
        rotated.artefacts()?,
        reconstructions.artefacts()?,
        vec![highlights.artefact()?],
        bounds.artefacts()?,
        renderings.artefacts()?,
        selected.artefacts()?,
    ] {
        artefacts.extend(figure.into_iter().map(|artefact| artefact.below(FOLDER)));
    }
    Ok(artefacts)
}
