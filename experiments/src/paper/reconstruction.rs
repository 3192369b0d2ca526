//! Fig. 7: velvet and leather, their reconstructions and the residuals.

use super::artefact::{Artefact, digits};
use super::highlight::{LISTED, brightest, image};
use super::plate::Plate;
use super::study::{Modes, Study, Trial, place};
use eigenshade_cli::picture::tone::exposure;
use eigenshade_model::error::Result;
use eigenshade_model::truth::Truth;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, fault};
use eigenshade_table::scene::Criterion;

/// Material and light of each image.
pub const SHOWN: [(&str, &str); 2] = [("07-velvet", "forest"), ("05-leather", "studio")];
/// Numbers of components.
const COUNTS: [usize; 6] = [3, 5, 10, 20, 30, 50];
/// Width of each sphere in pixels.
const SIZE: usize = 148;
/// The share of an image's values that its exposure leaves unclipped.
const UNCLIPPED: f64 = 0.98;
/// The colors of the residual end at this share of the image's largest value.
const RESIDUAL: f64 = 0.1;

/// The reconstructions of one image with 0, 1, .. components.
pub struct Course {
    /// Material and light.
    pub names: [&'static str; 2],
    /// The modes of the basis.
    pub modes: Modes,
    /// The error, by number of components.
    pub errors: Vec<f64>,
    /// The reconstruction at the brightest pixel of the reference, relative to the reference there,
    /// by number of components.
    pub brightest: Vec<f64>,
}

/// Velvet and leather, for each choice of modes.
pub struct Reconstructions {
    /// The images in the order of the plates.
    pub courses: Vec<Course>,
    plates: Vec<Artefact>,
}

impl Reconstructions {
    /// Computes and draws the reconstructions.
    ///
    /// # Errors
    ///
    /// Never in practice: the shipped data contain both images.
    pub fn new(study: &Study, trials: &[Trial]) -> Result<Self> {
        let (mut courses, mut plates) = (Vec::new(), Vec::new());
        for modes in Modes::BOTH {
            plates.push(plate(study, trials, modes, &mut courses)?);
        }
        Ok(Self { courses, plates })
    }

    /// The plates and the CSV file.
    pub fn artefacts(&self) -> Result<Vec<Artefact>> {
        let mut rows = Vec::new();
        for course in &self.courses {
            let [material, light] = course.names;
            for (count, both) in course.errors.iter().zip(&course.brightest).enumerate() {
                let names = [course.modes.count().to_string(), light.into(), material.into()];
                let numbers = [count.to_string(), digits(*both.0), digits(*both.1)];
                rows.push(names.into_iter().chain(numbers).collect());
            }
        }
        let header = "modes,light,material,components,error,brightest";
        let mut artefacts = self.plates.clone();
        artefacts.push(Artefact::csv("reconstruction.csv", header, &rows)?);
        Ok(artefacts)
    }
}

fn plate(
    study: &Study,
    trials: &[Trial],
    modes: Modes,
    courses: &mut Vec<Course>,
) -> Result<Artefact> {
    let table = &study.tables[place(Criterion::ImageCentered, modes)];
    let owned = OwnedBasis::<f64>::new(table);
    let basis = owned.basis().map_err(fault)?;
    let mut plate = Plate::new(SIZE, (COUNTS.len() + 1, 2 * SHOWN.len()), (2, 0, 1));
    let normals = plate.normals().to_vec();
    let shaded = OwnedNormals::<f64>::new(&normals);
    let truth = Truth::new(study.lights.degree, study.materials.order);
    for (pair, (material, light)) in SHOWN.into_iter().enumerate() {
        let trial = study.trial(trials, light, material)?;
        let image = image(study, trial, &truth, &normals);
        let peak = image.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        let scale = exposure(image.clone(), UNCLIPPED);
        let shown =
            |image: &[f64]| image.iter().map(|value| [scale * value; 3]).collect::<Vec<_>>();
        plate.light(0, 2 * pair, &shown(&image));
        plate.below(0, 2 * pair, 0, &super::spheres::title(material));
        let fit = &trial.fits[place(Criterion::ImageCentered, modes)];
        courses.push(Course {
            names: [material, light],
            modes,
            errors: fit.variances.iter().take(LISTED + 1).map(|v| v / trial.variance).collect(),
            brightest: brightest(&basis, &fit.coefficients, &image, &normals)?,
        });
        for (column, count) in (1..).zip(COUNTS) {
            let mut scene = vec![0.0; basis.scene_len()];
            let coefficients = &fit.coefficients[..count];
            let scene = basis.collapse_into(coefficients, &mut scene).map_err(fault)?;
            let mut ours = vec![0.0; normals.len()];
            scene.shade_slice(shaded.view()?, &mut ours).map_err(fault)?;
            plate.light(column, 2 * pair, &shown(&ours));
            let residual = image.iter().zip(&ours);
            let residual: Vec<f64> =
                residual.map(|(truth, ours)| (truth - ours) / (RESIDUAL * peak)).collect();
            plate.signed(column, 2 * pair + 1, &residual);
            let left = 100.0 * fit.variances[count] / trial.variance;
            plate.below(column, 2 * pair + 1, 0, &format!("{left:.1} %"));
        }
    }
    plate.above(0, "truth");
    for (column, count) in (1..).zip(COUNTS) {
        plate.above(column, &format!("K = {count}"));
    }
    let name = format!("reconstruction{}.png", modes.suffix());
    Ok(Artefact::picture(name, plate.scale(&format!("{RESIDUAL} of the peak"))))
}
