//! Fig. 3: the first twelve eigenimages of the image-centered bases, starting with the constant
//! one.

use super::artefact::{Artefact, digits};
use super::plate::Plate;
use super::shape::Shape;
use super::study::{Modes, Study, place};
use eigenshade_model::error::Result;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, fault};
use eigenshade_table::Table;
use eigenshade_table::scene::Criterion;

/// The number of eigenimages shown.
pub const SHOWN: usize = 12;
const COLUMNS: usize = 4;
/// Width of each eigenimage in pixels.
const SIZE: usize = 180;
/// The value at which the colors end; each image has mean square 1.
pub const SCALE: f64 = 3.0;
/// The number of components whose eigenvalues are listed.
const LISTED: usize = 100;

/// The measured properties of the eigenimages.
pub struct Eigenimages {
    /// The shapes of the eigenimages of all modes.
    pub shapes: Vec<Shape>,
    /// For the plate of all modes: the share of the discs beyond the end of the color scale, and
    /// the least distance of such a pixel from the center of its disc, relative to the radius.
    pub beyond: [f64; 2],
    /// Products U_i • U'_i of the eigenimages of all modes with those of the selected ones; 0 where
    /// m differs.
    pub products: Vec<f64>,
    artefacts: Vec<Artefact>,
}

impl Eigenimages {
    /// Draws the plates.
    ///
    /// # Errors
    ///
    /// Never in practice: the bases have enough components.
    pub fn new(study: &Study) -> Result<Self> {
        let tables = Modes::BOTH.map(|modes| &study.tables[place(Criterion::ImageCentered, modes)]);
        let (mut artefacts, mut beyond) = (Vec::new(), Vec::new());
        for (modes, table) in Modes::BOTH.into_iter().zip(tables) {
            let name = format!("eigenimages{}", modes.suffix());
            let (plate, outside) = plate(&name, table)?;
            artefacts.push(plate);
            beyond.push(outside);
            artefacts.push(sheet(&name, table)?);
        }
        let product = |index: usize| {
            let ones = tables.map(|table| table.components.get(index));
            let [Some(a), Some(b)] = ones else { return 0.0 };
            let of = |table: &Table, profile: usize| table.profiles[profile].node_values.clone();
            let values = of(tables[0], a.profile).into_iter().zip(of(tables[1], b.profile));
            let product: f64 = values.map(|(a, b)| a * b).sum();
            if a.order == b.order { product } else { 0.0 }
        };
        Ok(Self {
            shapes: (0..SHOWN).filter_map(|index| Shape::new(tables[0], index)).collect(),
            beyond: beyond[0],
            products: (0..SHOWN).map(product).collect(),
            artefacts,
        })
    }

    /// A plate and a CSV for each choice of modes.
    #[must_use]
    pub fn artefacts(&self) -> Vec<Artefact> {
        self.artefacts.clone()
    }
}

fn sheet(name: &str, table: &Table) -> Result<Artefact> {
    let mut rows = Vec::new();
    for (index, component) in table.components.iter().enumerate().take(LISTED) {
        let share = component.eigenvalue.map(|value| value / table.summary.energy);
        let left = table.energy_left(index + 1) / table.summary.energy;
        let [value, share] =
            [component.eigenvalue, share].map(|value| value.map_or(String::new(), digits));
        let whole = [index.to_string(), component.order.to_string()];
        rows.push(whole.into_iter().chain([value, share, digits(left)]).collect());
    }
    Artefact::csv(format!("{name}.csv"), "component,m,eigenvalue,share,left", &rows)
}

/// The plate, and the part of it beyond the end of the color scale.
fn plate(name: &str, table: &Table) -> Result<(Artefact, [f64; 2])> {
    let owned = OwnedBasis::<f64>::new(table);
    let basis = owned.basis().map_err(fault)?;
    let mut plate = Plate::new(SIZE, (COLUMNS, SHOWN.div_ceil(COLUMNS)), (0, 0, 2));
    let pixels = plate.normals().to_vec();
    let normals = OwnedNormals::<f64>::new(&pixels);
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
    let mut outside = Vec::new();
    for image in &images {
        let far = image.iter().zip(&pixels).filter(|(value, _)| value.abs() > SCALE);
        outside.extend(far.map(|(_, [x, y, _])| x.hypot(*y)));
    }
    let beyond = [
        outside.len() as f64 / (SHOWN * pixels.len()) as f64,
        outside.into_iter().fold(1.0, f64::min),
    ];
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
    let picture = Artefact::picture(format!("{name}.png"), plate.scale(&format!("{SCALE}")));
    Ok((picture, beyond))
}
