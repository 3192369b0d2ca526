//! Errors and pictures of small sources; the gloss and the total errors of the shipped materials.

use super::{inputs, write, write_csv};
use eigenshade_cli::messages::{print_message, progress_bar};
use eigenshade_cli::picture::{Canvas, SphereView};
use eigenshade_model::error::Result;
use eigenshade_model::inputs::gloss_csv::write_glosses;
use eigenshade_model::srgb::srgb;
use eigenshade_shading::picture::write_png;
use eigenshade_shading::sources::screen::{self, Reference};
use report::highlights::{self, DRAWN, Row};
use report::material_errors::{self, SPACING};
use report::sphere::Sphere;
use std::path::Path;

pub fn gloss(out: Option<&Path>) -> Result<()> {
    let glosses = highlights::glosses(&[])?;
    write(out, |out| write_glosses(&glosses, out))
}

pub fn material_errors(out: Option<&Path>) -> Result<()> {
    let found = material_errors::errors(inputs(), &[], SPACING, &progress_bar("materials", 0))?;
    write_csv(out, material_errors::COLUMNS, material_errors::rows(&found))
}

pub fn errors(out: Option<&Path>) -> Result<()> {
    let rows = highlights::errors(inputs(), &[], &progress_bar("lights", 0))?;
    write_csv(out, highlights::COLUMNS, rows.iter().map(Row::fields))
}

/// Width of a sphere and of the gap beside it, in pixels.
const SIZE: usize = 112;
const GAP: usize = 8;
const BACKGROUND: [u8; 3] = [32; 3];
const LIGHTS: [&str; 3] = ["studio", "sunset", "night"];
const MATERIALS: [&str; 3] = ["gold-metallic-paint", "blue-metallic-paint", "yellow-phenolic"];

pub fn picture(out: &Path) -> Result<()> {
    let view = SphereView::new(SIZE);
    let sphere = Sphere::of_normals(&view.normals);
    let across = |count: usize| GAP + count * (SIZE + GAP);
    let columns = DRAWN.len() * MATERIALS.len();
    let mut canvas = Canvas::new(across(columns), across(LIGHTS.len()), BACKGROUND);
    for k in 0..LIGHTS.len() * MATERIALS.len() {
        let (row, group) = (k / MATERIALS.len(), k % MATERIALS.len());
        let (light, material) = (LIGHTS[row], MATERIALS[group]);
        let pictures = highlights::spheres(inputs(), light, material, &view.normals)?;
        let Some(reference) = pictures.last().cloned() else { continue };
        let exposure = f64::from(screen::exposure(&reference, &sphere).factor());
        let reference = Reference::new(reference, &sphere);
        for (column, (picture, drawn)) in pictures.iter().zip(DRAWN).enumerate() {
            if let Some(((degree, order), sources)) = drawn {
                let error = reference.errors(picture, &sphere).all;
                print_message(format_args!(
                    "{light}, {material}, {degree}/{order} + {sources}: CIEDE2000 {:.1} in the \
                     mean, {:.1} for 95 of 100 pixels",
                    error.mean, error.p95
                ));
            }
            for (k, pixel) in view.pixels.iter().enumerate() {
                let color = [0, 1, 2].map(|c: usize| srgb(exposure * picture[c][k]));
                let left = across(DRAWN.len() * group + column);
                canvas.blend(left + pixel.column, across(row) + pixel.row, color, pixel.coverage);
            }
        }
    }
    write_png(out, canvas.width, canvas.height, &canvas.bytes)
}
