//! The picture of the demo: a row for each light, with the relief and the spheres.

use eigenshade::{Display, Meter, Rgb, Tone};
use eigenshade_cli::object::ObjectView;
use eigenshade_cli::picture::{Canvas, TextHeight, text_width, write_png};
use eigenshade_model::error::Result;
use std::path::Path;

/// The share of a row's pixels that its exposure leaves unclipped.
const UNCLIPPED: f32 = 0.98;

const BACKGROUND: [u8; 3] = [24, 25, 28];
const BRIGHT: [u8; 3] = [226, 226, 222];
const DIM: [u8; 3] = [138, 140, 146];

/// One column: an object of one material.
pub struct Column<'a> {
    pub title: String,
    pub view: &'a ObjectView,
}

/// One row: r, g and b of the pixels of each column's object under one light.
pub struct Row {
    pub title: String,
    pub images: Vec<[Vec<f32>; 3]>,
}

/// Draws the rows, each with its own exposure.
pub fn draw(path: &Path, columns: &[Column<'_>], rows: &[Row]) -> Result<()> {
    let size = columns.first().map_or(0, |column| column.view.width);
    let text = text_height(size);
    let (gap, line) = (size / 12, text.val());
    let beside = rows.iter().map(|row| text_width(text, &row.title)).max().unwrap_or(0);
    let (left, top) = (beside + 3 * line, 3 * line);
    let step = size + gap;
    let (width, height) = (left + columns.len() * step, top + rows.len() * step);
    let mut canvas = Canvas::new(width + line, height + line, BACKGROUND);
    for (place, column) in columns.iter().enumerate() {
        let middle = left + place * step + size / 2;
        canvas.centered_text((middle, top - 2 * line), text, BRIGHT, &column.title);
    }
    let display = Display::new(Tone::Filmic);
    for (place, row) in rows.iter().enumerate() {
        let top = top + place * step;
        canvas.text((3 * line / 2, top + (size - line) / 2), text, DIM, &row.title);
        let colors = |image: &[Vec<f32>; 3]| -> Vec<Rgb<f32>> {
            let [r, g, b] = image;
            r.iter().zip(g).zip(b).map(|((&r, &g), &b)| Rgb { r, g, b }).collect()
        };
        let images: Vec<Vec<Rgb<f32>>> = row.images.iter().map(colors).collect();
        let mut meter = Meter::default();
        images.iter().flatten().for_each(|&color| meter.add(color));
        let exposure = meter.exposure(UNCLIPPED).unwrap_or_default();
        for (place, (column, image)) in columns.iter().zip(images).enumerate() {
            let left = left + place * step;
            for (pixel, color) in column.view.pixels.iter().zip(image) {
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
pub fn title(name: &str) -> String {
    let title = name.trim_start_matches(|letter: char| letter.is_ascii_digit() || letter == '-');
    let title = if title.is_empty() { name } else { title };
    title.replace('-', " ")
}
