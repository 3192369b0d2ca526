//! Errors and pictures of small sources, and the gloss of the shipped materials.

use super::{inputs, write_command_line};
use clap::Args;
use eigenshade_cli::messages::{print_message, progress_bar};
use eigenshade_cli::output;
use eigenshade_cli::picture::{Canvas, SphereView, write_png};
use eigenshade_model::error::Result;
use eigenshade_model::inputs::gloss_csv::write_glosses;
use eigenshade_model::inputs::set_error_csv::write_set_errors;
use eigenshade_model::srgb::srgb;
use experiments::highlights::{self, DRAWN};
use experiments::numbers::{exposure, percent};
use experiments::pages::filled;
use std::path::{Path, PathBuf};

pub fn gloss(out: Option<&Path>) -> Result<()> {
    let glosses = highlights::glosses(&[])?;
    output::write(out, |out| {
        write_command_line(out)?;
        write_glosses(&glosses, out)
    })
}

pub fn source_errors(out: Option<&Path>) -> Result<()> {
    let errors = highlights::remaining(inputs(), &[], &progress_bar("lights", 0))?;
    output::write(out, |out| {
        write_command_line(out)?;
        write_set_errors(&errors, out)
    })
}

/// Errors of pictures with small sources, docs/highlights.csv and the tables of docs/highlights.md
///
/// The pictures are of GGX metals under the captured lights as they are and turned, and under three
/// synthetic ones. The reference is direct integration of the whole map. Takes some five minutes on
/// two cores.
#[derive(Args, Debug)]
pub struct Highlights {
    /// Write the CSV to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Write the tables into this page
    #[arg(long, value_name = "FILE")]
    page: Option<PathBuf>,
}

impl Highlights {
    pub fn run(self) -> Result<()> {
        let rows = highlights::errors(inputs(), &[], &progress_bar("lights", 0))?;
        output::write(self.out.as_deref(), |out| {
            write_command_line(out)?;
            highlights::write(&rows, out)
        })?;
        match &self.page {
            Some(page) => {
                let text = filled(page, &highlights::parts(&rows))?;
                output::write_all(Some(page), text)
            }
            None => Ok(()),
        }
    }
}

/// Width of a sphere and of the gap beside it, in pixels.
const SIZE: usize = 112;
const GAP: usize = 8;
const BACKGROUND: [u8; 3] = [32; 3];
/// The share of the reference's values that its exposure leaves unclipped.
const UNCLIPPED: f64 = 0.995;

const LIGHTS: [&str; 3] = ["studio", "sunset", "night"];
const MATERIALS: [&str; 3] = ["gold-metallic-paint", "blue-metallic-paint", "yellow-phenolic"];

pub fn picture(out: &Path) -> Result<()> {
    let view = SphereView::new(SIZE);
    let across = |count: usize| GAP + count * (SIZE + GAP);
    let columns = DRAWN.len() * MATERIALS.len();
    let mut canvas = Canvas::new(across(columns), across(LIGHTS.len()), BACKGROUND);
    let materials = || MATERIALS.into_iter().enumerate();
    let pairs =
        LIGHTS.into_iter().enumerate().flat_map(|light| materials().map(move |m| (light, m)));
    for ((row, light), (group, material)) in pairs {
        let pictures = highlights::spheres(inputs(), light, material, &view.normals)?;
        let reference = pictures.last().into_iter().flatten().flatten().copied().collect();
        let exposure = exposure(reference, UNCLIPPED);
        for (column, (picture, drawn)) in pictures.iter().zip(DRAWN).enumerate() {
            if let (Some(reference), Some(((degree, order), sources))) = (pictures.last(), drawn) {
                let [rms, worst] = highlights::errors_of(&view.normals, picture, reference);
                print_message(format_args!(
                    "{light}, {material}, {degree}/{order} + {sources}: {} rms, {} worst",
                    percent(rms, 2),
                    percent(worst, 2)
                ));
            }
            for (k, pixel) in view.pixels.iter().enumerate() {
                let color = [0, 1, 2].map(|c: usize| srgb(exposure * picture[c][k]));
                let column = DRAWN.len() * group + column;
                let (x, y) = (across(column) + pixel.column, across(row) + pixel.row);
                canvas.blend(x, y, color, pixel.coverage);
            }
        }
    }
    write_png(out, canvas.width, canvas.height, &canvas.bytes)
}
