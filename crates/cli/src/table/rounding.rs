//! The error that a number format adds to a table's images, measured when the table is made.

use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::error::Result;
use eigenshade_model::evaluation::Evaluator;
use eigenshade_model::overflow;
use eigenshade_model::sphere_rings::{Ring, rings};
use eigenshade_shading::integer_shader::{self, IntegerShader};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader, fault, fitted};
use eigenshade_table::wire::NumberFormat;
use eigenshade_table::{Rounding, Table};

/// Approximate limit on the products of a measurement: for larger tables, only a sample of the
/// images is measured.
const PRODUCTS: usize = 1 << 30;

/// The least number of images to measure, if the database has as many.
const LEAST: usize = 40;

/// Spacing of the normals in radians.
const SPACING: f64 = 0.2;

/// The largest error of a pixel, as a share of the peak, that causes no warning.
const UNSEEN: f64 = 1e-3;

/// The error of each of these formats that suits the table, over the images of a database in green:
/// the table's own, where it is made.
#[must_use]
pub fn measure(
    table: &Table,
    lights: &Lights,
    materials: &Materials,
    formats: &[NumberFormat],
) -> Vec<Rounding> {
    let (lights, materials) = fitted(table, lights, materials);
    let normals: Vec<[f64; 3]> = rings(SPACING).iter().flat_map(Ring::normals).collect();
    let pairs = lights.entries.len() * materials.entries.len();
    let numbers: usize = table.profiles.iter().map(|profile| profile.factors.len()).sum();
    let count = (PRODUCTS / (8 * numbers).max(1 << 16)).clamp(LEAST.min(pairs), pairs);
    // Spread evenly over the pairs, so that all lights and materials occur.
    let chosen: Vec<[Vec<f64>; 2]> = (0..count)
        .map(|k| k * pairs / count)
        .map(|pair| {
            let (light, material) =
                (pair / materials.entries.len(), pair % materials.entries.len());
            [lights.entries[light].rgb[1].clone(), materials.entries[material].rgb[1].clone()]
        })
        .collect();
    // Images outside the range of a format are skipped.
    let Ok(exact) = exact(table, &chosen, &normals) else {
        return Vec::new();
    };
    let mut roundings = Vec::new();
    for &format in formats {
        let images = match format {
            NumberFormat::F32 => floats(table, &chosen, &normals).ok(),
            NumberFormat::Q15 => integers(table, &chosen, &normals),
        };
        let Some(images) = images else { continue };
        let mut rounding = Rounding { format, largest: 0.0, rms: 0.0 };
        for (found, exact) in images.iter().zip(&exact) {
            let peak = exact.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
            if peak == 0.0 {
                continue;
            }
            let off: Vec<f64> =
                found.iter().zip(exact).map(|(a, b)| (a - b).abs() / peak).collect();
            let square: f64 = off.iter().map(|off| off * off).sum();
            rounding.largest = off.iter().copied().fold(rounding.largest, f64::max);
            rounding.rms = rounding.rms.max((square / off.len() as f64).sqrt());
        }
        roundings.push(rounding);
    }
    roundings
}

/// A warning if a format causes a visible error in a table's images.
#[must_use]
pub fn warning(table: &Table, format: NumberFormat) -> Option<String> {
    let Rounding { largest, rms, .. } = table.rounding(format)?;
    (*largest > UNSEEN).then(|| {
        let remedy = match format {
            NumberFormat::F32 => "make another table",
            NumberFormat::Q15 => "use f32, or another table",
        };
        format!(
            "warning: rounding to {} costs up to {largest:.1e} of an image's peak (rms {rms:.1e}) \
             over the table's database; {remedy}",
            format.name()
        )
    })
}

type Images = Vec<Vec<f64>>;

fn exact(table: &Table, pairs: &[[Vec<f64>; 2]], normals: &[[f64; 3]]) -> Result<Images> {
    let evaluator = Evaluator::new(table);
    let eigenimages = evaluator.eigenimages(normals);
    let image = |[light, material]: &[Vec<f64>; 2]| {
        let image = eigenimages.reconstruct(&evaluator.project(light, material)?);
        overflow::checked(image, light, material)
    };
    pairs.iter().map(image).collect()
}

fn floats(table: &Table, pairs: &[[Vec<f64>; 2]], normals: &[[f64; 3]]) -> Result<Images> {
    let basis = OwnedBasis::new(table)?;
    let any = basis.basis().map_err(fault)?;
    let mut shader = Shader::new(any, usize::MAX).with_transfers(basis.transfers());
    let normals = OwnedNormals::new(normals);
    let image = |[light, material]: &[Vec<f64>; 2]| {
        let image = shader.polynomial(light, material, &normals)?;
        Ok(image.into_iter().map(Into::into).collect())
    };
    pairs.iter().map(image).collect()
}

/// `None` if integers do not suit the table.
fn integers(table: &Table, pairs: &[[Vec<f64>; 2]], normals: &[[f64; 3]]) -> Option<Images> {
    let mut shader = IntegerShader::new(table, usize::MAX).ok()?;
    let normals = integer_shader::normals(normals).ok()?;
    let image =
        |[light, material]: &[Vec<f64>; 2]| shader.polynomial(light, material, &normals).ok();
    pairs.iter().map(image).collect()
}
