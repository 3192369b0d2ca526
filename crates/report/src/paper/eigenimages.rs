//! Fig. 3: the first twelve eigenimages of the image-centered basis of all modes, from the constant one on.

use super::plate::Plate;
use super::{Modes, Study, csv, digits, place, row};
use crate::figures::OutputFile;
use eigenshade_model::error::Result;
use eigenshade_model::evaluation::Evaluator;
use eigenshade_table::Table;
use eigenshade_table::scene::Criterion;

pub const SHOWN: usize = 12;
const COLUMNS: usize = 4;
/// Width of each eigenimage in pixels.
const SIZE: usize = 180;
/// The value at which the colors end; each image has mean square 1.
pub const SCALE: f64 = 3.0;
/// The number of components whose eigenvalues are listed.
const LISTED: usize = 100;

pub fn files(study: &Study) -> Result<Vec<OutputFile>> {
    let table = &study.tables[place(Criterion::ImageCentered, Modes::All)];
    Ok(vec![plate(table)?, sheet(table)?])
}

fn sheet(table: &Table) -> Result<OutputFile> {
    let mut rows = Vec::new();
    for (index, component) in table.components.iter().enumerate().take(LISTED) {
        // The constant has no eigenvalue.
        let value = component.eigenvalue.map_or(String::new(), digits);
        let share = component.eigenvalue.map(|value| digits(value / table.summary.energy));
        let left = table.energy_left(index + 1) / table.summary.energy;
        let texts = row(&[&index, &component.order, &value, &share.unwrap_or_default()], [left]);
        rows.push(texts);
    }
    csv("eigenimages.csv", "component,m,eigenvalue,share,left", &rows)
}

fn plate(table: &Table) -> Result<OutputFile> {
    let mut plate = Plate::new(SIZE, (COLUMNS, SHOWN.div_ceil(COLUMNS)), [0, 0, 2]);
    let evaluator = Evaluator::new(table).with_components(SHOWN);
    let eigenimages = evaluator.eigenimages(&plate.view.normals);
    for (index, component) in table.components.iter().enumerate().take(SHOWN) {
        let image = eigenimages.eigenimage(index);
        let place = (index % COLUMNS, index / COLUMNS);
        plate.signed(place, image.iter().map(|value| value / SCALE));
        let share = component.eigenvalue.map(|value| 100.0 * value / table.summary.energy);
        let share = share.map_or("constant".into(), |share| format!("{share:.1} %"));
        plate.below(place, &[&format!("{index}: m = {}", component.order), &share]);
    }
    Ok(OutputFile::picture("eigenimages.png", plate.scale(&format!("{SCALE}"))))
}
