//! `eigenshade demo`: draws the shipped materials under the shipped lights.

use super::demo_relief;
use super::options::{TableChoice, count};
use clap::Args;
use eigenshade::Rgb;
use eigenshade::screen::{Display, Meter, Tone};
use eigenshade_cli::messages::print_message;
use eigenshade_cli::object::ObjectView;
use eigenshade_cli::output;
use eigenshade_cli::picture::{Canvas, TextHeight, text_width};
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::output::writable;
use eigenshade_model::shipped;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::picture::write_png;
use eigenshade_shading::shader::{OwnedNormals, Shader, fault, fitted};
use serde::Serialize;
use std::fs;
use std::path::{Path, PathBuf};

/// Draw a relief and spheres of measured materials under captured lights
///
/// Writes demo.png, computed in f32.
#[derive(Args, Debug)]
pub struct Demo {
    #[command(flatten)]
    table: TableChoice,
    /// Folder for the picture; created if needed
    #[arg(short, long, value_name = "DIR")]
    out: PathBuf,
    /// Pixels across each object, 16 to 512
    #[arg(short, long, value_name = "N", default_value = "160", value_parser = count(16, 512))]
    size: usize,
    /// Print the name of the picture as a JSON object
    #[arg(long)]
    json: bool,
}

#[derive(Serialize)]
struct Answer {
    files: [String; 1],
}

impl Demo {
    pub fn run(self) -> Result<()> {
        fs::create_dir_all(&self.out).map_err(|error| Error::io(&self.out, &error))?;
        let file = self.out.join("demo.png");
        writable(&file)?;
        let table = self.table.read()?;
        let (lights, materials) = shown()?;
        let (lights, materials) = fitted(&table, &lights, &materials);
        let basis = OwnedBasis::new(&table)?;
        let components = table.count();
        let mut shader = Shader::new(basis.basis().map_err(fault)?, components)
            .with_transfers(basis.transfers());
        let (relief, sphere) = (demo_relief::view(self.size), ObjectView::sphere(self.size));
        // The most metallic material, which is the last, is also that of the relief.
        let metal = materials.entries.last().map(|material| (material, &relief));
        let spheres = materials.entries.iter().map(|material| (material, &sphere));
        let columns: Vec<(&Named, &ObjectView)> = metal.into_iter().chain(spheres).collect();
        let mut rows = Vec::new();
        for light in &lights.entries {
            let mut images: Vec<Vec<Rgb<f32>>> = Vec::new();
            for (material, view) in &columns {
                let normals = OwnedNormals::new(&view.normals);
                let [r, g, b] = shader.color(light, material, &normals)?;
                let colors = r.into_iter().zip(g).zip(b).map(|((r, g), b)| Rgb { r, g, b });
                images.push(colors.collect());
            }
            rows.push((light, images));
        }
        draw(&file, &columns, &rows)?;
        let file = file.display().to_string();
        if self.json {
            return output::write_json(None, &Answer { files: [file] });
        }
        print_message(file);
        Ok(())
    }
}

/// The shipped lights and materials of the picture.
fn shown() -> Result<(Lights, Materials)> {
    let lights = shipped::lights()?;
    let materials = shipped::named_materials(7)?;
    let entries = chosen(lights.entries, &shipped::SHOWN_LIGHTS)?;
    let lights = Lights { degree: lights.degree, entries };
    let entries = chosen(materials.entries, &shipped::SHOWN_MATERIALS)?;
    Ok((lights, Materials { order: materials.order, entries }))
}

fn chosen(entries: Vec<Named>, names: &[&str]) -> Result<Vec<Named>> {
    let find = |name: &&str| entries.iter().find(|entry| entry.name == **name).cloned();
    let missing = |name: &&str| {
        Error::new(format!("the shipped data have no `{name}`"), "build the program again")
    };
    names.iter().map(|name| find(name).ok_or_else(|| missing(name))).collect()
}

const BACKGROUND: [u8; 3] = [24, 25, 28];
const BRIGHT: [u8; 3] = [226, 226, 222];
const DIM: [u8; 3] = [138, 140, 146];

/// The pixels of each column's object under one light.
type Row<'a> = (&'a Named, Vec<Vec<Rgb<f32>>>);

/// Draws the rows, each with its own exposure.
fn draw(path: &Path, columns: &[(&Named, &ObjectView)], rows: &[Row<'_>]) -> Result<()> {
    let size = columns.first().map_or(0, |(_, view)| view.width);
    let text = text_height(size);
    let (gap, line) = (size / 12, text.val());
    let beside = rows.iter().map(|(light, _)| text_width(text, &title(light))).max().unwrap_or(0);
    let (left, top) = (beside + 3 * line, 3 * line);
    let step = size + gap;
    let (width, height) = (left + columns.len() * step, top + rows.len() * step);
    let mut canvas = Canvas::new(width + line, height + line, BACKGROUND);
    for (place, (material, _)) in columns.iter().enumerate() {
        let middle = left + place * step + size / 2;
        canvas.centered_text((middle, top - 2 * line), text, BRIGHT, &title(material));
    }
    let display = Display::new(Tone::Filmic);
    for (place, (light, images)) in rows.iter().enumerate() {
        let top = top + place * step;
        canvas.text((3 * line / 2, top + (size - line) / 2), text, DIM, &title(light));
        let mut meter = Meter::default();
        images.iter().flatten().for_each(|&color| meter.add(color));
        let exposure = meter.exposure().unwrap_or_default();
        for (place, ((_, view), image)) in columns.iter().zip(images).enumerate() {
            let left = left + place * step;
            for (pixel, &color) in view.pixels.iter().zip(image) {
                let color = display.rgb888(exposure.of(color)).into();
                canvas.blend(left + pixel.column, top + pixel.row, color, pixel.coverage);
            }
        }
    }
    write_png(path, canvas.width, canvas.height, &canvas.bytes)
}

/// The text that fits under objects of this many pixels.
fn text_height(size: usize) -> TextHeight {
    match size {
        0..224 => TextHeight::Size16,
        224..288 => TextHeight::Size20,
        288..384 => TextHeight::Size24,
        _ => TextHeight::Size32,
    }
}

/// A name without its leading number, with blanks for its hyphens.
fn title(Named { name, .. }: &Named) -> String {
    let title = name.trim_start_matches(|letter: char| letter.is_ascii_digit() || letter == '-');
    let title = if title.is_empty() { name.as_str() } else { title };
    title.replace('-', " ")
}
