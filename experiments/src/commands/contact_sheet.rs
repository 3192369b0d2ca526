//! The picture of all presets.

use clap::Args;
use eigenshade::presets::{self, light, material};
use eigenshade::{Display, Meter, Normal, Tone, sphere};
use eigenshade_cli::picture::{Canvas, LETTER, SphereView, write_png};
use eigenshade_model::error::{Error, Result};
use std::path::PathBuf;

/// Spheres side by side.
const COLUMNS: usize = 11;
/// Pixels across a sphere, and across the field with its name.
const SPHERE: usize = 92;
const FIELD: usize = 124;
const BACKGROUND: [u8; 3] = [32; 3];
const TEXT: [u8; 3] = [200; 3];
/// The share of a picture's pixels that its exposure leaves below white.
const UNCLIPPED: f32 = 0.95;

/// All presets, docs/presets.png: the materials in the lobby, then the lights on gold paint
#[derive(Args, Debug)]
pub struct ContactSheet {
    /// The file to write
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
}

impl ContactSheet {
    pub fn run(self) -> Result<()> {
        let materials = material::ALL.map(|(name, material)| (name, light::LOBBY, material));
        let lights = light::ALL.map(|(name, light)| (name, light, material::GOLD_METALLIC_PAINT));
        let rows = [&materials[..], &lights[..]].into_iter().flat_map(|all| all.chunks(COLUMNS));
        let rows: Vec<_> = rows.collect();
        let mut canvas = Canvas::new(FIELD * COLUMNS, FIELD * rows.len(), BACKGROUND);
        for (row, fields) in rows.into_iter().enumerate() {
            for (column, &(name, light, material)) in fields.iter().enumerate() {
                draw(&mut canvas, [FIELD * column, FIELD * row], name, light, material)
                    .map_err(|fault| Error::new(fault.to_string(), "check the presets"))?;
            }
        }
        write_png(&self.out, canvas.width, canvas.height, &canvas.bytes)
    }
}

/// Draws one sphere and its name into the field whose top left corner is given.
fn draw(
    canvas: &mut Canvas,
    [left, top]: [usize; 2],
    name: &str,
    light: presets::Light,
    material: presets::Material,
) -> std::result::Result<(), eigenshade::Error> {
    static DISPLAY: Display = Display::new(Tone::Filmic);
    let scene = sphere::color::scene(light, material)?;
    let view = SphereView::new(SPHERE);
    let mut meter = Meter::default();
    let mut colors = Vec::new();
    for normal in &view.normals {
        let [x, y, z] = normal.map(|component| component as f32);
        let color = scene.shade(Normal::new(x, y, z)?);
        meter.add(color);
        colors.push(color);
    }
    let exposure = meter.exposure(UNCLIPPED).unwrap_or(1.0);
    let margin = (FIELD - SPHERE) / 2;
    for (color, pixel) in colors.into_iter().zip(&view.pixels) {
        let color = DISPLAY.rgb888(color.exposed(exposure)).into();
        canvas.blend(left + margin + pixel.column, top + 4 + pixel.row, color, pixel.coverage);
    }
    for (line, part) in lines(name, FIELD / LETTER).into_iter().enumerate() {
        let indent = (FIELD - LETTER * part.len()) / 2;
        canvas.text(left + indent, top + 8 + SPHERE + (LETTER + 1) * line, 1, TEXT, part);
    }
    Ok(())
}

/// A name in one line, or in two that part at a hyphen.
fn lines(name: &str, most: usize) -> Vec<&str> {
    let place = name.get(..most).and_then(|start| start.rfind('-'));
    match place {
        Some(place) if name.len() > most => vec![&name[..place], &name[place + 1..]],
        _ => vec![name],
    }
}
