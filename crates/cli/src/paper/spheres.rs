//! Fig. 4: rendered spheres, by all modes and by the selected ones.

use super::artefact::Artefact;
use super::plate::Plate;
use super::study::{Modes, Study, place};
use crate::owned_basis::OwnedBasis;
use crate::shader::{OwnedNormals, Shader, fault};
use crate::tone::exposure;
use crate::truth_image;
use eigenshade_generator::database::{Lights, Materials};
use eigenshade_generator::error::Result;
use eigenshade_table::scene::Criterion;
use indicatif::ProgressBar;

/// Material and light of each, as near to the paper's as the shipped lights come.
pub const SHOWN: [(&str, &str); 3] =
    [("07-velvet", "forest"), ("05-leather", "studio"), ("55-orange-peel", "blender-sunset")];
/// Pixels across each.
const SIZE: usize = 288;
/// The share of an image's values that its exposure leaves unclipped.
const UNCLIPPED: f64 = 0.98;

/// One plate: a row by the direct sum of all modes, one of the selected modes.
pub fn artefacts(study: &Study, progress: &ProgressBar) -> Result<Vec<Artefact>> {
    let table = &study.tables[place(Criterion::ImageCentered, Modes::Selected)];
    let owned = OwnedBasis::<f64>::new(table);
    // All of its components span whatever the selected modes give.
    let mut shader = Shader::new(owned.basis().map_err(fault)?, usize::MAX);
    let mut plate = Plate::new(SIZE, (SHOWN.len(), 2), (0, 6, 2));
    let normals = plate.normals().to_vec();
    let shaded = OwnedNormals::<f64>::new(&normals);
    for (column, (material, light)) in SHOWN.into_iter().enumerate() {
        let (light, material) = (study.light(light)?, study.material(material)?);
        let lights = Lights { entries: vec![light.clone()], ..study.lights };
        let materials = Materials { entries: vec![material.clone()], ..study.materials };
        let truth = truth_image::images(&lights, &materials, &normals, progress);
        let truth: Vec<[f64; 3]> = truth.iter().map(|of_pairs| of_pairs[0]).collect();
        let selected = shader.colour(
            (study.lights.degree, light),
            (study.materials.order, material),
            &shaded,
        )?;
        let selected: Vec<[f64; 3]> =
            (0..normals.len()).map(|k| selected.each_ref().map(|channel| channel[k])).collect();
        let scale = exposure(truth.iter().flatten().copied().collect(), UNCLIPPED);
        for (row, image) in [truth, selected].iter().enumerate() {
            let image: Vec<[f64; 3]> =
                image.iter().map(|rgb| rgb.map(|value| scale * value)).collect();
            plate.light(column, row, &image);
            plate.below(column, row, 0, &title(&material.name));
            plate.below(column, row, 1, &light.name);
        }
    }
    plate.beside(0, &["3,704", "modes"]);
    plate.beside(1, &["1,000", "modes"]);
    Ok(vec![Artefact::picture("spheres.png", plate.finish())])
}

/// A material's name as a person would write it: without number and hyphens.
#[must_use]
pub fn title(name: &str) -> String {
    name.trim_start_matches(|letter: char| letter.is_ascii_digit() || letter == '-')
        .replace('-', " ")
}
