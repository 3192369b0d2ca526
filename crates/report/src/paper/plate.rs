//! Plates of spheres: pictures in rows and columns, with text.

use eigenshade_cli::picture::{Canvas, SphereView, TextHeight, text_width};
use eigenshade_model::srgb::srgb;

const PAPER: [u8; 3] = [212, 214, 217];
const INK: [u8; 3] = [40, 42, 46];
/// Color of the edge of a signed image, which may be as pale as the background.
const EDGE: [u8; 3] = [120, 122, 126];
const TEXT: TextHeight = TextHeight::Size24;
/// Pixels from one line of text to the next.
const LINE: usize = TEXT.val();
/// Height of the color scale.
const BAR: usize = 16;
/// Pixels between a sphere and text.
const PADDING: usize = 6;
/// The share of an image's values that its exposure leaves unclipped.
pub const UNCLIPPED: f64 = 0.98;

/// A column and a row, or their numbers.
type Place = (usize, usize);

/// A plate whose gray differs from the brightest value of an image and the zero of a signed one.
pub struct Plate {
    canvas: Canvas,
    pub view: SphereView,
    left: usize,
    top: usize,
    step: (usize, usize),
}

impl Plate {
    /// A plate for this many columns and rows of spheres of `size` pixels, with `lines` lines of
    /// text below each row, `above` lines before the first row and `beside` letters at the left.
    pub fn new(size: usize, (columns, rows): Place, [above, beside, lines]: [usize; 3]) -> Self {
        let gap = size / 10;
        let left = gap + beside * text_width(TEXT, " ");
        let top = gap + above * LINE;
        let step = (size + gap, size + lines * LINE + gap);
        let canvas = Canvas::new(left + columns * step.0, top + rows * step.1, PAPER);
        Self { canvas, view: SphereView::new(size), left, top, step }
    }

    fn place(&self, (column, row): Place) -> Place {
        (self.left + column * self.step.0, self.top + row * self.step.1)
    }

    /// Draws an image of light; `exposure` times a value of 1 / `exposure` is white.
    pub fn light(&mut self, at: Place, exposure: f64, image: impl Iterator<Item = [f64; 3]>) {
        let (left, top) = self.place(at);
        for (pixel, rgb) in self.view.pixels.iter().zip(image) {
            let color = rgb.map(|value| srgb(exposure * value));
            self.canvas.blend(left + pixel.column, top + pixel.row, color, pixel.coverage);
        }
    }

    /// Draws a signed image: -1 is blue, 0 white, 1 red.
    pub fn signed(&mut self, at: Place, image: impl IntoIterator<Item = f64>) {
        let (left, top) = self.place(at);
        let radius = 0.5 * self.view.size as f64 - 0.5;
        for (pixel, value) in self.view.pixels.iter().zip(image) {
            let (x, y) = (left + pixel.column, top + pixel.row);
            self.canvas.blend(x, y, diverging(value), pixel.coverage);
            let offset = |k: usize| k as f64 - radius;
            let inside = radius - offset(pixel.column).hypot(offset(pixel.row));
            self.canvas.blend(x, y, EDGE, (1.5 - inside).clamp(0.0, 1.0));
        }
    }

    /// Writes lines of text below a sphere.
    pub fn below(&mut self, at: Place, lines: &[&str]) {
        let (left, top) = self.place(at);
        for (line, text) in lines.iter().enumerate() {
            let top = top + self.view.size + PADDING + line * LINE;
            self.centered(left + self.view.size / 2, top, text);
        }
    }

    /// Writes text above the first sphere of a column.
    pub fn above(&mut self, column: usize, text: &str) {
        let (left, top) = self.place((column, 0));
        self.centered(left + self.view.size / 2, top - LINE - PADDING, text);
    }

    /// Writes lines of text at the left of a row, centered vertically.
    pub fn beside(&mut self, row: usize, lines: &[&str]) {
        let (_, top) = self.place((0, row));
        let first = top + self.view.size / 2 - lines.len() * LINE / 2;
        let left = self.step.0 - self.view.size;
        for (line, text) in lines.iter().enumerate() {
            self.canvas.text((left, first + line * LINE), TEXT, INK, text);
        }
    }

    fn centered(&mut self, middle: usize, top: usize, text: &str) {
        self.canvas.centered_text((middle, top), TEXT, INK, text);
    }

    /// The picture with the color scale of signed images, up to `largest`, at its foot.
    pub fn scale(mut self, largest: &str) -> Canvas {
        let (width, height) = (self.canvas.width / 3, BAR);
        let extra = 4 * BAR;
        let top = self.canvas.height;
        self.canvas.height += extra;
        self.canvas.bytes.extend(PAPER.repeat(self.canvas.width * extra));
        let left = (self.canvas.width - width) / 2;
        for column in 0..width {
            let value = 2.0 * column as f64 / (width - 1) as f64 - 1.0;
            for row in 0..height {
                self.canvas.blend(left + column, top + row, diverging(value), 1.0);
            }
        }
        let texts = [format!("-{largest}"), "0".into(), format!("+{largest}")];
        for (place, text) in texts.iter().enumerate() {
            self.centered(left + place * width / 2, top + height + PADDING, text);
        }
        self.canvas
    }

    pub fn finish(self) -> Canvas {
        self.canvas
    }
}

pub fn gray(image: &[f64]) -> impl Iterator<Item = [f64; 3]> {
    image.iter().map(|&value| [value; 3])
}

/// Blue for -1, white for 0, red for 1; values beyond are clamped.
fn diverging(value: f64) -> [u8; 3] {
    const NEGATIVE: [[f64; 3]; 2] = [[75.0, 140.0, 200.0], [8.0, 42.0, 105.0]];
    const POSITIVE: [[f64; 3]; 2] = [[226.0, 118.0, 84.0], [110.0, 4.0, 26.0]];
    let [middle, end] = if value < 0.0 { NEGATIVE } else { POSITIVE };
    let size = 2.0 * value.abs().min(1.0);
    let mix = |from: [f64; 3], to: [f64; 3], share: f64| {
        [0, 1, 2].map(|c| (from[c] + share * (to[c] - from[c])).round() as u8)
    };
    if size <= 1.0 { mix([250.0; 3], middle, size) } else { mix(middle, end, size - 1.0) }
}
