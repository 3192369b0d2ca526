//! Fig. 3: the first twelve eigenimages of the image-centred bases, the constant first.

use super::artefact::{Artefact, digits};
use super::plate::Plate;
use super::study::{Modes, Study, place};
use crate::owned_basis::OwnedBasis;
use crate::shader::{OwnedNormals, fault};
use eigenshade_generator::error::Result;
use eigenshade_table::Table;
use eigenshade_table::scene::Criterion;

/// How many are shown.
const SHOWN: usize = 12;
const COLUMNS: usize = 4;
/// Pixels across each.
const SIZE: usize = 180;
/// The colours end at this value; an image whose square is 1 on average exceeds it in a
/// thin ring at the rim alone.
const SCALE: f64 = 3.0;
/// Components whose eigenvalues are listed.
const LISTED: usize = 100;

/// A plate and a CSV for each choice of modes.
pub fn artefacts(study: &Study) -> Result<Vec<Artefact>> {
    let mut artefacts = Vec::new();
    for modes in Modes::BOTH {
        let table = &study.tables[place(Criterion::ImageCentered, modes)];
        let name = format!("eigenimages{}", modes.suffix());
        artefacts.push(plate(&name, table)?);
        let mut rows = Vec::new();
        for (index, component) in table.components.iter().enumerate().take(LISTED) {
            let share = component.eigenvalue.map(|value| value / table.summary.energy);
            let left = table.energy_left(index + 1) / table.summary.energy;
            let [value, share] =
                [component.eigenvalue, share].map(|value| value.map_or(String::new(), digits));
            let whole = [index.to_string(), component.order.to_string()];
            rows.push(whole.into_iter().chain([value, share, digits(left)]).collect());
        }
        let header = "component,m,eigenvalue,share,left";
        artefacts.push(Artefact::csv(format!("{name}.csv"), header, &rows)?);
    }
    Ok(artefacts)
}

fn plate(name: &str, table: &Table) -> Result<Artefact> {
    let owned = OwnedBasis::<f64>::new(table);
    let basis = owned.basis().map_err(fault)?;
    let mut plate = Plate::new(SIZE, (COLUMNS, SHOWN.div_ceil(COLUMNS)), (0, 0, 2));
    let normals = OwnedNormals::<f64>::new(plate.normals());
    let mut images = Vec::new();
    for index in 0..SHOWN {
        let mut coefficients = vec![0.0; index + 1];
        coefficients[index] = 1.0;
        let mut scene = vec![0.0; basis.scene_len()];
        let scene = basis.collapse_into(&coefficients, &mut scene).map_err(fault)?;
        let normals = normals.view()?;
        let mut image = vec![0.0; normals.len()];
        scene.shade_slice(normals, &mut image).map_err(fault)?;
        images.push(image);
    }
    for (index, (image, component)) in images.iter().zip(&table.components).enumerate() {
        let (column, row) = (index % COLUMNS, index / COLUMNS);
        let image: Vec<f64> = image.iter().map(|value| value / SCALE).collect();
        plate.signed(column, row, &image);
        let share = component.eigenvalue.map(|value| 100.0 * value / table.summary.energy);
        let words = match share {
            None => "constant".into(),
            Some(share) => format!("{share:.1} %"),
        };
        plate.below(column, row, 0, &format!("{index}: m = {}", component.order));
        plate.below(column, row, 1, &words);
    }
    Ok(Artefact::picture(format!("{name}.png"), plate.scale(&format!("{SCALE}"))))
}
